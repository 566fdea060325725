#pragma once

#include "puadem/dem/contact_laws/pair_constants.hpp"
#include "puadem/dem/lanes.hpp"

namespace puadem {

/// Linear springs whose stiffness follows from moduli and radii (Cundall and Strack 1979, Geotechnique
/// 29, 47), theory 2.5.
struct LinearSpring {
  static constexpr double damping_factor = 2.0;
  /// Share of a step for which the dashpot acts that begins with the contact and ends half a step behind an
  /// overlap of `depth` steps.
  PUADEM_INLINE static Lanes partial_dashpot(const Lanes& depth) { return depth + 0.5; }
  static constexpr double energy_share = 0.5;
  static constexpr bool stores_shear = true;
  static double stiffness_ratio(const PairConstants<double>& pair) { return pair.stiffness_ratio; }

  /// @param overlap           [m], >= 0
  /// @param effective_radius  R* = R_i R_j / (R_i + R_j), R_i against a plane [m]
  /// @param share_i           R_i / (R_i + R_j), 0 against a plane [-]
  template <class T>
  PUADEM_INLINE static ContactResponse<T> respond(const PairConstants<T>& pair, const T& overlap, const T& effective_radius,
                                                  const T& share_i) {
    const T normal =
        2.0 * pair.spring_i * pair.spring_j * effective_radius / (pair.spring_i * share_i + pair.spring_j * (1.0 - share_i));
    return {normal * overlap, normal, pair.stiffness_ratio * normal};
  }
};

}  // namespace puadem
