#include "puadem/io/recording_parts.hpp"
#include "puadem/io/series_coupled.hpp"
#include "puadem/io/vtk_fields.hpp"

namespace puadem {

void record_coupled(ResultsFolder& folder, const Case& c, Observer& observer) {
  observer.saturated = [&folder](const State&, const SaturatedRow& row) {
    AppendFile& rows = series(folder, folder.saturated, "saturated.csv", saturated_header);
    rows.append(saturated_line(row));
    rows.flush();
    folder.has_result = true;
  };
  observer.saturated_fields = [&folder, &c](const State& state, const SaturatedRecord& record) {
    AppendFile& profiles = series(folder, folder.pressure_profile, "pressure_profile.csv", pressure_profile_header);
    profiles.append(pressure_profile_lines(record, record.profiles.back()));
    profiles.flush();
    if (!c.output.fields) return;
    const std::vector<double> at_rest(to_size(state.network.throats()), 0.0);
    const DrivenFlow flow{state.network, state.saturated->pressure, at_rest};
    write_frame(folder, folder.flow_pore_frames, "flow_pores", state.time, flow_pore_fields(flow));
  };
}

}  // namespace puadem
