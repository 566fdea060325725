#pragma once

#include <cassert>

#include "support/packings.hpp"

namespace puadem::testing {

/// Turns vectors about z by the angle whose cosine is 4/5 and whose sine is 3/5.
inline Vec3 rotated(const Vec3& v) { return {0.8 * v.x - 0.6 * v.y, 0.6 * v.x + 0.8 * v.y, v.z}; }

/// The same packing in a box turned about z: five periods along the turned axes are (4, 3) and (-3, 4) periods of the
/// packing, so that 25 images fill a box that is periodic again.
/// @pre periodic along x and y, with one period, from the origin
inline Spheres rotated_packing(const Spheres& s) {
  assert(s.domain.upper.x == s.domain.upper.y);
  const double period = s.domain.upper.x;
  Spheres turned;
  turned.domain = s.domain;
  turned.domain.upper = {5 * period, 5 * period, s.domain.upper.z};
  const auto lies_within = [&](double x) { return x >= 0.0 && x < 5 * period; };
  for (int i = -8; i <= 8; ++i)
    for (int j = -8; j <= 8; ++j)
      for (std::size_t k = 0; k < s.centre.size(); ++k) {
        const Vec3 c = rotated(s.centre[k] + Vec3{i * period, j * period, 0.0});
        if (!lies_within(c.x) || !lies_within(c.y)) continue;
        turned.centre.push_back(c);
        turned.radius.push_back(s.radius[k]);
      }
  return turned;
}

}  // namespace puadem::testing
