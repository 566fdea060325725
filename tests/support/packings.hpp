#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "puadem/base/random.hpp"
#include "puadem/base/vec3.hpp"
#include "puadem/geometry/domain.hpp"

namespace puadem::testing {

/// Spheres in a box, made for tests.
struct Spheres {
  std::vector<Vec3> centre;
  std::vector<double> radius;
  Domain domain;

  double solid_volume() const {
    double v = 0.0;
    for (const double r : radius) v += 4.0 / 3.0 * std::numbers::pi * r * r * r;
    return v;
  }
};

/// The same at another size. @param first  radius of the first sphere
inline Spheres scaled_to(double first, Spheres s) {
  const double scale = first / s.radius.front();
  for (Vec3& x : s.centre) x = scale * x;
  for (double& r : s.radius) r *= scale;
  s.domain.upper = scale * s.domain.upper;
  return s;
}

/// Lattice of touching spheres of one radius: `basis` in units of the cubic cell edge, cells^3 cells.
inline Spheres lattice(double radius, double edge, const std::vector<Vec3>& basis, int cells, std::array<bool, 3> periodic) {
  Spheres s;
  for (int i = 0; i < cells; ++i)
    for (int j = 0; j < cells; ++j)
      for (int k = 0; k < cells; ++k)
        for (const Vec3& b : basis) {
          s.centre.push_back(edge * (Vec3{double(i), double(j), double(k)} + b));
          s.radius.push_back(radius);
        }
  s.domain = {{0, 0, 0}, {cells * edge, cells * edge, cells * edge}, periodic};
  return s;
}

inline Spheres simple_cubic(double radius, int cells, std::array<bool, 3> periodic = {true, true, true}) {
  return lattice(radius, 2.0 * radius, {{0.5, 0.5, 0.5}}, cells, periodic);
}
inline Spheres body_centred(double radius, int cells) {
  return lattice(radius, 4.0 / std::sqrt(3.0) * radius, {{0.25, 0.25, 0.25}, {0.75, 0.75, 0.75}}, cells, {true, true, true});
}
inline Spheres face_centred(double radius, int cells) {
  return lattice(radius, 2.0 * std::sqrt(2.0) * radius,
                 {{0.25, 0.25, 0.25}, {0.75, 0.75, 0.25}, {0.75, 0.25, 0.75}, {0.25, 0.75, 0.75}}, cells, {true, true, true});
}

/// Non-overlapping random spheres (sequential addition) with radii spread over 1 : `ratio`, largest first.
inline Spheres random_spheres(int count, double ratio, Vec3 size, std::array<bool, 3> periodic, std::uint64_t seed,
                              double solid_fraction = 0.25) {
  Spheres s;
  s.domain = {{0, 0, 0}, size, periodic};
  Random random(seed);
  std::vector<double> radii;
  double volume = 0.0;
  for (int i = 0; i < count; ++i) {
    radii.push_back(random.uniform(1.0, ratio));
    volume += 4.0 / 3.0 * std::numbers::pi * std::pow(radii.back(), 3);
  }
  const double scale = std::cbrt(solid_fraction * s.domain.volume() / volume);
  std::sort(radii.rbegin(), radii.rend());
  for (const double raw : radii) {
    const double r = raw * scale;
    for (;;) {
      Vec3 c;
      for (int a = 0; a < 3; ++a)
        c[a] = periodic[static_cast<unsigned>(a)] ? random.uniform(0.0, size[a]) : random.uniform(r, size[a] - r);
      bool free = true;
      for (std::size_t k = 0; k < s.centre.size() && free; ++k) {
        Vec3 d = c - s.centre[k];
        for (int a = 0; a < 3; ++a)
          if (periodic[static_cast<unsigned>(a)]) d[a] -= size[a] * std::nearbyint(d[a] / size[a]);
        free = norm(d) > r + s.radius[k];
      }
      if (!free) continue;
      s.centre.push_back(c);
      s.radius.push_back(r);
      break;
    }
  }
  return s;
}

}  // namespace puadem::testing
