#pragma once

#include <span>
#include <vector>

#include "puadem/base/large_array.hpp"
#include "puadem/base/parallel.hpp"
#include "puadem/base/vec3.hpp"
#include "puadem/dem/lanes.hpp"

namespace puadem {

/// Spheres sorted into cubic cells. Two spheres closer than the cell width lie in neighbouring cells.
struct CellGrid {
  Vec3 origin;
  double width = 0.0;  ///< [m]
  int nx = 0, ny = 0, nz = 0;
  std::vector<int> start;   ///< spheres of cell c: [start[c], start[c + 1])
  std::vector<int> sphere;  ///< by number, ascending within a cell
  LargeArray<Lanes> place;  ///< of those spheres: x, y, z, radius

  int cell_along(double x, double low, int n) const {
    const int c = static_cast<int>((x - low) / width);
    return c < 0 ? 0 : c >= n ? n - 1 : c;
  }
  int cell_x(double x) const { return cell_along(x, origin.x, nx); }
  int cell_y(double y) const { return cell_along(y, origin.y, ny); }
  int cell_z(double z) const { return cell_along(z, origin.z, nz); }
  int index(int i, int j, int k) const { return (k * ny + j) * nx + i; }
};

/// @param place   x, y, z, radius of every sphere
/// @param sphere  which of them to sort in
/// @param width   least width of a cell [m]; a larger one is taken where cells would outnumber spheres
CellGrid make_cell_grid(std::span<const Lanes> place, std::span<const int> sphere, double width);

/// Calls `visit(b)` for every sphere b of the cells around `a` with |x_a - x_b| < r_a + r_b + margin.
template <class Visit>
void for_each_near(const CellGrid& grid, const Lanes& a, double margin, const Visit& visit) {
  const int ci = grid.cell_x(a[0]), cj = grid.cell_y(a[1]), ck = grid.cell_z(a[2]);
  for (int k = ck > 0 ? ck - 1 : 0; k <= ck + 1 && k < grid.nz; ++k)
    for (int j = cj > 0 ? cj - 1 : 0; j <= cj + 1 && j < grid.ny; ++j) {
      const int from = grid.index(ci > 0 ? ci - 1 : 0, j, k), to = grid.index(ci + 1 < grid.nx ? ci + 1 : ci, j, k);
      const int end = grid.start[to_size(to) + 1];
      for (int e = grid.start[to_size(from)]; e < end; ++e) {
        const Lanes& b = grid.place[to_size(e)];
        const Lanes d = a - b;
        const double reach = a[3] + b[3] + margin;
        if (d[0] * d[0] + d[1] * d[1] + d[2] * d[2] < reach * reach) visit(grid.sphere[to_size(e)]);
      }
    }
}

/// One grid for every halving of the radius: a sphere meets others of its size and larger ones in the
/// few cells around it, so that the search stays linear for any range of sizes.
struct SizedGrids {
  std::vector<CellGrid> grid;  ///< the coarsest first; those without a sphere are left out
  std::vector<int> level;      ///< of every sphere
};
SizedGrids make_sized_grids(std::span<const Lanes> place, double margin);

/// Calls `visit(b)` for every sphere b with |x_a - x_b| < r_a + r_b + margin that is larger by its grid than a,
/// or in the same one and numbered higher.
template <class Visit>
void for_each_later_partner(const SizedGrids& grids, std::span<const Lanes> place, double margin, int a, const Visit& visit) {
  const int own = grids.level[to_size(a)];
  for (int level = 0; level < own; ++level) for_each_near(grids.grid[to_size(level)], place[to_size(a)], margin, visit);
  for_each_near(grids.grid[to_size(own)], place[to_size(a)], margin, [&](int b) {
    if (b > a) visit(b);
  });
}

/// Calls `visit(a, b)` once for every two spheres with |x_a - x_b| < r_a + r_b + margin, in order of a.
template <class Visit>
void for_each_close_pair(const SizedGrids& grids, std::span<const Lanes> place, double margin, const Visit& visit) {
  for (int a = 0; a < size_of(place); ++a) for_each_later_partner(grids, place, margin, a, [&](int b) { visit(a, b); });
}

}  // namespace puadem
