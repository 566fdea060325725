#include "puadem/dem/bridge_exchange.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "puadem/base/compensated_sum.hpp"
#include "puadem/base/error.hpp"
#include "puadem/dem/bridge_forces.hpp"
#include "puadem/dem/bridge_pairs.hpp"

namespace puadem {

namespace {

constexpr long exchange_interval = 50;  // steps; a ruptured bridge has no force from the step of its rupture on

bool is_at_suction(const GrainBridges& g) { return g.model.table.control == BridgeControl::suction; }
bool has_film(const GrainBridges& g, int end) { return end < size_of(g.film); }

/// Gives liquid back to two ends, a wall's part to the grain.
void put_on(GrainBridges& g, const std::array<int, 2>& ends, const std::array<double, 2>& volume) {
  for (std::size_t side = 0; side < 2; ++side) g.film[to_size(has_film(g, ends[side]) ? ends[side] : ends[0])] += volume[side];
}

void rupture(GrainBridges& g) {
  const auto ruptured = rupture_bridges(g.model, g.rules.split, g.bridges);
  g.ruptured += size_of(ruptured);
  if (ruptured.empty() || is_at_suction(g)) return;
  for (const RupturedBridge& r : ruptured) put_on(g, r.ends, r.volume);
  if (g.rules.exchange == BridgeRules::Exchange::neighbours) share_films(g.model, g.film, g.bridges);
}

/// Bridges of every end that has films.
std::vector<std::vector<int>> bridges_of_ends(const GrainBridges& g) {
  std::vector<std::vector<int>> of(g.film.size());
  for (int k = 0; k < g.bridges.size(); ++k)
    for (const int end : g.bridges.pairs.ends[to_size(k)])
      if (has_film(g, end)) of[to_size(end)].push_back(k);
  return of;
}

/// Half of an equal share of what the bridges of an end hold, for one more bridge; taken from them in proportion.
double take_share(GrainBridges& g, const std::vector<int>& bridges) {
  const double share = 0.5 / (size_of(bridges) + 1.0);
  double taken = 0.0;
  for (const int k : bridges) {
    double& volume = g.bridges.volume[to_size(k)];
    const double part = share * volume;
    if (volume - part < volume_range(g.model, g.bridges.pairs.radius[to_size(k)])[0]) continue;
    volume -= part;
    taken += part;
    update_curve(g.model, g.bridges, k);
  }
  return taken;
}

/// Liquid that the ends of every pair can spare for a bridge, taken from them.
std::vector<double> draw(GrainBridges& g, const BridgePairs& pairs) {
  const bool from_bridges = g.rules.exchange == BridgeRules::Exchange::neighbours;
  const auto of_ends = from_bridges ? bridges_of_ends(g) : std::vector<std::vector<int>>{};
  std::vector<double> amount(pairs.ends.size(), 0.0);
  for (std::size_t n = 0; n < amount.size(); ++n) {
    const auto [least, most] = volume_range(g.model, pairs.radius[n]);
    for (const int end : pairs.ends[n]) {
      if (!has_film(g, end)) continue;
      const double film = std::min(g.film[to_size(end)], most - amount[n]);
      g.film[to_size(end)] -= film;
      amount[n] += film;
      if (from_bridges) amount[n] += take_share(g, of_ends[to_size(end)]);
    }
    const double excess = amount[n] < least ? amount[n] : std::max(amount[n] - most, 0.0);
    put_on(g, pairs.ends[n], {0.5 * excess, excess - 0.5 * excess});
    amount[n] -= excess;
  }
  return amount;
}

bool has_bridge(const Bridges& bridges, const std::array<int, 2>& ends) {
  return std::ranges::binary_search(bridges.pairs.ends, ends);
}

/// Bridges on pairs that may carry one; what finds no place goes back.
void form(GrainBridges& g, const BridgePairs& pairs, const std::vector<double>& amount) {
  const int formed = form_bridges(g.model, pairs, amount, BridgeFormation::at_any_distance, g.bridges);
  g.formed += formed;
  if (is_at_suction(g) || formed == size_of(pairs.ends)) return;
  for (std::size_t n = 0; n < amount.size(); ++n)
    if (!has_bridge(g.bridges, pairs.ends[n])) put_on(g, pairs.ends[n], {0.5 * amount[n], amount[n] - 0.5 * amount[n]});
}

void form_where_touched(GrainSystem& s) {
  GrainBridges& g = *s.bridges;
  if (g.touched.empty()) return;
  std::ranges::sort(g.touched);
  g.touched.erase(std::ranges::unique(g.touched).begin(), g.touched.end());
  std::erase_if(g.touched, [&](const auto& ends) { return has_bridge(g.bridges, ends); });
  const BridgePairs pairs = pairs_between(s, g.touched);
  g.touched.clear();
  form(g, pairs, is_at_suction(g) ? std::vector<double>(pairs.ends.size(), g.suction) : draw(g, pairs));
}

/// Calls `visit(radius of an end, radius of its grain)`.
template <class Visit>
void for_each_radius(GrainSystem& s, const Visit& visit) {
  auto& radius = s.bridges->bridges.pairs.radius;
  for_each_bridge(
      s,
      [&](int first, int second, int bridge) {
        visit(radius[to_size(bridge)][0], radius_of(s.record[to_size(first)]));
        visit(radius[to_size(bridge)][1], radius_of(s.record[to_size(second)]));
      },
      [&](int, int record, int bridge) { visit(radius[to_size(bridge)][0], radius_of(s.record[to_size(record)])); });
}

bool have_grown(GrainSystem& s) {
  bool changed = false;
  for_each_radius(s, [&](double kept, double now) { changed = changed || kept != now; });
  return changed;
}

void follow_radii(GrainSystem& s) {
  if (!have_grown(s)) return;
  for_each_radius(s, [&](double& kept, double now) { kept = now; });
  update_curves(s.bridges->model, s.bridges->bridges);
}

/// Is any bridge past its rupture, has a grain grown, or have ends touched that have none?
bool is_exchange_due(GrainSystem& s) {
  const GrainBridges& g = *s.bridges;
  if (!g.touched.empty() || have_grown(s)) return true;
  const PresentBridges now = present_bridges(s);
  for (int k = 0; k < g.bridges.size(); ++k)
    if (now.gap[to_size(k)] > rupture_distance(g.model, g.bridges, k)) return true;
  return false;
}

void exchange(GrainSystem& s) {
  if (!is_exchange_due(s)) return;
  GrainBridges& g = *s.bridges;
  collect_bridges(s);  // here alone: the order in which a grain's bridges are listed goes by these gaps
  const double before = s.energy.is_kept ? rupture_work(g.model, g.bridges) : 0.0;
  follow_radii(s);
  rupture(g);
  form_where_touched(s);
  if (s.energy.is_kept) s.energy.wetting += rupture_work(g.model, g.bridges) - before;
  guard_images(s);
  list_bridges(s);
  update_bridge_forces(s);
}

}  // namespace

void wet_grains(GrainSystem& s, const BridgeModel& model, const BridgeRules& rules, const BridgeSupply& supply) {
  GrainBridges& g = s.bridges.emplace();
  g.model = model;
  g.rules = rules;
  g.suction = supply.suction;
  const bool everywhere = rules.formation == BridgeFormation::at_any_distance;
  const BridgePairs pairs = everywhere ? pairs_within(s, farthest_bridge(s, model, supply)) : pairs_between(s, touching_ends(s));
  require(!pairs.ends.empty(), "liquid bridges: no two grains touch{}, so there is none",
          everywhere ? " or are near enough" : "; let bridges form at any distance, or load the grains first");
  if (is_at_suction(g)) {
    form(g, pairs, std::vector<double>(pairs.ends.size(), supply.suction));
  } else {
    g.film.assign(to_size(s.owned), 0.0);
    const std::vector<double> amount =
        supply.total > 0.0 ? shared_volume(model, pairs, supply.total) : std::vector<double>(pairs.ends.size(), supply.each);
    for (std::size_t n = 0; n < amount.size(); ++n)
      require(amount[n] <= volume_range(model, pairs.radius[n])[1],
              "liquid bridges: a volume of {:.3g} m3 between radii of {:.3g} and {:.3g} m is more than a bridge holds there, "
              "{:.3g} m3; give less water",
              amount[n], pairs.radius[n][0], pairs.radius[n][1], volume_range(model, pairs.radius[n])[1]);
    form(g, pairs, amount);
    CompensatedSum sum;
    for (const double v : g.bridges.volume) sum.add(v);
    for (const double f : g.film) sum.add(f);
    g.water_start = sum.value();
  }
  guard_images(s);
  list_bridges(s);
  update_bridge_forces(s);
  add_wall_bridges(s);
}

void place_bridges(GrainSystem& s, const BridgeModel& model, const BridgeRules& rules, double suction, const BridgePairs& pairs,
                   std::span<const double> amount) {
  if (s.bridges)
    for (const int k : s.bridges->list.at_wall) {
      const GrainBridges& old = *s.bridges;
      Wall& wall = s.walls[to_size(-1 - old.list.record[to_size(k)][1])];
      wall.force -= old.bridges.force[to_size(k)] * wall.normal;
    }
  else
    s.bridges.emplace().model = model;
  GrainBridges& g = *s.bridges;
  g.rules = rules;
  g.suction = suction;
  g.bridges = {};
  form_bridges(g.model, pairs, amount, BridgeFormation::at_any_distance, g.bridges);
  guard_images(s);
  list_bridges(s);
  update_bridge_forces(s);
  add_wall_bridges(s);
}

void follow_bridges(GrainSystem& s) {
  update_bridge_forces(s);
  if (!s.bridges->rules.by_pores) {
    note_touches(s);
    if (s.steps % exchange_interval == 0) exchange(s);
  }
  add_wall_bridges(s);
}

void restore_bridges(GrainSystem& s, const BridgeModel& model, const BridgeRules& rules) {
  GrainBridges& g = *s.bridges;
  g.model = model;
  g.rules = rules;
  g.bridges.curve.resize(g.bridges.pairs.ends.size());
  update_curves(model, g.bridges);
  list_bridges(s);
  update_bridge_forces(s);
}

}  // namespace puadem
