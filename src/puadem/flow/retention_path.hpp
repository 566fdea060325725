#pragma once

#include <functional>
#include <vector>

#include "puadem/flow/invasion.hpp"
#include "puadem/flow/retention_curve.hpp"

namespace puadem {

/// A way through capillary pressures. The first value is reached from the state the path starts in, then
/// one turning point after the other.
struct RetentionPath {
  std::vector<double> turning_points;  ///< [Pa], >= 0, neighbours different
  /// Rows at multiples of it from the start of each leg, and at its end; one for all legs or one for each [Pa].
  std::vector<double> step{100.0};
  double mean_grain_radius = 0.0;  ///< <r> of p_c* = p_c <r> / gamma [m]
};

/// A pressure of a path and the branch it belongs to.
struct RetentionStop {
  double capillary_pressure = 0.0;  ///< [Pa]
  std::string branch;               ///< "drainage-1", "imbibition-1", "drainage-2", ...
};

/// All stops of a path that starts at pressure `start`. Legs that go on in one direction share a branch.
/// @param start  infinite: the path begins with an imbibition
/// @throws InputError  for an empty path, a step that is not positive, other than one step for all legs or one for each, turning
/// points negative, not
///                     finite or the same as their neighbour
std::vector<RetentionStop> retention_stops(const RetentionPath& path, double start = 0.0);

/// Moves the fluids to a stop; `number` counts it in the row.
/// @throws NumericalError  as `advance_to`
RetentionRow follow_to(const PoreNetwork& network, const Fluids& fluids, const RetentionPath& path, const RetentionStop& stop,
                       int number, InvasionState& state, const InvasionEventCallback& on_event = {});

/// Follows a path; one row per stop.
///
/// @param on_row    called at each equilibrium; false ends the path there. May be empty.
/// @param on_event  may be empty
/// @throws InputError, NumericalError  as `retention_stops` and `advance_to`
std::vector<RetentionRow> follow_path(const PoreNetwork& network, const Fluids& fluids, const RetentionPath& path,
                                      InvasionState& state, const std::function<bool(const RetentionRow&)>& on_row = {},
                                      const InvasionEventCallback& on_event = {});

}  // namespace puadem
