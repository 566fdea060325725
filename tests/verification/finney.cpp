#include "finney.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>
#include <string>

#include "puadem/geometry/cell.hpp"
#include "puadem/geometry/corner_meniscus.hpp"
#include "puadem/geometry/facets.hpp"
#include "puadem/geometry/packing_sites.hpp"
#include "puadem/geometry/throat_section.hpp"
#include "puadem/network/pore_units.hpp"

namespace puadem::verification {

namespace {

constexpr double region = 14.0, core = 10.0, cap = 7.0;  // radii of a ball
constexpr std::uint8_t at_bottom = 1 << 4, at_top = 1 << 5;

/// Tension of a front less the pressure on it, at radius r of curvature, with arcs where they fit.
double excess(const ThroatSection& section, double r) {
  double area = section.void_area, length = section.solid_perimeter();
  for (int k = 0; k < section.sides; ++k) {
    if (section.crevice[to_size(k)].gap >= 2.0 * r) continue;
    const CornerMeniscus arc = corner_meniscus(section, k, r, 0.0);
    area -= arc.area;
    length += r * arc.angle - arc.wetted_first - arc.wetted_next;
  }
  return length - area / r;
}

/// @param widest  half the widest gap: above it all arcs fit and the front is not in balance
double entry_with_fitting_menisci(const ThroatSection& section, double widest) {
  double last = widest;
  while (last > 0.0) {  // the excess jumps where an arc ceases to fit: look step by step
    double r = last - 0.01 * section.inscribed_radius;
    if (r > 0.0 && excess(section, r) > 0.0) {
      last = r;
      continue;
    }
    r = std::max(r, 0.0);
    for (int n = 0; n < 30; ++n) {
      const double middle = 0.5 * (r + last);
      (excess(section, middle) > 0.0 ? last : r) = middle;
    }
    return r;
  }
  return 0.0;
}

}  // namespace

void enter_with_fitting_menisci(const FinneyPacking& packing, PoreNetwork& network) {
  const PackingSites sites_of(packing.centre, packing.radius, packing.box);
  parallel_for(network.throats(), [&](int t) {
    double& radius = network.throat_entry_radius[to_size(t)];
    if (network.throat_entry_kind[to_size(t)] != EntryKind::half_gap || radius == 0.0) return;
    radius = entry_with_fitting_menisci(throat_section(sites_of(network.throat_vertices(t))), radius);
  });
}

double percentile(std::vector<double> values, int percent) {
  std::ranges::sort(values);
  return values[values.size() * to_size(percent) / 100];
}

FinneyPacking read_finney_packing(const std::filesystem::path& folder) {
  FinneyPacking packing;
  std::ifstream file(folder / "finney_packing_4021.csv");
  for (std::string line; std::getline(file, line);) {
    std::ranges::replace(line, ',', ' ');
    std::istringstream row(line);
    int id = 0;
    if (Vec3 c; row >> id >> c.x >> c.y >> c.z) packing.centre.push_back(c);
  }
  if (packing.centre.empty()) return packing;
  packing.radius.assign(packing.centre.size(), 1.0);
  packing.box = {packing.centre[0], packing.centre[0], {false, false, false}};
  for (const Vec3& c : packing.centre) {
    packing.middle += c / static_cast<double>(packing.centre.size());
    for (int axis = 0; axis < 3; ++axis) {
      packing.box.lower[axis] = std::min(packing.box.lower[axis], c[axis] - 1.5);
      packing.box.upper[axis] = std::max(packing.box.upper[axis], c[axis] + 1.5);
    }
  }
  return packing;
}

FinneyRadii inscribed_radii(const FinneyPacking& packing) {
  const Triangulation triangulation = triangulate(packing.centre, packing.radius, packing.box);
  const PackingSites sites_of(packing.centre, packing.radius, packing.box);
  const auto is_inside = [&](const auto& vertices) {
    Vec3 mean;
    for (const Vertex& v : vertices) {
      if (v.is_wall()) return false;
      mean += packing.centre[to_size(v.index)] / static_cast<double>(vertices.size());
    }
    return norm(mean - packing.middle) < region;
  };
  FinneyRadii radii;
  for (const auto& vertices : triangulation.vertices)
    if (is_inside(vertices)) radii.pores.push_back(inscribed_sphere(sites_of(vertices))->radius);
  for (const Facet& facet : find_facets(triangulation))
    if (const auto vertices = facet_vertices(triangulation, facet); is_inside(vertices))
      radii.throats.push_back(inscribed_circle_radius(sites_of(vertices)));
  return radii;
}

FinneyHeap finney_heap(const FinneyPacking& packing, const NetworkOptions& options, HeapReservoirs reservoirs) {
  FinneyHeap heap;
  heap.network = build_pore_network(packing.centre, packing.radius, packing.box, options);
  PoreNetwork& network = heap.network;
  const bool is_around = reservoirs == HeapReservoirs::gas_around;
  for (std::size_t p = 0; p < network.pore_centre.size(); ++p) {
    const Vec3 from_middle = network.pore_centre[p] - packing.middle;
    const bool is_inside = network.pore_walls[p] == 0 && norm(from_middle) < region;
    heap.is_core.push_back(is_inside && norm(from_middle) < core);
    network.pore_walls[p] = is_inside                          ? std::uint8_t{0}
                            : is_around || from_middle.z > cap ? at_top
                            : from_middle.z < -cap             ? at_bottom
                                                               : std::uint8_t{0};
    if (is_inside || network.pore_walls[p] != 0) continue;
    for (const int t : network.pore_throats[static_cast<int>(p)]) network.throat_entry_radius[to_size(t)] = 0.0;  // closed
  }
  if (is_around) {  // a reservoir of water that no throat leads to: with water that is never trapped, all can leave
    network.pore_centre.push_back(packing.middle);
    network.pore_volume.push_back(1.0);
    network.pore_radius.push_back(1.0);
    network.pore_faces.push_back(4);
    network.pore_walls.push_back(at_bottom);
    network.pore_throats = throats_of_pores(network.throat_pores, network.pores());
    heap.is_core.push_back(0);
  }
  return heap;
}

std::vector<double> drain_heap(const FinneyHeap& heap, const InvasionOptions& options, const std::vector<double>& pressures) {
  Fluids fluids;
  fluids.surface_tension = 1.0;
  InvasionState state = start_invasion(heap.network, fluids, options);
  std::vector<double> saturations;
  for (const double pressure : pressures) {
    advance_to(heap.network, pressure, state);
    double water = 0.0, space = 0.0;
    for (std::size_t p = 0; p < heap.is_core.size(); ++p) {
      if (!heap.is_core[p]) continue;
      water += state.wetting_volume[p];
      space += heap.network.pore_volume[p];
    }
    saturations.push_back(water / space);
  }
  return saturations;
}

InvasionOptions plain_percolation() {
  InvasionOptions options;
  options.trap_wetting = false;
  options.corner_water = false;
  options.body_entry = false;
  return options;
}

std::vector<FinneyDrainage> finney_drainage_reference() {
  return {{4.0, 1.0000, 0.9994},  {4.2, 1.0000, 0.9967},  {4.4, 1.0000, 0.9954},  {4.6, 1.0000, 0.9902},  {4.8, 1.0000, 0.9799},
          {5.0, 1.0000, 0.9530},  {5.2, 1.0000, 0.9106},  {5.4, 1.0000, 0.7177},  {5.6, 0.9967, 0.4817},  {5.8, 0.9963, 0.4288},
          {6.0, 0.9923, 0.3454},  {6.2, 0.9881, 0.2519},  {6.4, 0.9868, 0.2220},  {6.6, 0.9776, 0.1793},  {6.8, 0.9557, 0.1448},
          {7.0, 0.9166, 0.1289},  {7.2, 0.8851, 0.1125},  {7.4, 0.5854, 0.1003},  {7.6, 0.4014, 0.0915},  {7.8, 0.3436, 0.0728},
          {8.0, 0.2917, 0.0624},  {8.2, 0.2249, 0.0519},  {8.4, 0.2003, 0.0445},  {8.6, 0.1612, 0.0388},  {8.8, 0.1389, 0.0326},
          {9.0, 0.0908, 0.0285},  {9.2, 0.0820, 0.0232},  {9.4, 0.0602, 0.0161},  {9.6, 0.0480, 0.0133},  {9.8, 0.0417, 0.0109},
          {10.0, 0.0357, 0.0083}, {10.2, 0.0309, 0.0066}, {10.4, 0.0267, 0.0042}, {10.6, 0.0212, 0.0034}, {10.8, 0.0170, 0.0022},
          {11.0, 0.0128, 0.0013}, {11.2, 0.0109, 0.0007}, {11.4, 0.0087, 0.0000}, {11.6, 0.0067, 0.0000}, {11.8, 0.0049, 0.0000},
          {12.0, 0.0034, 0.0000}, {12.2, 0.0028, 0.0000}, {12.4, 0.0020, 0.0000}, {12.6, 0.0010, 0.0000}, {12.8, 0.0000, 0.0000}};
}

std::vector<FinneyDensities> finney_densities_reference() {
  return {{0.13, 0.0000, 0.0000}, {0.15, 3.9627, 0.0000}, {0.17, 5.4455, 0.0000}, {0.19, 4.1402, 0.0000}, {0.21, 3.3404, 0.0000},
          {0.23, 2.8967, 1.0275}, {0.25, 2.6060, 2.1670}, {0.27, 2.7111, 2.5220}, {0.29, 2.4169, 2.9703}, {0.31, 2.4799, 3.4327},
          {0.33, 2.5558, 3.7923}, {0.35, 2.5255, 4.1939}, {0.37, 2.4110, 4.5815}, {0.39, 2.3982, 4.5815}, {0.41, 2.4215, 4.5956},
          {0.43, 2.0024, 3.8903}, {0.45, 1.5505, 2.8862}, {0.47, 1.1267, 2.2651}, {0.49, 0.9656, 1.9242}, {0.51, 0.7414, 1.6019},
          {0.53, 0.5231, 1.2003}, {0.55, 0.3222, 0.8220}, {0.57, 0.2032, 0.5978}, {0.59, 0.1016, 0.3690}};
}

}  // namespace puadem::verification
