#include "puadem/flow/invasion_queue.hpp"

#include <algorithm>
#include <limits>
#include <tuple>

namespace puadem {

using Kind = InvasionCandidate::Kind;

std::optional<InvasionCandidate> drainage_candidate(const PoreNetwork& network, const InvasionState& state, int throat) {
  const auto& [wetting, nonwetting, thresholds] = std::tie(state.wetting, state.nonwetting, state.thresholds);
  const std::size_t t = to_size(throat);
  if (nonwetting.passes[t] || !thresholds.may_open[t]) return {};
  const std::size_t i = to_size(network.throat_pores[t][0]), j = to_size(network.throat_pores[t][1]);
  const double entry = thresholds.entry_pressure[t];
  if (nonwetting.holds[i] && nonwetting.holds[j]) {
    const bool gas = nonwetting.connected[i] || nonwetting.connected[j];
    const bool water = !wetting.traps || wetting.connected[i] || wetting.connected[j];
    if (gas && water) return InvasionCandidate{entry, entry, throat, Kind::join};
    return {};
  }
  const auto enters = [&](std::size_t from, std::size_t into) {
    return nonwetting.connected[from] && wetting.connected[into] && !wetting.reservoir[into];
  };
  const auto pressure_into = [&](std::size_t into) {
    return state.options.body_entry ? std::max(entry, thresholds.body_pressure[into]) : entry;
  };
  if (enters(i, j)) return InvasionCandidate{pressure_into(j), entry, throat, Kind::enter_second};
  if (enters(j, i)) return InvasionCandidate{pressure_into(i), entry, throat, Kind::enter_first};
  return {};
}

std::optional<InvasionCandidate> snap_off_candidate(const PoreNetwork& network, const InvasionState& state, int throat) {
  const std::size_t t = to_size(throat);
  if (!state.nonwetting.passes[t] || state.thresholds.snap_off_pressure[t] <= 0.0) return {};
  const std::size_t i = to_size(network.throat_pores[t][0]), j = to_size(network.throat_pores[t][1]);
  if (!state.nonwetting.connected[i] || !(state.wetting.connected[i] || state.wetting.connected[j])) return {};
  return InvasionCandidate{state.thresholds.snap_off_pressure[t], state.thresholds.entry_pressure[t], throat, Kind::snap_off};
}

std::optional<InvasionCandidate> fill_candidate(const InvasionState& state, int pore) {
  const std::size_t i = to_size(pore);
  if (!state.nonwetting.connected[i] || state.is_reservoir(pore)) return {};
  const double body = state.refill_pressure(pore);
  if (state.thresholds.keeps_water[i]) {
    if (!state.wetting.connected[i]) return {};
    return InvasionCandidate{body, 0.0, pore, Kind::fill};
  }
  // A dry pore is refilled by a front through the tightest of its throats that water stands behind. Where the
  // body does not resist entry, the widest throat to gas must let go too, or the pore would drain again at
  // once (theory 4.7).
  double front = 0.0, back = std::numeric_limits<double>::infinity();
  for (const auto [neighbour, throat] : state.links[pore]) {
    const double entry = state.thresholds.entry_pressure[to_size(throat)];
    if (!state.nonwetting.passes[to_size(throat)] && state.wetting.connected[to_size(neighbour)]) front = std::max(front, entry);
    if (state.nonwetting.holds[to_size(neighbour)] && state.thresholds.may_open[to_size(throat)]) back = std::min(back, entry);
  }
  if (front == 0.0) return {};
  const double pressure = state.options.body_entry ? std::min(body, front) : std::min({body, front, back});
  return InvasionCandidate{pressure, 0.0, pore, Kind::fill};
}

namespace {

bool drains_later(const InvasionCandidate& a, const InvasionCandidate& b) {
  return std::tie(a.pressure, a.entry, a.index) > std::tie(b.pressure, b.entry, b.index);
}

bool imbibes_later(const InvasionCandidate& a, const InvasionCandidate& b) {
  return std::tuple(-a.pressure, a.kind, a.entry, a.index) > std::tuple(-b.pressure, b.kind, b.entry, b.index);
}

std::uint8_t& mark_of(const InvasionCandidate& candidate, InvasionQueue& queue) {
  return (candidate.kind == Kind::fill ? queue.pore_marks : queue.throat_marks)[to_size(candidate.index)];
}

std::uint8_t bit_of(Kind kind) { return static_cast<std::uint8_t>(1U << static_cast<unsigned>(kind)); }

template <class Later>
void push(const std::optional<InvasionCandidate>& candidate, bool once, const Later& later, InvasionQueue& queue) {
  if (!candidate) return;
  std::uint8_t& mark = mark_of(*candidate, queue);
  if (once && (mark & bit_of(candidate->kind))) return;
  mark |= bit_of(candidate->kind);
  queue.heap.push_back(*candidate);
  std::ranges::push_heap(queue.heap, later);
}

template <class Later>
void pop(const Later& later, InvasionQueue& queue) {
  std::ranges::pop_heap(queue.heap, later);
  const InvasionCandidate& last = queue.heap.back();
  mark_of(last, queue) &= static_cast<std::uint8_t>(~bit_of(last.kind));
  queue.heap.pop_back();
}

bool is_same(const InvasionCandidate& a, const std::optional<InvasionCandidate>& b) {
  return b && a.kind == b->kind && a.pressure == b->pressure;
}

// Does the pressure at which a pore refills stay, whatever its neighbours do?
bool has_fixed_refill(int pore, const InvasionState& state) {
  return state.thresholds.keeps_water[to_size(pore)] && !state.options.cooperative_filling;
}

// If it changes with its neighbours, the pore may stand in the queue more than once.
void queue_fill(int pore, InvasionState& state) {
  push(fill_candidate(state, pore), has_fixed_refill(pore, state), imbibes_later, state.imbibition);
}

}  // namespace

void queue_throat(const PoreNetwork& network, int throat, InvasionState& state) {
  push(drainage_candidate(network, state, throat), true, drains_later, state.drainage);
  push(snap_off_candidate(network, state, throat), true, imbibes_later, state.imbibition);
}

void queue_pore(const PoreNetwork& network, int pore, InvasionState& state) {
  for (const auto [neighbour, throat] : state.links[pore]) {
    queue_throat(network, throat, state);
    if (!has_fixed_refill(neighbour, state)) queue_fill(neighbour, state);
  }
  queue_fill(pore, state);
}

std::optional<InvasionCandidate> next_drainage(const PoreNetwork& network, double limit, InvasionState& state) {
  while (!state.drainage.heap.empty() && state.drainage.heap.front().pressure < limit) {
    const InvasionCandidate first = state.drainage.heap.front();
    if (is_same(first, drainage_candidate(network, state, first.index))) return first;
    pop(drains_later, state.drainage);
  }
  return {};
}

std::optional<InvasionCandidate> next_imbibition(const PoreNetwork& network, double limit, InvasionState& state) {
  while (!state.imbibition.heap.empty() && state.imbibition.heap.front().pressure > limit) {
    const InvasionCandidate first = state.imbibition.heap.front();
    const bool fills = first.kind == Kind::fill;
    const auto now = fills ? fill_candidate(state, first.index) : snap_off_candidate(network, state, first.index);
    if (is_same(first, now)) return first;
    pop(imbibes_later, state.imbibition);
    if (fills) queue_fill(first.index, state);  // its pressure fell
  }
  return {};
}

}  // namespace puadem
