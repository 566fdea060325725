#include "puadem/network/network_geometry.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

#include "puadem/base/error.hpp"
#include "puadem/geometry/cell.hpp"
#include "puadem/geometry/throat_domain.hpp"
#include "puadem/network/throat_windows.hpp"

namespace puadem {

namespace {

/// Normal of a facet out of its first cell: away from that cell's vertex opposite the facet.
Vec3 outward_normal_of(const std::array<Site, 3>& sites, const Site& opposite, const Vec3& centroid) {
  const Vec3 normal = facet_normal(sites);
  const Vec3 inwards = opposite.is_wall ? opposite.normal : centroid - sites[first_grain(sites)].centre;
  return dot(normal, inwards) > 0.0 ? -normal : normal;
}

/// Surface of a throat that holds the fluid [m2].
double resisting_area(const ThroatDomain& domain, const std::array<Vertex, 3>& vertices, const std::array<bool, 6>& no_slip) {
  double area = 0.0;
  for (std::size_t k = 0; k < 3; ++k)
    if (!vertices[k].is_wall() || no_slip[to_size(vertices[k].face())]) area += domain.solid_area[k];
  return area;
}

double smallest_grain(const std::array<Site, 3>& sites) {
  double radius = std::numeric_limits<double>::infinity();
  for (const Site& site : sites)
    if (!site.is_wall) radius = std::min(radius, site.radius);
  return radius;
}

/// Whether a cell and its neighbour, moved by `shift`, are of one pore and not of two images of it.
bool lie_in_one_unit(const PoreNetwork& network, int cell, int neighbour, const std::array<std::int8_t, 3>& shift) {
  if (network.tetrahedron_pore[to_size(cell)] != network.tetrahedron_pore[to_size(neighbour)]) return false;
  const auto &a = network.tetrahedron_shift[to_size(cell)], &b = network.tetrahedron_shift[to_size(neighbour)];
  for (std::size_t k = 0; k < 3; ++k)
    if (a[k] + shift[k] != b[k]) return false;
  return true;
}

}  // namespace

CellGeometry measure_cells(const Triangulation& triangulation, const PackingSites& sites_of) {
  const auto n = to_size(triangulation.cells());
  CellGeometry cells{std::vector<double>(n), std::vector<double>(n), std::vector<Vec3>(n), std::vector<Vec3>(n)};
  parallel_for(triangulation.cells(), [&](int t) {
    const auto i = to_size(t);
    const auto sites = sites_of(triangulation.vertices[i]);
    cells.volume[i] = cell_volume(sites);
    cells.void_volume[i] = cell_void_volume(sites);
    cells.centroid[i] = cell_centroid(sites);
    cells.power_centre[i] = power_centre(sites).value_or(cells.centroid[i]);
  });
  return cells;
}

bool centre_flat_cells(const PoreNetwork& network, const PackingSites& sites_of, CellGeometry& cells) {
  constexpr double flat = 1e-6;  // of the mean cell
  const int n = size_of(cells.volume);
  const double mean = std::accumulate(cells.volume.begin(), cells.volume.end(), 0.0) / n;
  std::vector<int> waiting;
  for (int t = 0; t < n; ++t)
    if (cells.volume[to_size(t)] <= flat * mean) waiting.push_back(t);
  const bool are_some = !waiting.empty();

  std::vector<char> has_centre(to_size(n), 1);
  for (const int t : waiting) has_centre[to_size(t)] = 0;
  const auto centre_beside = [&](int t) -> std::optional<Vec3> {
    for (const auto& [cell, shift] : network.triangulation.neighbours[to_size(t)]) {
      if (cell < 0 || !has_centre[to_size(cell)] || !lie_in_one_unit(network, t, cell, shift)) continue;
      return cells.power_centre[to_size(cell)] + sites_of.translation(shift);
    }
    return std::nullopt;
  };
  for (std::size_t before = waiting.size() + 1; waiting.size() < before;) {  // flat cells behind flat cells come later
    before = waiting.size();
    std::vector<int> centred;
    std::erase_if(waiting, [&](int t) {
      const auto centre = centre_beside(t);
      if (!centre) return false;
      cells.power_centre[to_size(t)] = *centre;
      centred.push_back(t);
      return true;
    });
    for (const int t : centred) has_centre[to_size(t)] = 1;
  }
  return are_some;
}

FacetGeometry::FacetGeometry(std::size_t facets)
    : normal(facets),
      area(facets),
      void_area(facets),
      length(facets),
      conductance(facets),
      inscribed_radius(facets),
      entry_radius(facets),
      snap_off_radius(facets),
      kind(facets) {}

FacetGeometry measure_facets(const Triangulation& triangulation, std::span<const Facet> facets, const CellGeometry& cells,
                             const PackingSites& sites_of, const NetworkOptions& options) {
  FacetGeometry g(facets.size());
  std::visit(
      [&](const ThroatEntryLaw auto& law) {
        parallel_for(size_of(facets), [&](int f) {
          const auto i = to_size(f);
          const Facet& facet = facets[i];
          const auto a = to_size(facet.cell), b = to_size(facet.neighbour);
          const auto vertices = facet_vertices(triangulation, facet);
          const auto sites = sites_of(vertices);
          const Site opposite = sites_of(triangulation.vertices[a][static_cast<std::size_t>(facet.opposite)]);
          const ThroatSection section = throat_section(sites);
          const ThroatDomain domain =
              throat_domain(sites, section, cells.power_centre[a], cells.power_centre[b] + sites_of.translation(facet.shift));
          const Entry entry = law.entry(section, options.contact_angle);
          g.normal[i] = outward_normal_of(sites, opposite, cells.centroid[a]);
          g.area[i] = section.facet_area;
          g.void_area[i] = section.void_area;
          g.length[i] = domain.length;
          g.conductance[i] = throat_conductance(domain, section.void_area, resisting_area(domain, vertices, options.no_slip),
                                                smallest_grain(sites));
          g.inscribed_radius[i] = section.inscribed_radius;
          g.entry_radius[i] = entry.radius;
          g.kind[i] = entry.kind;
          g.snap_off_radius[i] = snap_off_radius(section, options.contact_angle);
        });
      },
      options.entry_law);
  return g;
}

void set_pore_geometry(PoreNetwork& network, const CellGeometry& cells, const PackingSites& sites_of, PoreShape shape) {
  const int pores = network.pore_tetrahedra.rows();
  network.pore_centre.resize(to_size(pores));
  network.pore_volume.resize(to_size(pores));
  network.pore_radius.resize(to_size(pores));
  parallel_for(pores, [&](int p) {
    double space = 0.0, bulk = 0.0;
    Vec3 moment;
    for (const int t : network.pore_tetrahedra[p]) {
      const auto i = to_size(t);
      space += cells.void_volume[i];
      bulk += cells.volume[i];
      moment += cells.volume[i] * (cells.centroid[i] + sites_of.translation(network.tetrahedron_shift[i]));
    }
    const auto u = to_size(p);
    network.pore_centre[u] = moment / bulk;
    network.pore_volume[u] = space;
    const Vec3& c = network.pore_centre[u];
    ensure(space > 0.0, "pore {} at ({:g}, {:g}, {:g}) m has no void left ({:g} m3): the grains around it overlap too far", p,
           c.x, c.y, c.z, space);
    network.pore_radius[u] = inscribed_radius_coefficient(network.pore_faces[u], shape) * std::cbrt(space);
  });
  network.tetrahedron_void = cells.void_volume;
}

void set_throat_geometry(PoreNetwork& network, FacetGeometry geometry, const PackingSites& sites_of,
                         const NetworkOptions& options) {
  network.throat_normal = std::move(geometry.normal);
  for (int t = 0; t < network.throats(); ++t)  // a facet is seen from its first cell, a throat from its first pore
    if (network.tetrahedron_pore[to_size(network.throat_facet[to_size(t)].cell)] != network.throat_pores[to_size(t)][0])
      network.throat_normal[to_size(t)] = -network.throat_normal[to_size(t)];
  network.throat_area = std::move(geometry.void_area);
  network.throat_facet_area = std::move(geometry.area);
  network.throat_length = std::move(geometry.length);
  network.throat_conductance = std::move(geometry.conductance);
  network.throat_radius = std::move(geometry.inscribed_radius);
  network.throat_entry_radius = std::move(geometry.entry_radius);
  network.throat_snap_off_radius = std::move(geometry.snap_off_radius);
  network.throat_entry_kind = std::move(geometry.kind);
  if (options.throat_section == ThroatOutline::window) set_window_radii(network, sites_of, options);
}

void update_network_geometry(PoreNetwork& network, std::span<const Vec3> centre, std::span<const double> radius,
                             const Domain& domain, const NetworkOptions& options) {
  const PackingSites sites_of(centre, radius, domain);
  CellGeometry cells = measure_cells(network.triangulation, sites_of);
  centre_flat_cells(network, sites_of, cells);
  set_pore_geometry(network, cells, sites_of, options.pore_shape);
  set_throat_geometry(network, measure_facets(network.triangulation, network.throat_facet, cells, sites_of, options), sites_of,
                      options);
}

}  // namespace puadem
