#pragma once

#include <rapidcheck/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>

#include "puadem/base/random.hpp"
#include "support/packings.hpp"

namespace puadem::testing {

/// The same cases in every run; RC_PARAMS in the environment asks for others.
inline const int fixed_cases = setenv("RC_PARAMS", "seed=1 max_success=60", 0);

inline std::array<bool, 3> any_boundary() {
  const int bits = *rc::gen::inRange(0, 8);
  return {(bits & 1) != 0, (bits & 2) != 0, (bits & 4) != 0};
}

inline std::uint64_t any_seed() { return static_cast<std::uint64_t>(*rc::gen::inRange(1, 1 << 30)); }

/// Moves every grain by at most `amplitude`, inside the box.
inline Spheres shaken(Spheres s, double amplitude, std::uint64_t seed) {
  Random random(seed);
  for (Vec3& c : s.centre)
    for (int axis = 0; axis < 3; ++axis) {
      const double to = c[axis] + random.uniform(-amplitude, amplitude);
      if (to > s.domain.lower[axis] && to < s.domain.upper[axis]) c[axis] = to;
    }
  return s;
}

/// 6 to 59 grains of ratios up to 1 : 20.
inline Spheres any_random_packing() {
  const double ratio = *rc::gen::element(1.0, 2.0, 5.0, 20.0);
  return random_spheres(*rc::gen::inRange(6, 60), ratio, {1.0, 1.2, 0.9}, any_boundary(), any_seed(),
                        *rc::gen::element(0.03, 0.1));
}

/// Lattices of touching grains, shaken by 1e-2 to 1e-16 of a radius.
inline Spheres any_shaken_lattice() {
  const int cells = *rc::gen::inRange(1, 4);
  const double amplitude = std::pow(10.0, -*rc::gen::inRange(2, 17));
  const int kind = *rc::gen::inRange(0, 3);
  const Spheres lattice = kind == 0   ? simple_cubic(1.0, cells, any_boundary())
                          : kind == 1 ? body_centred(1.0, cells)
                                      : face_centred(1.0, cells);
  return shaken(lattice, amplitude, any_seed());
}

/// Grains that touch one wall, two or three, exactly: sites of one plane with the wall, and of one line with an edge.
inline Spheres any_packing_at_walls() {
  const Spheres loose = random_spheres(*rc::gen::inRange(1, 40), *rc::gen::element(1.0, 3.0, 20.0), {1, 1, 1},
                                       {false, false, false}, any_seed(), 0.05);
  Spheres s{{}, {}, loose.domain};
  for (std::size_t i = 0; i < loose.centre.size(); ++i) {
    Vec3 c = loose.centre[i];
    const double r = loose.radius[i];
    for (int axis = 0; axis < 3; ++axis)
      if (const int to = *rc::gen::inRange(0, 4); to < 2) c[axis] = to == 0 ? r : 1.0 - r;
    bool is_free = true;
    for (std::size_t k = 0; k < s.centre.size(); ++k) is_free = is_free && norm(c - s.centre[k]) > r + s.radius[k];
    if (!is_free) continue;
    s.centre.push_back(c);
    s.radius.push_back(r);
  }
  return s;
}

/// All centres in a plane that may lie anywhere between two walls; some on a line.
inline Spheres any_layer() {
  Spheres s = random_spheres(*rc::gen::inRange(3, 25), 1.5, {1, 1, 1}, {false, false, false}, any_seed(), 0.05);
  const double height = *rc::gen::element(0.5, 0.2, 0.9);
  const bool line = *rc::gen::arbitrary<bool>();
  for (std::size_t i = 0; i < s.centre.size(); ++i) {
    s.centre[i].z = height;
    if (line) s.centre[i] = {(static_cast<double>(i) + 0.5) / static_cast<double>(s.centre.size()), 0.5, height};
    s.radius[i] = 0.4 / static_cast<double>(s.centre.size());
  }
  return s;
}

}  // namespace puadem::testing
