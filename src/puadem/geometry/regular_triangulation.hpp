#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <span>
#include <vector>

#include "puadem/base/vec3.hpp"
#include "puadem/geometry/domain.hpp"

namespace puadem {

/// A vertex of the triangulation: a grain, one of its periodic images, or a wall of the box.
struct Vertex {
  int index = 0;                       ///< grain >= 0; wall face f as -1 - f
  std::array<std::int8_t, 3> shift{};  ///< the grain is moved by this many periods along each axis

  constexpr bool is_wall() const { return index < 0; }
  constexpr int face() const { return -1 - index; }
  static constexpr Vertex wall(int face) { return {-1 - face, {}}; }
  constexpr auto operator<=>(const Vertex&) const = default;
};

/// Regular (weighted Delaunay) triangulation of spheres in a box, one period of it where the box is
/// periodic. A cell with wall vertices stands for the polyhedron of its grains and their feet on the
/// walls (theory 3.2), so that the cells tile the box.
///
/// The four vertices of a cell ascend, grains after walls, and the cells ascend by their vertices:
/// the same spheres give the same arrays, whatever the order of construction.
struct Triangulation {
  /// Where facet k of a cell (opposite vertex k) leads.
  struct Neighbour {
    int cell = -1;                       ///< -1: out of the box, through a wall
    std::array<std::int8_t, 3> shift{};  ///< the neighbour is moved by this many periods
    constexpr bool operator==(const Neighbour&) const = default;
  };
  std::vector<std::array<Vertex, 4>> vertices;
  std::vector<std::array<Neighbour, 4>> neighbours;

  int cells() const { return static_cast<int>(vertices.size()); }
};

/// A cell as the triangulation lists it. Its images by whole periods are one cell: the one whose lowest grain is not moved
/// stands for all; where that grain occurs more than once, the least of the candidates.
struct CanonicalCell {
  std::array<Vertex, 4> vertices;      ///< ascending
  std::array<std::int8_t, 3> shift{};  ///< how far the given cell lies from the canonical one
};
CanonicalCell canonical(const std::array<Vertex, 4>& cell);

/// Triangulates spheres (theory 3.1).
///
/// @param centre  [m], inside the box (periodic directions included)
/// @param radius  [m], > 0
/// @throws InputError  for no spheres, a sphere centre outside the box, two spheres at one place, and
///                     hidden spheres (swallowed by their neighbours so far that they own no space)
Triangulation triangulate(std::span<const Vec3> centre, std::span<const double> radius, const Domain& domain);

}  // namespace puadem
