#include "puadem/coupling/unsaturated_results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "puadem/coupling/capillary_forces.hpp"
#include "puadem/dem/bridge_measures.hpp"
#include "puadem/dem/contacts.hpp"
#include "puadem/dem/fabric.hpp"
#include "puadem/dem/force_chains.hpp"
#include "puadem/dem/grain_stress.hpp"
#include "puadem/dem/stress.hpp"

namespace puadem {

namespace {

constexpr double worth_a_direction = 1e-6;  // of the mean contact force: less is rounding

/// Densities of sizes over their mean in classes of `ForceSpread::width`, up to the largest.
std::vector<double> spread_of(std::vector<double> sizes) {
  double sum = 0.0, largest = 0.0;
  for (const double f : sizes) {
    sum += f;
    largest = std::max(largest, f);
  }
  if (!(sum > 0.0)) return {};
  const double mean = sum / static_cast<double>(sizes.size());
  std::vector<double> density(static_cast<std::size_t>(largest / mean / ForceSpread::width) + 1, 0.0);
  for (const double f : sizes)
    density[static_cast<std::size_t>(f / mean / ForceSpread::width)] +=
        1.0 / (static_cast<double>(sizes.size()) * ForceSpread::width);
  return density;
}

std::vector<double> magnitudes(std::span<const Vec3> force) {
  std::vector<double> sizes(force.size());
  std::ranges::transform(force, sizes.begin(), [](const Vec3& f) { return norm(f); });
  return sizes;
}

double mean_of(std::span<const double> values) {
  double sum = 0.0;
  for (const double v : values) sum += v;
  return values.empty() ? 0.0 : sum / static_cast<double>(values.size());
}

/// The two walls of an axis carry grains and fluids together [Pa].
double total_stress(const GrainSystem& grains, int axis, const Tensor& contact, const Tensor& fluid) {
  double sum = 0.0;
  int walls = 0;
  for (const Wall& wall : grains.walls) {
    if (wall.face < 0 || axis_of(wall.face) != axis) continue;
    const Vec3 size = grains.domain.size();
    sum -= dot(wall.force + wall.fluid_force, wall.normal) / (size[(axis + 1) % 3] * size[(axis + 2) % 3]);
    ++walls;
  }
  const auto a = to_size(axis);
  return walls > 0 ? sum / walls : contact[a][axis] + fluid[a][axis];
}

}  // namespace

UnsaturatedRow unsaturated_row(const GrainSystem& grains, const PoreNetwork& network, const Particles& particles,
                               const UnsaturatedState& state, const UnsaturatedCache& cache, int axis) {
  const GrainMeasures m = measure(grains);
  const FabricMeasures contacts = measure_fabric(grains);
  const ForceChains chains = find_force_chains(grains);
  const Tensor fluid = fluid_stress(state.forces, particles.position, grains.domain);
  const InvasionTotals sums = totals(network, *cache.model, state.flow);
  UnsaturatedRow row;
  row.capillary_pressure = state.capillary_pressure;
  const double space = compensated_sum(network.pore_volume);
  row.saturation = sums.saturation + state.bridge_water / space;
  row.trapped_wetting = sums.trapped_wetting;
  row.trapped_nonwetting = sums.trapped_nonwetting;
  for (int a = 0; a < 3; ++a) {
    row.bridge_stress[a] = m.bridge_stress[to_size(a)][a];
    row.contact_stress[a] = m.stress[to_size(a)][a] - row.bridge_stress[a];
    row.fluid_stress[a] = fluid[to_size(a)][a];
  }
  row.total_stress = total_stress(grains, axis, m.stress, fluid);
  if (state.capillary_pressure > 0.0) {
    row.chi_contact = (row.contact_stress[axis] - row.total_stress) / state.capillary_pressure;
    row.chi_fluid = -(row.fluid_stress[axis] + row.bridge_stress[axis]) / state.capillary_pressure;
  }
  row.mean_force = contacts.mean_force;
  row.strong_share = chains.strong_share;
  row.chains_span = chains.spans;
  row.coordination = contacts.coordination;
  row.contact_anisotropy = contacts.deviatoric;
  const ForceFabric capillary = force_fabric(state.forces.grain);
  if (capillary.mean > worth_a_direction * contacts.mean_force) row.capillary_anisotropy = capillary.anisotropy;
  row.capillary_force = capillary.mean;
  std::vector<Vec3> solid = state.forces.grain;
  for (std::size_t k = 0; k < solid.size(); ++k) solid[k] -= state.tension[k];
  row.tension_force = mean_of(magnitudes(state.tension));
  row.pressure_force = mean_of(magnitudes(solid));
  if (grains.bridges) {
    const BridgeMeasures bridges = measure_bridges(grains);
    row.bridges = bridges.bridges;
    row.bridge_force = bridges.mean_force;
    row.bridge_saturation = state.bridge_water / space;
  }
  const auto [water, gas] = ledger_errors(network, state, cache);
  row.wetting_error = water;
  row.nonwetting_error = gas;
  row.remeshes = state.remeshes;
  row.pores_changed = state.pores_changed;
  return row;
}

SwellingRow swelling_row(const GrainSystem& grains, const PoreNetwork& network, const Particles& particles,
                         const SwellingState& state) {
  SwellingRow row;
  const std::vector<double> radius = swelling_radii(particles, state);
  row.radius_mean = mean_of(radius);
  row.radius_least = std::ranges::min(radius);
  row.radius_most = std::ranges::max(radius);
  row.wetted = mean_of(state.wetted);
  row.grown = grown_volume(particles, state);
  row.from_pores = state.from_pores.value();
  row.from_reservoirs = state.from_reservoirs.value();
  row.water_error = (row.grown - row.from_pores - row.from_reservoirs) / compensated_sum(network.pore_volume);
  const GrainMeasures m = measure(grains);
  row.mean_stress = m.mean_stress;
  row.deviatoric_stress = m.deviatoric_stress;
  const std::vector<double> q = grain_stresses(grains).deviatoric;
  row.grain_deviator_mean = mean_of(q);
  double squares = 0.0;
  for (const double one : q) squares += (one - row.grain_deviator_mean) * (one - row.grain_deviator_mean);
  row.grain_deviator_deviation = std::sqrt(squares / static_cast<double>(q.size()));
  return row;
}

ForceSpread force_spread(const GrainSystem& grains, const UnsaturatedState& state) {
  std::vector<double> sizes;
  for_each_grain_contact(grains, [&](int, int, const Vec3&, int slot) { sizes.push_back(grains.slot[to_size(slot)].force[3]); });
  return {spread_of(std::move(sizes)), spread_of(magnitudes(state.forces.grain))};
}

double contact_deviator(const UnsaturatedRow& row) {
  return row.contact_stress.z - 0.5 * (row.contact_stress.x + row.contact_stress.y);
}

std::optional<ChiFit> fit_chi(std::span<const UnsaturatedRow> rows, std::optional<double> UnsaturatedRow::*chi) {
  double n = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
  for (const UnsaturatedRow& r : rows) {
    if (!(r.*chi)) continue;
    n += 1.0;
    x += r.saturation;
    y += *(r.*chi);
    xx += r.saturation * r.saturation;
    xy += r.saturation * *(r.*chi);
  }
  const double spread = n * xx - x * x;
  if (n < 3.0 || !(spread > 0.0)) return std::nullopt;
  ChiFit fit;
  fit.rows = static_cast<int>(n);
  fit.slope = (n * xy - x * y) / spread;
  fit.offset = (y - fit.slope * x) / n;
  for (const UnsaturatedRow& r : rows) {
    if (!(r.*chi)) continue;
    fit.residual += std::pow(*(r.*chi) - fit.offset - fit.slope * r.saturation, 2) / n;
    fit.from_saturation += std::pow(*(r.*chi) - r.saturation, 2) / n;
  }
  fit.residual = std::sqrt(fit.residual);
  fit.from_saturation = std::sqrt(fit.from_saturation);
  return fit;
}

std::optional<DrainageRegimes> drainage_regimes(std::span<const UnsaturatedRow> branch) {
  double steepest = 0.0;
  DrainageRegimes regimes;
  for (std::size_t k = 1; k < branch.size(); ++k) {
    const UnsaturatedRow &a = branch[k - 1], &b = branch[k];
    const double slope = (b.saturation - a.saturation) / (b.pc_star - a.pc_star);
    if (!(slope < steepest)) continue;
    steepest = slope;
    const double middle = 0.5 * (a.pc_star + b.pc_star), saturation = 0.5 * (a.saturation + b.saturation);
    regimes = {middle + (1.0 - saturation) / slope, middle + (branch.back().saturation - saturation) / slope};
  }
  if (!(steepest < 0.0)) return std::nullopt;
  return regimes;
}

void describe_unsaturated(const UnsaturatedRecord& record, const UnsaturatedState& state, RunResults& results) {
  const auto set = [&](std::string_view name, double value) {
    results.scalars[fmt::format("{}_{}", record.stage, name)] = value;
  };
  double wetting = 0.0, nonwetting = 0.0, apart = 0.0;
  for (const UnsaturatedRow& r : record.rows) {
    wetting = std::max(wetting, std::abs(r.wetting_error));
    nonwetting = std::max(nonwetting, std::abs(r.nonwetting_error));
    if (r.chi_contact) apart = std::max(apart, std::abs(*r.chi_contact - *r.chi_fluid));
  }
  set("wetting_error", wetting);
  set("nonwetting_error", nonwetting);
  set("chi_apart", apart);
  const UnsaturatedRow& shortest = *std::ranges::max_element(record.rows, {}, &UnsaturatedRow::strain);
  set("strain_largest", shortest.strain);
  set("strain_largest_pc_star", shortest.pc_star);
  const UnsaturatedRow& last = record.rows.back();
  set("strain_end", last.strain);
  set("volume_strain_end", last.volume_strain);
  set("saturation_end", last.saturation);
  set("mean_force_ratio_end", last.mean_force_ratio);
  const std::span<const UnsaturatedRow> rows(record.rows);
  for (std::size_t first = 0; first < rows.size();) {
    std::size_t end = first;
    while (end < rows.size() && rows[end].branch == rows[first].branch) ++end;
    const auto branch = rows.subspan(first, end - first);
    const std::string& name = branch.front().branch;
    if (const auto fit = fit_chi(branch, &UnsaturatedRow::chi_contact)) {
      set("chi_slope_" + name, fit->slope);
      set("chi_offset_" + name, fit->offset);
      set("chi_residual_" + name, fit->residual);
      set("chi_from_saturation_" + name, fit->from_saturation);
    }
    if (name.starts_with("drainage"))
      if (const auto regimes = drainage_regimes(branch)) {
        set("air_entry_pc_star_" + name, regimes->air_entry);
        set("pendular_pc_star_" + name, regimes->pendular);
      }
    first = end;
  }
  const UnsaturatedRow* peak = nullptr;
  for (const UnsaturatedRow& r : record.rows)
    if (r.branch == "strain" && (peak == nullptr || contact_deviator(r) > contact_deviator(*peak))) peak = &r;
  if (peak != nullptr) {
    set("peak_q_Pa", contact_deviator(*peak));
    set("peak_strain", peak->strain);
    set("peak_saturation", peak->saturation);
    set("end_q_Pa", contact_deviator(last));
  }
  if (!record.swelling.empty()) {
    const SwellingRow& swollen = record.swelling.back();
    double error = 0.0;
    for (const SwellingRow& r : record.swelling) error = std::max(error, std::abs(r.water_error));
    set("swelling_radius_mean_end_m", swollen.radius_mean);
    set("swelling_radius_least_end_m", swollen.radius_least);
    set("swelling_radius_most_end_m", swollen.radius_most);
    set("swelling_grown_m3", swollen.grown);
    set("swelling_water_error", error);
    set("grain_deviator_end_Pa", swollen.grain_deviator_mean);
    set("porosity_end", last.porosity);
  }
  set("remeshes", static_cast<double>(state.remeshes));
  set("pores_changed", static_cast<double>(state.pores_changed));
  set("grain_steps", static_cast<double>(state.grain_steps));
  set("fluid_steps", static_cast<double>(state.fluid_steps));
}

}  // namespace puadem
