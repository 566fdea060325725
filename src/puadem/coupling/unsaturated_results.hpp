#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "puadem/coupling/run.hpp"

namespace puadem {

/// Grains, forces and fluids as they rest; branch, strains and ratios are the caller's.
/// @pre the forces are those of the present places
UnsaturatedRow unsaturated_row(const GrainSystem& grains, const PoreNetwork& network, const Particles& particles,
                               const UnsaturatedState& state, const UnsaturatedCache& cache, int axis);

SwellingRow swelling_row(const GrainSystem& grains, const PoreNetwork& network, const Particles& particles,
                         const SwellingState& state);

/// Sizes of the contact forces and of the fluids' forces, each over its mean.
ForceSpread force_spread(const GrainSystem& grains, const UnsaturatedState& state);

/// q of the contacts' stress, sigma'_z - (sigma'_x + sigma'_y) / 2 [Pa].
double contact_deviator(const UnsaturatedRow& row);

/// A straight line through Bishop's coefficient over saturation, by least squares, and the roots of the mean squares of what is
/// left beside it and beside chi = S.
struct ChiFit {
  double slope = 0.0, offset = 0.0, residual = 0.0, from_saturation = 0.0;  ///< [-]
  int rows = 0;
};
/// @param chi  which of the two; rows without it do not count; none where fewer than three rows are left
std::optional<ChiFit> fit_chi(std::span<const UnsaturatedRow> rows, std::optional<double> UnsaturatedRow::*chi);

/// Where the steepest tangent of a drainage, S over p_c*, meets full saturation and the last saturation: air entry and the begin
/// of the pendular regime.
struct DrainageRegimes {
  double air_entry = 0.0, pendular = 0.0;  ///< p_c* [-]
};
std::optional<DrainageRegimes> drainage_regimes(std::span<const UnsaturatedRow> branch);

/// What a stage found, by name.
void describe_unsaturated(const UnsaturatedRecord& record, const UnsaturatedState& state, RunResults& results);

}  // namespace puadem
