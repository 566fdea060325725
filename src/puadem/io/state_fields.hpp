#pragma once

#include "puadem/coupling/run.hpp"
#include "puadem/io/archive.hpp"
#include "puadem/io/state_fields_coupled.hpp"

// The members of a state, for the archive. What follows from the case alone is left out: see `complete_state`.

namespace puadem {

template <>
inline constexpr bool is_row<HistoryRow> = true;
template <>
inline constexpr bool is_row<FlowRow> = true;
template <>
inline constexpr bool is_row<RetentionRow> = true;

// Base, geometry.

void fields(auto& a, Is<Csr> auto& csr) {
  auto& [start, index] = csr;
  each(a, "start index", start, index);
}

void fields(auto& a, Is<Domain> auto& domain) {
  auto& [lower, upper, periodic] = domain;
  each(a, "lower upper periodic", lower, upper, periodic);
}

void fields(auto& a, Is<Triangulation> auto& t) {
  auto& [vertices, neighbours] = t;
  each(a, "vertices neighbours", vertices, neighbours);
}

// Grains.

void fields(auto& a, Is<Particles> auto& p) {
  auto& [position, velocity, angular_velocity, force, torque, radius, mass, inertia, material] = p;
  each(a, "position velocity angular_velocity force torque radius mass inertia material", position, velocity, angular_velocity,
       force, torque, radius, mass, inertia, material);
}

void fields(auto& a, Is<Energies> auto& e) {
  auto& [kinetic, normal, shear, friction, shear_work, roll_work, viscous, damping, bridges, wetting, input] = e;
  each(a, "kinetic normal shear friction shear_work roll_work viscous damping bridges wetting input", kinetic, normal, shear,
       friction, shear_work, roll_work, viscous, damping, bridges, wetting, input);
}

void fields(auto& a, Is<EnergyBook> auto& book) {
  auto& [is_kept, shear, roll, viscous, damping, walls, box, last_box_rate, body, wetting] = book;
  each(a, "is_kept shear roll viscous damping walls box last_box_rate body wetting", is_kept, shear, roll, viscous, damping,
       walls, box, last_box_rate, body, wetting);
}

void fields(auto& a, Is<MotionOptions> auto& motion) {
  auto& [damping, gravity, safety, strain_with_box] = motion;
  each(a, "damping gravity safety strain_with_box", damping, gravity, safety, strain_with_box);
}

void fields(auto& a, Is<Wall> auto& wall) {
  auto& [point, normal, velocity, last_velocity, face, friction, target, area, slide, servo_gain, speed_limit, servo_stress,
         force, fluid_force, stiffness] = wall;
  each(
      a,
      "point normal velocity last_velocity face friction target area slide servo_gain speed_limit servo_stress force fluid_force "
      "stiffness",
      point, normal, velocity, last_velocity, face, friction, target, area, slide, servo_gain, speed_limit, servo_stress, force,
      fluid_force, stiffness);
}

void fields(auto& a, Is<ContactBlocks> auto& blocks) {
  auto& [first, second, shear, roll, viscous, live] = blocks;
  each(a, "first second shear roll viscous live", first, second, shear, roll, viscous, live);
}

void fields(auto& a, Is<BridgePairs> auto& pairs) {
  auto& [ends, radius, gap] = pairs;
  each(a, "ends radius gap", ends, radius, gap);
}

void fields(auto& a, Is<Bridges> auto& b) {
  // Curves follow from radii and amounts.
  auto& [pairs, capillary_pressure, volume, force, curve] = b;
  each(a, "pairs capillary_pressure volume force", pairs, capillary_pressure, volume, force);
}

void fields(auto& a, Is<GrainBridges> auto& g) {
  // Model and rules follow from the case, the list from the bridges.
  auto& [model, rules, suction, bridges, film, water_start, touched, formed, ruptured, list] = g;
  each(a, "suction bridges film water_start touched formed ruptured", suction, bridges, film, water_start, touched, formed,
       ruptured);
}

void fields(auto& a, Is<GrainSystem> auto& s) {
  // Pairs, contact and law follow from the case.
  auto& [domain, box_rate, walls, pairs, contact, law, motion, time_step, steps, is_evaluated, energy, external_force, owned,
         record, identity, image_owner, image_shift, skin, slack, grown, drift_limit, listed_at, listed_in, walls_listed_at,
         listed_step, list_builds, grain_contacts, wall_contacts, wall_start, slot, roll_slot, row_start, row, bridges] = s;
  each(a, "domain box_rate walls motion time_step steps is_evaluated energy external_force owned record identity", domain,
       box_rate, walls, motion, time_step, steps, is_evaluated, energy, external_force, owned, record, identity);
  each(a, "image_owner image_shift skin slack grown drift_limit listed_at listed_in walls_listed_at listed_step list_builds",
       image_owner, image_shift, skin, slack, grown, drift_limit, listed_at, listed_in, walls_listed_at, listed_step,
       list_builds);
  each(a, "grain_contacts wall_contacts wall_start slot roll_slot row_start row bridges", grain_contacts, wall_contacts,
       wall_start, slot, roll_slot, row_start, row, bridges);
}

void fields(auto& a, Is<BridgeRow> auto& row) {
  each(a, "bridges water film water_error mean_force coordination formed ruptured", row.bridges, row.water, row.film,
       row.water_error, row.mean_force, row.coordination, row.formed, row.ruptured);
  each(a, "mean_contact_force mean_stress stress rumpf_strength", row.mean_contact_force, row.mean_stress, row.stress,
       row.rumpf_strength);
}

void fields(auto& a, Is<HistoryRow> auto& row) {
  each(a, "time strain stress mean deviator volumetric unbalanced coordination", row.time, row.strain, row.stress, row.mean,
       row.deviator, row.volumetric, row.unbalanced, row.coordination);
  each(a, "stage fraction step time_step porosity shear_strain normal_stress shear_stress coordination_inner", row.stage,
       row.fraction, row.step, row.time_step, row.porosity, row.shear_strain, row.normal_stress, row.shear_stress,
       row.coordination_inner);
  each(a, "coordination_mechanical rattlers sliding fabric_anisotropy largest_overlap", row.coordination_mechanical, row.rattlers,
       row.sliding, row.fabric_anisotropy, row.largest_overlap);
  each(a, "wall_force wall_position energy energy_residual bridges", row.wall_force, row.wall_position, row.energy,
       row.energy_residual, row.bridges);
}

void fields(auto& a, Is<HistoryStart> auto& start) {
  auto& [size, solid_volume, energies, shear_axis, shear_direction, wall_offset] = start;
  each(a, "size solid_volume energies shear_axis shear_direction wall_offset", size, solid_volume, energies, shear_axis,
       shear_direction, wall_offset);
}

// Network and one fluid.

void fields(auto& a, Is<PoreNetwork> auto& n) {
  auto& [pore_centre, pore_volume, pore_radius, pore_faces, pore_walls, pore_throats, throat_pores, throat_shift, throat_normal,
         throat_area, throat_facet_area, throat_length, throat_conductance, throat_radius, throat_entry_radius,
         throat_snap_off_radius, throat_entry_kind, throat_at_wall, triangulation, tetrahedron_void, tetrahedron_pore,
         tetrahedron_shift, throat_facet, pore_tetrahedra, windows] = n;
  each(a, "pore_centre pore_volume pore_radius pore_faces pore_walls pore_throats", pore_centre, pore_volume, pore_radius,
       pore_faces, pore_walls, pore_throats);
  each(a, "throat_pores throat_shift throat_normal throat_area throat_facet_area throat_length throat_conductance throat_radius",
       throat_pores, throat_shift, throat_normal, throat_area, throat_facet_area, throat_length, throat_conductance,
       throat_radius);
  each(a, "throat_entry_radius throat_snap_off_radius throat_entry_kind throat_at_wall", throat_entry_radius,
       throat_snap_off_radius, throat_entry_kind, throat_at_wall);
  each(a, "triangulation tetrahedron_void tetrahedron_pore tetrahedron_shift throat_facet pore_tetrahedra windows", triangulation,
       tetrahedron_void, tetrahedron_pore, tetrahedron_shift, throat_facet, pore_tetrahedra, windows);
}

void fields(auto& a, Is<Permeability> auto& k) {
  auto& [tensor, measured, imbalance, carried, joined, limited_low, limited_high, iterations, unknowns, is_factorised] = k;
  each(a, "tensor measured imbalance carried joined limited_low limited_high iterations unknowns is_factorised", tensor, measured,
       imbalance, carried, joined, limited_low, limited_high, iterations, unknowns, is_factorised);
}

void fields(auto& a, Is<PressureLayer> auto& layer) {
  auto& [place, pressure, linear, pores] = layer;
  each(a, "place pressure linear pores", place, pressure, linear, pores);
}

void fields(auto& a, Is<PermeabilityResult> auto& r) {
  auto& [stage, permeability, pores, throats, closed_throats, porosity, sauter_radius, viscosity, inlet, pressure_drop,
         darcy_velocity, linear_error, profile] = r;
  each(a, "stage permeability pores throats closed_throats porosity sauter_radius viscosity", stage, permeability, pores, throats,
       closed_throats, porosity, sauter_radius, viscosity);
  each(a, "inlet pressure_drop darcy_velocity linear_error profile", inlet, pressure_drop, darcy_velocity, linear_error, profile);
}

// Two fluids.

void fields(auto& a, Is<FluidClusters> auto& c) {
  auto& [traps, holds, passes, reservoir, connected] = c;
  each(a, "traps holds passes reservoir connected", traps, holds, passes, reservoir, connected);
}

void fields(auto& a, Is<FluidLedger> auto& ledger) {
  auto& [wetting_in, wetting_out, nonwetting_in, nonwetting_out] = ledger;
  each(a, "wetting_in wetting_out nonwetting_in nonwetting_out", wetting_in, wetting_out, nonwetting_in, nonwetting_out);
}

void fields(auto& a, Is<InvasionQueue> auto& queue) {
  auto& [heap, pore_marks, throat_marks] = queue;
  each(a, "heap pore_marks throat_marks", heap, pore_marks, throat_marks);
}

void fields(auto& a, Is<InvasionState> auto& s) {
  // Options, links and thresholds follow from case and network; a search leaves nothing behind.
  auto& [options, capillary_pressure, wetting, nonwetting, wetting_volume, counted, void_volume, ledger, links, thresholds,
         drainage, imbibition, search] = s;
  each(a, "capillary_pressure wetting nonwetting wetting_volume counted void_volume ledger drainage imbibition",
       capillary_pressure, wetting, nonwetting, wetting_volume, counted, void_volume, ledger, drainage, imbibition);
}

void fields(auto& a, Is<RetentionRow> auto& row) {
  auto& [step, branch, capillary_pressure, pc_star, saturation, trapped_wetting, trapped_nonwetting] = row;
  each(a, "step branch capillary_pressure pc_star saturation trapped_wetting trapped_nonwetting", step, branch,
       capillary_pressure, pc_star, saturation, trapped_wetting, trapped_nonwetting);
}

void fields(auto& a, Is<TwoPhaseState> auto& s) {
  auto& [time, time_step, wetting_volume, wetting_pressure, nonwetting_pressure, wetting, nonwetting, gas_amount, ledger,
         boundary_inflow, boundary_pressure, steps, is_settling, quiet_steps] = s;
  each(a, "time time_step wetting_volume wetting_pressure nonwetting_pressure wetting nonwetting gas_amount ledger", time,
       time_step, wetting_volume, wetting_pressure, nonwetting_pressure, wetting, nonwetting, gas_amount, ledger);
  each(a, "boundary_inflow boundary_pressure steps is_settling quiet_steps", boundary_inflow, boundary_pressure, steps,
       is_settling, quiet_steps);
}

void fields(auto& a, Is<FluidTopology> auto& t) {
  auto& [pores, throats, clusters] = t;
  each(a, "pores throats clusters", pores, throats, clusters);
}

void fields(auto& a, Is<FlowRow> auto& row) {
  auto& [stage, step, time, saturation, capillary_pressure, water_pressure, wetting_in, wetting_out, nonwetting_in,
         nonwetting_out, capillary_number, trapped_wetting, trapped_nonwetting, wetting, nonwetting, meniscus_area] = row;
  each(a, "stage step time saturation capillary_pressure water_pressure wetting_in wetting_out nonwetting_in nonwetting_out",
       stage, step, time, saturation, capillary_pressure, water_pressure, wetting_in, wetting_out, nonwetting_in, nonwetting_out);
  each(a, "capillary_number trapped_wetting trapped_nonwetting wetting nonwetting meniscus_area", capillary_number,
       trapped_wetting, trapped_nonwetting, wetting, nonwetting, meniscus_area);
}

void fields(auto& a, Is<BoxCount> auto& count) {
  auto& [size, boxes, dimension] = count;
  each(a, "size boxes dimension", size, boxes, dimension);
}

void fields(auto& a, Is<FlowPattern> auto& pattern) {
  auto& [saturation, finger_width, mostly, projected] = pattern;
  each(a, "saturation finger_width mostly projected", saturation, finger_width, mostly, projected);
}

void fields(auto& a, Is<HainesJump> auto& jump) {
  auto& [throat, invaded, retracting, time, invaded_pressure, retracting_pressure] = jump;
  each(a, "throat invaded retracting time invaded_pressure retracting_pressure", throat, invaded, retracting, time,
       invaded_pressure, retracting_pressure);
}

void fields(auto& a, Is<FlowRecord> auto& record) {
  auto& [stage, rows, breakthrough_time, breakthrough_saturation, pattern, jump] = record;
  each(a, "stage rows breakthrough_time breakthrough_saturation pattern jump", stage, rows, breakthrough_time,
       breakthrough_saturation, pattern, jump);
}

void fields(auto& a, Is<FlowVolumes> auto& volumes) {
  auto& [wetting, nonwetting] = volumes;
  each(a, "wetting nonwetting", wetting, nonwetting);
}

// The run.

void fields(auto& a, Is<LoadingScale> auto& scale) {
  auto& [diameter, density, youngs_modulus, size, stress, bridge_stress] = scale;
  each(a, "diameter density youngs_modulus size stress bridge_stress", diameter, density, youngs_modulus, size, stress,
       bridge_stress);
}

void fields(auto& a, Is<BoxServo> auto& servo) {
  auto& [steady_rate] = servo;
  each(a, "steady_rate", steady_rate);
}

void fields(auto& a, Is<LoadingProgress> auto& at) {
  auto& [scale, start, longest_step, first_step, first_row, last_row_step, leg, leg_step, leg_began, leg_strain, leg_stress,
         leg_rows, servo] = at;
  each(a, "scale start longest_step first_step first_row last_row_step leg leg_step leg_began leg_strain leg_stress", scale,
       start, longest_step, first_step, first_row, last_row_step, leg, leg_step, leg_began, leg_strain, leg_stress);
  each(a, "leg_rows servo", leg_rows, servo);
}

void fields(auto& a, Is<RetentionProgress> auto& at) {
  auto& [events, wetting_start] = at;
  each(a, "events wetting_start", events, wetting_start);
}

void fields(auto& a, Is<TwoPhaseProgress> auto& at) {
  auto& [start, done, saturation, awaited, last_picture, breaks_through, ends, before_jump, stop, stop_end] = at;
  each(a, "start done saturation awaited last_picture breaks_through ends before_jump stop stop_end", start, done, saturation,
       awaited, last_picture, breaks_through, ends, before_jump, stop, stop_end);
}

void fields(auto& a, Is<SaturatedProgress> auto& at) {
  auto& [start, diameter, height, began, duration, interval, longest_step, step, rows, profiles] = at;
  each(a, "start diameter height began duration interval longest_step step rows profiles", start, diameter, height, began,
       duration, interval, longest_step, step, rows, profiles);
}

void fields(auto& a, Is<UnsaturatedProgress> auto& at) {
  auto& [began, mean_radius, first_force, start_size, stop, round, strain_rate, strain_rows, motion_began, interval, time_rows,
         saturation_before, strain_before, first_centre, first_domain] = at;
  each(a, "began mean_radius first_force start_size stop round strain_rate strain_rows motion_began interval time_rows", began,
       mean_radius, first_force, start_size, stop, round, strain_rate, strain_rows, motion_began, interval, time_rows);
  each(a, "saturation_before strain_before first_centre first_domain", saturation_before, strain_before, first_centre,
       first_domain);
}

void fields(auto& a, Is<RunPosition> auto& position) {
  auto& [stage, is_packing_shown, progress] = position;
  each(a, "stage is_packing_shown progress", stage, is_packing_shown, progress);
}

void fields(auto& a, Is<State> auto& s) {
  auto& [position, time, domain, particles, grains, history, network, reservoir_pores, permeability, invasion, flow, flows,
         saturated, saturated_flows, unsaturated, unsaturated_flows, saturation, retention] = s;
  each(a, "position time domain particles grains history network reservoir_pores permeability", position, time, domain, particles,
       grains, history, network, reservoir_pores, permeability);
  each(a, "invasion flow flows saturated saturated_flows unsaturated unsaturated_flows saturation retention", invasion, flow,
       flows, saturated, saturated_flows, unsaturated, unsaturated_flows, saturation, retention);
}

void fields(auto& a, Is<Ledger> auto& ledger) {
  auto& [void_volume, wetting_start, wetting_in, wetting_out, wetting_end, nonwetting_start, nonwetting_in, nonwetting_out,
         nonwetting_end] = ledger;
  each(a, "void_volume wetting_start wetting_in wetting_out wetting_end", void_volume, wetting_start, wetting_in, wetting_out,
       wetting_end);
  each(a, "nonwetting_start nonwetting_in nonwetting_out nonwetting_end", nonwetting_start, nonwetting_in, nonwetting_out,
       nonwetting_end);
}

void fields(auto& a, Is<RunResults> auto& results) {
  auto& [scalars, ledger, interrupted] = results;
  each(a, "scalars ledger interrupted", scalars, ledger, interrupted);
}

}  // namespace puadem
