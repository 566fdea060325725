#include "puadem/io/series_two_phase.hpp"

#include <fmt/format.h>

#include <cmath>

namespace puadem {

std::string flow_line(const FlowRow& r) {
  return fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", r.stage, r.step, r.time, r.saturation,
                     r.capillary_pressure, r.water_pressure, r.wetting_in, r.wetting_out, r.nonwetting_in, r.nonwetting_out,
                     r.capillary_number, r.trapped_wetting, r.trapped_nonwetting, r.wetting.clusters, r.nonwetting.clusters,
                     r.wetting.euler(), r.nonwetting.euler(), r.meniscus_area);
}

std::string flow_event_line(long event, const TwoPhaseEvent& e) {
  return fmt::format("{},{},{},{},{},{},{}\n", event, e.time, event_name(e.kind), e.capillary_pressure, e.pore, e.throat,
                     e.units);
}

std::string haines_jump_csv(const HainesJump& jump) {
  std::string csv = fmt::format("# throat {}, invaded pore {}, retracting pore {}\n", jump.throat, jump.invaded, jump.retracting);
  csv += "time_s,pc_invaded_Pa,pc_retracting_Pa\n";
  const auto text = [](double value) { return std::isnan(value) ? std::string() : fmt::format("{}", value); };
  for (std::size_t k = 0; k < jump.time.size(); ++k)
    csv += fmt::format("{},{},{}\n", jump.time[k], text(jump.invaded_pressure[k]), text(jump.retracting_pressure[k]));
  return csv;
}

std::string boxes_csv(const FlowPattern& pattern) {
  std::string csv = "region,box_m,boxes\n";
  const auto add = [&](const char* region, const BoxCount& count) {
    for (std::size_t k = 0; k < count.size.size(); ++k) csv += fmt::format("{},{},{}\n", region, count.size[k], count.boxes[k]);
  };
  add("mostly", pattern.mostly);
  add("projected", pattern.projected);
  return csv;
}

}  // namespace puadem
