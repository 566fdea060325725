#pragma once

#include <array>
#include <cassert>
#include <cmath>
#include <optional>

#include "puadem/base/vec3.hpp"

namespace puadem {

/// A vertex of a cell as geometry sees it: a grain, or a plane wall that stands for a grain of infinite
/// radius. What a formula needs of a wall is its outward normal and the offset of its plane.
struct Site {
  Vec3 centre{};        ///< grain: centre [m]
  double radius = 0.0;  ///< grain: radius, 0 for a point [m]
  bool is_wall = false;
  Vec3 normal{};        ///< wall: unit normal out of the box [-]
  double offset = 0.0;  ///< wall: normal . x of its plane [m]

  static constexpr Site grain(const Vec3& centre, double radius) { return {centre, radius, false, {}, 0.0}; }
  static constexpr Site wall(const Vec3& normal, double offset) { return {{}, 0.0, true, normal, offset}; }
};

/// Distance of a grain's centre to a wall, positive inside the box [m].
constexpr double distance_to_wall(const Site& grain, const Site& wall) { return wall.offset - dot(wall.normal, grain.centre); }

/// Edge of a cell seen from a grain: to the other grain's centre, or along the normal of a wall. Only
/// the direction counts where the other site is a wall.
constexpr Vec3 edge_from(const Site& grain, const Site& other) {
  return other.is_wall ? other.normal : other.centre - grain.centre;
}

/// Index of the first grain among the sites of a cell or facet; there is one.
template <std::size_t N>
constexpr std::size_t first_grain(const std::array<Site, N>& sites) {
  std::size_t k = 0;
  while (k + 1 < N && sites[k].is_wall) ++k;
  assert(!sites[k].is_wall);
  return k;
}

/// A circle or sphere of centre y (seen from a grain) and radius r that touches the grain, |y| = r + R_0, and
/// another site, |y - x| = r + R or n . y + r = offset. The difference of the two is linear:
/// edge . y = constant + linear r. With r = 0 it says where the powers to the two are equal.
struct Tangency {
  Vec3 edge;
  double constant = 0.0, linear = 0.0;
};
constexpr Tangency tangency(const Site& grain, const Site& other) {
  const Vec3 edge = edge_from(grain, other);
  if (other.is_wall) return {edge, distance_to_wall(grain, other), -1.0};
  return {edge, 0.5 * (squared_norm(edge) + grain.radius * grain.radius - other.radius * other.radius),
          grain.radius - other.radius};
}

/// Smallest r >= 0 with |u + r v| = r + R: 0 where the grains overlap at u, none where nothing fits.
inline std::optional<double> tangent_radius(const Vec3& u, const Vec3& v, double grain_radius) {
  const double a = squared_norm(v) - 1.0, b = dot(u, v) - grain_radius, d = squared_norm(u) - grain_radius * grain_radius;
  if (d <= 0.0) return 0.0;
  const double discriminant = b * b - a * d;
  if (discriminant < 0.0) return std::nullopt;
  const double denominator = -b + std::sqrt(discriminant);  // d over it: the root without cancellation
  if (denominator <= 0.0) return std::nullopt;
  return d / denominator;
}

}  // namespace puadem
