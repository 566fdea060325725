#include "puadem/coupling/fluid_forces.hpp"

#include <cassert>
#include <cmath>
#include <numbers>

#include "puadem/geometry/cell.hpp"
#include "puadem/geometry/throat_domain.hpp"

namespace puadem {

namespace {

/// What each vertex has of the solid that bears a throat's void.
std::array<double, 3> bearing(const std::array<Vertex, 3>& vertices, const std::array<Site, 3>& sites,
                              const ThroatSection& section, const ThroatDomain& domain, ThroatShare share,
                              const std::array<bool, 6>& no_slip) {
  std::array<double, 3> solid{};
  for (unsigned k = 0; k < 3; ++k) {
    if (sites[k].is_wall && !no_slip[to_size(vertices[k].face())]) continue;
    solid[k] = share == ThroatShare::surface ? domain.solid_area[k] : section.solid_length(static_cast<int>(k));
  }
  return solid;
}

std::vector<PushedAreas::Patch> wall_patches(const PoreNetwork& network, const PackingSites& sites_of) {
  std::vector<PushedAreas::Patch> patches;
  for (int c = 0; c < network.triangulation.cells(); ++c) {
    const auto& vertices = network.triangulation.vertices[to_size(c)];
    for (unsigned k = 0; k < 4; ++k) {
      if (!vertices[k].is_wall()) continue;
      // What the cell has on a wall is its opposite facet seen along the wall's normal.
      const auto opposite = sites_of(std::array{vertices[(k + 1) % 4], vertices[(k + 2) % 4], vertices[(k + 3) % 4]});
      const double along = std::abs(dot(facet_normal(opposite), outward_normal(vertices[k].face())));
      patches.push_back({network.tetrahedron_pore[to_size(c)], vertices[k].face(), along * facet_area(opposite)});
    }
  }
  return patches;
}

}  // namespace

PushedAreas pushed_areas(const PoreNetwork& network, const PackingSites& sites_of, ThroatShare share,
                         const std::array<bool, 6>& no_slip) {
  PushedAreas areas;
  areas.throat.resize(to_size(network.throats()));
  areas.throat_void.resize(to_size(network.throats()));
  areas.bearer.resize(to_size(network.throats()));
  std::vector<Vec3> centre(to_size(network.triangulation.cells()));
  if (share == ThroatShare::surface)
    parallel_for(network.triangulation.cells(), [&](int c) {
      const auto sites = sites_of(network.triangulation.vertices[to_size(c)]);
      centre[to_size(c)] = power_centre(sites).value_or(cell_centroid(sites));
    });
  parallel_for(network.throats(), [&](int t) {
    const Facet& facet = network.throat_facet[to_size(t)];
    const auto vertices = network.throat_vertices(t);
    const auto sites = sites_of(vertices);
    const ThroatSection section = throat_section(sites);
    const ThroatDomain domain = throat_domain(sites, section, centre[to_size(facet.cell)],
                                              centre[to_size(facet.neighbour)] + sites_of.translation(facet.shift));
    auto solid = bearing(vertices, sites, section, domain, share, no_slip);
    double whole = solid[0] + solid[1] + solid[2];
    // A domain that overlapping grains fill, or one turned inside out, has no surface to go by.
    if (!(whole > 0.0)) {
      solid = bearing(vertices, sites, section, domain, ThroatShare::contact_line, no_slip);
      whole = solid[0] + solid[1] + solid[2];
    }
    for (unsigned k = 0; k < 3; ++k) {
      areas.bearer[to_size(t)][k] = vertices[k].index;
      const double sector = sites[k].is_wall ? 0.0 : 0.5 * sites[k].radius * sites[k].radius * section.side[k].extent;
      areas.throat_void[to_size(t)][k] = solid[k] / whole * section.void_area;
      areas.throat[to_size(t)][k] = sector + areas.throat_void[to_size(t)][k];
    }
  });
  areas.wall = wall_patches(network, sites_of);
  return areas;
}

FluidForces pressure_forces(const PoreNetwork& network, const PushedAreas& areas, std::span<const double> pressure,
                            const Vec3& jump, int grains) {
  assert(size_of(pressure) == network.pores());
  FluidForces forces;
  forces.grain.resize(to_size(grains));
  const bool jumps = jump != Vec3{};
  for (int t = 0; t < network.throats(); ++t) {
    const auto [i, j] = network.throat_pores[to_size(t)];
    double drop = pressure[to_size(i)] - pressure[to_size(j)];
    if (jumps) {
      const auto& s = network.throat_shift[to_size(t)];
      drop -= dot(jump, Vec3{1.0 * s[0], 1.0 * s[1], 1.0 * s[2]});
    }
    const Vec3 push = drop * network.throat_normal[to_size(t)];
    for (unsigned k = 0; k < 3; ++k) {
      const Vertex v{areas.bearer[to_size(t)][k]};
      Vec3& force = v.is_wall() ? forces.wall[to_size(v.face())] : forces.grain[to_size(v.index)];
      force += areas.throat[to_size(t)][k] * push;
    }
  }
  for (const auto& [pore, face, area] : areas.wall)
    forces.wall[to_size(face)] += pressure[to_size(pore)] * area * outward_normal(face);
  return forces;
}

void add_buoyancy(std::span<const double> radius, double density, const Vec3& gravity, std::span<const double> wetted,
                  std::span<Vec3> force) {
  for (std::size_t k = 0; k < radius.size(); ++k) {
    const double volume = 4.0 / 3.0 * std::numbers::pi * radius[k] * radius[k] * radius[k];
    force[k] -= density * volume * (wetted.empty() ? 1.0 : wetted[k]) * gravity;
  }
}

void freeze_forces(const FluidForces& forces, GrainSystem& grains) {
  grains.external_force = forces.grain;
  for (Wall& wall : grains.walls) wall.fluid_force = wall.face >= 0 ? forces.wall[to_size(wall.face)] : Vec3{};
}

void release_forces(GrainSystem& grains) {
  grains.external_force.clear();
  for (Wall& wall : grains.walls) wall.fluid_force = {};
}

}  // namespace puadem
