#include "puadem/flow/flow_boundary.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace puadem {

namespace {

using Point = std::vector<double>::const_iterator;

double value_before(const Schedule& schedule, Point next, double t) {
  if (next == schedule.time.begin()) return schedule.value.front();
  if (next == schedule.time.end()) return schedule.value.back();
  const auto k = static_cast<std::size_t>(next - schedule.time.begin());
  return std::lerp(schedule.value[k - 1], schedule.value[k],
                   (t - schedule.time[k - 1]) / (schedule.time[k] - schedule.time[k - 1]));
}

}  // namespace

double Schedule::at(double t) const { return value_before(*this, std::ranges::upper_bound(time, t), t); }

double Schedule::just_before(double t) const { return value_before(*this, std::ranges::lower_bound(time, t), t); }

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
