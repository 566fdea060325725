#pragma once

#include <cmath>

#include "puadem/base/vec3.hpp"

namespace puadem {

/// Solid angle of the corner spanned by three edges [sr], in [0, 2 pi].
/// Van Oosterom and Strackee 1983 (IEEE Trans. Biomed. Eng. 30, 125); theory 3.3. The two-argument arc
/// tangent keeps it right for corners wider than a hemisphere's half.
inline double solid_angle(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double la = norm(a), lb = norm(b), lc = norm(c);
  return 2.0 * std::atan2(std::abs(triple(a, b, c)), la * lb * lc + dot(a, b) * lc + dot(a, c) * lb + dot(b, c) * la);
}

/// Angle between two directions [rad], in [0, pi]; accurate where they are nearly parallel.
inline double angle_between(const Vec3& a, const Vec3& b) { return std::atan2(norm(cross(a, b)), dot(a, b)); }

}  // namespace puadem
