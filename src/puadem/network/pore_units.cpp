#include "puadem/network/pore_units.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <ranges>

#include "puadem/base/error.hpp"
#include "puadem/geometry/cell.hpp"
#include "puadem/network/grain_overlaps.hpp"
#include "puadem/network/merging.hpp"
#include "puadem/network/network_geometry.hpp"

namespace puadem {

namespace {

using Shift = std::array<std::int8_t, 3>;

/// A unit falls apart this far below the ratio at which it would have merged, so that small motion does not merge and split
/// it again and again.
constexpr double split_margin = 0.1;

/// Facets and wall faces of each cell.
std::vector<int> count_faces(const Triangulation& triangulation) {
  std::vector<int> faces(to_size(triangulation.cells()));
  for (std::size_t t = 0; t < faces.size(); ++t) {
    for (const Vertex& v : triangulation.vertices[t]) faces[t] += v.is_wall();
    for (const auto& neighbour : triangulation.neighbours[t]) faces[t] += neighbour.cell >= 0;
  }
  return faces;
}

/// Wall faces that each cell touches.
std::vector<std::uint8_t> find_walls(const Triangulation& triangulation) {
  std::vector<std::uint8_t> walls(to_size(triangulation.cells()));
  for (std::size_t t = 0; t < walls.size(); ++t)
    for (const Vertex& v : triangulation.vertices[t])
      if (v.is_wall()) walls[t] = static_cast<std::uint8_t>(walls[t] | 1u << v.face());
  return walls;
}

/// Overlap of the inscribed spheres on either side of each facet, as a share of the smaller radius [-].
std::vector<double> insphere_overlaps(const Triangulation& triangulation, std::span<const Facet> facets,
                                      const PackingSites& sites_of) {
  std::vector<InscribedSphere> sphere(to_size(triangulation.cells()));
  parallel_for(triangulation.cells(), [&](int t) {
    sphere[to_size(t)] = inscribed_sphere(sites_of(triangulation.vertices[to_size(t)])).value_or(InscribedSphere{});
  });
  std::vector<double> overlap(facets.size());
  for (std::size_t f = 0; f < facets.size(); ++f) {
    const InscribedSphere &a = sphere[to_size(facets[f].cell)], &b = sphere[to_size(facets[f].neighbour)];
    const double distance = norm(b.centre + sites_of.translation(facets[f].shift) - a.centre),
                 smaller = std::min(a.radius, b.radius);
    overlap[f] = smaller > 0.0 ? (a.radius + b.radius - distance) / smaller : 0.0;
  }
  return overlap;
}

/// Cells, walls and wall faces of the pores.
void lay_out_pores(PoreNetwork& network, MergedCells merged) {
  network.pore_walls.assign(to_size(merged.units), 0);
  network.pore_faces.assign(to_size(merged.units), 0);
  for (std::size_t t = 0; t < merged.unit.size(); ++t) {
    const auto u = to_size(merged.unit[t]);
    for (const Vertex& v : network.triangulation.vertices[t])
      if (v.is_wall()) {
        network.pore_walls[u] = static_cast<std::uint8_t>(network.pore_walls[u] | 1u << v.face());
        ++network.pore_faces[u];
      }
  }
  network.pore_tetrahedra = rows_from(merged.unit, merged.units);
  network.tetrahedron_pore = std::move(merged.unit);
  network.tetrahedron_shift = std::move(merged.cell_shift);
}

/// Throats are the facets between two pores, or between a pore and its own image. Returns which facets they are.
std::vector<int> lay_out_throats(PoreNetwork& network, std::span<const Facet> facets) {
  const auto shift_of = [&](const Facet& facet) {
    const Shift &a = network.tetrahedron_shift[to_size(facet.cell)], &b = network.tetrahedron_shift[to_size(facet.neighbour)];
    Shift shift;
    for (std::size_t k = 0; k < 3; ++k) shift[k] = static_cast<std::int8_t>(a[k] + facet.shift[k] - b[k]);
    return shift;
  };
  const auto is_throat = [&](int f) {
    const Facet& facet = facets[to_size(f)];
    return network.tetrahedron_pore[to_size(facet.cell)] != network.tetrahedron_pore[to_size(facet.neighbour)] ||
           shift_of(facet) != Shift{};
  };
  const auto all = std::views::iota(0, size_of(facets));
  const auto count = to_size(static_cast<int>(std::ranges::count_if(all, is_throat)));
  std::vector<int> kept;
  kept.reserve(count);
  network.throat_pores.reserve(count);
  network.throat_shift.reserve(count);
  network.throat_facet.reserve(count);
  network.throat_at_wall.reserve(count);
  for (const int f : all) {
    if (!is_throat(f)) continue;
    const Facet& facet = facets[to_size(f)];
    int i = network.tetrahedron_pore[to_size(facet.cell)], j = network.tetrahedron_pore[to_size(facet.neighbour)];
    Shift shift = shift_of(facet);
    if (j < i) {
      std::swap(i, j);
      for (auto& s : shift) s = static_cast<std::int8_t>(-s);
    }
    kept.push_back(f);
    network.throat_pores.push_back({i, j});
    network.throat_shift.push_back(shift);
    network.throat_facet.push_back(facet);
    network.throat_at_wall.push_back(std::ranges::any_of(facet_vertices(network.triangulation, facet), &Vertex::is_wall) ? 1 : 0);
    ++network.pore_faces[to_size(i)];
    ++network.pore_faces[to_size(j)];
  }
  network.pore_throats = throats_of_pores(network.throat_pores, network.pore_tetrahedra.rows());
  return kept;
}

/// The entries `kept` of `values`, in that order.
template <class T>
void select(std::vector<T>& values, const std::vector<int>& kept) {
  for (std::size_t k = 0; k < kept.size(); ++k) values[k] = values[to_size(kept[k])];  // ascending: read before written
  values.resize(kept.size());
  values.shrink_to_fit();  // merging leaves a third
}

void select(FacetGeometry& g, const std::vector<int>& kept) {
  select(g.normal, kept);
  for (auto* values :
       {&g.area, &g.void_area, &g.length, &g.conductance, &g.inscribed_radius, &g.entry_radius, &g.snap_off_radius})
    select(*values, kept);
  select(g.kind, kept);
}

/// What merging starts from when a network is made anew.
struct FormerUnits {
  std::vector<int> unit, kind;
  std::vector<Shift> cell_shift;
};

FormerUnits former_units(const PoreNetwork& before, std::span<const int> kind, const CellMatch& match) {
  FormerUnits former;
  former.unit.assign(match.before.size(), -1);
  former.cell_shift.resize(match.before.size());
  if (!kind.empty()) former.kind.resize(match.before.size());
  for (std::size_t c = 0; c < match.before.size(); ++c) {
    if (match.before[c] < 0) continue;
    const auto old = to_size(match.before[c]);
    former.unit[c] = before.tetrahedron_pore[old];
    for (std::size_t k = 0; k < 3; ++k)
      former.cell_shift[c][k] = static_cast<std::int8_t>(before.tetrahedron_shift[old][k] + match.shift[c][k]);
    if (!kind.empty()) former.kind[c] = kind[to_size(former.unit[c])];
  }
  if (kind.empty()) return former;
  for (int cavity = 0; cavity < match.appeared.rows(); ++cavity) {
    int highest = std::numeric_limits<int>::min();
    for (const int c : match.vanished[cavity]) highest = std::max(highest, kind[to_size(before.tetrahedron_pore[to_size(c)])]);
    for (const int c : match.appeared[cavity]) former.kind[to_size(c)] = highest;
  }
  return former;
}

/// Units, throats and geometry upon a triangulation.
PoreNetwork network_of(Triangulation mesh, const FormerUnits& former, std::span<const Vec3> centre,
                       std::span<const double> radius, const Domain& domain, const NetworkOptions& options) {
  PoreNetwork network;
  network.triangulation = std::move(mesh);
  const Triangulation& triangulation = network.triangulation;
  const PackingSites sites_of(centre, radius, domain);
  CellGeometry cells = measure_cells(triangulation, sites_of);
  if (!(std::accumulate(cells.void_volume.begin(), cells.void_volume.end(), 0.0) > 0.0))
    throw NumericalError("the grains overlap too far, no void is left between them; " +
                         deepest_in_words(find_overlaps(triangulation, centre, radius, domain)));
  const std::vector<Facet> facets = find_facets(triangulation);
  FacetGeometry geometry = measure_facets(triangulation, facets, cells, sites_of, options);

  std::vector<double> wide(facets.size()), overlap;
  for (std::size_t f = 0; f < facets.size(); ++f) wide[f] = 2.0 * geometry.entry_radius[f];
  const std::vector<std::uint8_t> walls = find_walls(triangulation);
  MergeOptions merging{options.merge_ratio, options.merge_limit, options.pore_shape, {}, walls};
  if (options.merge_criterion == MergeCriterion::insphere_overlap) {
    overlap = insphere_overlaps(triangulation, facets, sites_of);
    merging.ratio = 0.0;
    merging.rank = overlap;
  }
  const StartingUnits start{former.unit, former.cell_shift, merging.ratio - split_margin, former.kind};
  lay_out_pores(network, merge_cells(triangulation.cells(), facets, cells.void_volume, count_faces(triangulation), wide,
                                     geometry.void_area, merging, start));
  select(geometry, lay_out_throats(network, facets));
  if (centre_flat_cells(network, sites_of, cells))
    geometry = measure_facets(triangulation, network.throat_facet, cells, sites_of, options);

  set_pore_geometry(network, cells, sites_of, options.pore_shape);
  set_throat_geometry(network, std::move(geometry), sites_of, options);
  return network;
}

}  // namespace

PoreNetwork build_pore_network(std::span<const Vec3> centre, std::span<const double> radius, const Domain& domain,
                               const NetworkOptions& options) {
  return network_of(triangulate(centre, radius, domain), {}, centre, radius, domain, options);
}

RebuiltNetwork rebuild_pore_network(const PoreNetwork& before, std::span<const int> kind, std::span<const Shift> wraps,
                                    std::span<const Vec3> centre, std::span<const double> radius, const Domain& domain,
                                    const NetworkOptions& options, std::span<const std::uint8_t> turned) {
  Triangulation mesh = triangulate(centre, radius, domain);
  CellMatch match = match_cells(before.triangulation, mesh, wraps, turned);
  const FormerUnits former = former_units(before, kind, match);
  return {network_of(std::move(mesh), former, centre, radius, domain, options), std::move(match)};
}

}  // namespace puadem
