#include "puadem/dem/cell_grid.hpp"

#include <algorithm>
#include <limits>

#include "puadem/base/parallel.hpp"

namespace puadem {

CellGrid make_cell_grid(std::span<const Lanes> place, std::span<const int> sphere, double width) {
  CellGrid grid;
  constexpr double huge = std::numeric_limits<double>::max();
  Vec3 low{huge, huge, huge}, high{-huge, -huge, -huge};
  for (const int k : sphere)
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], place[to_size(k)][axis]);
      high[axis] = std::max(high[axis], place[to_size(k)][axis]);
    }
  if (sphere.empty()) low = high = Vec3{};
  grid.origin = low;
  grid.width = width;
  const auto cells = [&] {
    return ((high.x - low.x) / grid.width + 1.0) * ((high.y - low.y) / grid.width + 1.0) * ((high.z - low.z) / grid.width + 1.0);
  };
  while (cells() > 4.0 * static_cast<double>(sphere.size()) + 64.0) grid.width *= 1.25;
  grid.nx = static_cast<int>((high.x - low.x) / grid.width) + 1;
  grid.ny = static_cast<int>((high.y - low.y) / grid.width) + 1;
  grid.nz = static_cast<int>((high.z - low.z) / grid.width) + 1;

  const auto cell_of = [&](int k) {
    const Lanes& p = place[to_size(k)];
    return grid.index(grid.cell_x(p[0]), grid.cell_y(p[1]), grid.cell_z(p[2]));
  };
  grid.start.assign(to_size(grid.nx) * to_size(grid.ny) * to_size(grid.nz) + 1, 0);
  for (const int k : sphere) ++grid.start[to_size(cell_of(k)) + 1];
  for (std::size_t c = 1; c < grid.start.size(); ++c) grid.start[c] += grid.start[c - 1];
  std::vector<int> next(grid.start.begin(), grid.start.end() - 1);
  grid.sphere.resize(sphere.size());
  grid.place.resize(sphere.size());
  for (const int k : sphere) {
    const std::size_t e = to_size(next[to_size(cell_of(k))]++);
    grid.sphere[e] = k;
    grid.place[e] = place[to_size(k)];
  }
  return grid;
}

SizedGrids make_sized_grids(std::span<const Lanes> place, double margin) {
  double largest = 0.0;
  for (const Lanes& p : place) largest = std::max(largest, p[3]);
  std::vector<std::vector<int>> members;
  for (int k = 0; k < size_of(place); ++k) {
    const double radius = place[to_size(k)][3];
    int halvings = 0;
    for (double bound = 0.5 * largest; radius <= bound; bound *= 0.5) ++halvings;
    if (halvings >= size_of(members)) members.resize(to_size(halvings + 1));
    members[to_size(halvings)].push_back(k);
  }
  SizedGrids grids;
  grids.level.resize(place.size());
  double bound = largest;  // of the radii of a level
  for (const std::vector<int>& level : members) {
    if (!level.empty()) {
      for (const int k : level) grids.level[to_size(k)] = size_of(grids.grid);
      grids.grid.push_back(make_cell_grid(place, level, 2.0 * bound + margin));
    }
    bound *= 0.5;
  }
  return grids;
}

}  // namespace puadem
