#include "puadem/flow/flow_boundary.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace puadem {

double Schedule::at(double t) const {
  const auto after = std::ranges::upper_bound(time, t);
  if (after == time.begin()) return value.front();
  if (after == time.end()) return value.back();
  const auto k = static_cast<std::size_t>(after - time.begin());
  return std::lerp(value[k - 1], value[k], (t - time[k - 1]) / (time[k] - time[k - 1]));
}

double Schedule::next_corner(double t) const {
  const auto after = std::ranges::upper_bound(time, t);
  return after == time.end() ? std::numeric_limits<double>::infinity() : *after;
}

std::vector<int> face_pores(const PoreNetwork& network, int face) {
  std::vector<int> pores;
  for (int i = 0; i < network.pores(); ++i)
    if (network.pore_walls[to_size(i)] >> face & 1) pores.push_back(i);
  return pores;
}

std::vector<int> cylinder_pores(const PoreNetwork& network, double x, double y, double radius) {
  std::vector<int> pores;
  for (int i = 0; i < network.pores(); ++i) {
    const Vec3& centre = network.pore_centre[to_size(i)];
    if (std::hypot(centre.x - x, centre.y - y) < radius) pores.push_back(i);
  }
  return pores;
}

}  // namespace puadem
