#include <fmt/format.h>

#include "puadem/io/recording_parts.hpp"
#include "puadem/io/series_two_phase.hpp"
#include "puadem/io/vtk_two_phase.hpp"

namespace puadem {
namespace {

constexpr int picture_width = 360;  // pixels

void record_row(ResultsFolder& folder, const FlowRow& row) {
  AppendFile& rows = series(folder, folder.flow, "flow.csv", flow_header);
  series(folder, folder.flow_events, "flow_events.csv", flow_events_header).flush();
  rows.append(flow_line(row));
  rows.flush();
  folder.has_result = true;
}

void record_fields(ResultsFolder& folder, const Case& c, const State& state, const TwoPhaseModel& model, double saturation) {
  const double time = state.flow->time;
  if (!folder.section || folder.section_pores != state.network.pores()) {
    folder.section = cut_section(state, picture_width);
    folder.section_pores = state.network.pores();
  }
  folder.pictures.push_back({state.flows.back().stage, time, saturation, section_picture(*folder.section, state.saturation)});
  record_message(folder, fmt::format("two-phase-flow: t = {:.6g} s, S = {:.6f}", time, saturation));
  if (!c.output.fields) return;
  write_frame(folder, folder.pore_frames, "pores", time, two_phase_pore_fields(state, model));
  write_frame(folder, folder.throat_frames, "throats", time, two_phase_throat_fields(state, model));
}

}  // namespace

void record_two_phase(ResultsFolder& folder, const Case& c, Observer& observer) {
  observer.flow = [&folder](const State&, const TwoPhaseModel&, const FlowRow& row) { record_row(folder, row); };
  observer.flow_fields = [&folder, &c](const State& state, const TwoPhaseModel& model, double saturation) {
    record_fields(folder, c, state, model, saturation);
  };
  observer.flow_event = [&folder](const State&, const TwoPhaseEvent& event) {
    series(folder, folder.flow_events, "flow_events.csv", flow_events_header)
        .append(flow_event_line(folder.flow_events_seen++, event));
  };
}

void write_flow_records(const ResultsFolder& folder, const State& state) {
  for (std::size_t k = 0; k < state.flows.size(); ++k) {
    const FlowRecord& record = state.flows[k];
    const std::string end = k == 0 ? ".csv" : "_" + record.stage + ".csv";
    if (record.jump) write_file(folder.path / "series" / ("haines_jump" + end), haines_jump_csv(*record.jump));
    if (record.pattern) write_file(folder.path / "series" / ("boxes" + end), boxes_csv(*record.pattern));
  }
}

}  // namespace puadem
