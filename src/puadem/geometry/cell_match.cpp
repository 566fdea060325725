#include "puadem/geometry/cell_match.hpp"

#include <algorithm>
#include <array>
#include <cassert>

#include "puadem/base/compensated_sum.hpp"
#include "puadem/base/disjoint_sets.hpp"

namespace puadem {

namespace {

using Shift = std::array<std::int8_t, 3>;

/// Facet of a cell, by its vertices in the frame of its lowest grain: the same from both sides and in both triangulations.
struct FacetKey {
  std::array<Vertex, 3> vertices;
  int cell;
};

std::array<Vertex, 3> frameless(const std::array<Vertex, 4>& cell, unsigned opposite) {
  std::array<Vertex, 3> facet;
  for (unsigned k = 0, at = 0; k < 4; ++k)
    if (k != opposite) facet[at++] = cell[k];
  std::array<Vertex, 3> best;
  bool found = false;
  int lowest = -1;
  for (const Vertex& v : facet)
    if (!v.is_wall() && (lowest < 0 || v.index < lowest)) lowest = v.index;
  for (const Vertex& origin : facet) {  // a grain may stand there with its own image
    if (origin.index != lowest) continue;
    std::array<Vertex, 3> candidate = facet;
    for (Vertex& v : candidate)
      if (!v.is_wall())
        for (std::size_t a = 0; a < 3; ++a) v.shift[a] = static_cast<std::int8_t>(v.shift[a] - origin.shift[a]);
    std::sort(candidate.begin(), candidate.end());
    if (!found || candidate < best) best = candidate;
    found = true;
  }
  return best;
}

void list_facets(const std::array<Vertex, 4>& vertices, int cell, std::vector<FacetKey>& facets) {
  for (unsigned opposite = 0; opposite < 4; ++opposite) facets.push_back({frameless(vertices, opposite), cell});
}

/// A cell before, as a triangulation of the grains where they stand now would list it.
struct FormerCell {
  std::array<Vertex, 4> vertices;
  Shift shift{};
  int cell = 0;
};

std::vector<FormerCell> former_cells(const Triangulation& before, std::span<const Shift> wraps) {
  std::vector<FormerCell> former;
  former.reserve(to_size(before.cells()));
  for (int c = 0; c < before.cells(); ++c) {
    auto vertices = before.vertices[to_size(c)];
    if (!wraps.empty())
      for (Vertex& v : vertices)
        if (!v.is_wall())
          for (std::size_t a = 0; a < 3; ++a) v.shift[a] = static_cast<std::int8_t>(v.shift[a] + wraps[to_size(v.index)][a]);
    const CanonicalCell listed = canonical(vertices);
    former.push_back({listed.vertices, listed.shift, c});
  }
  std::ranges::sort(former, {}, &FormerCell::vertices);
  return former;
}

}  // namespace

CellMatch match_cells(const Triangulation& before, const Triangulation& now, std::span<const Shift> wraps,
                      std::span<const std::uint8_t> turned) {
  const std::vector<FormerCell> former = former_cells(before, wraps);
  CellMatch match;
  match.before.assign(to_size(now.cells()), -1);
  match.shift.resize(to_size(now.cells()));
  std::vector<int> come;
  std::vector<FormerCell> gone;
  auto b = former.begin();
  for (int n = 0; n < now.cells(); ++n) {  // both ascend by vertices
    const auto& vertices = now.vertices[to_size(n)];
    for (; b != former.end() && b->vertices < vertices; ++b) gone.push_back(*b);
    const bool is_listed = b != former.end() && b->vertices == vertices;
    // A cell that has turned inside out and is listed anew fills the other side of its place: all around it has changed.
    if (is_listed && (turned.empty() || !turned[to_size(b->cell)])) {
      match.before[to_size(n)] = b->cell;
      match.shift[to_size(n)] = b->shift;
      ++b;
    } else {
      come.push_back(n);
    }
  }
  gone.insert(gone.end(), b, former.end());

  std::vector<FacetKey> facets;
  for (int k = 0; k < size_of(come); ++k) list_facets(now.vertices[to_size(come[to_size(k)])], k, facets);
  for (int k = 0; k < size_of(gone); ++k) list_facets(gone[to_size(k)].vertices, size_of(come) + k, facets);
  std::sort(facets.begin(), facets.end(), [](const FacetKey& x, const FacetKey& y) {
    return x.vertices != y.vertices ? x.vertices < y.vertices : x.cell < y.cell;
  });
  DisjointSets joined(size_of(come) + size_of(gone));
  for (std::size_t k = 1; k < facets.size(); ++k)
    if (facets[k].vertices == facets[k - 1].vertices) joined.join(facets[k].cell, facets[k - 1].cell);

  std::vector<int> number(come.size() + gone.size(), -1), row_come, row_gone;
  int cavities = 0;
  for (int k = 0; k < size_of(number); ++k) {
    int& cavity = number[to_size(joined.find(k))];
    if (cavity < 0) cavity = cavities++;
    (k < size_of(come) ? row_come : row_gone).push_back(cavity);
  }
  match.appeared = rows_from(row_come, cavities);
  for (int& entry : match.appeared.index) entry = come[to_size(entry)];
  match.vanished = rows_from(row_gone, cavities);
  for (int& entry : match.vanished.index) entry = gone[to_size(entry)].cell;
  return match;
}

std::vector<double> carry_over(const CellMatch& match, std::span<const double> amount, std::span<const double> space) {
  std::vector<double> result(match.before.size());
  for (std::size_t c = 0; c < result.size(); ++c)
    if (match.before[c] >= 0) result[c] = amount[to_size(match.before[c])];
  for (int cavity = 0; cavity < match.appeared.rows(); ++cavity) {
    CompensatedSum held, room;
    for (const int c : match.vanished[cavity]) held.add(amount[to_size(c)]);
    for (const int c : match.appeared[cavity]) room.add(space[to_size(c)]);
    for (const int c : match.appeared[cavity]) result[to_size(c)] = held.value() / room.value() * space[to_size(c)];
  }
  return result;
}

std::int8_t cell_orientation(const std::array<Site, 4>& sites) {
  const std::size_t k = first_grain(sites);
  const double volume = triple(edge_from(sites[k], sites[(k + 1) % 4]), edge_from(sites[k], sites[(k + 2) % 4]),
                               edge_from(sites[k], sites[(k + 3) % 4]));
  return static_cast<std::int8_t>((volume > 0.0) - (volume < 0.0));
}

std::vector<std::int8_t> cell_orientations(const Triangulation& triangulation, const PackingSites& sites_of) {
  std::vector<std::int8_t> sign(to_size(triangulation.cells()));
  parallel_for(triangulation.cells(),
               [&](int c) { sign[to_size(c)] = cell_orientation(sites_of(triangulation.vertices[to_size(c)])); });
  return sign;
}

}  // namespace puadem
