#pragma once

#include "puadem/coupling/run.hpp"
#include "puadem/io/archive.hpp"

// The members of what grains and fluids that move each other keep, for the archive; the others stand in state_fields.hpp.

namespace puadem {

template <>
inline constexpr bool is_row<SaturatedRow> = true;
template <>
inline constexpr bool is_row<PressureLayer> = true;
template <>
inline constexpr bool is_row<PoreSpaceRow> = true;
template <>
inline constexpr bool is_row<LocalBlock> = true;

// Grains and one fluid.

void fields(auto& a, Is<NetworkPlace> auto& place) {
  auto& [centre, domain, orientation] = place;
  each(a, "centre domain orientation", centre, domain, orientation);
}

void fields(auto& a, Is<FluidForces> auto& forces) {
  auto& [grain, wall] = forces;
  each(a, "grain wall", grain, wall);
}

void fields(auto& a, Is<SaturatedState> auto& s) {
  auto& [place, pore_volume, pressure, inflow, stored, void_start, void_now, forces, steps, remeshes, cells_renewed] = s;
  each(a, "place pore_volume pressure inflow stored void_start void_now forces steps remeshes cells_renewed", place, pore_volume,
       pressure, inflow, stored, void_start, void_now, forces, steps, remeshes, cells_renewed);
}

void fields(auto& a, Is<SaturatedRow> auto& row) {
  auto& [stage, step, time, settlement, pressure_mean, pressure_largest, inlet_pressure, gradient, contact_stress_lower,
         contact_stress_upper, fluid_in, void_volume, ledger_error, porosity, unbalanced, remeshes, time_factor, degree,
         degree_pressure, degree_terzaghi] = row;
  each(a, "stage step time settlement pressure_mean pressure_largest inlet_pressure gradient contact_stress_lower", stage, step,
       time, settlement, pressure_mean, pressure_largest, inlet_pressure, gradient, contact_stress_lower);
  each(a, "contact_stress_upper fluid_in void_volume ledger_error porosity unbalanced remeshes", contact_stress_upper, fluid_in,
       void_volume, ledger_error, porosity, unbalanced, remeshes);
  each(a, "time_factor degree degree_pressure degree_terzaghi", time_factor, degree, degree_pressure, degree_terzaghi);
}

void fields(auto& a, Is<ConsolidationReference> auto& r) {
  auto& [load, settlement, stiffness, permeability, drainage_length, coefficient] = r;
  each(a, "load settlement stiffness permeability drainage_length coefficient", load, settlement, stiffness, permeability,
       drainage_length, coefficient);
}

void fields(auto& a, Is<PressureProfile> auto& profile) {
  auto& [time, time_factor, layers] = profile;
  each(a, "time time_factor layers", time, time_factor, layers);
}

void fields(auto& a, Is<SaturatedRecord> auto& record) {
  auto& [stage, axis, reference, rows, profiles, coupling_limit, coupling_interval] = record;
  each(a, "stage axis reference rows profiles coupling_limit coupling_interval", stage, axis, reference, rows, profiles,
       coupling_limit, coupling_interval);
}

void fields(auto& a, Is<SwellingState> auto& s) {
  auto& [grain, start_radius, start_mass, wetted, from_pores, from_reservoirs, grown] = s;
  each(a, "grain start_radius start_mass wetted from_pores from_reservoirs grown", grain, start_radius, start_mass, wetted,
       from_pores, from_reservoirs, grown);
}

void fields(auto& a, Is<SwellingRow> auto& r) {
  auto& [radius_mean, radius_least, radius_most, wetted, grown, from_pores, from_reservoirs, water_error, mean_stress,
         deviatoric_stress, grain_deviator_mean, grain_deviator_deviation] = r;
  each(a, "radius_mean radius_least radius_most wetted grown from_pores from_reservoirs water_error", radius_mean, radius_least,
       radius_most, wetted, grown, from_pores, from_reservoirs, water_error);
  each(a, "mean_stress deviatoric_stress grain_deviator_mean grain_deviator_deviation", mean_stress, deviatoric_stress,
       grain_deviator_mean, grain_deviator_deviation);
}

void fields(auto& a, Is<UnsaturatedState> auto& s) {
  auto& [place, flow, forces, tension, capillary_pressure, void_listed, water_start, gas_start, bridge_water, remeshes,
         cells_renewed, pores_changed, grain_steps, fluid_steps, grain_time, settling_steps, swelling] = s;
  each(a, "place flow forces tension capillary_pressure void_listed water_start gas_start remeshes cells_renewed pores_changed",
       place, flow, forces, tension, capillary_pressure, void_listed, water_start, gas_start, remeshes, cells_renewed,
       pores_changed);
  each(a, "grain_steps fluid_steps grain_time settling_steps swelling bridge_water", grain_steps, fluid_steps, grain_time,
       settling_steps, swelling, bridge_water);
}

void fields(auto& a, Is<UnsaturatedRow> auto& r) {
  auto& [stage, branch, time, capillary_pressure, pc_star, saturation, strain, volume_strain, porosity, total_stress,
         contact_stress, bridge_stress, fluid_stress, chi_contact, chi_fluid, mean_force, mean_force_ratio, strong_share,
         chains_span, coordination, contact_anisotropy, capillary_anisotropy, capillary_force, pressure_force, tension_force,
         bridges, bridge_force, bridge_saturation, trapped_wetting, trapped_nonwetting, wetting_error, nonwetting_error, rounds,
         remeshes, pores_changed] = r;
  each(a, "stage branch time capillary_pressure pc_star saturation strain volume_strain porosity total_stress contact_stress",
       stage, branch, time, capillary_pressure, pc_star, saturation, strain, volume_strain, porosity, total_stress,
       contact_stress);
  each(a, "fluid_stress chi_contact chi_fluid mean_force mean_force_ratio strong_share chains_span coordination", fluid_stress,
       chi_contact, chi_fluid, mean_force, mean_force_ratio, strong_share, chains_span, coordination);
  each(a, "contact_anisotropy capillary_anisotropy capillary_force pressure_force tension_force trapped_wetting",
       contact_anisotropy, capillary_anisotropy, capillary_force, pressure_force, tension_force, trapped_wetting);
  each(a, "trapped_nonwetting wetting_error nonwetting_error rounds remeshes pores_changed", trapped_nonwetting, wetting_error,
       nonwetting_error, rounds, remeshes, pores_changed);
  each(a, "bridge_stress bridges bridge_force bridge_saturation", bridge_stress, bridges, bridge_force, bridge_saturation);
}

void fields(auto& a, Is<ForceSpread> auto& spread) {
  auto& [contact, capillary] = spread;
  each(a, "contact capillary", contact, capillary);
}

void fields(auto& a, Is<PoreSizes> auto& sizes) {
  auto& [samples, mean, deviation, parts, part, first_class, density_begin, classes] = sizes;
  each(a, "samples mean deviation parts part first_class density_begin classes", samples, mean, deviation, parts, part,
       first_class, density_begin, classes);
}

void fields(auto& a, Is<PoreSpaceRow> auto& row) {
  auto& [pore_radius, throat_radius, porosity] = row;
  each(a, "pore_radius throat_radius porosity", pore_radius, throat_radius, porosity);
}

void fields(auto& a, Is<LocalBlock> auto& block) {
  auto& [grains, porosity, saturation, displacement] = block;
  each(a, "grains porosity saturation displacement", grains, porosity, saturation, displacement);
}

void fields(auto& a, Is<UnsaturatedRecord> auto& record) {
  auto& [stage, axis, rows, spreads, swelling, pore_space, pore_density, blocks, local] = record;
  each(a, "stage axis rows spreads swelling pore_space pore_density blocks local", stage, axis, rows, spreads, swelling,
       pore_space, pore_density, blocks, local);
}

}  // namespace puadem
