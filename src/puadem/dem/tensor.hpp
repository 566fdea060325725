#pragma once

#include <array>

#include "puadem/base/vec3.hpp"

namespace puadem {

using Tensor = std::array<Vec3, 3>;  ///< rows

/// t += f (outer) d.
constexpr void add_outer(Tensor& t, const Vec3& f, const Vec3& d) {
  for (unsigned a = 0; a < 3; ++a) t[a] += f[static_cast<int>(a)] * d;
}

constexpr double trace(const Tensor& t) { return t[0].x + t[1].y + t[2].z; }

/// The symmetric part less a third of the trace.
Tensor deviator(const Tensor& t);

/// sqrt(3/2 s:s) of the deviator s: of a stress q, in axial symmetry the difference of the axial and the
/// lateral stress.
double deviatoric_invariant(const Tensor& t);

/// Eigenvalues of the symmetric part, the largest first.
Vec3 principal_values(const Tensor& t);

}  // namespace puadem
