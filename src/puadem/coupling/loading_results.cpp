#include "puadem/coupling/loading_results.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "puadem/base/parallel.hpp"

namespace puadem {

namespace {

using Rows = std::span<const HistoryRow>;

constexpr double degrees = 180.0 / std::numbers::pi;

/// The rows of the last tenth of a stage, at least one: what lasts, without the noise of one row.
Rows last_tenth(Rows rows) { return rows.subspan(rows.size() - std::max<std::size_t>(rows.size() / 10, 1)); }

template <class Value>
double mean_of(Rows rows, const Value& value) {
  double sum = 0.0;
  for (const HistoryRow& row : rows) sum += value(row);
  return sum / static_cast<double>(rows.size());
}

/// Least-squares slope of volumetric against axial strain.
double slope(Rows rows) {
  const double x0 = mean_of(rows, [](const auto&r) { return r.strain.z; }),
               y0 = mean_of(rows, [](const auto&r) { return r.volumetric; });
  double xy = 0.0, xx = 0.0;
  for (const HistoryRow& r : rows) {
    xy += (r.strain.z - x0) * (r.volumetric - y0);
    xx += (r.strain.z - x0) * (r.strain.z - x0);
  }
  return xx > 0.0 ? xy / xx : 0.0;
}

void describe(const TriaxialStage& stage, Rows rows, const std::string& name, RunResults& results) {
  auto& s = results.scalars;
  const HistoryRow& peak = *std::ranges::max_element(rows, {}, [](const auto& r) { return std::abs(r.stress_ratio()); });
  s[name + "_peak_q_over_p"] = peak.stress_ratio();
  s[name + "_peak_q_Pa"] = peak.deviator;
  s[name + "_peak_strain"] = peak.strain.z;
  s[name + "_peak_friction_angle_deg"] = degrees * mobilised_friction(peak);
  s[name + "_end_friction_angle_deg"] = degrees * mean_of(last_tenth(rows), mobilised_friction);
  if (stage.path == TriaxialStage::StressPath::constant_volume || stage.strain < 0.0) return;
  const double dilatancy = largest_dilatancy(rows);
  s[name + "_dilatancy"] = dilatancy;
  s[name + "_dilation_angle_deg"] = degrees * dilation_angle(dilatancy);
}

void describe(const OedometerStage&, Rows rows, const std::string& name, RunResults& results) {
  auto& s = results.scalars;
  const auto top = std::ranges::max_element(rows, {}, [](const auto& r) { return r.stress.z; });
  s[name + "_top_stress_Pa"] = top->stress.z;
  s[name + "_k0"] = 0.5 * (top->stress.x + top->stress.y) / top->stress.z;
  const auto half = std::find_if(rows.begin(), top, [&](const auto& r) { return r.stress.z > 0.5 * top->stress.z; });
  const double decades = std::log10(top->stress.z / half->stress.z);
  if (decades > 0.0) s[name + "_compression_index"] = (half->void_ratio() - top->void_ratio()) / decades;
}

void describe(const ShearStage&, Rows rows, const std::string& name, RunResults& results) {
  auto& s = results.scalars;
  const auto ratio = [](const HistoryRow& r) { return r.normal_stress > 0.0 ? r.shear_stress / r.normal_stress : 0.0; };
  s[name + "_strain"] = rows.back().shear_strain;
  s[name + "_peak_ratio"] = ratio(*std::ranges::max_element(rows, {}, ratio));
  s[name + "_end_ratio"] = mean_of(last_tenth(rows), ratio);
}

void describe(const auto&, Rows, const std::string&, RunResults&) {}

/// Tension along the axis that bears most of it [Pa]; 0 where none does.
double tension(const HistoryRow& r) { return std::max({-r.stress.x, -r.stress.y, -r.stress.z, 0.0}); }

void describe_bridges(Rows rows, const std::string& name, RunResults& results) {
  auto& s = results.scalars;
  const HistoryRow &first = rows.front(), &last = rows.back();
  s[name + "_bridges"] = last.bridges->bridges;
  s[name + "_bridges_per_grain"] = last.bridges->coordination;
  s[name + "_bridge_force_N"] = last.bridges->mean_force;
  s[name + "_contact_force_N"] = last.bridges->mean_contact_force;
  s[name + "_bridge_stress_Pa"] = last.bridges->mean_stress;
  s[name + "_bridge_water_m3"] = last.bridges->water;
  s[name + "_bridges_formed"] = static_cast<double>(last.bridges->formed - first.bridges->formed);
  s[name + "_bridges_ruptured"] = static_cast<double>(last.bridges->ruptured - first.bridges->ruptured);
  s[name + "_water_error"] = std::abs(
      std::ranges::max_element(rows, {}, [](const auto& r) { return std::abs(r.bridges->water_error); })->bridges->water_error);
  const HistoryRow& peak = *std::ranges::max_element(rows, {}, tension);
  if (tension(peak) == 0.0) return;
  s[name + "_peak_tension_Pa"] = tension(peak);
  s[name + "_peak_tension_strain"] = peak.strain.z;
  s[name + "_rumpf_strength_Pa"] = first.bridges->rumpf_strength;
  s[name + "_peak_tension_over_rumpf"] = tension(peak) / first.bridges->rumpf_strength;
}

}  // namespace

double mobilised_friction(const HistoryRow& row) {
  const double lateral = 0.5 * (row.stress.x + row.stress.y), sum = row.stress.z + lateral;
  return sum > 0.0 ? std::asin(std::min(std::abs(row.stress.z - lateral) / sum, 1.0)) : 0.0;
}

double largest_dilatancy(Rows rows) {
  const std::size_t window = std::max<std::size_t>(rows.size() / 20, 3);
  double steepest = 0.0;
  for (std::size_t first = 0; first + window <= rows.size(); ++first)
    steepest = std::max(steepest, -slope(rows.subspan(first, window)));
  return steepest;
}

double dilation_angle(double dilatancy) { return std::asin(dilatancy / (2.0 + dilatancy)); }

HeldStress held_stress(const LoadingLeg& leg, Rows rows) {
  if (leg.end == LoadingLeg::End::rest) rows = rows.last(1);
  HeldStress held;
  double squares = 0.0;
  int count = 0;
  const auto compare = [&](const std::optional<double>& target, const auto& stress_of) {
    if (!target) return;
    held.error = std::max(held.error, std::abs(mean_of(rows, stress_of) / *target - 1.0));
    squares += mean_of(rows, [&](const HistoryRow& r) { return std::pow(stress_of(r) / *target - 1.0, 2); });
    ++count;
  };
  compare(leg.box.mean_stress, [](const HistoryRow& r) { return r.mean; });
  for (int axis = 0; axis < 3; ++axis)
    compare(leg.box.stress[to_size(axis)], [axis](const HistoryRow& r) { return r.stress[axis]; });
  if (count > 0) held.fluctuation = std::sqrt(squares / count);
  return held;
}

void describe_loading(const Stage& stage, const std::string& name, const LoadingProgram& program, Rows rows,
                      RunResults& results) {
  auto& s = results.scalars;
  const HistoryRow &first = rows.front(), &last = rows.back();
  s[name + "_steps"] = static_cast<double>(last.step - first.step);
  s[name + "_time_step_s"] = last.time_step;
  s[name + "_strain_axial"] = last.strain.z;
  s[name + "_strain_volumetric"] = last.volumetric;
  s[name + "_porosity"] = last.porosity;
  s[name + "_coordination"] = last.coordination;
  s[name + "_rattlers"] = last.rattlers;
  s[name + "_fabric_anisotropy"] = last.fabric_anisotropy;
  s[name + "_unbalanced"] = mean_of(last_tenth(rows), [](const auto& r) { return r.unbalanced; });
  s[name + "_end_p_Pa"] = mean_of(last_tenth(rows), [](const auto& r) { return r.mean; });
  s[name + "_end_q_Pa"] = mean_of(last_tenth(rows), [](const auto& r) { return r.deviator; });
  s[name + "_end_q_over_p"] = mean_of(last_tenth(rows), [](const auto& r) { return r.stress_ratio(); });
  s[name + "_largest_overlap"] = std::ranges::max_element(rows, {}, &HistoryRow::largest_overlap)->largest_overlap;
  if (program.inertial_number > 0.0) s[name + "_inertial_number"] = program.inertial_number;
  const LoadingLeg& leg = program.legs.back();
  const bool holds = leg.box.mean_stress || std::ranges::any_of(leg.box.stress, [](const auto& t) { return t.has_value(); });
  if (holds) {
    const HeldStress held = held_stress(leg, rows);
    s[name + "_stress_error"] = held.error;
    s[name + "_stress_fluctuation"] = held.fluctuation;
  }
  const double turned_over = std::max(std::abs(last.energy.input), last.energy.taken());
  const double missing =
      std::abs(std::ranges::max_element(rows, {}, [](const auto& r) { return std::abs(r.energy_residual); })->energy_residual);
  if (turned_over > 0.0) s[name + "_energy_residual"] = missing / turned_over;
  if (first.bridges && last.bridges) describe_bridges(rows, name, results);
  std::visit([&](const auto& one) { describe(one, rows, name, results); }, stage);
}

}  // namespace puadem
