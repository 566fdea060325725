#include "puadem/geometry/cell_voids.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "puadem/geometry/cell.hpp"
#include "puadem/geometry/cell_match.hpp"

// The loop is compiled twice, and the loader takes what the machine can do.
#if defined(__x86_64__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define PUADEM_TWICE __attribute__((target_clones("arch=x86-64-v3", "default")))
#else
#define PUADEM_TWICE
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

PUADEM_TWICE void angles(const double* y, const double* x, double* angle, int count) {
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

/// Cells of one chunk: six times their volume, and what stands beside it in the arc tangent of each corner (theory 3.3).
struct Corners {
  double volume[cells_per_chunk];
  double beside[4][cells_per_chunk];
  double cubes[4][cells_per_chunk];  ///< of the radii
  double angle[cells_per_chunk];
};

/// A cell of four grains; returns its oriented volume times six.
double set_corners(const std::array<Site, 4>& sites, Corners& at, int c) {
  double squared[4][4], length[4][4];
  for (unsigned i = 0; i < 4; ++i)
    for (unsigned j = i + 1; j < 4; ++j) {
      squared[i][j] = squared[j][i] = squared_norm(sites[j].centre - sites[i].centre);
      length[i][j] = length[j][i] = std::sqrt(squared[i][j]);
    }
  const double volume =
      triple(sites[1].centre - sites[0].centre, sites[2].centre - sites[0].centre, sites[3].centre - sites[0].centre);
  at.volume[c] = std::abs(volume);
  for (unsigned k = 0; k < 4; ++k) {
    const unsigned i = (k + 1) % 4, j = (k + 2) % 4, l = (k + 3) % 4;
    const auto inner = [&](unsigned a, unsigned b) { return 0.5 * (squared[k][a] + squared[k][b] - squared[a][b]); };
    at.beside[k][c] = length[k][i] * length[k][j] * length[k][l] + inner(i, j) * length[k][l] + inner(i, l) * length[k][j] +
                      inner(j, l) * length[k][i];
    at.cubes[k][c] = sites[k].radius * sites[k].radius * sites[k].radius;
  }
  return volume;
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
    Corners at;
    const int begin = chunk * cells_per_chunk, count = std::min(cells - begin, cells_per_chunk);
    bool has_wall[cells_per_chunk];
    for (int c = 0; c < count; ++c) {
      const auto cell = to_size(begin + c);
      const auto& vertices = triangulation.vertices[cell];
      const auto sites = sites_of(vertices);
      has_wall[c] = std::ranges::any_of(vertices, [](const Vertex& v) { return v.is_wall(); });
      if (has_wall[c]) {
        at.volume[c] = 0.0;
        for (unsigned k = 0; k < 4; ++k) at.beside[k][c] = 1.0, at.cubes[k][c] = 0.0;
        voids.space[cell] = cell_void_volume(sites);
        voids.orientation[cell] = cell_orientation(sites);
        continue;
      }
      const double volume = set_corners(sites, at, c);
      voids.space[cell] = at.volume[c] / 6.0;
      voids.orientation[cell] = static_cast<std::int8_t>((volume > 0.0) - (volume < 0.0));
    }
    for (unsigned k = 0; k < 4; ++k) {
      angles(at.volume, at.beside[k], at.angle, count);
      for (int c = 0; c < count; ++c) voids.space[to_size(begin + c)] -= at.cubes[k][c] * (2.0 / 3.0) * at.angle[c];
    }
  });
  return voids;
}

}  // namespace puadem
