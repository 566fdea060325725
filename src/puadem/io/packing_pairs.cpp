#include <algorithm>
#include <array>
#include <cmath>

#include "puadem/base/csr.hpp"
#include "puadem/io/packing_file.hpp"

namespace puadem {

namespace {

/// Cells of about the mean diameter, at most a few for each sphere.
struct Cells {
  Vec3 lower;
  std::array<int, 3> count{1, 1, 1};
  Vec3 per_length;  // cells per metre

  int along(int axis, double coordinate) const {
    const double cell = std::floor((coordinate - lower[axis]) * per_length[axis]);
    return static_cast<int>(std::clamp(cell, 0.0, static_cast<double>(count[to_size(axis)] - 1)));
  }
  int index(int i, int j, int k) const { return (k * count[1] + j) * count[0] + i; }
};

Cells make_cells(std::span<const double> radius, const Domain& box) {
  double sum = 0.0;
  for (const double r : radius) sum += r;
  const double spheres = static_cast<double>(radius.size());
  // Not finer than four cells a sphere in a box that is nearly empty.
  const double edge = std::max(2.0 * sum / spheres, std::cbrt(box.volume() / (4.0 * spheres)));
  Cells cells;
  cells.lower = box.lower;
  for (int axis = 0; axis < 3; ++axis) {
    const double length = box.size()[axis];
    cells.count[to_size(axis)] = static_cast<int>(std::clamp(std::floor(length / edge), 1.0, 1000.0));
    cells.per_length[axis] = cells.count[to_size(axis)] / length;
  }
  return cells;
}

}  // namespace

std::vector<BadPair> find_bad_pairs(std::span<const Vec3> centre, std::span<const double> radius, const Domain& box) {
  const int spheres = size_of(radius);
  std::vector<BadPair> pairs;
  if (spheres == 0) return pairs;
  const Cells cells = make_cells(radius, box);
  std::vector<int> cell_of(to_size(spheres));
  for (int i = 0; i < spheres; ++i) {
    const Vec3& c = centre[to_size(i)];
    cell_of[to_size(i)] = cells.index(cells.along(0, c.x), cells.along(1, c.y), cells.along(2, c.z));
  }
  const Csr members = rows_from(cell_of, cells.count[0] * cells.count[1] * cells.count[2]);

  // Each sphere looks for partners not larger than itself: they are within its own diameter, so that all
  // searches together visit about the cells that the spheres fill.
  for (int i = 0; i < spheres; ++i) {
    const Vec3 c = centre[to_size(i)];
    const double r = radius[to_size(i)];
    std::array<int, 3> low{}, high{};
    for (int axis = 0; axis < 3; ++axis) {
      low[to_size(axis)] = cells.along(axis, c[axis] - 2.0 * r);
      high[to_size(axis)] = cells.along(axis, c[axis] + 2.0 * r);
    }
    for (int z = low[2]; z <= high[2]; ++z)
      for (int y = low[1]; y <= high[1]; ++y)
        for (int x = low[0]; x <= high[0]; ++x)
          for (const int j : members[cells.index(x, y, z)]) {
            const double s = radius[to_size(j)];
            if (j == i || s > r || (s == r && j < i)) continue;
            const double distance = norm(centre[to_size(j)] - c);
            const double overlap = r + s - distance;
            if (overlap <= 0.5 * s) continue;
            using Kind = BadPair::Kind;
            const Kind kind = distance <= 1e-9 * s ? Kind::same_place : distance + s <= r ? Kind::inside : Kind::deep_overlap;
            pairs.push_back({std::min(i, j), std::max(i, j), kind, overlap});
          }
  }
  std::ranges::sort(
      pairs, [](const BadPair& a, const BadPair& b) { return a.second != b.second ? a.second < b.second : a.first < b.first; });
  return pairs;
}

}  // namespace puadem
