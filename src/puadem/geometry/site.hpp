#pragma once

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

/// Distance of the surfaces of a grain and another grain or wall [m]; negative where they overlap.
inline double gap(const Site& grain, const Site& other) {
  return other.is_wall ? distance_to_wall(grain, other) - grain.radius
                       : norm(other.centre - grain.centre) - (grain.radius + other.radius);
}

}  // namespace puadem
