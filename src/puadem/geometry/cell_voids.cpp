#include "puadem/geometry/cell_voids.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "puadem/geometry/cell.hpp"
#include "puadem/geometry/cell_match.hpp"

// The loop is compiled for several machines, and the loader takes what the machine can do.
#if defined(__x86_64__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define PUADEM_CLONES __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#else
#define PUADEM_CLONES
#endif

namespace puadem {

namespace {

constexpr int cells_per_chunk = 128;

/// atan(r) / r for s = r^2 up to tan(pi/8)^2, to 1e-17: interpolation at the nodes of Chebyshev.
inline double arc_tangent_over(double s) {
  constexpr double c[] = {1.0,
                          -0.33333333333333121,
                          0.19999999999940891,
                          -0.14285714279250245,
                          0.11111110744919658,
                          -0.090908968090640271,
                          0.07692045330902225,
                          -0.066629518136291901,
                          0.058468782973308725,
                          -0.050351024566015518,
                          0.037965257453865936,
                          -0.017805397205419445};
  double sum = c[11];
  for (int k = 10; k >= 0; --k) sum = sum * s + c[k];
  return sum;
}

PUADEM_CLONES void angles(const double* y, const double* x, double* angle, int count) {
  constexpr double pi = std::numbers::pi, tan_pi_8 = std::numbers::sqrt2 - 1.0;
  for (int k = 0; k < count; ++k) {
    const double across = std::abs(x[k]);
    const double less = y[k] < across ? y[k] : across, more = y[k] < across ? across : y[k];
    // tan(a - pi/4) = (t - 1) / (t + 1) brings the upper half of the octant down.
    const bool upper = less > tan_pi_8 * more;
    const double rise = upper ? less - more : less, run = upper ? less + more : more;
    const double r = rise / (run > 0.0 ? run : 1.0);
    const double a = (upper ? 0.25 * pi : 0.0) + r * arc_tangent_over(r * r);
    const double b = y[k] > across ? 0.5 * pi - a : a;
    angle[k] = x[k] < 0.0 ? pi - b : b;
  }
}

using Row = double[cells_per_chunk];

/// Cells of one chunk, one number of each beside the other.
struct Chunk {
  Row place[4][3];  ///< of the vertices [m]
  Row cube[4];      ///< of their radii; 0 where a wall is among them [m3]
  Row volume;       ///< six times the oriented volume [m3]
  Row across;       ///< its size
  Row along[4];     ///< what stands under it in the arc tangent of each corner (theory 3.3) [m3]
  Row angle, space;
};

void put(Chunk& at, int c, unsigned k, const Vec3& centre, double radius) {
  at.place[k][0][c] = centre.x;
  at.place[k][1][c] = centre.y;
  at.place[k][2][c] = centre.z;
  at.cube[k][c] = radius * radius * radius;
}

/// Stands for a cell with walls, which is done on its own.
void put_nothing(Chunk& at, int c) {
  constexpr Vec3 corner[4] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (unsigned k = 0; k < 4; ++k) put(at, c, k, corner[k], 0.0);
}

PUADEM_CLONES void set_corners(Chunk& at, int count) {
  for (int c = 0; c < count; ++c) {
    double edge[6][3], squared[6], length[6];  // 01 02 03 12 13 23
    constexpr unsigned from[6] = {0, 0, 0, 1, 1, 2}, to[6] = {1, 2, 3, 2, 3, 3};
    for (unsigned e = 0; e < 6; ++e) {
      for (unsigned axis = 0; axis < 3; ++axis) edge[e][axis] = at.place[to[e]][axis][c] - at.place[from[e]][axis][c];
      squared[e] = edge[e][0] * edge[e][0] + edge[e][1] * edge[e][1] + edge[e][2] * edge[e][2];
      length[e] = std::sqrt(squared[e]);
    }
    const double volume = edge[0][0] * (edge[1][1] * edge[2][2] - edge[1][2] * edge[2][1]) +
                          edge[0][1] * (edge[1][2] * edge[2][0] - edge[1][0] * edge[2][2]) +
                          edge[0][2] * (edge[1][0] * edge[2][1] - edge[1][1] * edge[2][0]);
    at.volume[c] = volume;
    at.across[c] = std::abs(volume);
    at.space[c] = at.across[c] / 6.0;
    // Of each corner the edges that meet in it, and behind each of them the one between the other two.
    constexpr unsigned near[4][3] = {{0, 1, 2}, {0, 3, 4}, {1, 3, 5}, {2, 4, 5}};
    constexpr unsigned far[4][3] = {{5, 4, 3}, {5, 2, 1}, {4, 2, 0}, {3, 1, 0}};
    for (unsigned k = 0; k < 4; ++k) {
      const unsigned i = near[k][0], j = near[k][1], l = near[k][2];
      at.along[k][c] = length[i] * length[j] * length[l] + 0.5 * (squared[j] + squared[l] - squared[far[k][0]]) * length[i] +
                       0.5 * (squared[i] + squared[l] - squared[far[k][1]]) * length[j] +
                       0.5 * (squared[i] + squared[j] - squared[far[k][2]]) * length[l];
    }
  }
}

/// Takes the sector of a grain from the space of its cells.
PUADEM_CLONES void take_corner(Chunk& at, unsigned k, int count) {
  for (int c = 0; c < count; ++c) at.space[c] -= at.cube[k][c] * (2.0 / 3.0) * at.angle[c];
}

}  // namespace

void vector_angles(std::span<const double> y, std::span<const double> x, std::span<double> angle) {
  angles(y.data(), x.data(), angle.data(), size_of(y));
}

CellVoids cell_voids(const Triangulation& triangulation, const PackingSites& sites_of) {
  const int cells = triangulation.cells(), chunks = (cells + cells_per_chunk - 1) / cells_per_chunk;
  CellVoids voids;
  voids.space.resize(to_size(cells));
  voids.orientation.resize(to_size(cells));
  parallel_for(chunks, [&](int chunk) {
    Chunk at;
    const int begin = chunk * cells_per_chunk, count = std::min(cells - begin, cells_per_chunk);
    std::array<bool, cells_per_chunk> has_wall;
    for (int c = 0; c < count; ++c) {
      const auto cell = to_size(begin + c);
      const auto& vertices = triangulation.vertices[cell];
      has_wall[to_size(c)] = vertices[0].is_wall();  // walls come first
      if (!has_wall[to_size(c)]) {
        for (unsigned k = 0; k < 4; ++k) put(at, c, k, sites_of.centre_of(vertices[k]), sites_of.radius_of(vertices[k]));
        continue;
      }
      put_nothing(at, c);
      const auto sites = sites_of(vertices);
      voids.space[cell] = cell_void_volume(sites);
      voids.orientation[cell] = cell_orientation(sites);
    }
    set_corners(at, count);
    for (unsigned k = 0; k < 4; ++k) {
      angles(at.across, at.along[k], at.angle, count);
      take_corner(at, k, count);
    }
    for (int c = 0; c < count; ++c) {
      if (has_wall[to_size(c)]) continue;
      voids.space[to_size(begin + c)] = at.space[c];
      voids.orientation[to_size(begin + c)] = static_cast<std::int8_t>((at.volume[c] > 0.0) - (at.volume[c] < 0.0));
    }
  });
  return voids;
}

}  // namespace puadem
