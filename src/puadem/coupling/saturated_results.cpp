#include "puadem/coupling/saturated_results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace puadem {

namespace {

/// The last row before the gradient rises.
std::vector<SaturatedRow>::const_iterator last_at_rest(const SaturatedRecord& record) {
  const auto rising = std::ranges::find_if(record.rows, [](const SaturatedRow& r) { return r.gradient > 0.0; });
  return rising == record.rows.begin() ? rising : std::prev(rising);
}

/// Weight of the grains under the fluid and the stress on them, over the weight of the same column of fluid (theory 7.5).
double gradient_of_weight(const Case& c, const SaturatedStage& stage, const SaturatedRecord& record, const GrainSystem& grains) {
  double mass = 0.0, volume = 0.0;
  for (int k = 0; k < grains.owned; ++k) {
    const double r = radius_of(grains.record[to_size(k)]);
    mass += mass_of(grains.record[to_size(k)]);
    volume += 4.0 / 3.0 * std::numbers::pi * r * r * r;
  }
  const double g = std::abs(c.motion.gravity[record.axis]), density = c.fluids.wetting.density;
  const double area = grains.domain.volume() / grains.domain.size()[record.axis];
  const double box = volume / (1.0 - last_at_rest(record)->porosity);
  return ((mass - density * volume) * g + stage.stress.value_or(0.0) * area) / (density * g * box);
}

/// Gradient at which the grains leave the wall of the inlet: zero of the straight line through the stresses on it while
/// they fall from 0.9 to 0.2 of the last before the gradient rises; none where they do not.
std::optional<double> critical_gradient(const SaturatedStage& stage, const SaturatedRecord& record) {
  const auto stress = [&](const SaturatedRow& r) {
    return is_upper(*stage.inlet) ? r.contact_stress_upper : r.contact_stress_lower;
  };
  const auto at_rest = last_at_rest(record);
  const double first = stress(*at_rest);
  double n = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0, last = first;
  for (auto at = at_rest; at != record.rows.end(); ++at) {
    const SaturatedRow& r = *at;
    last = std::min(last, stress(r));
    if (stress(r) > 0.9 * first || last < 0.2 * first) continue;
    n += 1.0;
    x += r.gradient;
    y += stress(r);
    xx += r.gradient * r.gradient;
    xy += r.gradient * stress(r);
  }
  const double spread = n * xx - x * x;
  if (n < 3.0 || last > 0.2 * first || !(spread > 0.0)) return std::nullopt;
  const double slope = (n * xy - x * y) / spread;
  return (y - slope * x) / n / -slope;
}

}  // namespace

SaturatedRow saturated_row(const PoreNetwork& network, const SaturatedState& fluid, const GrainSystem& grains,
                           const GrainMeasures& m, const SaturatedRecord& record, double height) {
  SaturatedRow row;
  row.stage = record.stage;
  row.step = fluid.steps;
  row.settlement = height - grains.domain.size()[record.axis];
  double volume = 0.0, sum = 0.0, largest = 0.0;
  for (std::size_t p = 0; p < fluid.pressure.size(); ++p) {
    volume += network.pore_volume[p];
    sum += network.pore_volume[p] * fluid.pressure[p];
    largest = std::max(largest, std::abs(fluid.pressure[p]));
  }
  row.pressure_mean = sum / volume;
  row.pressure_largest = largest;
  row.contact_stress_lower = m.wall_stress[to_size(2 * record.axis)];
  row.contact_stress_upper = m.wall_stress[to_size(2 * record.axis + 1)];
  for (const CompensatedSum& face : fluid.inflow) row.fluid_in += face.value();
  row.void_volume = fluid.void_now;
  row.ledger_error = fluid.ledger_error();
  row.unbalanced = m.unbalanced;
  row.remeshes = fluid.remeshes;
  return row;
}

void set_degrees(const ConsolidationReference& r, SaturatedRow& row) {
  row.time_factor = r.coefficient * row.time / (r.drainage_length * r.drainage_length);
  row.degree = row.settlement / r.settlement;
  row.degree_pressure = 1.0 - row.pressure_mean / r.load;
  row.degree_terzaghi = terzaghi_degree(*row.time_factor);
}

void describe_saturated(const Case& c, const SaturatedStage& stage, const SaturatedRecord& record, const SaturatedState& fluid,
                        const GrainSystem& grains, RunResults& results) {
  const auto set = [&](std::string_view name, double value) {
    results.scalars[fmt::format("{}_{}", record.stage, name)] = value;
  };
  double ledger = 0.0;
  for (const SaturatedRow& row : record.rows) ledger = std::max(ledger, std::abs(row.ledger_error));
  set("ledger_error", ledger);
  set("coupled_steps", static_cast<double>(fluid.steps));
  set("remeshes", static_cast<double>(fluid.remeshes));
  set("coupling_limit_s", record.coupling_limit);
  set("coupling_interval_s", record.coupling_interval);
  set("settlement_m", record.rows.back().settlement);
  set("pressure_mean_end_Pa", record.rows.back().pressure_mean);
  if (const auto& r = record.reference) {
    set("stiffness_Pa", r->stiffness);
    set("permeability_m2", r->permeability);
    set("cv_m2_s", r->coefficient);
    double error = 0.0, pressure_error = 0.0;
    for (const SaturatedRow& row : record.rows)
      if (*row.time_factor > 0.05 && *row.time_factor < 1.0) {
        error = std::max(error, std::abs(*row.degree - *row.degree_terzaghi));
        pressure_error = std::max(pressure_error, std::abs(*row.degree_pressure - *row.degree_terzaghi));
      }
    set("degree_error", error);
    set("degree_error_pressure", pressure_error);
    set("degree_end", *record.rows.back().degree);
  }
  if (stage.inlet && c.motion.gravity[record.axis] != 0.0) {
    const double expected = gradient_of_weight(c, stage, record, grains);
    set("critical_gradient_of_weight", expected);
    if (const auto found = critical_gradient(stage, record)) {
      set("critical_gradient", *found);
      set("critical_gradient_over_weight", *found / expected);
    }
  }
}

}  // namespace puadem
