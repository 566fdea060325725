#include "puadem/network/grain_overlaps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <tuple>
#include <vector>

#include "puadem/geometry/packing_sites.hpp"

namespace puadem {

namespace {

using Shift = std::array<std::int8_t, 3>;

/// Two grains, the second one moved by whole periods.
struct Pair {
  int first, second;
  Shift shift;
  auto operator<=>(const Pair&) const = default;
};

Pair pair_of(const Vertex& a, const Vertex& b) {
  Pair pair{a.index, b.index, {}};
  for (std::size_t k = 0; k < 3; ++k) pair.shift[k] = static_cast<std::int8_t>(b.shift[k] - a.shift[k]);
  const Shift back{static_cast<std::int8_t>(-pair.shift[0]), static_cast<std::int8_t>(-pair.shift[1]),
                   static_cast<std::int8_t>(-pair.shift[2])};
  return std::min(pair, Pair{b.index, a.index, back});
}

/// Volume that two spheres share, neither inside the other.
double lens_volume(double r, double s, double distance) {
  const double overlap = r + s - distance, difference = r - s;
  return std::numbers::pi * overlap * overlap * (distance * distance + 2.0 * distance * (r + s) - 3.0 * difference * difference) /
         (12.0 * distance);
}

}  // namespace

GrainOverlaps find_overlaps(const Triangulation& triangulation, std::span<const Vec3> centre, std::span<const double> radius,
                            const Domain& domain) {
  const PackingSites sites_of(centre, radius, domain);
  std::vector<Pair> pairs;
  for (const auto& cell : triangulation.vertices)
    for (std::size_t a = 0; a < cell.size(); ++a)
      for (std::size_t b = a + 1; b < cell.size(); ++b) {
        if (cell[a].is_wall() || cell[b].is_wall()) continue;
        const Site s = sites_of(cell[a]), t = sites_of(cell[b]);
        if (norm(s.centre - t.centre) < s.radius + t.radius) pairs.push_back(pair_of(cell[a], cell[b]));
      }
  std::ranges::sort(pairs);
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());

  GrainOverlaps overlaps;
  for (const auto& [i, j, shift] : pairs) {
    const Vec3 from = centre[to_size(i)], way = centre[to_size(j)] + sites_of.translation(shift) - from;
    const double r = radius[to_size(i)], s = radius[to_size(j)], distance = norm(way), depth = r + s - distance;
    overlaps.volume += lens_volume(r, s, distance);
    const double share = depth / std::min(r, s);
    if (share <= overlaps.deepest) continue;
    overlaps.deepest = share;
    overlaps.first = i;
    overlaps.second = j;
    overlaps.place = from + (r - 0.5 * depth) / distance * way;
  }
  return overlaps;
}

std::string deepest_in_words(const GrainOverlaps& overlaps) {
  const Vec3& p = overlaps.place;
  return fmt::format("the deepest is that of grains {} and {} at ({:g}, {:g}, {:g}) m, {:.2g} % of the smaller radius",
                     overlaps.first, overlaps.second, p.x, p.y, p.z, 100.0 * overlaps.deepest);
}

}  // namespace puadem
