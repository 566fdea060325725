#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "puadem/geometry/regular_triangulation.hpp"

namespace puadem {

/// A facet between two cells of a triangulation, listed once.
struct Facet {
  int cell = 0, neighbour = 0;         ///< the normal points from the first to the second
  std::array<std::int8_t, 3> shift{};  ///< the neighbour is moved by this many periods
  std::int8_t opposite = 0;            ///< vertex of `cell` opposite the facet
  constexpr bool operator==(const Facet&) const = default;
};

/// Facets of a triangulation: of a pair of cells the lower one lists it; between a cell and its own
/// image the positive direction does. Ascending by (cell, opposite).
std::vector<Facet> find_facets(const Triangulation& triangulation);

/// The three vertices of a facet, where its first cell has them.
std::array<Vertex, 3> facet_vertices(const Triangulation& triangulation, const Facet& facet);

}  // namespace puadem
