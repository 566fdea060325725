#include "puadem/bridges/bridges.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "puadem/base/error.hpp"
#include "puadem/base/parallel.hpp"
#include "puadem/bridges/bridge_formulas.hpp"

namespace puadem {

namespace {

using std::numbers::pi;
using Law = BridgeModel::Law;

bool is_at_suction(const BridgeModel& model) { return model.table.control == BridgeControl::suction; }

double cube_of_reduced(const std::array<double, 2>& radius) {
  const double length = reduced_radius(radius);
  return length * length * length;
}

constexpr double least_of_willett = 1e-5, most_of_willett = 0.1;  // V / R*^3; some way below, its force vanishes in contact

BridgeCurve curve_of(const BridgeModel& model, const std::array<double, 2>& radius, double amount) {
  if (model.law == Law::willett) {
    const double scaled = amount / cube_of_reduced(radius);
    require(scaled >= least_of_willett && scaled <= most_of_willett,
            "liquid bridge between radii of {:g} and {:g} m: V/R*^3 = {:g}, but the fit of Willett holds from {:g} to {:g}; "
            "use the table",
            radius[0], radius[1], scaled, least_of_willett, most_of_willett);
  }
  return bridge_curve(model.table, radius, is_at_suction(model) ? amount / model.surface_tension : amount);
}

double reach_of(const BridgeModel& model, const std::array<double, 2>& radius, double amount, const BridgeCurve& curve) {
  switch (model.law) {
    case Law::table:
      return curve.reach;
    case Law::willett:
      return willett_reach(radius, model.table.contact_angle, amount);
    case Law::soulie:
      return lian_reach(model.table.contact_angle, amount);
  }
  return 0.0;
}

double pull_of(const BridgeModel& model, const Bridges& b, int k, double gap) {
  const auto at = to_size(k);
  switch (model.law) {
    case Law::table:
      return bridge_pull(b.curve[at], gap);
    case Law::willett:
      return willett_pull(b.pairs.radius[at], model.table.contact_angle, b.volume[at], gap);
    case Law::soulie:
      return soulie_pull(b.pairs.radius[at], model.table.contact_angle, b.volume[at], gap);
  }
  return 0.0;
}

void append(const BridgePairs& pairs, std::size_t n, double amount, const BridgeCurve& curve, bool at_suction, Bridges& b) {
  b.pairs.ends.push_back(pairs.ends[n]);
  b.pairs.radius.push_back(pairs.radius[n]);
  b.pairs.gap.push_back(pairs.gap[n]);
  b.capillary_pressure.push_back(at_suction ? amount : 0.0);
  b.volume.push_back(at_suction ? 0.0 : amount);
  b.force.push_back(0.0);
  b.curve.push_back(curve);
}

void append(const Bridges& from, std::size_t k, Bridges& b) {
  b.pairs.ends.push_back(from.pairs.ends[k]);
  b.pairs.radius.push_back(from.pairs.radius[k]);
  b.pairs.gap.push_back(from.pairs.gap[k]);
  b.capillary_pressure.push_back(from.capillary_pressure[k]);
  b.volume.push_back(from.volume[k]);
  b.force.push_back(from.force[k]);
  b.curve.push_back(from.curve[k]);
}

}  // namespace

BridgeModel bridge_model(double surface_tension, double contact_angle, BridgeControl control, Law law) {
  require(surface_tension > 0.0, "liquid bridges: surface tension {} N/m must be positive", surface_tension);
  require(law == Law::table || control == BridgeControl::volume,
          "liquid bridges: the fits of Willett and Soulie are for given volumes; at given suction use the table");
  return {surface_tension, make_bridge_table(control, contact_angle), law};
}

int form_bridges(const BridgeModel& model, const BridgePairs& pairs, std::span<const double> amount, BridgeFormation formation,
                 Bridges& bridges) {
  assert(amount.size() == pairs.ends.size() && std::ranges::is_sorted(pairs.ends));
  const int n = size_of(pairs.ends);
  std::vector<BridgeCurve> curve(to_size(n));
  std::vector<char> forms(to_size(n), 0);
  parallel_for(n, [&](int i) {
    const auto at = to_size(i);
    if (amount[at] <= 0.0 || (formation == BridgeFormation::at_contact && pairs.gap[at] > 0.0) ||
        std::ranges::binary_search(bridges.pairs.ends, pairs.ends[at]))
      return;
    curve[at] = curve_of(model, pairs.radius[at], amount[at]);
    forms[at] = pairs.gap[at] <= reach_of(model, pairs.radius[at], amount[at], curve[at]);
  });
  const auto added = std::ranges::count(forms, 1);
  if (added == 0) return 0;
  Bridges all;
  std::size_t old = 0;
  for (std::size_t i = 0; i < to_size(n); ++i) {
    if (!forms[i]) continue;
    while (old < to_size(bridges.size()) && bridges.pairs.ends[old] < pairs.ends[i]) append(bridges, old++, all);
    append(pairs, i, amount[i], curve[i], is_at_suction(model), all);
  }
  while (old < to_size(bridges.size())) append(bridges, old++, all);
  bridges = std::move(all);
  update_forces(model, bridges);
  update_contents(model, bridges);
  return static_cast<int>(added);
}

std::array<double, 2> volume_range(const BridgeModel& model, const std::array<double, 2>& radius) {
  const double cube = cube_of_reduced(radius);
  const bool is_fit = model.law == Law::willett;
  return {cube * (is_fit ? std::max(least_of_willett, model.table.least) : model.table.least),
          cube * (is_fit ? std::min(most_of_willett, model.table.most) : model.table.most)};
}

void update_curve(const BridgeModel& model, Bridges& b, int k) {
  const auto at = to_size(k);
  b.curve[at] = curve_of(model, b.pairs.radius[at], is_at_suction(model) ? b.capillary_pressure[at] : b.volume[at]);
}

void update_curves(const BridgeModel& model, Bridges& b) {
  parallel_for(b.size(), [&](int k) { update_curve(model, b, k); });
}

void update_forces(const BridgeModel& model, Bridges& b) {
  if (model.law == Law::table) return bridge_forces(model.surface_tension, b.curve, b.pairs.gap, b.force);
  parallel_for(b.size(), [&](int k) {
    const auto at = to_size(k);
    const double gap = b.pairs.gap[at];
    b.force[at] = gap > rupture_distance(model, b, k) ? 0.0 : 2.0 * pi * model.surface_tension * pull_of(model, b, k, gap);
  });
}

void update_contents(const BridgeModel& model, Bridges& b) {
  parallel_for(b.size(), [&](int k) {
    const auto at = to_size(k);
    const double gap = b.pairs.gap[at];
    const double content = bridge_content(b.curve[at], std::min(gap, b.curve[at].reach));
    if (is_at_suction(model)) {
      b.volume[at] = content;
    } else {
      b.capillary_pressure[at] = model.surface_tension * content;
    }
  });
}

double rupture_distance(const BridgeModel& model, const Bridges& b, int k) {
  return reach_of(model, b.pairs.radius[to_size(k)], b.volume[to_size(k)], b.curve[to_size(k)]);
}

std::vector<RupturedBridge> rupture_bridges(const BridgeModel& model, RuptureSplit split, Bridges& bridges) {
  std::vector<RupturedBridge> ruptured;
  Bridges left;
  for (int k = 0; k < bridges.size(); ++k) {
    const auto at = to_size(k);
    if (bridges.pairs.gap[at] <= rupture_distance(model, bridges, k)) continue;
    const double volume = bridges.volume[at];
    const double first = (split == RuptureSplit::halves ? 0.5 : bridges.curve[at].share) * volume;
    ruptured.push_back({bridges.pairs.ends[at], {first, volume - first}});
  }
  if (ruptured.empty()) return ruptured;
  std::size_t gone = 0;
  for (std::size_t k = 0; k < to_size(bridges.size()); ++k) {
    if (gone < ruptured.size() && ruptured[gone].ends == bridges.pairs.ends[k]) {
      ++gone;
    } else {
      append(bridges, k, left);
    }
  }
  bridges = std::move(left);
  return ruptured;
}

void share_films(const BridgeModel& model, std::span<double> film, Bridges& b) {
  assert(!is_at_suction(model));
  const auto has_film = [&](int end) { return end >= 0 && end < size_of(film); };
  std::vector<int> bridges_of(film.size(), 0);
  for (const auto& ends : b.pairs.ends)
    for (const int end : ends)
      if (has_film(end)) ++bridges_of[to_size(end)];
  const std::vector<double> before(film.begin(), film.end());
  for (int k = 0; k < b.size(); ++k) {
    const auto at = to_size(k);
    const double most = volume_range(model, b.pairs.radius[at])[1], held = b.volume[at];
    for (const int end : b.pairs.ends[at]) {
      if (!has_film(end)) continue;
      const auto on = to_size(end);
      const double given = std::min({before[on] / bridges_of[on], film[on], std::max(most - b.volume[at], 0.0)});
      b.volume[at] += given;
      film[on] -= given;
    }
    if (b.volume[at] != held) update_curve(model, b, k);
  }
}

double rupture_work(const BridgeModel& model, const Bridges& b) {
  const auto work_from = [&](int k, double gap) {
    const auto at = to_size(k);
    const double reach = rupture_distance(model, b, k);
    if (gap >= reach) return 0.0;
    if (model.law == Law::table) return bridge_work(b.curve[at], gap);
    constexpr int points = 256;  // of the force over sqrt(distance to rupture)
    double sum = 0.0;
    for (int i = 0; i < points; ++i) {
      const double zeta = (i + 0.5) / points;
      sum += 2.0 * zeta * pull_of(model, b, k, reach - (reach - gap) * zeta * zeta);
    }
    return 2.0 * pi * (reach - gap) * sum / points;
  };
  // Ends that overlap have the force of contact on the way to it.
  const auto work = [&](int k) {
    const double gap = b.pairs.gap[to_size(k)];
    return gap >= 0.0 ? work_from(k, gap) : work_from(k, 0.0) - 2.0 * pi * pull_of(model, b, k, 0.0) * gap;
  };
  return model.surface_tension * parallel_sum<double>(b.size(), work);
}

}  // namespace puadem
