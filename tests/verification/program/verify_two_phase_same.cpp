// What the flow must not depend on; chains of pores with known answers.
#include <algorithm>
#include <cmath>

#include "dense_packing.hpp"
#include "flow/two_phase_scenes.hpp"
#include "two_phase_bed.hpp"

namespace puadem::verification {

namespace {

struct Drained {
  TwoPhaseState state;
  double time_scale = 0.0;
};

/// Drainage of a fixed number of drainage times, by a suction of 10 gamma / <r>.
Drained drain(const Bed& bed, const char* what, LedgerFile& ledger) {
  const TwoPhaseModel model = driven_by_suction(bed, {}, bed.pressure(10.0));
  Drained drained{start_two_phase(bed.network, model), model.time_scale};
  Watch watch{bed, model, drained.state};
  advance_two_phase(bed.network, model, 50.0 * model.time_scale, {}, drained.state, watch.callbacks());
  ledger.row(what, watch);
  return drained;
}

/// Largest difference of the saturation of pores at the same place, in the units of the first bed.
double largest_difference(const Bed& a, const TwoPhaseState& sa, const Bed& b, const TwoPhaseState& sb, double length) {
  std::vector<int> order_a(to_size(a.network.pores())), order_b(to_size(b.network.pores()));
  const auto sort = [](std::vector<int>& order, const PoreNetwork& network) {
    for (int i = 0; i < size_of(order); ++i) order[to_size(i)] = i;
    std::ranges::sort(order, {}, [&](int i) { return network.pore_volume[to_size(i)]; });
  };
  if (order_a.size() != order_b.size()) return 1.0;
  sort(order_a, a.network);
  sort(order_b, b.network);
  const std::vector<double> s = saturation(a.network, sa), t = saturation(b.network, sb);
  double worst = 0.0;
  for (std::size_t k = 0; k < order_a.size(); ++k) {
    const auto i = to_size(order_a[k]), j = to_size(order_b[k]);
    Vec3 apart = b.network.pore_centre[j] / length - a.network.pore_centre[i];
    const Vec3 size = a.spheres.domain.size();
    for (int axis = 0; axis < 2; ++axis) apart[axis] -= size[axis] * std::nearbyint(apart[axis] / size[axis]);
    if (norm(apart) > 1e-6 * size.z) return 1.0;
    worst = std::max(worst, std::abs(s[i] - t[j]));
  }
  return worst;
}

}  // namespace

void write_two_phase_invariances(const std::filesystem::path& folder) {
  LedgerFile ledger(folder, "invariance");
  Csv csv(folder / "two_phase_invariances.csv", "what,saturation,time,steps");
  const Bed bed = make_bed(1000, 1);
  set_threads(1);
  const Drained one = drain(bed, "one thread", ledger);
  set_threads(2);
  const Drained two = drain(bed, "two threads", ledger);
  set_threads(1);
  const bool same_bits =
      one.state.wetting_volume == two.state.wetting_volume && one.state.wetting_pressure == two.state.wetting_pressure &&
      one.state.nonwetting_pressure == two.state.nonwetting_pressure && one.state.time_step == two.state.time_step;
  csv.row("1 and 2 threads (bits)", same_bits ? 0.0 : largest_difference(bed, one.state, bed, two.state, 1.0), 0.0,
          std::abs(one.state.steps - two.state.steps));

  const Bed other = bed_of(shuffled(bed.spheres, 7));
  const Drained mixed = drain(other, "another order of the grains", ledger);
  csv.row("another order of the grains", largest_difference(bed, one.state, other, mixed.state, 1.0),
          std::abs(mixed.state.time / one.state.time - 1.0), std::abs(one.state.steps - mixed.state.steps));

  for (const double unit : {1e3, 1e-3}) {
    Bed large = bed_of(scaled(bed.spheres, unit));
    large.fluids.surface_tension *= 7.0;
    large.fluids.wetting.viscosity *= 30.0;
    large.fluids.nonwetting.viscosity *= 30.0;
    const Drained same = drain(large, "other units", ledger);
    csv.row(unit > 1.0 ? "lengths × 1000; surface tension × 7; viscosities × 30"
                       : "lengths / 1000; surface tension × 7; viscosities × 30",
            largest_difference(bed, one.state, large, same.state, unit),
            std::abs(same.time_scale / one.time_scale / (unit * 30.0 / 7.0) - 1.0), std::abs(one.state.steps - same.state.steps));
  }
}

void write_chains(const std::filesystem::path& folder) {
  using namespace testing;
  Csv csv(folder / "chains.csv", "what,expected,found");
  const HainesJumpScene jump = haines_jump_scene();
  Csv jumped(folder / "haines_jump.csv", "time,invaded,invading");
  for (const auto& row : jump.rows) jumped.row(row.time, row.invaded, row.invading);
  csv.row("Haines jump: gas in the second pore at p_c = threshold (1 - 1e-6)", "no", jump.enters_below ? "yes" : "no");
  csv.row("Haines jump: the same at threshold (1 + 1e-6)", "yes", jump.enters_above ? "yes" : "no");
  csv.row("Haines jump: water the second pore gave before / V", 0.0, jump.lost_below);
  csv.row("Haines jump: difference of S from S(p_c) in both pores at rest", 0.0, jump.law_difference);
  csv.row("Haines jump: most taken up in a step by the invaded pore / V", 0.0, jump.regain);
  csv.row("Haines jump: change of water less inflow / V at any step", 0.0, jump.imbalance);
  const WashburnScene washburn = washburn_scene();
  Csv filled(folder / "washburn.csv", "pore,time,by_sum");
  for (std::size_t n = 0; n < washburn.time.size(); ++n) filled.row(n + 1, washburn.time[n], washburn.by_sum[n]);
  csv.row("Washburn: exponent of the filled length over time; pores 20 to 60", "0.50 ± 0.03", washburn.exponent);
  for (const std::size_t n : {20U, 40U, 60U})
    csv.row(fmt::format("Washburn: time of pore {} / sum of throats", n), "1 ± 0.1",
            washburn.time[n - 1] / washburn.by_sum[n - 1]);
  for (const double viscosity : {1e-4, 1e-3, 1e-2}) {
    const SeriesScene series = series_scene(viscosity);
    const std::string name = fmt::format("M = {}", viscosity / 1e-3);
    csv.row("throats in series " + name + ": error of the water's flow (largest of the steps)", 0.0, series.wetting_error);
    csv.row("throats in series " + name + ": error of the gas's flow", 0.0, series.nonwetting_error);
    csv.row("throats in series " + name + ": gas in / water out - 1", 0.0, series.conserved);
  }
  const RiseScene rise = rise_scene();
  csv.row("drained column: height of the water (pores)", rise.drained_by_formula, rise.drained);
  csv.row("wetted column: height of the water (pores)", rise.wetted_by_formula, rise.wetted);
  csv.row("column at rest: error of the hydrostatic pressure / weight of a pore", 0.0, rise.hydrostatic_error);
}

}  // namespace puadem::verification
