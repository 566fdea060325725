#include "puadem/network/network_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "puadem/base/compensated_sum.hpp"
#include "puadem/base/disjoint_sets.hpp"

namespace puadem {

namespace {

using Shift = std::array<std::int8_t, 3>;

std::string name(const Vertex& v) {
  return v.is_wall() ? fmt::format("the {} wall", face_names[to_size(v.face())]) : fmt::format("grain {}", v.index);
}

/// "grain 3, grain 8 and the left wall"
template <std::size_t N>
std::string names(const std::array<Vertex, N>& vertices) {
  std::string text;
  for (std::size_t k = 0; k < N; ++k) text += (k == 0 ? "" : k + 1 == N ? " and " : ", ") + name(vertices[k]);
  return text;
}

std::string place(const PoreNetwork& network, int p) {
  std::string text = fmt::format("pore {}", p);
  if (p < size_of(network.pore_centre)) {
    const Vec3& c = network.pore_centre[to_size(p)];
    text += fmt::format(" at ({:g}, {:g}, {:g}) m", c.x, c.y, c.z);
  }
  if (p < network.pore_tetrahedra.rows() && !network.pore_tetrahedra[p].empty())
    text += fmt::format(", among {},", names(network.triangulation.vertices[to_size(network.pore_tetrahedra[p].front())]));
  return text;
}

void check_pores(const PoreNetwork& network, std::vector<std::string>& faults) {
  for (int p = 0; p < network.pores(); ++p) {
    const double v = network.pore_volume[to_size(p)];
    if (!(v > 0.0) || !std::isfinite(v)) faults.push_back(fmt::format("{} has the volume {:g} m3", place(network, p), v));
    if (network.pores() > 1 && network.pore_throats[p].empty())
      faults.push_back(fmt::format("{} has no throat", place(network, p)));
  }
}

void check_throats(const PoreNetwork& network, std::vector<std::string>& faults) {
  std::vector<int> seen(to_size(network.throats()), 0);
  for (int p = 0; p < network.pores(); ++p)
    for (const int t : network.pore_throats[p]) {
      const bool known = t >= 0 && t < network.throats();
      if (known && std::ranges::count(network.throat_pores[to_size(t)], p) > 0)
        ++seen[to_size(t)];
      else
        faults.push_back(fmt::format("{} lists throat {}, which does not lead to it", place(network, p), t));
    }
  for (int t = 0; t < network.throats(); ++t) {
    const auto [i, j] = network.throat_pores[to_size(t)];
    if (i < 0 || i > j || j >= network.pores())
      faults.push_back(fmt::format("throat {} leads from pore {} to pore {} of {}", t, i, j, network.pores()));
    else if (seen[to_size(t)] != (i == j ? 1 : 2))
      faults.push_back(fmt::format("throat {} of {} and pore {} is listed {} times", t, place(network, i), j, seen[to_size(t)]));
  }
}

void check_connectedness(const PoreNetwork& network, std::vector<std::string>& faults) {
  DisjointSets parts(network.pores());
  for (int t = 0; t < network.throats(); ++t)
    if (network.throat_conductance.empty() || network.throat_conductance[to_size(t)] > 0.0)
      parts.join(network.throat_pores[to_size(t)][0], network.throat_pores[to_size(t)][1]);
  std::vector<int> size(to_size(network.pores()), 0);
  for (int p = 0; p < network.pores(); ++p) ++size[to_size(parts.find(p))];
  const auto largest = static_cast<int>(std::ranges::max_element(size) - size.begin());
  for (int p = 0; p < network.pores(); ++p)
    if (size[to_size(p)] > 0 && p != largest)
      faults.push_back(fmt::format("{} and {} more are cut off from the rest of the network: all their throats are closed",
                                   place(network, p), size[to_size(p)] - 1));
}

void check_closure(const PoreNetwork& network, std::span<const double> radius, const Domain& domain,
                   std::vector<std::string>& faults) {
  CompensatedSum sum;
  for (const double v : network.pore_volume) sum.add(v);
  for (const double r : radius) sum.add(4.0 / 3.0 * std::numbers::pi * r * r * r);
  const double error = sum.value() / domain.volume() - 1.0;
  if (!(std::abs(error) <= 1e-12))
    faults.push_back(fmt::format("pores and grains together miss the volume of the box by {:.2e} of it, allowed 1e-12", error));
}

void check_grains(const Triangulation& triangulation, std::span<const Vec3> centre, std::vector<std::string>& faults) {
  std::vector<char> is_vertex(centre.size(), 0);
  for (const auto& cell : triangulation.vertices)
    for (const Vertex& v : cell)
      if (!v.is_wall() && v.index < size_of(centre)) is_vertex[to_size(v.index)] = 1;
  for (int g = 0; g < size_of(centre); ++g) {
    const Vec3& c = centre[to_size(g)];
    if (!is_vertex[to_size(g)])
      faults.push_back(fmt::format("grain {} at ({:g}, {:g}, {:g}) m is hidden: it has no pore around it", g, c.x, c.y, c.z));
  }
}

/// Whether facet (a, k) and its counterpart have the same vertices, moved by `shift`.
bool is_same_facet(const Triangulation& triangulation, int a, int k, int b, int back, const Shift& shift) {
  auto here = facet_vertices(triangulation, {a, b, shift, static_cast<std::int8_t>(k)});
  auto there = facet_vertices(triangulation, {b, a, {}, static_cast<std::int8_t>(back)});
  for (Vertex& v : there)
    if (!v.is_wall())
      for (std::size_t axis = 0; axis < 3; ++axis) v.shift[axis] = static_cast<std::int8_t>(v.shift[axis] + shift[axis]);
  std::ranges::sort(here);
  std::ranges::sort(there);
  return here == there;
}

void check_facets(const PoreNetwork& network, std::vector<std::string>& faults) {
  const Triangulation& triangulation = network.triangulation;
  for (int t = 0; t < triangulation.cells(); ++t)
    for (int k = 0; k < 4; ++k) {
      const auto& [cell, shift] = triangulation.neighbours[to_size(t)][to_size(k)];
      if (cell < 0) continue;
      bool returned = false;
      for (int back = 0; back < 4 && cell < triangulation.cells(); ++back)
        returned = returned || (triangulation.neighbours[to_size(cell)][to_size(back)].cell == t &&
                                is_same_facet(triangulation, t, k, cell, back, shift));
      if (!returned)
        faults.push_back(fmt::format("the facet of {} in {} is not a facet of its neighbour",
                                     names(facet_vertices(triangulation, {t, cell, shift, static_cast<std::int8_t>(k)})),
                                     place(network, network.tetrahedron_pore[to_size(t)])));
    }
}

}  // namespace

std::vector<std::string> find_network_faults(const PoreNetwork& network) {
  std::vector<std::string> faults;
  if (network.pores() == 0) return {"the network has no pores"};
  check_pores(network, faults);
  check_throats(network, faults);
  if (faults.empty()) check_connectedness(network, faults);
  return faults;
}

std::vector<std::string> find_network_faults(const PoreNetwork& network, std::span<const Vec3> centre,
                                             std::span<const double> radius, const Domain& domain) {
  std::vector<std::string> faults = find_network_faults(network);
  check_closure(network, radius, domain, faults);
  check_grains(network.triangulation, centre, faults);
  check_facets(network, faults);
  return faults;
}

}  // namespace puadem
