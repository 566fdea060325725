#include "puadem/dem/placed_grains.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "puadem/base/parallel.hpp"

namespace puadem {

namespace {

/// Level whose cells are at least as wide as the grain, and less than twice that where the box allows.
int level_of(double widest, double r) {
  int level = 0;
  for (double width = widest; 0.5 * width >= 2.0 * r; width *= 0.5) ++level;
  return level;
}

int cell_along(const PlacedGrains& p, const PlacedGrains::Level& level, double x, int axis) {
  return static_cast<int>(std::floor((x - p.box.lower[axis]) / p.box.size()[axis] * level.cells[to_size(axis)]));
}

std::size_t bucket_of(const PlacedGrains& p, int level, int i, int j, int k) {
  std::uint64_t h = static_cast<std::uint64_t>(level);
  for (const int n : {i, j, k}) h = (h ^ static_cast<std::uint64_t>(n)) * 0x9e3779b97f4a7c15ULL;
  return static_cast<std::size_t>((h >> 32) & (p.bucket.size() - 1));
}

/// Cells between two, a cell of a periodic axis once only; none beyond a wall.
struct Range {
  int begin, end, cells;
  bool periodic;
  int wrapped(int c) const { return periodic ? (c % cells + cells) % cells : c; }
};
Range range_of(const PlacedGrains& p, const PlacedGrains::Level& level, double x, double reach, int axis) {
  const int cells = level.cells[to_size(axis)];
  const int low = cell_along(p, level, x - reach, axis), high = cell_along(p, level, x + reach, axis) + 1;
  if (p.box.periodic[to_size(axis)]) return {low, std::min(high, low + cells), cells, true};
  return {std::clamp(low, 0, cells - 1), std::clamp(high, 1, cells), cells, false};
}

bool touches(const PlacedGrains& p, int other, const Vec3& x, double r) {
  const Vec3 size = p.box.size();
  Vec3 d = p.position[to_size(other)] - x;
  for (int axis = 0; axis < 3; ++axis)
    if (p.box.periodic[to_size(axis)]) d[axis] -= size[axis] * std::round(d[axis] / size[axis]);
  const double reach = r + p.radius[to_size(other)];
  return squared_norm(d) < reach * reach;
}

}  // namespace

PlacedGrains empty_box(const Domain& box, const std::vector<double>& radius) {
  const auto [least, most] = std::minmax_element(radius.begin(), radius.end());
  PlacedGrains p;
  p.box = box;
  p.radius = radius;
  p.position.resize(radius.size());
  p.widest = 2.0 * *most;
  double width = p.widest;
  for (int level = 0; level <= level_of(p.widest, *least); ++level, width *= 0.5) {
    PlacedGrains::Level& l = p.levels.emplace_back();
    for (int axis = 0; axis < 3; ++axis) l.cells[to_size(axis)] = std::max(1, static_cast<int>(box.size()[axis] / width));
  }
  std::size_t buckets = 1;
  while (buckets < 2 * radius.size()) buckets *= 2;
  p.bucket.assign(buckets, -1);
  p.next.assign(radius.size(), -1);
  return p;
}

bool is_free(const PlacedGrains& p, const Vec3& x, double r) {
  for (int level = 0; level < size_of(p.levels); ++level) {
    const PlacedGrains::Level& l = p.levels[to_size(level)];
    if (l.largest == 0.0) continue;
    const double reach = r + l.largest;
    const Range along_x = range_of(p, l, x.x, reach, 0), along_y = range_of(p, l, x.y, reach, 1),
                along_z = range_of(p, l, x.z, reach, 2);
    for (int k = along_z.begin; k < along_z.end; ++k)
      for (int j = along_y.begin; j < along_y.end; ++j)
        for (int i = along_x.begin; i < along_x.end; ++i) {
          const std::size_t bucket = bucket_of(p, level, along_x.wrapped(i), along_y.wrapped(j), along_z.wrapped(k));
          for (int other = p.bucket[bucket]; other >= 0; other = p.next[to_size(other)])
            if (touches(p, other, x, r)) return false;
        }
  }
  return true;
}

void place(PlacedGrains& p, int grain, const Vec3& x) {
  const double r = p.radius[to_size(grain)];
  const int level = level_of(p.widest, r);
  PlacedGrains::Level& l = p.levels[to_size(level)];
  l.largest = std::max(l.largest, r);
  std::array<int, 3> cell;
  for (int axis = 0; axis < 3; ++axis)
    cell[to_size(axis)] = std::clamp(cell_along(p, l, x[axis], axis), 0, l.cells[to_size(axis)] - 1);
  const std::size_t bucket = bucket_of(p, level, cell[0], cell[1], cell[2]);
  p.position[to_size(grain)] = x;
  p.next[to_size(grain)] = p.bucket[bucket];
  p.bucket[bucket] = grain;
}

}  // namespace puadem
