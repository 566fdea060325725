#include "puadem/coupling/fluid_transfer.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "puadem/flow/two_phase_system.hpp"

namespace puadem {

namespace {

constexpr double worth_counting = 0.01;  // of a pore's saturation

/// One transfer under way.
struct Transfer {
  const PoreNetwork& before;
  std::span<const double> cell_void;
  const TwoPhaseModel& former;
  const RebuiltNetwork& now;
  const TwoPhaseModel& model;
  const TwoPhaseState& state;
  std::vector<double> water_before{}, water{};  ///< per cell [m3]
  std::vector<int> donor{};                     ///< per cell now: a former pore that it, or the cavity it fills, was part of

  int former_pore(int cell) const {
    const int old = now.match.before[to_size(cell)];
    return old < 0 ? -1 : before.tetrahedron_pore[to_size(old)];
  }
};

/// The former pore that has exactly the cells of a pore, or -1.
int same_pore(const Transfer& t, int pore) {
  const auto cells = t.now.network.pore_tetrahedra[pore];
  const int former = t.former_pore(*cells.begin());
  if (former < 0 || t.before.pore_tetrahedra[former].size() != cells.size()) return -1;
  return std::ranges::all_of(cells, [&](int c) { return t.former_pore(c) == former; }) ? former : -1;
}

/// Water of each cell before: its share of its pore's void. A cell of less than no void, as one
/// that has turned inside out, takes away from the cavity it lies in as much as that holds in its place: neither that nor the
/// rest of the cell's pore gets fuller than full by it.
void share_by_cells(Transfer& t) {
  const auto pore_of = [&](std::size_t cell) { return to_size(t.before.tetrahedron_pore[cell]); };
  std::vector<double> water = t.state.wetting_volume, space(water.size(), 0.0);
  for (std::size_t c = 0; c < t.cell_void.size(); ++c) space[pore_of(c)] += t.cell_void[c];
  t.water_before.resize(t.cell_void.size());
  const auto share = [&](std::size_t c) { return water[pore_of(c)] / space[pore_of(c)] * t.cell_void[c]; };
  for (std::size_t c = 0; c < t.cell_void.size(); ++c) t.water_before[c] = share(c);
  std::vector<std::uint8_t> is_turned(t.cell_void.size(), 0);
  for (int cavity = 0; cavity < t.now.match.vanished.rows(); ++cavity) {
    double held = 0.0, room = 0.0;
    for (const int c : t.now.match.vanished[cavity]) {
      if (t.cell_void[to_size(c)] <= 0.0) continue;
      held += t.water_before[to_size(c)];
      room += t.cell_void[to_size(c)];
    }
    if (!(room > 0.0)) continue;  // grains that poke through facets leave cells of less than nothing, all at once
    for (const int cell : t.now.match.vanished[cavity]) {
      const auto c = to_size(cell);
      // A pore of nothing but such cells has nowhere else to keep its water.
      if (t.cell_void[c] >= 0.0 || space[pore_of(c)] <= t.cell_void[c]) continue;
      t.water_before[c] = held / room * t.cell_void[c];
      water[pore_of(c)] -= t.water_before[c];
      space[pore_of(c)] -= t.cell_void[c];
      is_turned[c] = 1;
    }
  }
  for (std::size_t c = 0; c < t.cell_void.size(); ++c)
    if (!is_turned[c]) t.water_before[c] = share(c);
}

/// Water of each cell now, and whose place each cell takes. A cavity that holds gas counts as a pore of gas.
void share_water(Transfer& t) {
  share_by_cells(t);
  t.water = carry_over(t.now.match, t.water_before, t.now.network.tetrahedron_void);
  t.donor.resize(t.water.size());
  for (std::size_t c = 0; c < t.donor.size(); ++c) t.donor[c] = t.former_pore(static_cast<int>(c));
  for (int cavity = 0; cavity < t.now.match.appeared.rows(); ++cavity) {
    int donor = -1;
    for (const int old : t.now.match.vanished[cavity]) {
      const int pore = t.before.tetrahedron_pore[to_size(old)];
      if (donor < 0 || (t.state.nonwetting.holds[to_size(pore)] && !t.state.nonwetting.holds[to_size(donor)])) donor = pore;
    }
    for (const int c : t.now.match.appeared[cavity]) t.donor[to_size(c)] = donor;
  }
}

/// Which throats of the network made anew stood before, per throat; -1: none did.
std::vector<int> former_throats(const Transfer& t) {
  const auto at = [](int cell, int vertex) { return 4 * to_size(cell) + to_size(vertex); };
  std::vector<int> throat_of(4 * to_size(t.before.triangulation.cells()), -1);
  for (int k = 0; k < t.before.throats(); ++k) {
    const Facet& facet = t.before.throat_facet[to_size(k)];
    throat_of[at(facet.cell, facet.opposite)] = k;
    const auto& back = t.before.triangulation.neighbours[to_size(facet.neighbour)];
    for (int v = 0; v < 4; ++v) {
      const auto& n = back[to_size(v)];
      const std::array<std::int8_t, 3> reverse{static_cast<std::int8_t>(-facet.shift[0]),
                                               static_cast<std::int8_t>(-facet.shift[1]),
                                               static_cast<std::int8_t>(-facet.shift[2])};
      if (n.cell == facet.cell && n.shift == reverse) throat_of[at(facet.neighbour, v)] = k;
    }
  }
  const PoreNetwork& network = t.now.network;
  std::vector<int> former(to_size(network.throats()), -1);
  for (int k = 0; k < network.throats(); ++k) {
    const Facet& facet = network.throat_facet[to_size(k)];
    const int old = t.now.match.before[to_size(facet.cell)];
    if (old < 0) continue;
    const int grain = network.triangulation.vertices[to_size(facet.cell)][to_size(int{facet.opposite})].index;
    for (int v = 0; v < 4; ++v)  // the order of vertices may have changed with the period they are listed in
      if (t.before.triangulation.vertices[to_size(old)][to_size(v)].index == grain) former[to_size(k)] = throat_of[at(old, v)];
  }
  return former;
}

void set_pores(const Transfer& t, TwoPhaseState& next, long* changed) {
  const PoreNetwork& network = t.now.network;
  const auto n = to_size(network.pores());
  next.wetting_volume.assign(n, 0.0);
  next.wetting_pressure.assign(n, 0.0);
  next.nonwetting_pressure.assign(n, 0.0);
  next.gas_amount.assign(n, 0.0);
  next.wetting.holds.assign(n, 0);
  next.nonwetting.holds.assign(n, 0);
  for (int p = 0; p < network.pores(); ++p) {
    const auto i = to_size(p);
    const auto cells = network.pore_tetrahedra[p];
    int donor = t.donor[to_size(*cells.begin())];
    for (const int c : cells)
      if (t.state.nonwetting.holds[to_size(t.donor[to_size(c)])]) donor = t.donor[to_size(c)];
    const bool gas = t.state.nonwetting.holds[to_size(donor)];
    double water = 0.0;
    for (const int c : cells) water += t.water[to_size(c)];
    if (const int same = same_pore(t, p); same >= 0) water = t.state.wetting_volume[to_size(same)];
    next.wetting_volume[i] = water;
    next.nonwetting.holds[i] = gas;
    next.wetting.holds[i] = !gas || t.state.wetting.holds[to_size(donor)];
    next.wetting_pressure[i] = t.state.wetting_pressure[to_size(donor)];
    next.nonwetting_pressure[i] = gas ? t.state.nonwetting_pressure[to_size(donor)] : 0.0;
    if (changed == nullptr || same_pore(t, p) >= 0 || !gas) continue;
    const double now = water / network.pore_volume[i],
                 was = t.state.wetting_volume[to_size(donor)] / t.before.pore_volume[to_size(donor)];
    if (std::abs(now - was) > worth_counting) ++*changed;
  }
}

/// Reservoirs of the network made anew are full of their fluid.
void set_reservoirs(const Transfer& t, TwoPhaseState& next) {
  const PoreNetwork& network = t.now.network;
  next.wetting.reservoir.assign(to_size(network.pores()), 0);
  next.nonwetting.reservoir = next.wetting.reservoir;
  for (const FlowBoundary& boundary : t.model.boundaries)
    for (const int p : boundary.pores) {
      const auto i = to_size(p);
      const bool is_gas = boundary.fluid == FluidPhase::nonwetting;
      (is_gas ? next.nonwetting : next.wetting).reservoir[i] = 1;
      if (is_gas) next.nonwetting.holds[i] = 1;
      if (t.model.is_counted(p)) continue;
      next.nonwetting.holds[i] = is_gas;
      next.wetting.holds[i] = !is_gas;
      next.wetting_volume[i] = is_gas ? 0.0 : network.pore_volume[i];
    }
}

void set_throats(const Transfer& t, TwoPhaseState& next) {
  const PoreNetwork& network = t.now.network;
  next.wetting.passes.assign(to_size(network.throats()), 1);
  next.nonwetting.passes.assign(to_size(network.throats()), 0);
  const std::vector<int> former = former_throats(t);
  for (int k = 0; k < network.throats(); ++k) {
    const auto [i, j] = network.throat_pores[to_size(k)];
    const bool between_gas = next.nonwetting.holds[to_size(i)] && next.nonwetting.holds[to_size(j)];
    const int old = former[to_size(k)];
    const bool open =
        between_gas && (old < 0 ? t.model.thresholds.may_open[to_size(k)] != 0 : t.state.nonwetting.passes[to_size(old)] != 0);
    if (open) set_open(network, t.model, k, true, next.wetting, next.nonwetting);
  }
  connect_all(t.model.links, next.wetting);
  connect_all(t.model.links, next.nonwetting);
}

/// Books the fluids of cells that join or leave a reservoir.
void book_exchange(const Transfer& t, TwoPhaseState& next) {
  const PoreNetwork& network = t.now.network;
  const auto was_counted = [&](int c) { return t.former.is_counted(t.before.tetrahedron_pore[to_size(c)]); };
  const auto is_counted = [&](int c) { return t.model.is_counted(network.tetrahedron_pore[to_size(c)]); };
  double water = 0.0, gas = 0.0;
  const auto take = [&](double sign, double held, double space) {
    water += sign * held;
    gas += sign * (space - held);
  };
  for (int c = 0; c < network.triangulation.cells(); ++c) {
    const int old = t.now.match.before[to_size(c)];
    if (old < 0 || was_counted(old) == is_counted(c)) continue;
    take(is_counted(c) ? 1.0 : -1.0, t.water[to_size(c)], network.tetrahedron_void[to_size(c)]);
  }
  for (int cavity = 0; cavity < t.now.match.appeared.rows(); ++cavity) {
    const auto gone = t.now.match.vanished[cavity];
    const auto come = t.now.match.appeared[cavity];
    if (std::ranges::all_of(gone, was_counted) && std::ranges::all_of(come, is_counted)) continue;
    for (const int c : gone)
      if (was_counted(c)) take(-1.0, t.water_before[to_size(c)], t.cell_void[to_size(c)]);
    for (const int c : come)
      if (is_counted(c)) take(1.0, t.water[to_size(c)], network.tetrahedron_void[to_size(c)]);
  }
  next.ledger.book(water, gas);
}

}  // namespace

std::vector<int> fluid_kinds(const TwoPhaseState& state) {
  return {state.nonwetting.holds.begin(), state.nonwetting.holds.end()};
}

void fill_reservoirs(const TwoPhaseModel& model, std::span<const double> volume, TwoPhaseState& state) {
  for (int p = 0; p < size_of(volume); ++p)
    if (!model.is_counted(p)) state.wetting_volume[to_size(p)] = state.nonwetting.holds[to_size(p)] ? 0.0 : volume[to_size(p)];
}

TwoPhaseState carry_fluids(const PoreNetwork& before, std::span<const double> cell_void, const TwoPhaseModel& former_model,
                           const RebuiltNetwork& now, const TwoPhaseModel& model, const TwoPhaseState& state, long* changed) {
  Transfer t{before, cell_void, former_model, now, model, state};
  share_water(t);
  TwoPhaseState next = state;
  set_pores(t, next, changed);
  set_reservoirs(t, next);
  set_throats(t, next);
  book_exchange(t, next);
  return next;
}

}  // namespace puadem
