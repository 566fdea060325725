#include "puadem/base/histogram.hpp"

#include <algorithm>
#include <cmath>

#include "puadem/base/parallel.hpp"

namespace puadem {

std::vector<Bin> histogram(std::span<const double> values, int bins_per_unit) {
  if (values.empty()) return {};
  const auto bin_of = [=](double value) { return static_cast<int>(std::floor(value * bins_per_unit)); };
  const auto [lowest, highest] = std::ranges::minmax(values);
  const int first = bin_of(lowest);
  std::vector<int> count(to_size(bin_of(highest) - first + 1), 0);
  for (const double value : values) ++count[to_size(bin_of(value) - first)];

  const double per_unit = bins_per_unit;  // edges as quotients: 0.35, not 7 times 0.05
  std::vector<Bin> bins;
  for (int b = 0; b < size_of(count); ++b)
    bins.push_back(
        {(first + b) / per_unit, (first + b + 1) / per_unit, count[to_size(b)] * per_unit / static_cast<double>(values.size())});
  return bins;
}

}  // namespace puadem
