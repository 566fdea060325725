#include "puadem/network/pore_units.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "puadem/geometry/cell.hpp"
#include "puadem/geometry/packing_sites.hpp"
#include "puadem/network/merging.hpp"
#include "puadem/network/pore_shape.hpp"

namespace puadem {

namespace {

/// What geometry says of every cell.
struct Cells {
  std::vector<double> volume, void_volume;
  std::vector<Vec3> centroid;
  std::vector<Vec3> power_centre;
  std::vector<int> faces;
  std::vector<std::uint8_t> walls;
};

Cells measure_cells(const Triangulation& triangulation, const PackingSites& sites_of) {
  const auto n = to_size(triangulation.cells());
  Cells cells{std::vector<double>(n), std::vector<double>(n), std::vector<Vec3>(n),
              std::vector<Vec3>(n),   std::vector<int>(n),    std::vector<std::uint8_t>(n)};
  parallel_for(triangulation.cells(), [&](int t) {
    const auto i = to_size(t);
    const auto& vertices = triangulation.vertices[i];
    const auto sites = sites_of(vertices);
    cells.volume[i] = cell_volume(sites);
    cells.void_volume[i] = cell_void_volume(sites);
    cells.centroid[i] = cell_centroid(sites);
    cells.power_centre[i] = power_centre(sites).value_or(cells.centroid[i]);  // flat cells have none, and always merge
    for (const auto& v : vertices)
      if (v.is_wall()) {
        cells.walls[i] = static_cast<std::uint8_t>(cells.walls[i] | 1u << v.face());
        ++cells.faces[i];
      }
    for (const auto& neighbour : triangulation.neighbours[i]) cells.faces[i] += neighbour.cell >= 0;
  });
  return cells;
}

std::array<Vertex, 3> facet_vertices(const Triangulation& triangulation, const Facet& facet) {
  const auto& v = triangulation.vertices[to_size(facet.cell)];
  const auto k = static_cast<std::size_t>(facet.opposite);
  return {v[(k + 1) % 4], v[(k + 2) % 4], v[(k + 3) % 4]};
}

/// Sections, entry and snap-off radii of all facets.
struct Sections {
  std::vector<double> facet_area, void_area, inscribed_radius, entry_radius, snap_off_radius;
  std::vector<EntryKind> kind;
};

Sections measure_sections(const Triangulation& triangulation, const std::vector<Facet>& facets, const PackingSites& sites_of,
                          const NetworkOptions& options) {
  const auto n = facets.size();
  Sections s{std::vector<double>(n), std::vector<double>(n), std::vector<double>(n),
             std::vector<double>(n), std::vector<double>(n), std::vector<EntryKind>(n)};
  std::visit(
      [&](const ThroatEntryLaw auto& law) {
        parallel_for(size_of(facets), [&](int f) {
          const auto i = to_size(f);
          const ThroatSection section = throat_section(sites_of(facet_vertices(triangulation, facets[i])));
          const Entry entry = law.entry(section, options.contact_angle);
          s.facet_area[i] = section.facet_area;
          s.void_area[i] = section.void_area;
          s.inscribed_radius[i] = section.inscribed_radius;
          s.entry_radius[i] = entry.radius;
          s.kind[i] = entry.kind;
          s.snap_off_radius[i] = snap_off_radius(section, options.contact_angle);
        });
      },
      options.entry_law);
  return s;
}

void fill_pores(PoreNetwork& network, const Cells& cells, const MergedCells& merged, const PackingSites& sites_of) {
  const auto units = to_size(merged.units);
  network.pore_centre.assign(units, {});
  network.pore_volume.assign(units, 0.0);
  network.pore_radius.resize(units);
  network.pore_faces.assign(units, 0);
  network.pore_walls.assign(units, 0);
  std::vector<double> bulk(units, 0.0);
  for (std::size_t t = 0; t < merged.unit.size(); ++t) {
    const auto u = to_size(merged.unit[t]);
    network.pore_volume[u] += cells.void_volume[t];
    network.pore_walls[u] = static_cast<std::uint8_t>(network.pore_walls[u] | cells.walls[t]);
    network.pore_faces[u] += std::popcount(cells.walls[t]);
    bulk[u] += cells.volume[t];
    network.pore_centre[u] += cells.volume[t] * (cells.centroid[t] + sites_of.translation(merged.cell_shift[t]));
  }
  for (std::size_t u = 0; u < units; ++u) network.pore_centre[u] *= 1.0 / bulk[u];
}

void add_throat(PoreNetwork& network, const Facet& facet, std::size_t f, const Cells& cells, const MergedCells& merged,
                const Sections& sections, const PackingSites& sites_of) {
  const auto a = to_size(facet.cell), b = to_size(facet.neighbour);
  int i = merged.unit[a], j = merged.unit[b];
  std::array<std::int8_t, 3> shift;
  for (std::size_t k = 0; k < 3; ++k)
    shift[k] = static_cast<std::int8_t>(merged.cell_shift[a][k] + facet.shift[k] - merged.cell_shift[b][k]);
  const bool self = i == j;
  if (self && shift == std::array<std::int8_t, 3>{}) return;  // inside one unit

  const auto vertices = facet_vertices(network.triangulation, facet);
  Vec3 normal = facet_normal(sites_of(vertices));
  // From the cell outwards: away from its vertex opposite the facet.
  const auto& opposite = network.triangulation.vertices[a][static_cast<std::size_t>(facet.opposite)];
  const Vec3 apex =
      opposite.is_wall()
          ? sites_of(opposite).normal
          : cells.centroid[a] -
                sites_of(*std::find_if(vertices.begin(), vertices.end(), [](const Vertex& v) { return !v.is_wall(); })).centre;
  if (dot(normal, apex) > 0.0) normal = -normal;
  const double length = norm(cells.power_centre[b] + sites_of.translation(facet.shift) - cells.power_centre[a]);
  if (j < i) {
    std::swap(i, j);
    normal = -normal;
    for (auto& s : shift) s = static_cast<std::int8_t>(-s);
  }
  network.throat_pores.push_back({i, j});
  network.throat_shift.push_back(shift);
  network.throat_normal.push_back(normal);
  network.throat_area.push_back(sections.void_area[f]);
  network.throat_facet_area.push_back(sections.facet_area[f]);
  network.throat_length.push_back(length);
  network.throat_radius.push_back(sections.inscribed_radius[f]);
  network.throat_entry_radius.push_back(sections.entry_radius[f]);
  network.throat_snap_off_radius.push_back(sections.snap_off_radius[f]);
  network.throat_entry_kind.push_back(sections.kind[f]);
  network.throat_at_wall.push_back(std::ranges::any_of(vertices, &Vertex::is_wall) ? 1 : 0);
  network.throat_particles.push_back(vertices);
  ++network.pore_faces[to_size(i)];
  ++network.pore_faces[to_size(j)];
}

}  // namespace

PoreNetwork build_pore_network(std::span<const Vec3> centre, std::span<const double> radius, const Domain& domain,
                               const NetworkOptions& options) {
  PoreNetwork network;
  network.triangulation = triangulate(centre, radius, domain);
  const Triangulation& triangulation = network.triangulation;
  const PackingSites sites_of(centre, radius, domain);
  const Cells cells = measure_cells(triangulation, sites_of);
  const std::vector<Facet> facets = find_facets(triangulation);
  const Sections sections = measure_sections(triangulation, facets, sites_of, options);

  std::vector<double> wide(facets.size());
  for (std::size_t f = 0; f < facets.size(); ++f) wide[f] = 2.0 * sections.entry_radius[f];
  const MergedCells merged = merge_cells(triangulation.cells(), facets, cells.void_volume, cells.faces, wide, sections.void_area,
                                         {options.merge_ratio, options.merge_limit});

  fill_pores(network, cells, merged, sites_of);
  for (std::size_t f = 0; f < facets.size(); ++f) add_throat(network, facets[f], f, cells, merged, sections, sites_of);
  for (std::size_t u = 0; u < to_size(merged.units); ++u)
    network.pore_radius[u] = inscribed_radius_coefficient(network.pore_faces[u]) * std::cbrt(network.pore_volume[u]);

  network.tetrahedron_void = cells.void_volume;
  network.tetrahedron_pore = merged.unit;
  network.pore_tetrahedra = rows_from(merged.unit, merged.units);
  network.pore_throats = throats_of_pores(network.throat_pores, merged.units);
  return network;
}

}  // namespace puadem
