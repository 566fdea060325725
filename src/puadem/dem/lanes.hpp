#pragma once

#include <cmath>
#include <cstdint>
#if defined(__SSE2__)
#include <emmintrin.h>
#endif

// Vectors wider than the baseline's registers never cross the border of a compiled file.
#pragma GCC diagnostic ignored "-Wpsabi"

#define PUADEM_INLINE [[gnu::always_inline]] inline

// A hot loop is compiled twice, and the loader takes what the machine can do.
#if defined(__x86_64__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define PUADEM_CLONES __attribute__((target_clones("arch=x86-64-v3", "default")))
#else
#define PUADEM_CLONES
#endif

namespace puadem {

/// Four numbers that are worked on together: the same quantity of four contacts, or (x, y, z, .) of one grain.
using Lanes = double __attribute__((vector_size(32)));
using LaneMask = std::int64_t __attribute__((vector_size(32)));
inline constexpr int lane_count = 4;

PUADEM_INLINE Lanes broadcast(double a) { return Lanes{a, a, a, a}; }

PUADEM_INLINE bool any(const LaneMask& m) { return ((m[0] | m[1]) | (m[2] | m[3])) != 0; }

PUADEM_INLINE Lanes square_root(const Lanes& a) {
#if defined(__SSE2__)  // std::sqrt may set errno, which keeps it scalar
  const __m128d low = _mm_sqrt_pd(__m128d{a[0], a[1]});
  const __m128d high = _mm_sqrt_pd(__m128d{a[2], a[3]});
  return Lanes{low[0], low[1], high[0], high[1]};
#else
  return Lanes{std::sqrt(a[0]), std::sqrt(a[1]), std::sqrt(a[2]), std::sqrt(a[3])};
#endif
}
PUADEM_INLINE double square_root(double a) { return std::sqrt(a); }

/// Rows to columns: lane l of the result a is the first number of the l-th argument, and so on.
PUADEM_INLINE void transpose(Lanes& a, Lanes& b, Lanes& c, Lanes& d) {
  const Lanes ab_low = __builtin_shuffle(a, b, LaneMask{0, 4, 2, 6});
  const Lanes ab_high = __builtin_shuffle(a, b, LaneMask{1, 5, 3, 7});
  const Lanes cd_low = __builtin_shuffle(c, d, LaneMask{0, 4, 2, 6});
  const Lanes cd_high = __builtin_shuffle(c, d, LaneMask{1, 5, 3, 7});
  a = __builtin_shuffle(ab_low, cd_low, LaneMask{0, 1, 4, 5});
  b = __builtin_shuffle(ab_high, cd_high, LaneMask{0, 1, 4, 5});
  c = __builtin_shuffle(ab_low, cd_low, LaneMask{2, 3, 6, 7});
  d = __builtin_shuffle(ab_high, cd_high, LaneMask{2, 3, 6, 7});
}

/// Four vectors side by side.
struct alignas(32) LaneVec3 {
  Lanes x, y, z;
};
PUADEM_INLINE LaneVec3 operator+(const LaneVec3& a, const LaneVec3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
PUADEM_INLINE LaneVec3 operator-(const LaneVec3& a, const LaneVec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
PUADEM_INLINE LaneVec3 operator*(const Lanes& s, const LaneVec3& a) { return {s * a.x, s * a.y, s * a.z}; }
PUADEM_INLINE LaneVec3 operator*(double s, const LaneVec3& a) { return broadcast(s) * a; }
PUADEM_INLINE Lanes dot(const LaneVec3& a, const LaneVec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
PUADEM_INLINE LaneVec3 cross(const LaneVec3& a, const LaneVec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

}  // namespace puadem
