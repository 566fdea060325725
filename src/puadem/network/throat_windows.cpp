#include "puadem/network/throat_windows.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <set>

namespace puadem {

namespace {

using Shift = std::array<std::int8_t, 3>;
using Edge = std::array<Vertex, 2>;  // ascending

Edge edge_of(const std::array<Vertex, 3>& facet, std::size_t k) {
  const Vertex &a = facet[k], &b = facet[(k + 1) % 3];
  return a < b ? Edge{a, b} : Edge{b, a};
}

/// Grains and walls of a throat as its first pore sees them: in that pore's frame.
std::array<Vertex, 3> vertices_in_pore(const PoreNetwork& network, int t) {
  const int cell = network.throat_facet[to_size(t)].cell;
  Shift move = network.tetrahedron_shift[to_size(cell)];
  if (network.tetrahedron_pore[to_size(cell)] != network.throat_pores[to_size(t)][0])
    for (std::size_t k = 0; k < 3; ++k) move[k] = static_cast<std::int8_t>(move[k] + network.throat_shift[to_size(t)][k]);
  auto vertices = network.throat_vertices(t);
  for (Vertex& v : vertices)
    if (!v.is_wall())
      for (std::size_t k = 0; k < 3; ++k) v.shift[k] = static_cast<std::int8_t>(v.shift[k] + move[k]);
  return vertices;
}

/// Throats that share edges and face nearly the same way, beginning with the first of `rest`; they leave it.
std::vector<int> take_flat_part(const PoreNetwork& network, const std::map<int, std::array<Vertex, 3>>& vertices,
                                std::vector<int>& rest) {
  constexpr double flat = 0.9;  // cosine between normals of neighbours
  std::vector<int> part{rest.front()};
  rest.erase(rest.begin());
  for (std::size_t k = 0; k < part.size(); ++k)
    for (std::size_t r = 0; r < rest.size();) {
      const auto &a = vertices.at(part[k]), &b = vertices.at(rest[r]);
      int shared = 0;
      for (const Vertex& v : a) shared += static_cast<int>(std::ranges::count(b, v));
      if (shared == 2 && dot(network.throat_normal[to_size(part[k])], network.throat_normal[to_size(rest[r])]) > flat) {
        part.push_back(rest[r]);
        rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(r));
      } else {
        ++r;
      }
    }
  return part;
}

/// Outline of facets as one ring, in order; none where they leave a hole, touch in a point or enclose a vertex.
std::optional<std::vector<Vertex>> find_ring(const std::vector<std::array<Vertex, 3>>& facets) {
  std::map<Edge, int> count;
  std::set<Vertex> inside;
  for (const auto& facet : facets) {
    inside.insert(facet.begin(), facet.end());
    for (std::size_t k = 0; k < 3; ++k) ++count[edge_of(facet, k)];
  }
  std::map<Vertex, std::vector<Vertex>> next;
  for (const auto& [edge, times] : count) {
    if (times > 2) return std::nullopt;
    if (times == 2) continue;
    next[edge[0]].push_back(edge[1]);
    next[edge[1]].push_back(edge[0]);
  }
  for (const auto& [vertex, ways] : next)
    if (ways.size() != 2) return std::nullopt;
  std::vector<Vertex> ring{next.begin()->first, next.begin()->second[0]};
  for (;;) {
    const auto& ways = next.at(ring.back());
    const Vertex& to = ways[0] == ring[ring.size() - 2] ? ways[1] : ways[0];
    if (to == ring.front()) break;
    ring.push_back(to);
  }
  const bool is_whole = ring.size() == next.size() && ring.size() == inside.size();
  if (!is_whole || ring.size() > static_cast<std::size_t>(ThroatSection::max_sides)) return std::nullopt;
  return ring;
}

/// Section of a window, put together from those of its facets.
ThroatSection window_section(const std::vector<Vertex>& ring, const std::vector<std::array<Vertex, 3>>& facets,
                             const PackingSites& sites_of) {
  ThroatSection window;
  window.sides = size_of(ring);
  const auto n = ring.size();
  for (std::size_t k = 0; k < n; ++k) {
    const Site site = sites_of(ring[k]);
    window.side[k] = {site.is_wall, site.radius, 0.0};
  }
  for (const auto& facet : facets) {
    const ThroatSection section = throat_section(sites_of(facet));
    window.facet_area += section.facet_area;
    window.void_area += section.void_area;
    for (std::size_t k = 0; k < n; ++k)
      for (std::size_t v = 0; v < 3; ++v) {
        if (facet[v] != ring[k]) continue;
        window.side[k].extent += section.side[v].extent;
        if (facet[(v + 1) % 3] == ring[(k + 1) % n]) window.crevice[k] = section.crevice[v];
        if (facet[(v + 2) % 3] == ring[(k + 1) % n]) window.crevice[k] = section.crevice[(v + 2) % 3];
      }
  }
  // Of the circles between three of the ring the smallest meets no other, as in grain_window_section.
  window.inscribed_radius = std::numeric_limits<double>::infinity();
  for (std::size_t a = 0; a < n; ++a)
    for (std::size_t b = a + 1; b < n; ++b)
      for (std::size_t c = b + 1; c < n; ++c)
        if (!(ring[a].is_wall() && ring[b].is_wall() && ring[c].is_wall()))
          window.inscribed_radius =
              std::min(window.inscribed_radius, inscribed_circle_radius(sites_of(std::array{ring[a], ring[b], ring[c]})));
  return window;
}

void set_radii(PoreNetwork& network, const std::vector<int>& throats, const ThroatSection& window,
               const NetworkOptions& options) {
  const Entry entry = std::visit([&](const auto& law) { return law.entry(window, options.contact_angle); }, options.entry_law);
  const double snap_off = snap_off_radius(window, options.contact_angle);
  for (const int t : throats) {
    network.throat_entry_radius[to_size(t)] = entry.radius;
    network.throat_entry_kind[to_size(t)] = entry.kind;
    network.throat_snap_off_radius[to_size(t)] = snap_off;
    network.throat_radius[to_size(t)] = window.inscribed_radius;
  }
}

}  // namespace

void set_window_radii(PoreNetwork& network, const PackingSites& sites_of, const NetworkOptions& options) {
  network.windows = 0;
  std::vector<int> order(to_size(network.throats()));
  std::iota(order.begin(), order.end(), 0);
  const auto key = [&](int t) { return std::pair(network.throat_pores[to_size(t)], network.throat_shift[to_size(t)]); };
  std::ranges::stable_sort(order, {}, key);
  for (std::size_t first = 0, last = 0; first < order.size(); first = last) {
    while (last < order.size() && key(order[last]) == key(order[first])) ++last;
    std::vector<int> rest(order.begin() + static_cast<std::ptrdiff_t>(first), order.begin() + static_cast<std::ptrdiff_t>(last));
    std::map<int, std::array<Vertex, 3>> vertices;
    for (const int t : rest) vertices[t] = vertices_in_pore(network, t);
    while (rest.size() > 1) {
      const std::vector<int> part = take_flat_part(network, vertices, rest);
      if (part.size() < 2) continue;
      std::vector<std::array<Vertex, 3>> facets;
      for (const int t : part) facets.push_back(vertices.at(t));
      const auto ring = find_ring(facets);
      if (!ring) continue;
      set_radii(network, part, window_section(*ring, facets, sites_of), options);
      ++network.windows;
    }
  }
}

}  // namespace puadem
