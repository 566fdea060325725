#pragma once

#include <algorithm>
#include <limits>
#include <optional>
#include <tuple>
#include <vector>

#include "puadem/flow/capillary_laws/regular_polyhedron.hpp"
#include "puadem/flow/invasion.hpp"

namespace puadem::testing {

/// The rules of the invasion in the plainest form: after every event both fluids are flooded afresh from
/// their reservoirs, all volumes are set, and all throats and pores are looked at for the next event.
struct ReferenceInvasion {
  const PoreNetwork& network;
  Fluids fluids;
  InvasionOptions options;
  double pressure = 0.0;
  std::vector<std::uint8_t> gas, open;  // per pore, per throat
  std::vector<std::uint8_t> water_connected, gas_connected;
  std::vector<double> water;                         // volume per pore
  std::vector<std::tuple<int, int, double>> events;  // kind, pore or throat, pressure

  ReferenceInvasion(const PoreNetwork& n, const Fluids& f, const InvasionOptions& o) : network(n), fluids(f), options(o) {
    for (int i = 0; i < n.pores(); ++i) {
      gas.push_back(is_top(i));
      water.push_back(is_top(i) ? 0.0 : volume(i));
    }
    for (const auto [i, j] : n.throat_pores) open.push_back(is_top(i) && is_top(j));
    flood();
  }

  bool at(int i, int face) const { return (network.pore_walls[to_size(i)] >> face) & 1; }
  bool is_top(int i) const { return at(i, options.nonwetting_face); }
  bool is_bottom(int i) const { return at(i, options.wetting_face); }
  double volume(int i) const { return network.pore_volume[to_size(i)]; }
  CapillaryUnit unit(int i) const {
    return {2.0 * fluids.surface_tension * std::cos(fluids.contact_angle) / network.pore_radius[to_size(i)],
            network.pore_faces[to_size(i)]};
  }
  bool keeps_water(int i) const {
    return options.corner_water && fluids.contact_angle < corner_angle_limit(network.pore_faces[to_size(i)]);
  }
  bool has_water(int i) const { return !is_top(i) && (!gas[to_size(i)] || keeps_water(i)); }
  double body(int i) const {
    if (!keeps_water(i)) return unit(i).threshold;
    return std::visit([&](const auto& law) { return law.saturated_pressure(unit(i)); }, options.retention_law);
  }
  double entry(int t) const { return fluids.surface_tension / network.throat_entry_radius[to_size(t)]; }
  bool is_throat(int t) const {
    return network.throat_pores[to_size(t)][0] != network.throat_pores[to_size(t)][1] &&
           network.throat_entry_radius[to_size(t)] > 0.0;
  }
  bool may_open(int t) const {
    const auto [i, j] = network.throat_pores[to_size(t)];
    if (!options.side_pores && network.pore_walls[to_size(i)] != 0 && network.pore_walls[to_size(j)] != 0) return false;
    return is_throat(t) && (options.wall_throats || !network.throat_at_wall[to_size(t)]);
  }
  bool is_counted(int i) const {
    return !is_top(i) && !is_bottom(i) && (options.side_pores || network.pore_walls[to_size(i)] == 0);
  }

  // Spreads marks over throats until nothing changes.
  template <class Holds, class Passes>
  void spread(std::vector<std::uint8_t>& marks, const Holds& holds, const Passes& passes) const {
    for (bool changed = true; changed;) {
      changed = false;
      for (int t = 0; t < network.throats(); ++t) {
        const auto [i, j] = network.throat_pores[to_size(t)];
        if (!is_throat(t) || !passes(t) || !holds(i) || !holds(j) || marks[to_size(i)] == marks[to_size(j)]) continue;
        marks[to_size(i)] = marks[to_size(j)] = 1;
        changed = true;
      }
    }
  }

  void flood() {
    const auto holds_gas = [&](int i) { return gas[to_size(i)] != 0; };
    const auto holds_water = [&](int i) { return has_water(i); };
    gas_connected.assign(gas.size(), 0);
    water_connected.assign(gas.size(), 0);
    for (int i = 0; i < network.pores(); ++i) {
      gas_connected[to_size(i)] = options.trap_nonwetting ? is_top(i) : holds_gas(i);
      water_connected[to_size(i)] = options.trap_wetting ? is_bottom(i) : holds_water(i);
    }
    spread(gas_connected, holds_gas, [&](int t) { return open[to_size(t)] != 0; });
    spread(water_connected, holds_water, [&](int t) { return !open[to_size(t)] || options.corner_films; });
  }

  void settle() {
    for (int i = 0; i < network.pores(); ++i)
      if (!is_top(i) && !is_bottom(i) && gas_connected[to_size(i)] && water_connected[to_size(i)] && pressure >= body(i))
        water[to_size(i)] =
            volume(i) * std::visit([&](const auto& law) { return law.saturation(unit(i), pressure); }, options.retention_law);
  }

  struct Move {
    double threshold;
    int order;  // between equal thresholds
    double entry;
    int index;
    InvasionEventKind kind;
    int into = -1;
  };

  std::optional<Move> first_drainage() const {
    std::optional<Move> best;
    for (int t = 0; t < network.throats(); ++t) {
      if (open[to_size(t)] || !may_open(t)) continue;
      const auto [a, b] = network.throat_pores[to_size(t)];
      std::optional<Move> move;
      if (gas[to_size(a)] && gas[to_size(b)]) {
        const bool water_moves = !options.trap_wetting || water_connected[to_size(a)] || water_connected[to_size(b)];
        if (water_moves && (gas_connected[to_size(a)] || gas_connected[to_size(b)]))
          move = Move{entry(t), 0, entry(t), t, InvasionEventKind::open_throat};
      } else
        for (const auto& [from, into] : {std::pair(a, b), std::pair(b, a)})
          if (gas_connected[to_size(from)] && !gas[to_size(into)] && water_connected[to_size(into)] && !is_bottom(into))
            move = Move{
                options.body_entry ? std::max(entry(t), body(into)) : entry(t), 0, entry(t), t, InvasionEventKind::drain, into};
      if (move && (!best || std::tuple(move->threshold, move->entry) < std::tuple(best->threshold, best->entry))) best = move;
    }
    return best;
  }

  std::optional<Move> first_imbibition() const {
    std::optional<Move> best;
    const auto offer = [&](const Move& move) {
      if (!best || std::tuple(-move.threshold, move.order, move.entry) < std::tuple(-best->threshold, best->order, best->entry))
        best = move;
    };
    for (int i = 0; i < network.pores(); ++i) {
      if (is_top(i) || !gas_connected[to_size(i)]) continue;
      if (keeps_water(i)) {
        if (water_connected[to_size(i)]) offer({body(i), 0, 0.0, i, InvasionEventKind::fill});
        continue;
      }
      double front = 0.0, lowest = body(i);
      for (int t = 0; t < network.throats(); ++t) {
        const auto [a, b] = network.throat_pores[to_size(t)];
        if (is_throat(t) && !open[to_size(t)] && (a == i || b == i) && water_connected[to_size(a == i ? b : a)])
          front = std::max(front, entry(t));
        if (!options.body_entry && may_open(t) && (a == i || b == i) && gas[to_size(a == i ? b : a)])
          lowest = std::min(lowest, entry(t));
      }
      if (front > 0.0) offer({std::min(lowest, front), 0, 0.0, i, InvasionEventKind::fill});
    }
    if (options.snap_off)
      for (int t = 0; t < network.throats(); ++t) {
        const auto [a, b] = network.throat_pores[to_size(t)];
        if (open[to_size(t)] && is_throat(t) && gas_connected[to_size(a)] &&
            (water_connected[to_size(a)] || water_connected[to_size(b)]))
          offer({std::min(fluids.surface_tension / network.throat_snap_off_radius[to_size(t)], entry(t)), 1, entry(t), t,
                 InvasionEventKind::snap_off});
      }
    return best;
  }

  void log(InvasionEventKind kind, int index) { events.emplace_back(static_cast<int>(kind), index, pressure); }

  void carry_out(const Move& move) {
    settle();
    const int t = move.index, i = move.index;
    log(move.kind, move.kind == InvasionEventKind::drain ? move.into : move.index);
    if (move.kind == InvasionEventKind::open_throat) open[to_size(t)] = 1;
    if (move.kind == InvasionEventKind::snap_off) open[to_size(t)] = 0;
    if (move.kind == InvasionEventKind::fill) {
      gas[to_size(i)] = 0;
      water[to_size(i)] = volume(i);
      for (int k = 0; k < network.throats(); ++k)
        if (network.throat_pores[to_size(k)][0] == i || network.throat_pores[to_size(k)][1] == i) open[to_size(k)] = 0;
    }
    if (move.kind == InvasionEventKind::drain) {
      const int into = move.into;
      gas[to_size(into)] = 1;
      water[to_size(into)] =
          keeps_water(into) ? volume(into) * std::visit([&](const auto& law) { return law.saturation(unit(into), pressure); },
                                                        options.retention_law)
                            : 0.0;
      open[to_size(t)] = 1;
      for (int k = 0; k < network.throats(); ++k) {
        const auto [a, b] = network.throat_pores[to_size(k)];
        if ((a != into && b != into) || open[to_size(k)] || !may_open(k) || !gas[to_size(a == into ? b : a)] ||
            entry(k) >= pressure)
          continue;
        open[to_size(k)] = 1;
        log(InvasionEventKind::open_throat, k);
      }
    }
    flood();
    settle();
  }

  void advance_to(double target) {
    for (;;) {
      auto move = first_drainage();
      if (!move || move->threshold >= pressure) {
        move = first_imbibition();
        if (!move || move->threshold <= pressure) {
          if (target > pressure) {
            move = first_drainage();
            if (!move || move->threshold >= target) break;
          } else if (!move || move->threshold <= target)
            break;
          pressure = move->threshold;
        }
      }
      carry_out(*move);
    }
    pressure = target;
    settle();
  }
};

}  // namespace puadem::testing
