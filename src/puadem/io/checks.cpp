#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "puadem/base/compensated_sum.hpp"
#include "puadem/coupling/loading_program.hpp"
#include "puadem/io/manifest.hpp"

namespace puadem {
namespace {

constexpr double volume_tolerance = 1e-12;  // of the box or the void: rounding of a sum, no more
constexpr double flow_tolerance = 1e-9;     // of the void: what the solves of many steps leave
constexpr double stress_tolerance = 0.01;   // of the target stress
constexpr double porosity_tolerance = 0.002;
constexpr double energy_tolerance = 1e-3;    // of the work put in
constexpr double overlap_tolerance = 0.05;   // of the smaller radius: contacts far apart do not feel each other
constexpr double flux_tolerance = 1e-10;     // of the largest flow through a pore
constexpr double symmetry_tolerance = 1e-8;  // of the mean permeability: what the imbalance leaves
constexpr double grading_tolerance = 0.01;   // largest error of the share of a class

/// (pores + grains - box) / box.
double volume_defect(const State& state) {
  CompensatedSum sum;
  for (const double v : state.network.pore_volume) sum.add(v);
  for (const double r : state.particles.radius) sum.add(4.0 / 3.0 * std::numbers::pi * r * r * r);
  sum.add(-state.domain.volume());
  return sum.value() / state.domain.volume();
}

std::string bound_text(const Expected& e) {
  const bool low = std::isfinite(e.low), high = std::isfinite(e.high);
  if (low && high) return fmt::format("{:.6g} to {:.6g}", e.low, e.high);
  if (low) return fmt::format("at least {:.6g}", e.low);
  if (high) return fmt::format("at most {:.6g}", e.high);
  return "any number";
}

void add_expected(std::vector<Check>& checks, const Case& c, const RunResults& results) {
  for (const auto& [name, bound] : c.expected) {
    const auto found = results.scalars.find(name);
    const double value = found == results.scalars.end() ? std::nan("") : found->second;
    checks.push_back({name, bound_text(bound), value, value >= bound.low && value <= bound.high});
  }
}

/// What the last compaction was asked for, against what the results say of it.
void add_packing(std::vector<Check>& checks, const Case& c, const RunResults& results) {
  const CompactStage* stage = nullptr;
  for (const Stage& s : c.stages)
    if (const auto* compact = std::get_if<CompactStage>(&s)) stage = compact;
  if (!stage) return;
  const auto near = [&](const char* name, double target, double tolerance, const std::string& bound) {
    const auto found = results.scalars.find(name);
    if (found != results.scalars.end())
      checks.push_back({name, bound, found->second, std::abs(found->second - target) <= tolerance});
  };
  near("unbalanced_force", 0.0, stage->unbalanced, fmt::format("at most {:g}", stage->unbalanced));
  near("stress_mean_Pa", stage->stress, stress_tolerance * stage->stress, fmt::format("{:g} ± 1 %", stage->stress));
  near("grading_error", 0.0, grading_tolerance, fmt::format("at most {:g}", grading_tolerance));
  // What loads the grains afterwards changes the porosity; the compaction itself has reached its own.
  const bool is_loaded =
      std::ranges::any_of(c.stages, [](const Stage& s) { return !std::holds_alternative<CompactStage>(s) && !puts_fluid(s); });
  if (stage->porosity && !is_loaded)
    near(stage->porosity_region == CompactStage::Region::core ? "porosity_core" : "porosity_box", *stage->porosity,
         porosity_tolerance, fmt::format("{:g} ± {:g}", *stage->porosity, porosity_tolerance));
}

/// Every stage that loaded the grains: stress, balance of energy, overlaps, and whether it was quasi-static.
void add_loading(std::vector<Check>& checks, const Case& c, const RunResults& results) {
  for (int stage = 0; stage < size_of(c.stages); ++stage) {
    const std::string name = stage_name(c, stage);
    const auto at_most = [&](const char* what, double bound) {
      const auto found = results.scalars.find(name + what);
      if (found != results.scalars.end())
        checks.push_back({name + what, fmt::format("at most {:g}", bound), found->second, found->second <= bound});
    };
    at_most("_stress_error", stress_tolerance);
    at_most("_energy_residual", energy_tolerance);
    at_most("_largest_overlap", overlap_tolerance);
    at_most("_inertial_number", quasi_static_inertial_number);
  }
}

/// Every permeability stage: what flows in flows out; between periodic faces the tensor is symmetric; it is positive.
void add_permeability(std::vector<Check>& checks, const State& state, const RunResults& results) {
  const auto& s = results.scalars;
  for (const PermeabilityResult& r : state.permeability) {
    const auto at_most = [&](const std::string& name, double bound) {
      if (const auto found = s.find(name); found != s.end())
        checks.push_back({name, fmt::format("at most {:g}", bound), found->second, found->second <= bound});
    };
    at_most(r.stage + "_imbalance", flux_tolerance);
    at_most(r.stage + "_asymmetry", symmetry_tolerance);
    const auto lowest = s.find(r.stage + "_principal_3_m2");
    const double least = lowest != s.end() ? lowest->second : r.permeability.mean();
    checks.push_back({r.stage + ", the lowest principal value (m²)", "above 0", least, least > 0.0});
  }
}

}  // namespace

bool expected_bounds_hold(const Case& c, const RunResults& results) {
  std::vector<Check> checks;
  add_expected(checks, c, results);
  return std::ranges::all_of(checks, &Check::passed);
}

std::vector<Check> run_checks(const Case& c, const State& state, const RunResults* results) {
  std::vector<Check> checks;
  const auto within = [&](const char* name, double value, double tolerance) {
    checks.push_back({name, fmt::format("within ±{:g}", tolerance), value, std::abs(value) <= tolerance});
  };
  if (state.network.pores() > 0 && state.particles.size() > 0)
    within("pore volume + grain volume = box volume (relative)", volume_defect(state), volume_tolerance);
  if (!state.saturation.empty()) {
    const auto [low, high] = std::ranges::minmax(state.saturation);
    const double worst = high - 1.0 > -low ? high : low;
    const bool is_solved_for = !state.flows.empty() || !state.unsaturated_flows.empty();
    const double rounding = is_solved_for ? flow_tolerance : 0.0;
    checks.push_back({"saturation of every pore, the farthest out", "0 to 1", worst, low >= -rounding && high <= 1.0 + rounding});
  }
  if (!results) return checks;
  if (results->ledger.void_volume > 0.0) {
    const double tolerance = state.flows.empty() ? volume_tolerance : flow_tolerance;
    within("wetting fluid: in − out = change (of the void)", results->ledger.wetting_error(), tolerance);
    within("non-wetting fluid: in − out = change (of the void)", results->ledger.nonwetting_error(), tolerance);
  }
  add_packing(checks, c, *results);
  add_loading(checks, c, *results);
  add_permeability(checks, state, *results);
  add_expected(checks, c, *results);
  return checks;
}

}  // namespace puadem
