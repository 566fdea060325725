#include "puadem/geometry/facets.hpp"

#include "puadem/base/parallel.hpp"

namespace puadem {

std::vector<Facet> find_facets(const Triangulation& triangulation) {
  std::vector<Facet> facets;
  facets.reserve(2 * to_size(triangulation.cells()));
  for (int t = 0; t < triangulation.cells(); ++t)
    for (std::int8_t k = 0; k < 4; ++k) {
      const auto& [cell, shift] = triangulation.neighbours[to_size(t)][static_cast<std::size_t>(k)];
      if (cell > t || (cell == t && shift > std::array<std::int8_t, 3>{})) facets.push_back({t, cell, shift, k});
    }
  return facets;
}

std::array<Vertex, 3> facet_vertices(const Triangulation& triangulation, const Facet& facet) {
  const auto& v = triangulation.vertices[to_size(facet.cell)];
  const auto k = static_cast<std::size_t>(facet.opposite);
  return {v[(k + 1) % 4], v[(k + 2) % 4], v[(k + 3) % 4]};
}

}  // namespace puadem
