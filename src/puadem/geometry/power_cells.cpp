#include "puadem/geometry/power_cells.hpp"

#include "puadem/geometry/cell.hpp"
#include "puadem/geometry/packing_sites.hpp"

namespace puadem {

namespace {

/// Where the line from a grain to another site meets their plane of equal power, seen from the grain.
Vec3 foot_of_plane(const Site& grain, const Site& other) {
  const Tangency t = tangency(grain, other);
  return t.constant / squared_norm(t.edge) * t.edge;
}

}  // namespace

// The face between two neighbours is the polygon of the power centres of the cells around their edge. It is cut into
// triangles from its foot on the edge; with the grain as apex each makes a signed tetrahedron, one for each facet of the
// triangulation at the edge. A facet is met from both of its cells, hence the half.
std::vector<double> power_cell_volumes(const Triangulation& triangulation, std::span<const Vec3> centre,
                                       std::span<const double> radius, const Domain& domain) {
  const PackingSites sites_of(centre, radius, domain);
  std::vector<Vec3> dual(to_size(triangulation.cells()));
  parallel_for(triangulation.cells(), [&](int c) {
    const std::array<Site, 4> sites = sites_of(triangulation.vertices[to_size(c)]);
    dual[to_size(c)] = power_centre(sites).value_or(cell_centroid(sites));  // a flat cell adds nothing wherever its centre lies
  });
  std::vector<double> volume(centre.size(), 0.0);
  for (int c = 0; c < triangulation.cells(); ++c) {
    const std::array<Vertex, 4>& vertices = triangulation.vertices[to_size(c)];
    const std::array<Site, 4> sites = sites_of(vertices);
    for (unsigned apex = 0; apex < 4; ++apex) {
      const Triangulation::Neighbour& next = triangulation.neighbours[to_size(c)][apex];
      if (next.cell < 0) continue;
      const Vec3 here = dual[to_size(c)], there = dual[to_size(next.cell)] + sites_of.translation(next.shift);
      for (unsigned k = 0; k < 4; ++k) {
        if (k == apex || sites[k].is_wall) continue;
        const Site& grain = sites[k];
        for (unsigned j = 0; j < 4; ++j) {
          if (j == apex || j == k) continue;
          const unsigned third = 6 - apex - k - j;
          // Seen along the edge from k to j, the way from here to there turns with the clock or against it.
          const double turn = triple(edge_from(grain, sites[j]), edge_from(grain, sites[third]), edge_from(grain, sites[apex]));
          const double cone = triple(foot_of_plane(grain, sites[j]), here - grain.centre, there - grain.centre) / 6.0;
          volume[to_size(vertices[k].index)] += 0.5 * (turn > 0.0 ? -cone : cone);
        }
      }
    }
  }
  return volume;
}

}  // namespace puadem
