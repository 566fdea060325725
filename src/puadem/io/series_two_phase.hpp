#pragma once

#include <string>
#include <string_view>

#include "puadem/coupling/flow_record.hpp"

namespace puadem {

// Series of a stage "two-phase-flow": CSV as in series_writer.

/// series/flow.csv: a row each time. Volumes went through the boundaries since the start of the stage.
inline constexpr std::string_view flow_header =
    "stage,step,time_s,saturation,pc_Pa,water_pressure_Pa,wetting_in_m3,wetting_out_m3,nonwetting_in_m3,nonwetting_out_m3,"
    "capillary_number,trapped_wetting,trapped_nonwetting,clusters_wetting,clusters_nonwetting,euler_wetting,euler_nonwetting,"
    "meniscus_area_m2\n";
/// series/flow_events.csv: a row each event.
inline constexpr std::string_view flow_events_header = "event,time_s,kind,pc_Pa,pore,throat,units\n";

std::string flow_line(const FlowRow& row);
std::string flow_event_line(long event, const TwoPhaseEvent& event_of);

/// series/haines_jump.csv, header and lines; an empty field where the pore is still full of water.
std::string haines_jump_csv(const HainesJump& jump);

/// series/boxes.csv, header and lines: the box counts of a pattern.
std::string boxes_csv(const FlowPattern& pattern);

}  // namespace puadem
