#include "puadem/dem/mixture.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "puadem/base/error.hpp"
#include "puadem/base/parallel.hpp"

namespace puadem {

std::vector<int> assign_materials(std::span<const double> radius, std::span<const MaterialShare> shares) {
  require(!shares.empty(), "no material is given for the grains");
  double sum = 0.0;
  for (const MaterialShare& share : shares) {
    require(share.fraction > 0.0 && share.fraction <= 1.0, "grains.materials: fraction {} must lie in (0, 1]", share.fraction);
    sum += share.fraction;
  }
  require(std::abs(sum - 1.0) <= 1e-3, "the fractions of grains.materials add to {:.6g}; they must add to 1", sum);

  std::vector<int> order(radius.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return radius[to_size(a)] > radius[to_size(b)]; });
  std::vector<double> filled(shares.size(), 0.0);
  std::vector<int> material(radius.size());
  double total = 0.0;
  for (const int grain : order) {
    const double r = radius[to_size(grain)], volume = r * r * r;
    total += volume;
    std::size_t neediest = 0;
    const auto missing = [&](std::size_t m) { return shares[m].fraction / sum * total - filled[m]; };
    for (std::size_t m = 1; m < shares.size(); ++m)
      if (missing(m) > missing(neediest)) neediest = m;
    filled[neediest] += volume;
    material[to_size(grain)] = shares[neediest].material;
  }
  return material;
}

}  // namespace puadem
