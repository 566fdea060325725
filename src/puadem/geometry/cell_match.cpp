#include "puadem/geometry/cell_match.hpp"

#include <algorithm>
#include <array>
#include <cassert>

#include "puadem/base/compensated_sum.hpp"
#include "puadem/base/disjoint_sets.hpp"

namespace puadem {

namespace {

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

void list_facets(const Triangulation& triangulation, const std::vector<int>& cells, int first, std::vector<FacetKey>& facets) {
  for (int k = 0; k < size_of(cells); ++k)
    for (unsigned opposite = 0; opposite < 4; ++opposite)
      facets.push_back({frameless(triangulation.vertices[to_size(cells[to_size(k)])], opposite), first + k});
}

}  // namespace

CellMatch match_cells(const Triangulation& before, const Triangulation& now) {
  CellMatch match;
  match.before.assign(to_size(now.cells()), -1);
  std::vector<int> gone, come;
  int b = 0;
  for (int n = 0; n < now.cells(); ++n) {  // both ascend by vertices
    for (; b < before.cells() && before.vertices[to_size(b)] < now.vertices[to_size(n)]; ++b) gone.push_back(b);
    if (b < before.cells() && before.vertices[to_size(b)] == now.vertices[to_size(n)])
      match.before[to_size(n)] = b++;
    else
      come.push_back(n);
  }
  for (; b < before.cells(); ++b) gone.push_back(b);

  std::vector<FacetKey> facets;
  list_facets(now, come, 0, facets);
  list_facets(before, gone, size_of(come), facets);
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
  const auto rows = [&](const std::vector<int>& row_of, const std::vector<int>& cells) {
    Csr csr = rows_from(row_of, cavities);
    for (int& entry : csr.index) entry = cells[to_size(entry)];
    return csr;
  };
  match.appeared = rows(row_come, come);
  match.vanished = rows(row_gone, gone);
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

std::vector<std::int8_t> cell_orientations(const Triangulation& triangulation, const PackingSites& sites_of) {
  std::vector<std::int8_t> sign(to_size(triangulation.cells()));
  parallel_for(triangulation.cells(), [&](int c) {
    const auto sites = sites_of(triangulation.vertices[to_size(c)]);
    const std::size_t k = first_grain(sites);
    const double volume = triple(edge_from(sites[k], sites[(k + 1) % 4]), edge_from(sites[k], sites[(k + 2) % 4]),
                                 edge_from(sites[k], sites[(k + 3) % 4]));
    sign[to_size(c)] = static_cast<std::int8_t>((volume > 0.0) - (volume < 0.0));
  });
  return sign;
}

}  // namespace puadem
