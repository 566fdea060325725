#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <ranges>
#include <span>

#include "puadem/coupling/checked_network.hpp"
#include "puadem/coupling/stages.hpp"
#include "puadem/dem/grain_statistics.hpp"
#include "puadem/flow/retention_path.hpp"

namespace puadem {

namespace {

/// Sum over the counted pores [m3].
double counted_sum(const InvasionState& invasion, const std::vector<double>& volume) {
  double sum = 0.0;
  for (int p = 0; p < size_of(volume); ++p)
    if (invasion.is_counted(p)) sum += volume[to_size(p)];
  return sum;
}

void describe_network(const PoreNetwork& network, const InvasionState& invasion, RunResults& results) {
  auto& s = results.scalars;
  s["pores"] = network.pores();
  s["throats"] = network.throats();
  s["throat_windows"] = network.windows;
  s["pores_reservoir"] =
      network.pores() - static_cast<int>(std::ranges::count_if(std::views::iota(0, network.pores()),
                                                               [&](int p) { return !invasion.is_reservoir(p); }));
  s["void_counted_m3"] = invasion.void_volume;
  if (network.triangulation.cells() == 0) return;  // of a file: it does not tell how throats are entered
  s["tetrahedra"] = network.triangulation.cells();
  for (const auto& [name, kind] : {std::pair{"throats_meniscus", EntryKind::meniscus},
                                   {"throats_wide_edge", EntryKind::wide_edge},
                                   {"throats_half_gap", EntryKind::half_gap},
                                   {"throats_inscribed", EntryKind::inscribed},
                                   {"throats_closed", EntryKind::closed}})
    s[name] = static_cast<double>(std::ranges::count(network.throat_entry_kind, kind));
}

/// What is said of each branch, and of each loop of two neighbouring branches.
void describe_curves(const std::vector<RetentionRow>& rows, RunResults& results) {
  auto& s = results.scalars;
  std::span<const RetentionRow> before;
  for (std::size_t first = 0; first < rows.size();) {
    std::size_t last = first;
    while (last < rows.size() && rows[last].branch == rows[first].branch) ++last;
    const auto branch = std::span(rows).subspan(first, last - first);
    const std::string& name = rows[first].branch;
    if (const auto half = capillary_pressure_at(branch, 0.5)) {
      s["pc_half_" + name + "_Pa"] = *half;
      const auto& scale = branch.front().capillary_pressure > 0.0 ? branch.front() : branch.back();
      if (scale.pc_star > 0.0) s["pc_star_half_" + name] = *half * scale.pc_star / scale.capillary_pressure;
    }
    s["saturation_end_" + name] = branch.back().saturation;
    s["trapped_wetting_end_" + name] = branch.back().trapped_wetting;
    s["trapped_nonwetting_end_" + name] = branch.back().trapped_nonwetting;
    if (!before.empty()) s["loop_area_" + before.front().branch + "_" + name + "_Pa"] = std::abs(loop_area(before, branch));
    before = branch;
    first = last;
  }
}

RetentionProgress begin(const Case& c, const RetentionStage& stage, State& state, const Observer& observer, RunResults& results) {
  Progress progress;
  progress.stage = "network";
  if (observer.progress && !observer.progress(progress)) throw Interrupted{};
  if (!c.network_file) state.network = checked_network(c, state, observer);
  state.invasion = start_invasion(state.network, c.fluids, stage.invasion);
  state.saturation = saturation(state.network, *state.invasion);
  state.retention.clear();
  describe_network(state.network, *state.invasion, results);
  if (observer.packed) observer.packed(state);
  return {{}, counted_sum(*state.invasion, state.invasion->wetting_volume)};
}

void describe_ledger(const State& state, const RetentionProgress& at, RunResults& results) {
  const InvasionState& invasion = *state.invasion;
  Ledger& ledger = results.ledger;
  ledger.void_volume = invasion.void_volume;
  ledger.wetting_start = at.wetting_start;
  ledger.nonwetting_start = invasion.void_volume - at.wetting_start;
  ledger.wetting_in = invasion.ledger.wetting_in.value();
  ledger.wetting_out = invasion.ledger.wetting_out.value();
  ledger.nonwetting_in = invasion.ledger.nonwetting_in.value();
  ledger.nonwetting_out = invasion.ledger.nonwetting_out.value();
  ledger.wetting_end = counted_sum(invasion, invasion.wetting_volume);
  std::vector<double> nonwetting(state.network.pore_volume);
  for (std::size_t p = 0; p < nonwetting.size(); ++p) nonwetting[p] -= invasion.wetting_volume[p];
  ledger.nonwetting_end = counted_sum(invasion, nonwetting);
  results.scalars["ledger_wetting_error"] = ledger.wetting_error();
  results.scalars["ledger_nonwetting_error"] = ledger.nonwetting_error();
}

}  // namespace

void run_retention_stage(const Case& c, const RetentionStage& stage, State& state, const Observer& observer,
                         RunResults& results) {
  if (!has_begun(state)) state.position.progress = begin(c, stage, state, observer, results);
  auto& at = std::get<RetentionProgress>(state.position.progress);
  RetentionPath path;
  path.turning_points = stage.path;
  path.step = {stage.step};
  if (state.particles.size() > 0) path.mean_grain_radius = statistics_of(state.particles.radius).mean_radius;
  const std::vector<RetentionStop> stops = retention_stops(path);
  for (int k = size_of(state.retention); k < size_of(stops); ++k) {
    const RetentionRow row =
        follow_to(state.network, c.fluids, path, stops[to_size(k)], k, *state.invasion, [&](const InvasionEvent& event) {
          ++at.events[static_cast<std::size_t>(event.kind)];
          if (observer.event) observer.event(state, event);
        });
    state.retention.push_back(row);
    state.saturation = saturation(state.network, *state.invasion);
    if (observer.equilibrium) observer.equilibrium(state, row);
    Progress progress;
    progress.stage = "retention";
    progress.fraction = (k + 1.0) / size_of(stops);
    progress.capillary_pressure = row.capillary_pressure;
    progress.saturation = row.saturation;
    progress.step = k + 1;
    tell_at_safe_place(observer, progress, state, results);
  }
  describe_ledger(state, at, results);
  for (int k = 0; k < invasion_event_kinds; ++k)
    results.scalars[fmt::format("events_{}", event_name(static_cast<InvasionEventKind>(k)))] = at.events[to_size(k)];
  describe_curves(state.retention, results);
}

}  // namespace puadem
