#pragma once

#include "puadem/dem/contact_laws/pair_constants.hpp"
#include "puadem/dem/lanes.hpp"

namespace puadem {

/// Hertz normal force and the no-slip shear stiffness of Mindlin, taken up in increments (Johnson 1985,
/// Contact Mechanics, sections 4.2 and 7.2), theory 2.6.
struct HertzMindlin {
  static constexpr double damping_factor = 1.8257418583505537;  ///< 2 sqrt(5/6), Tsuji et al. 1992, Powder Technology 71, 239
  /// Mean of the dashpot, which goes with overlap^(1/4), over the last part of a step that begins with the
  /// contact and ends half a step behind an overlap of `depth` steps; 1 is its value at that overlap.
  PUADEM_INLINE static Lanes partial_dashpot(const Lanes& depth) {
    const Lanes whole = depth + 0.5;
    return 0.8 * whole * square_root(square_root(whole / depth));
  }
  static constexpr double energy_share = 4.0 / 15.0;
  static constexpr bool stores_shear = false;
  static double stiffness_ratio(const PairConstants<double>& pair) { return 4.0 * pair.shear / pair.youngs; }

  /// @param overlap           [m], >= 0
  /// @param effective_radius  R* = R_i R_j / (R_i + R_j), R_i against a plane [m]
  template <class T>
  PUADEM_INLINE static ContactResponse<T> respond(const PairConstants<T>& pair, const T& overlap, const T& effective_radius,
                                                  const T&) {
    const T contact_radius = square_root(overlap * effective_radius);
    const T normal = 2.0 * pair.youngs * contact_radius;
    return {2.0 / 3.0 * normal * overlap, normal, 8.0 * pair.shear * contact_radius};
  }
};

}  // namespace puadem
