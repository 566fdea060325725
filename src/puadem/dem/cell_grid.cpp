#include "puadem/dem/cell_grid.hpp"

#include <algorithm>
#include <limits>

#include "puadem/base/parallel.hpp"

namespace puadem {

CellGrid make_cell_grid(std::span<const Lanes> place, double width) {
  CellGrid grid;
  constexpr double huge = std::numeric_limits<double>::max();
  Vec3 low{huge, huge, huge}, high{-huge, -huge, -huge};
  for (const Lanes& p : place)
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], p[axis]);
      high[axis] = std::max(high[axis], p[axis]);
    }
  if (place.empty()) low = high = Vec3{};
  grid.origin = low;
  grid.width = width;
  const auto cells = [&] {
    return ((high.x - low.x) / grid.width + 1.0) * ((high.y - low.y) / grid.width + 1.0) * ((high.z - low.z) / grid.width + 1.0);
  };
  while (cells() > 4.0 * static_cast<double>(place.size()) + 64.0) grid.width *= 1.25;
  grid.nx = static_cast<int>((high.x - low.x) / grid.width) + 1;
  grid.ny = static_cast<int>((high.y - low.y) / grid.width) + 1;
  grid.nz = static_cast<int>((high.z - low.z) / grid.width) + 1;

  const int n = size_of(place);
  std::vector<int> cell(to_size(n));
  grid.start.assign(to_size(grid.nx) * to_size(grid.ny) * to_size(grid.nz) + 1, 0);
  for (int k = 0; k < n; ++k) {
    const Lanes& p = place[to_size(k)];
    cell[to_size(k)] = grid.index(grid.cell_x(p[0]), grid.cell_y(p[1]), grid.cell_z(p[2]));
    ++grid.start[to_size(cell[to_size(k)]) + 1];
  }
  for (std::size_t c = 1; c < grid.start.size(); ++c) grid.start[c] += grid.start[c - 1];
  std::vector<int> next(grid.start.begin(), grid.start.end() - 1);
  grid.sphere.resize(to_size(n));
  grid.place.resize(to_size(n));
  for (int k = 0; k < n; ++k) {
    const std::size_t e = to_size(next[to_size(cell[to_size(k)])]++);
    grid.sphere[e] = k;
    grid.place[e] = place[to_size(k)];
  }
  return grid;
}

}  // namespace puadem
