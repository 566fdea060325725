#include "puadem/io/distributions.hpp"

#include <algorithm>
#include <cmath>

namespace puadem {
namespace {

constexpr int pore_bins = 20;    // per unit of R_i / <r>, which spans about 0.2 to 2
constexpr int throat_bins = 50;  // per unit of R_ij / <r>, which spans about 0.1 to 1

}  // namespace

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

double mean_radius(const Particles& particles) {
  if (particles.radius.empty()) return 0.0;
  double sum = 0.0;
  for (const double r : particles.radius) sum += r;
  return sum / particles.size();
}

RadiusDistributions radius_distributions(const State& state) {
  const double scale = mean_radius(state.particles);
  if (scale == 0.0) return {};
  std::vector<double> pore, throat;
  for (const double r : state.network.pore_radius) pore.push_back(r / scale);
  for (const double r : state.network.throat_radius)
    if (r > 0.0) throat.push_back(r / scale);
  return {histogram(pore, pore_bins), histogram(throat, throat_bins)};
}

}  // namespace puadem
