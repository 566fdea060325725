#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "puadem/io/packing_file.hpp"
#include "puadem/io/recording_parts.hpp"
#include "puadem/io/results_folder.hpp"
#include "puadem/io/resume.hpp"
#include "puadem/io/series_writer.hpp"
#include "puadem/io/vtk_fields.hpp"

namespace puadem {
namespace {

using Clock = std::chrono::steady_clock;

}  // namespace

AppendFile& series(const ResultsFolder& folder, AppendFile& file, const char* name, std::string_view header) {
  if (!file.is_open()) {
    file = AppendFile(folder.path / "series" / name);
    file.append(header);
  }
  return file;
}

void record_message(ResultsFolder& folder, std::string_view message) {
  constexpr std::string_view mark = "warning: ";
  if (message.starts_with(mark)) folder.warnings.emplace_back(message.substr(mark.size()));
  folder.log.append(fmt::format("[{:9.2f} s] {}\n", wall_seconds(folder), message));
  folder.log.flush();
}

void write_frame(const ResultsFolder& folder, std::vector<VtkFrame>& frames, const char* name, double time,
                 const VtkPolyData& data) {
  const std::string file = fmt::format("{}_{:05}.vtp", name, frames.size());
  write_file(folder.path / "fields" / file, vtp_bytes(data));
  frames.push_back({time, file});
  write_file(folder.path / "fields" / fmt::format("{}.pvd", name), pvd_text(frames));
}

namespace {

/// One line a second, and one where a stage begins or ends.
void record_progress(ResultsFolder& folder, const Progress& p) {
  constexpr auto interval = std::chrono::seconds(1);
  const bool turn = p.stage != folder.last_stage || p.fraction >= 1.0;
  if (!turn && Clock::now() - folder.last_progress < interval) return;
  folder.last_progress = Clock::now();
  folder.last_stage = p.stage;
  const nlohmann::ordered_json line{{"wall_s", wall_seconds(folder)},
                                    {"stage", p.stage},
                                    {"fraction", p.fraction},
                                    {"step", p.step},
                                    {"time_s", p.time},
                                    {"saturation", p.saturation},
                                    {"pc_Pa", p.capillary_pressure},
                                    {"unbalanced", p.unbalanced},
                                    {"stress_Pa", p.stress},
                                    {"porosity", p.porosity}};
  folder.progress.append(line.dump() + "\n");
  folder.progress.flush();
}

void record_compaction(ResultsFolder& folder, const Progress& p) {
  series(folder, folder.compaction, "compaction.csv", compaction_header).append(compaction_line(p));
}

/// Grains, and contacts and bridges where the engine has them.
void write_grains(ResultsFolder& folder, const State& state) {
  write_frame(folder, folder.grain_frames, "grains", state.time, grain_fields(state));
  if (!state.grains) return;
  write_frame(folder, folder.contact_frames, "contacts", state.time, contact_fields(state));
  if (state.grains->bridges) write_frame(folder, folder.bridge_frames, "bridges", state.time, bridge_fields(state));
}

void write_distributions(ResultsFolder& folder, const State& state) {
  if (folder.has_distributions || state.network.pores() == 0) return;
  write_file(folder.path / "series" / "distributions.csv", distributions_csv(radius_distributions(state)));
  folder.has_distributions = true;
}

void record_packing(ResultsFolder& folder, const Case& c, const State& state) {
  write_distributions(folder, state);
  if (state.particles.size() == 0) {
    record_message(folder, fmt::format("{} pores, {} throats", state.network.pores(), state.network.throats()));
    folder.has_result = true;
    return;
  }
  write_packing(folder.path / "packing.csv", state.particles.position, state.particles.radius, state.domain);
  if (c.output.fields) {
    write_grains(folder, state);
    const bool is_last = std::ranges::none_of(c.stages, puts_fluid);
    if (is_last && state.network.pores() > 0) {
      write_frame(folder, folder.pore_frames, "pores", 0.0, pore_fields(state));
      write_frame(folder, folder.throat_frames, "throats", 0.0, throat_fields(state, c.fluids));
    }
  }
  record_message(folder, fmt::format("{} grains, {} pore units, {} throats", state.particles.size(), state.network.pores(),
                                     state.network.throats()));
  folder.has_result = true;
}

void record_equilibrium(ResultsFolder& folder, const Case& c, const State& state, const RetentionRow& row) {
  AppendFile& retention = series(folder, folder.retention, "retention.csv", retention_header);
  series(folder, folder.events, "events.csv", events_header).flush();
  retention.append(retention_line(row));
  retention.flush();
  // A permeability stage before has had other pores.
  if (folder.equilibria == 0 && !state.permeability.empty()) folder.has_distributions = false;
  write_distributions(folder, state);
  if (c.output.fields && folder.equilibria % std::max(c.output.fields_every, 1) == 0) {
    const double time = folder.equilibria;
    if (folder.grain_frames.empty() && state.particles.size() > 0)
      write_frame(folder, folder.grain_frames, "grains", time, grain_fields(state));
    VtkPolyData pores = pore_fields(state);
    VtkPolyData throats = throat_fields(state, c.fluids);
    add_equilibrium(pores, row);
    add_equilibrium(throats, row);
    write_frame(folder, folder.pore_frames, "pores", time, pores);
    write_frame(folder, folder.throat_frames, "throats", time, throats);
  }
  record_message(folder, fmt::format("{}: p_c = {:.6g} Pa, S = {:.6f}", row.branch, row.capillary_pressure, row.saturation));
  ++folder.equilibria;
  folder.has_result = true;
}

void record_permeability(ResultsFolder& folder, const Case& c, const State& state, const DrivenFlow& flow,
                         const PermeabilityResult& result) {
  AppendFile& pressure = series(folder, folder.pressure, "pressure.csv", pressure_header);
  for (const PressureLayer& layer : result.profile) pressure.append(pressure_line(result, layer));
  pressure.flush();
  if (c.output.fields) {
    const double time = size_of(folder.flow_pore_frames);
    write_frame(folder, folder.flow_pore_frames, "flow_pores", time, flow_pore_fields(flow));
    write_frame(folder, folder.flow_throat_frames, "flow_throats", time, flow_throat_fields(flow, state.domain));
  }
  record_message(
      folder, fmt::format("{}: {:.6g} m2, {} unknowns", result.stage, result.permeability.mean(), result.permeability.unknowns));
  folder.has_result = true;
}

void record_history(ResultsFolder& folder, const Case& c, const State& state, const HistoryRow& row) {
  AppendFile& history = series(folder, folder.history, "history.csv", history_header(state.domain, c.bridges.has_value()));
  history.append(history_line(row, state.domain));
  history.flush();
  folder.has_result = true;
  if (!c.output.fields) return;
  const bool begins = folder.history_stage != row.stage;
  if (begins) folder.fields_written = 0;
  folder.history_stage = row.stage;
  if (row.fraction * c.output.fields_count < folder.fields_written) return;
  write_grains(folder, state);
  folder.fields_written = static_cast<int>(row.fraction * c.output.fields_count) + 1;
}

void record_event(ResultsFolder& folder, const InvasionEvent& e) {
  series(folder, folder.events, "events.csv", events_header).append(event_line(folder.events_seen++, e));
}

}  // namespace

Observer recording_observer(ResultsFolder& folder, const Case& c) {
  Observer observer;
  observer.progress = [&folder](const Progress& p) {
    record_progress(folder, p);
    if (p.stage == "compact") record_compaction(folder, p);
    return true;
  };
  observer.message = [&folder](std::string_view message) { record_message(folder, message); };
  observer.packed = [&folder, &c](const State& state) { record_packing(folder, c, state); };
  observer.equilibrium = [&folder, &c](const State& state, const RetentionRow& row) {
    record_equilibrium(folder, c, state, row);
  };
  observer.permeability = [&folder, &c](const State& state, const DrivenFlow& flow, const PermeabilityResult& result) {
    record_permeability(folder, c, state, flow, result);
  };
  observer.history = [&folder, &c](const State& state, const HistoryRow& row) { record_history(folder, c, state, row); };
  observer.safe_place = [&folder, &c](const State& state, const RunResults& results, bool is_last) {
    const std::chrono::duration<double> since = Clock::now() - folder.last_checkpoint;
    const int stage = state.position.stage;
    const bool moves_grains = stage < size_of(c.stages) && !puts_fluid(c.stages[to_size(stage)]);
    if (is_last || since.count() >= c.output.checkpoint_every)
      record_checkpoint(folder, c, state, results);
    else if (moves_grains)
      keep_safe_place(folder, state, results);
  };
  record_two_phase(folder, c, observer);
  record_coupled(folder, c, observer);
  observer.event = [&folder](const State&, const InvasionEvent& e) { record_event(folder, e); };
  return observer;
}

}  // namespace puadem
