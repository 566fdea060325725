#include "puadem/flow/invasion.hpp"

#include <cmath>
#include <string_view>

#include "puadem/base/error.hpp"
#include "puadem/flow/invasion_moves.hpp"
#include "puadem/flow/invasion_queue.hpp"
#include "puadem/flow/invasion_thresholds.hpp"
#include "puadem/geometry/domain.hpp"

namespace puadem {

namespace {

std::vector<std::uint8_t> pores_at(const PoreNetwork& network, int face, std::string_view fluid) {
  require(face >= 0 && face < 6, "the {} reservoir is at face {}; faces are numbered 0 to 5", fluid, face);
  std::vector<std::uint8_t> is_at(to_size(network.pores()));
  int count = 0;
  for (int i = 0; i < network.pores(); ++i) count += is_at[to_size(i)] = (network.pore_walls[to_size(i)] >> face) & 1;
  require(count > 0, "no pore touches the {} face, where the {} reservoir is: choose a face of the box that is a wall",
          face_names[to_size(face)], fluid);
  return is_at;
}

void set_reservoirs(const PoreNetwork& network, InvasionState& state) {
  const InvasionOptions& options = state.options;
  state.nonwetting.reservoir = pores_at(network, options.nonwetting_face, "non-wetting");
  state.wetting.reservoir = pores_at(network, options.wetting_face, "wetting");
  state.counted.resize(to_size(network.pores()));
  CompensatedSum volume;
  int counted = 0;
  for (int i = 0; i < network.pores(); ++i) {
    require(!state.nonwetting.reservoir[to_size(i)] || !state.wetting.reservoir[to_size(i)],
            "pore {} touches both reservoirs, at the {} and the {} face: the packing is too thin between them", i,
            face_names[to_size(options.nonwetting_face)], face_names[to_size(options.wetting_face)]);
    if (state.is_reservoir(i)) continue;
    state.counted[to_size(i)] = options.side_pores || network.pore_walls[to_size(i)] == 0;
    if (!state.is_counted(i)) continue;
    ++counted;
    volume.add(network.pore_volume[to_size(i)]);
  }
  require(counted > 0, "every pore {}: the packing is too thin between the {} and the {} face",
          options.side_pores ? "belongs to a reservoir" : "touches a wall", face_names[to_size(options.nonwetting_face)],
          face_names[to_size(options.wetting_face)]);
  state.void_volume = volume.value();
}

void saturate(const PoreNetwork& network, InvasionState& state) {
  FluidClusters &wetting = state.wetting, &nonwetting = state.nonwetting;
  wetting.traps = state.options.trap_wetting;
  nonwetting.traps = state.options.trap_nonwetting;
  nonwetting.holds = nonwetting.reservoir;
  wetting.holds.resize(nonwetting.holds.size());
  state.wetting_volume = network.pore_volume;
  for (int i = 0; i < network.pores(); ++i) {
    wetting.holds[to_size(i)] = !nonwetting.holds[to_size(i)];
    if (nonwetting.holds[to_size(i)]) state.wetting_volume[to_size(i)] = 0.0;
  }
  nonwetting.passes.resize(to_size(network.throats()));
  wetting.passes.resize(to_size(network.throats()));
  for (int t = 0; t < network.throats(); ++t) {
    const auto [i, j] = network.throat_pores[to_size(t)];
    nonwetting.passes[to_size(t)] = nonwetting.reservoir[to_size(i)] && nonwetting.reservoir[to_size(j)];
    wetting.passes[to_size(t)] = !nonwetting.passes[to_size(t)];
  }
  connect_all(state.links, wetting);
  connect_all(state.links, nonwetting);
}

/// Counts the moves at one pressure. Each throat and pore moves once at most (theory 4.5), so twice
/// their number means that the thresholds contradict one another.
struct StormWatch {
  const PoreNetwork& network;
  double pressure = -1.0;
  long moves = 0;

  void count(const InvasionCandidate& candidate, double now) {
    moves = now == pressure ? moves + 1 : 1;
    pressure = now;
    if (moves <= 2L * (network.pores() + network.throats())) return;
    if (candidate.kind == InvasionCandidate::Kind::fill)
      throw NumericalError(
          fmt::format("invasion comes to no end at p_c = {:.6g} Pa: pore {} fills and drains again", now, candidate.index));
    const auto [i, j] = network.throat_pores[to_size(candidate.index)];
    throw NumericalError(
        fmt::format("invasion comes to no end at p_c = {:.6g} Pa: throat {} between pores {} and {} opens and closes again", now,
                    candidate.index, i, j));
  }
};

// The next move on the way to the target: first what is due at the present pressure, then what lies ahead.
std::optional<InvasionCandidate> next_move(const PoreNetwork& network, double target, InvasionState& state) {
  const double pressure = state.capillary_pressure;
  auto next = next_drainage(network, pressure, state);
  if (!next) next = next_imbibition(network, pressure, state);
  if (next) return next;
  next = target > pressure ? next_drainage(network, target, state) : next_imbibition(network, target, state);
  if (next) state.capillary_pressure = next->pressure;
  return next;
}

}  // namespace

std::string_view event_name(InvasionEventKind kind) {
  switch (kind) {
    case InvasionEventKind::drain:
      return "drain";
    case InvasionEventKind::open_throat:
      return "open_throat";
    case InvasionEventKind::fill:
      return "fill";
    case InvasionEventKind::snap_off:
      return "snap_off";
    case InvasionEventKind::trap_wetting:
      return "trap_wetting";
    case InvasionEventKind::trap_nonwetting:
      return "trap_nonwetting";
    case InvasionEventKind::free_wetting:
      return "free_wetting";
    case InvasionEventKind::free_nonwetting:
      return "free_nonwetting";
  }
  return "unknown";
}

InvasionState start_invasion(const PoreNetwork& network, const Fluids& fluids, const InvasionOptions& options) {
  require(options.body_entry || !options.corner_water,
          "body_entry = false needs corner_water = false: a unit entered below its body pressure has no state of rest with "
          "corner water; set both to false, or body_entry to true");
  InvasionState state;
  state.options = options;
  state.thresholds = invasion_thresholds(network, fluids, options);
  state.links = pore_links(network);
  if (options.cooperative_filling) state.thresholds.filling_shares = filling_shares(network, state.links, fluids, options.seed);
  set_reservoirs(network, state);
  saturate(network, state);
  for (InvasionQueue* queue : {&state.drainage, &state.imbibition}) {
    queue->pore_marks.resize(to_size(network.pores()));
    queue->throat_marks.resize(to_size(network.throats()));
  }
  for (int t = 0; t < network.throats(); ++t) queue_throat(network, t, state);
  return state;
}

void advance_to(const PoreNetwork& network, double target, InvasionState& state, const InvasionEventCallback& on_event) {
  require(std::isfinite(target) && target >= 0.0,
          "capillary pressure {} Pa cannot be reached; it must be finite and not negative", target);
  StormWatch storm{network};
  while (const auto move = next_move(network, target, state)) {
    storm.count(*move, state.capillary_pressure);
    carry_out(network, *move, state, on_event);
  }
  state.capillary_pressure = target;
  if (state.options.trap_check == TrapCheck::step) trap_at_stop(network, state, on_event);
  for (int i = 0; i < network.pores(); ++i) settle(network, i, state);
}

std::vector<double> saturation(const PoreNetwork& network, const InvasionState& state) {
  std::vector<double> result(to_size(network.pores()));
  for (int i = 0; i < network.pores(); ++i)
    result[to_size(i)] = state.wetting_volume[to_size(i)] / network.pore_volume[to_size(i)];
  return result;
}

InvasionTotals totals(const PoreNetwork& network, const InvasionState& state) {
  CompensatedSum wetting, trapped_wetting, trapped_nonwetting;
  for (int i = 0; i < network.pores(); ++i) {
    if (!state.is_counted(i)) continue;
    const double water = state.wetting_volume[to_size(i)];
    wetting.add(water);
    if (!state.wetting.connected[to_size(i)]) trapped_wetting.add(water);
    if (!state.nonwetting.connected[to_size(i)]) trapped_nonwetting.add(network.pore_volume[to_size(i)] - water);
  }
  return {wetting.value() / state.void_volume, trapped_wetting.value() / state.void_volume,
          trapped_nonwetting.value() / state.void_volume};
}

}  // namespace puadem
