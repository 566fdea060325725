#include "one_fluid.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "csv.hpp"
#include "dense_packing.hpp"
#include "puadem/dem/grain_statistics.hpp"
#include "puadem/flow/permeability.hpp"
#include "puadem/geometry/cell.hpp"
#include "puadem/geometry/facets.hpp"
#include "puadem/geometry/packing_sites.hpp"
#include "puadem/geometry/throat_domain.hpp"
#include "puadem/network/pore_units.hpp"
#include "support/lattice_facts.hpp"
#include "support/rotated_packing.hpp"

namespace puadem::verification {

namespace {

using testing::LatticeFacts;
using testing::Spheres;

PoreNetwork tetrahedra_of(const Spheres& s) {
  NetworkOptions options;
  options.merge_ratio = std::numeric_limits<double>::infinity();
  return build_pore_network(s.centre, s.radius, s.domain, options);
}

Permeability permeability_of(const Spheres& s) { return measure_permeability(tetrahedra_of(s), s.domain); }

double porosity_of(const Spheres& s) { return 1.0 - s.solid_volume() / s.domain.volume(); }

double kozeny_carman_of(const Spheres& s) { return kozeny_carman(porosity_of(s), statistics_of(s.radius).sauter_radius); }

double relative_error(double ours, double exact) { return std::abs(ours / exact - 1.0); }

/// All throats of a packing with their domains.
void for_each_throat(const Spheres& s, const std::function<void(const ThroatSection&, const ThroatDomain&)>& visit) {
  const Triangulation triangulation = triangulate(s.centre, s.radius, s.domain);
  const PackingSites sites_of(s.centre, s.radius, s.domain);
  for (const Facet& f : find_facets(triangulation)) {
    const auto sites = sites_of(facet_vertices(triangulation, f));
    const ThroatSection section = throat_section(sites);
    const Vec3 from = *power_centre(sites_of(triangulation.vertices[to_size(f.cell)]));
    const Vec3 to = *power_centre(sites_of(triangulation.vertices[to_size(f.neighbour)])) + sites_of.translation(f.shift);
    visit(section, throat_domain(sites, section, from, to));
  }
}

double total(const std::array<double, 3>& areas) { return areas[0] + areas[1] + areas[2]; }

/// Largest difference of two tensors over the mean permeability.
double largest_difference(const Permeability& a, const Permeability& b) {
  double worst = 0.0;
  for (std::size_t i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) worst = std::max(worst, std::abs(a.tensor[i][j] - b.tensor[i][j]));
  return worst / std::abs(b.mean());
}

/// Flow along z between two pressures.
struct Column {
  PoreNetwork network;
  Domain domain;
  SinglePhaseMemory memory{};

  SinglePhaseFlow solve(double low, double high, double viscosity) {
    SinglePhaseProblem problem;
    problem.viscosity = viscosity;
    problem.faces[4] = {FaceCondition::Kind::pressure, low};
    problem.faces[5] = {FaceCondition::Kind::pressure, high};
    return solve_single_phase(network, domain, problem, memory);
  }
  double permeability(double low, double high, double viscosity) {
    const double length = domain.size().z, area = domain.volume() / length;
    return solve(low, high, viscosity).face_inflow[4] * viscosity * length / (area * (low - high));
  }
};

/// Largest relative difference between the flow through a level section and the flow into the column.
double section_error(Column& column) {
  const SinglePhaseFlow flow = column.solve(1e3, 0.0, 1e-3);
  const FlowGraph& graph = column.memory.graph;
  const auto height = [&](int pore) {  // pores without resistance between them are on one side together
    return column.network.pore_centre[to_size(graph.node_pore[to_size(graph.pore_node[to_size(pore)])])].z;
  };
  double worst = 0.0;
  for (int k = 2; k <= 18; ++k) {
    const double level = column.domain.lower.z + 0.05 * k * column.domain.size().z;
    double through = 0.0;
    for (int t = 0; t < column.network.throats(); ++t) {
      const auto [i, j] = column.network.throat_pores[to_size(t)];
      through += flow.throat_flow[to_size(t)] * ((height(j) > level) - (height(i) > level));
    }
    worst = std::max(worst, relative_error(through, flow.face_inflow[4]));
  }
  return worst;
}

}  // namespace

void write_throats(const std::filesystem::path& folder) {
  Csv csv(folder / "throats.csv", "packing,quantity,exact,error");
  for (const LatticeFacts& lattice : testing::lattice_facts()) {
    std::array<double, 6> worst{};
    int throats = 0;
    for_each_throat(lattice.make(2), [&](const ThroatSection& section, const ThroatDomain& domain) {
      if (domain.length < 1e-9) return;  // halves of one pore
      ++throats;
      const double solid = total(domain.solid_area);
      const std::array<std::pair<double, double>, 6> pairs{
          {{section.void_area, lattice.void_area},
           {section.inscribed_radius, lattice.inscribed_radius},
           {domain.length, lattice.length},
           {domain.void_volume, lattice.void_volume},
           {solid, lattice.solid_area},
           {throat_conductance(domain, section.void_area, solid, 1.0), lattice.conductance()}}};
      for (std::size_t k = 0; k < pairs.size(); ++k)
        worst[k] = std::max(worst[k], relative_error(pairs[k].first, pairs[k].second));
    });
    csv.row(lattice.name, "throats of a cubic cell", lattice.throats, relative_error(throats / 8.0, lattice.throats));
    csv.row(lattice.name, "void area of a throat A / R²", lattice.void_area, worst[0]);
    csv.row(lattice.name, "inscribed radius / R", lattice.inscribed_radius, worst[1]);
    csv.row(lattice.name, "length ℓ / R", lattice.length, worst[2]);
    csv.row(lattice.name, "void of its domain V / R³", lattice.void_volume, worst[3]);
    csv.row(lattice.name, "surface of its domain Γ / R²", lattice.solid_area, worst[4]);
    csv.row(lattice.name, "conductance g / R³", lattice.conductance(), worst[5]);
  }
  const Spheres s = testing::random_spheres(500, 5.0, {1, 1, 1}, {true, true, true}, 3, 0.35);
  double space = 0.0, surface = 0.0, grains = 0.0;
  for_each_throat(s, [&](const ThroatSection&, const ThroatDomain& domain) {
    space += domain.void_volume;
    surface += total(domain.solid_area);
  });
  for (const double r : s.radius) grains += 4.0 * std::numbers::pi * r * r;
  csv.row("500 random grains 1 : 5", "sum of V / void", 1.0, relative_error(space, porosity_of(s) * s.domain.volume()));
  csv.row("500 random grains 1 : 5", "sum of Γ / surface of the grains", 1.0, relative_error(surface, grains));
}

void write_lattices(const std::filesystem::path& folder) {
  Csv csv(folder / "lattices.csv", "packing,porosity,exact,ours,error,off_diagonal,stokes,kozeny_carman");
  for (const LatticeFacts& lattice : testing::lattice_facts()) {
    const Spheres s = lattice.make(2);
    const Permeability k = permeability_of(s);
    double error = 0.0, off = 0.0;
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 3; ++b) {
        const double value = k.tensor[to_size(a)][b];
        (a == b ? error : off) = std::max(a == b ? error : off, a == b ? relative_error(value, lattice.permeability())
                                                                       : std::abs(value) / lattice.permeability());
      }
    csv.row(lattice.name, porosity_of(s), lattice.permeability(), k.mean(), error, off, lattice.stokes_permeability(),
            kozeny_carman_of(s));
  }
}

void write_random_packings(const std::filesystem::path& folder) {
  Csv csv(folder / "random.csv", "boundary,grains,seed,porosity,ratio,xx,yy,zz,yz,xz,xy,imbalance");
  for (const bool is_periodic : {true, false})
    for (const auto& [grains, packings] : {std::pair{250, 10}, {1000, 10}, {4000, 5}})
      for (int seed = 1; seed <= packings; ++seed) {
        const Spheres s = dense_packing(grains, {1, 1, 1}, {is_periodic, is_periodic, is_periodic}, seed);
        const Permeability k = permeability_of(s);
        const auto& t = k.tensor;
        const double mean = k.mean();
        csv.row(is_periodic ? "periodic" : "walls", grains, seed, porosity_of(s), mean / kozeny_carman_of(s), t[0].x / mean,
                t[1].y / mean, t[2].z / mean, 0.5 * (t[1].z + t[2].y) / mean, 0.5 * (t[0].z + t[2].x) / mean,
                0.5 * (t[0].y + t[1].x) / mean, k.imbalance);
      }
}

void write_columns(const std::filesystem::path& folder) {
  Csv csv(folder / "columns.csv", "grains,seed,pores,height,l2,largest,flux_error,section_error,imbalance,carried");
  Csv profile(folder / "column_profiles.csv", "grains,height,pressure");
  for (const auto& [grains, columns] : {std::pair{250, 8}, {1000, 6}, {4000, 3}, {16000, 1}})
    for (int seed = 1; seed <= columns; ++seed) {
      const Spheres s = dense_packing(grains, {1, 1, 2}, {true, true, false}, seed);
      Column column{tetrahedra_of(s), s.domain};
      const SinglePhaseFlow flow = column.solve(1.0, 0.0, 1e-3);
      double squares = 0.0, largest = 0.0;
      const int pores = column.network.pores(), stride = std::max(1, pores / 1500);
      for (int p = 0; p < pores; ++p) {
        const double height = (column.network.pore_centre[to_size(p)].z - s.domain.lower.z) / s.domain.size().z;
        const double difference = flow.pressure[to_size(p)] - (1.0 - height);
        squares += difference * difference;
        largest = std::max(largest, std::abs(difference));
        if (seed == 1 && p % stride == 0) profile.row(grains, height, flow.pressure[to_size(p)]);
      }
      csv.row(grains, seed, pores, s.domain.size().z / (2.0 * statistics_of(s.radius).sauter_radius), std::sqrt(squares / pores),
              largest, relative_error(-flow.face_inflow[5], flow.face_inflow[4]), section_error(column), flow.imbalance,
              flow.carried);
    }
}

void write_invariances(const std::filesystem::path& folder) {
  Csv csv(folder / "invariances.csv", "what,difference");
  const Spheres s = dense_packing(1000, {1, 1, 1}, {true, true, false}, 1);
  const Permeability k = permeability_of(s);

  Column column{tetrahedra_of(s), s.domain};
  const double reference = column.permeability(1.0, 0.0, 1e-3);
  double worst = 0.0;
  for (const double drop : {1e-6, 1e-3, 1e3, 1e6})
    worst = std::max(worst, relative_error(column.permeability(drop, 0.0, 1e-3), reference));
  csv.row("pressure drop of 1e-6 to 1e6 Pa", worst);
  csv.row("flow the other way", relative_error(column.permeability(0.0, 1.0, 1e-3), reference));
  csv.row("1 Pa at a pressure of 100 kPa", relative_error(column.permeability(100001.0, 1e5, 1e-3), reference));
  csv.row("viscosity of 1e-6 and of 1e3 Pa s", std::max(relative_error(column.permeability(1.0, 0.0, 1e-6), reference),
                                                        relative_error(column.permeability(1.0, 0.0, 1e3), reference)));
  csv.row("flow through 17 level sections", section_error(column));

  for (const double unit : {1e3, 1e-3}) {
    Permeability other = permeability_of(scaled(s, unit));
    for (Vec3& row : other.tensor) row = row / (unit * unit);
    csv.row(unit > 1.0 ? "lengths 1000 times as large (k / 1000²)" : "lengths 1000 times as small (k · 1000²)",
            largest_difference(other, k));
  }
  csv.row("another order of the grains", largest_difference(permeability_of(shuffled(s, 7)), k));

  const Spheres cube = testing::random_spheres(200, 2.0, {1, 1, 1}, {true, true, true}, 2, 0.35);
  const Permeability upright = permeability_of(cube), oblique = permeability_of(testing::rotated_packing(cube));
  double turned = 0.0;
  for (const Vec3& gradient : {Vec3{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}) {
    const auto flux = [](const Permeability& of, const Vec3& g) {
      return Vec3{dot(of.tensor[0], g), dot(of.tensor[1], g), dot(of.tensor[2], g)};
    };
    const Vec3 difference = flux(oblique, testing::rotated(gradient)) - testing::rotated(flux(upright, gradient));
    turned = std::max(turned, norm(difference) / upright.mean());
  }
  csv.row("packing turned by 36.87° (in a turned box of 25 images)", turned);

  set_threads(1);
  const Permeability one = permeability_of(s);
  set_threads(2);
  const Permeability two = permeability_of(s);
  set_threads(0);
  csv.row("1 and 2 threads (bits)", one.tensor == two.tensor ? 0.0 : largest_difference(one, two));
}

}  // namespace puadem::verification
