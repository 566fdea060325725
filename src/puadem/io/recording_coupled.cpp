#include <fmt/format.h>

#include <algorithm>

#include "puadem/coupling/pore_space.hpp"
#include "puadem/io/recording_parts.hpp"
#include "puadem/io/series_coupled.hpp"
#include "puadem/io/vtk_fields.hpp"

namespace puadem {

namespace {

constexpr int picture_width = 240;       // pixels
constexpr double picture_change = 0.15;  // of saturation, after which another picture is worth its place
constexpr int most_pictures = 6;         // of a stage

void take_picture(ResultsFolder& folder, const State& state, const UnsaturatedRow& row) {
  auto& pictures = folder.unsaturated_pictures;
  const auto is_of_stage = [&](const UnsaturatedPicture& p) { return p.stage == row.stage; };
  const SectionMap map = cut_section(state, picture_width);
  if (map.planes > 1) return;  // seen through its thickness, a box has no plane to draw grains in
  UnsaturatedPicture picture;
  picture.stage = row.stage;
  picture.row = size_of(state.unsaturated_flows.back().rows) - 1;
  picture.saturation = row.saturation;
  picture.pc_star = row.pc_star;
  picture.axis = map.axis;
  picture.columns = map.columns;
  picture.rows = map.rows;
  picture.pixel = map.pixel;
  picture.bytes = section_picture(map, state.saturation);
  picture.grains = cut_grains(state, map, state.unsaturated->forces.grain, displacements_of(state)->total);
  // The last row is always shown: its picture gives way to that of the next.
  if (!pictures.empty() && is_of_stage(pictures.back()) && pictures.back().gives_way) pictures.pop_back();
  const bool is_first = pictures.empty() || !is_of_stage(pictures.back());
  picture.gives_way = !is_first && (std::abs(pictures.back().saturation - row.saturation) < picture_change ||
                                    std::ranges::count_if(pictures, is_of_stage) >= most_pictures - 1);
  pictures.push_back(std::move(picture));
}

void write_unsaturated_fields(ResultsFolder& folder, const Case& c, const State& state, double time) {
  write_frame(folder, folder.grain_frames, "grains", time, grain_fields(state));
  write_frame(folder, folder.contact_frames, "contacts", time, contact_fields(state));
  write_frame(folder, folder.pore_frames, "pores", time, pore_fields(state));
  write_frame(folder, folder.throat_frames, "throats", time, throat_fields(state, c.fluids));
  if (state.grains->bridges) write_frame(folder, folder.bridge_frames, "bridges", time, bridge_fields(state));
}

/// A state on the way: sets of files as in stages that load the grains, at every so many rows.
void record_moment(ResultsFolder& folder, const Case& c, const State& state, const UnsaturatedRow& row) {
  take_picture(folder, state, row);
  const auto& rows = state.unsaturated_flows.back().rows;
  const auto moments = std::ranges::count_if(rows, [](const UnsaturatedRow& r) { return r.time.has_value(); });
  const int every = std::max(1, c.output.history_rows / std::max(1, c.output.fields_count));
  if (c.output.fields && (moments - 1) % every == 0) write_unsaturated_fields(folder, c, state, state.time);
}

/// A state at rest: every such one, as the equilibria of a retention stage.
void record_unsaturated(ResultsFolder& folder, const Case& c, const State& state, const UnsaturatedRow& row) {
  AppendFile& rows = series(folder, folder.unsaturated, "unsaturated.csv", unsaturated_header);
  rows.append(unsaturated_line(row));
  rows.flush();
  if (const auto& swelling = state.unsaturated_flows.back().swelling; !swelling.empty()) {
    AppendFile& swollen = series(folder, folder.swelling, "swelling.csv", swelling_header);
    swollen.append(swelling_line(row, swelling.back()));
    swollen.flush();
  }
  const UnsaturatedRecord& record = state.unsaturated_flows.back();
  AppendFile& pores = series(folder, folder.pore_space, "pore_space.csv", pore_space_header);
  pores.append(pore_space_lines(row, record.pore_space.back()));
  pores.flush();
  AppendFile& local = series(folder, folder.local_porosity, "local_porosity.csv", local_porosity_header);
  local.append(local_porosity_lines(record, size_of(record.rows) - 1));
  local.flush();
  folder.has_result = true;
  if (row.time) return record_moment(folder, c, state, row);
  record_message(folder, fmt::format("{}: {}: p_c = {:.6g} Pa, S = {:.6f}, strain {:.4g}, {} rounds", row.stage, row.branch,
                                     row.capillary_pressure, row.saturation, row.strain, row.rounds));
  take_picture(folder, state, row);
  const int equilibrium = folder.equilibria++;
  if (c.output.fields && equilibrium % std::max(c.output.fields_every, 1) == 0)
    write_unsaturated_fields(folder, c, state, equilibrium);
}

}  // namespace

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
  observer.unsaturated = [&folder, &c](const State& state, const UnsaturatedRow& row) {
    record_unsaturated(folder, c, state, row);
  };
}

}  // namespace puadem
