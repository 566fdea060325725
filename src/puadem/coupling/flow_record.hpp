#pragma once

#include <string>
#include <vector>

#include "puadem/coupling/haines_jump.hpp"
#include "puadem/flow/fluid_topology.hpp"
#include "puadem/flow/invasion_pattern.hpp"
#include "puadem/flow/two_phase_flow.hpp"

namespace puadem {

/// Two fluids at one time of a stage "two-phase-flow": a row of series/flow.csv. Sums over the counted pores.
struct FlowRow {
  std::string stage;  ///< see stage_name
  long step = 0;
  double time = 0.0;                                 ///< [s]
  double saturation = 1.0;                           ///< [-]
  double capillary_pressure = 0.0;                   ///< of the reservoirs: pressure of the air's less that of the water's [Pa]
  double water_pressure = 0.0;                       ///< of the reservoir [Pa]
  double wetting_in = 0.0, wetting_out = 0.0;        ///< through the boundaries since the start [m3]
  double nonwetting_in = 0.0, nonwetting_out = 0.0;  ///< [m3]
  double capillary_number = 0.0;                     ///< of the flow since the last row [-]
  double trapped_wetting = 0.0, trapped_nonwetting = 0.0;  ///< shares of the void [-]
  FluidTopology wetting, nonwetting;
  double meniscus_area = 0.0;  ///< in the pores (theory 5.5) [m2]
};

/// The shape of the region that air has entered (theory 5.7).
struct FlowPattern {
  double saturation = 1.0;  ///< at which it was taken [-]
  double finger_width = 0.0;
  BoxCount mostly, projected;  ///< pixels mostly invaded, and those with any invaded pore
};

/// Volumes of both fluids [m3].
struct FlowVolumes {
  double wetting = 0.0, nonwetting = 0.0;
};

/// What a stage leaves behind.
struct FlowRecord {
  std::string stage;
  std::vector<FlowRow> rows;
  std::optional<double> breakthrough_time, breakthrough_saturation;  ///< [s], [-]
  std::optional<FlowPattern> pattern;  ///< of a thin bed, at breakthrough or, without one, at the end
  std::optional<HainesJump> jump;
};

/// The row of a state. @param initial_area  A_0 of theory 5.6 [m2]; `last` may be null
FlowRow flow_row(const PoreNetwork& network, const TwoPhaseModel& model, const TwoPhaseState& state, const FlowRow* last,
                 double initial_area);

/// Is the bed thin enough for its pattern to be seen from one side? Its least side is less than half of the next.
bool is_thin(const Domain& domain);

FlowPattern flow_pattern(const PoreNetwork& network, const Domain& domain, const TwoPhaseModel& model,
                         const TwoPhaseState& state);

/// Capillary number when half of the volume displaced in the end has been (theory 5.6); 0 for fewer than three rows.
double capillary_number_at_half(const std::vector<FlowRow>& rows, const Fluids& fluids, double initial_area);

}  // namespace puadem
