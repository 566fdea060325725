#include "puadem/coupling/unsaturated_step.hpp"

#include <algorithm>
#include <cmath>

#include "puadem/base/compensated_sum.hpp"
#include "puadem/base/error.hpp"
#include "puadem/coupling/fluid_transfer.hpp"
#include "puadem/coupling/vanishing_pores.hpp"
#include "puadem/coupling/wall_guard.hpp"
#include "puadem/coupling/wall_servo.hpp"
#include "puadem/dem/bridge_forces.hpp"
#include "puadem/dem/motion.hpp"
#include "puadem/dem/stress.hpp"
#include "puadem/dem/time_step.hpp"
#include "puadem/network/network_geometry.hpp"

namespace puadem {

namespace {

constexpr long check_interval = 50;      // steps of the grains between two looks at rest
constexpr double slow = 1e3;             // time over which pores change, over the drainage time of the median pore
constexpr double largest_strain = 0.05;  // of the void, at which a new network is made

TwoPhaseModel model_of(const UnsaturatedOptions& options, const PoreNetwork& network, const PackingSites& sites,
                       double capillary_pressure) {
  FlowBoundary air;
  air.name = face_names[to_size(options.air)];
  air.fluid = FluidPhase::nonwetting;
  air.pores = face_pores(network, options.air);
  air.schedule = Schedule::constant(0.0);
  air.initial_gas_fraction = options.initial_air_fraction;
  std::vector<FlowBoundary> boundaries{std::move(air)};
  for (int face = 0; face < 6; ++face) {
    if (!options.water[to_size(face)]) continue;
    FlowBoundary& water = boundaries.emplace_back();
    water.name = face_names[to_size(face)];
    water.pores = face_pores(network, face);
    water.schedule = Schedule::constant(-capillary_pressure);
  }
  return make_two_phase_model(network, options.fluids, options.flow, std::move(boundaries),
                              throat_films(network, sites, options.fluids.contact_angle));
}

void renew_cache(const UnsaturatedOptions& options, const PoreNetwork& network, std::span<const Vec3> centre,
                 const Particles& particles, const Domain& domain, double capillary_pressure, UnsaturatedCache& cache) {
  const PackingSites sites(centre, particles.radius, domain);
  cache.model = model_of(options, network, sites, capillary_pressure);
  cache.areas = pushed_areas(network, sites, ThroatShare::contact_line, options.network.no_slip);
}

struct Held {
  double water = 0.0, gas = 0.0;  ///< [m3]
};

Held held_by(const PoreNetwork& network, const UnsaturatedState& state, const TwoPhaseModel& model) {
  CompensatedSum water, gas;
  for (int p = 0; p < network.pores(); ++p) {
    if (!model.is_counted(p)) continue;
    const double w = state.flow.wetting_volume[to_size(p)];
    water.add(w);
    gas.add(network.pore_volume[to_size(p)] - w);
  }
  return {water.value(), gas.value()};
}

[[noreturn]] void throw_vanished(const PoreNetwork& network, const MovedVoids& voids, int pore, long step) {
  const Vec3& at = network.pore_centre[to_size(pore)];
  throw NumericalError(fmt::format(
      "step {}: pore {} at ({:g}, {:g}, {:g}) m has vanished between its grains, it has {:.3g} m3 left and no neighbour with "
      "room; a smaller remesh_displacement or step of the capillary pressure helps",
      step, pore, at.x, at.y, at.z, voids.pore[to_size(pore)]));
}

/// Has a grain moved so far that the network must be made anew?
bool have_gone_far(const UnsaturatedOptions& options, const GrainSystem& grains, Particles& particles,
                   const UnsaturatedState& state) {
  collect_places(grains, particles);
  return largest_displacement(state.place, followed_centres(state.place, particles, grains.domain)) > options.remesh_displacement;
}

void advance(long steps, GrainSystem& grains, UnsaturatedState& state) {
  renew_wall_areas(grains);
  advance_grains(grains, steps);
  guard_walls(grains);
  state.grain_steps += steps;
  state.grain_time += static_cast<double>(steps) * grains.time_step;
}

}  // namespace

void set_fluid_forces(const UnsaturatedOptions& options, const PoreNetwork& network, const Particles& particles,
                      GrainSystem& grains, UnsaturatedState& state, const UnsaturatedCache& cache) {
  const std::vector<double> pressure = options.bridges
                                           ? pendular_pressures(network, *cache.model, state.flow, options.bridges->coalescence)
                                           : effective_pressures(network, *cache.model, state.flow);
  state.forces = pressure_forces(network, cache.areas, pressure, {}, particles.size());
  state.tension = tension_forces(network, cache.areas, pressure, particles.size());
  freeze_forces(state.forces, grains);
}

void renew_cache(const UnsaturatedOptions& options, const PoreNetwork& network, const Particles& particles, const Domain& domain,
                 const UnsaturatedState& state, UnsaturatedCache& cache) {
  renew_cache(options, network, followed_centres(state.place, particles, domain), particles, domain, state.capillary_pressure,
              cache);
}

UnsaturatedState start_unsaturated(const UnsaturatedOptions& options, const PoreNetwork& network, const Particles& particles,
                                   GrainSystem& grains, UnsaturatedCache& cache) {
  UnsaturatedState state;
  state.place = place_of(network, particles, grains.domain);
  state.capillary_pressure = options.dry_at.value_or(0.0);
  renew_cache(options, network, particles, grains.domain, state, cache);
  state.flow = options.dry_at ? start_dry(network, *cache.model, *options.dry_at) : start_two_phase(network, *cache.model);
  if (options.bridges && grains.bridges) {
    collect_bridges(grains);
    state.bridge_water = compensated_sum(grains.bridges->bridges.volume);
  }
  const Held held = held_by(network, state, *cache.model);
  state.void_listed = compensated_sum(network.pore_volume);
  state.water_start = held.water + state.bridge_water;
  state.gas_start = held.gas;
  set_fluid_forces(options, network, particles, grains, state, cache);
  return state;
}

bool rest_grains(const UnsaturatedOptions& options, GrainSystem& grains, Particles& particles, UnsaturatedState& state) {
  const auto holds_stress = [&] {
    return std::ranges::all_of(grains.walls, [&](const Wall& w) {
      if (!w.target) return true;
      return std::abs(-dot(w.force + w.fluid_force, w.normal) / w.area / *w.target - 1.0) < options.stress_tolerance;
    });
  };
  for (long step = 0;; step += check_interval) {
    evaluate_forces(grains);
    renew_wall_areas(grains);
    const GrainMeasures m = measure(grains);
    if (step > 0 && m.unbalanced < options.unbalanced && holds_stress()) return true;
    ensure(state.settling_steps < options.most_steps,
           "step {}: the grains do not come to rest at a capillary pressure of {:.4g} Pa within {} steps; their unbalanced force "
           "ratio is {:.3g}",
           grains.steps, state.capillary_pressure, state.settling_steps, m.unbalanced);
    if (step > 0 && have_gone_far(options, grains, particles, state)) return false;
    renew_time_step(grains);
    advance(check_interval, grains, state);
    state.settling_steps += check_interval;
  }
}

void move_grains(const UnsaturatedOptions& options, double duration, GrainSystem& grains, Particles& particles,
                 UnsaturatedState& state) {
  const double end = state.grain_time + duration;
  do {
    evaluate_forces(grains);
    renew_time_step(grains);
    const auto steps = static_cast<long>(std::ceil((end - state.grain_time) / grains.time_step * (1.0 - 1e-9)));
    advance(std::clamp(steps, 1L, check_interval), grains, state);
  } while (state.grain_time < end * (1.0 - 1e-12) && !have_gone_far(options, grains, particles, state));
}

void follow_grains(const UnsaturatedOptions& options, GrainSystem& grains, Particles& particles, PoreNetwork& network,
                   UnsaturatedState& state, UnsaturatedCache& cache) {
  const double time = slow * cache.model->time_scale;
  state.flow.time_step = time;
  state.flow.time = 0.0;  // counts for nothing here, and the interval would be rounded beside a long one
  follow_grains(options, time, {}, grains, particles, network, state, cache);
}

void follow_grains(const UnsaturatedOptions& options, double time, std::span<const double> uptake, GrainSystem& grains,
                   Particles& particles, PoreNetwork& network, UnsaturatedState& state, UnsaturatedCache& cache) {
  collect(grains, particles);
  const Domain& domain = grains.domain;
  const std::vector<Vec3> centre = followed_centres(state.place, particles, domain);
  MovedVoids voids = moved_voids(network, state.place, centre, particles.radius, domain);
  const std::vector<BorrowedRoom> borrowed = borrow_room(network, *cache.model, state.flow, voids.pore);
  if (!borrowed.empty() && borrowed.back().from < 0) throw_vanished(network, voids, borrowed.back().pore, grains.steps);

  std::vector<double> rate(voids.pore.size());
  for (std::size_t p = 0; p < rate.size(); ++p) rate[p] = (voids.pore[p] - network.pore_volume[p]) / time;
  state.fluid_steps += advance_two_phase(network, *cache.model, time, {rate, uptake}, state.flow).steps;
  give_back_room(borrowed, voids.pore, state.flow);
  fill_reservoirs(*cache.model, voids.pore, state.flow);

  const double strain = std::abs(compensated_sum(voids.pore) / state.void_listed - 1.0);
  const bool is_deformed = voids.inverted >= 0 || !borrowed.empty() || strain > largest_strain ||
                           largest_displacement(state.place, centre) + state.swelling.grown > options.remesh_displacement;
  if (is_deformed) {
    const std::vector<int> kinds = fluid_kinds(state.flow);
    network.pore_volume = voids.pore;
    RebuiltNetwork rebuilt = remesh(network, kinds, centre, particles, domain, options.network, state.place);
    const TwoPhaseModel former = *cache.model;
    renew_cache(options, rebuilt.network, particles.position, particles, domain, state.capillary_pressure, cache);
    state.flow = carry_fluids(network, voids.cell, former, rebuilt, *cache.model, state.flow, &state.pores_changed);
    state.cells_renewed += static_cast<long>(rebuilt.match.appeared.index.size());
    ++state.remeshes;
    state.swelling.grown = 0.0;
    state.void_listed = compensated_sum(rebuilt.network.pore_volume);
    network = std::move(rebuilt.network);
  } else {
    update_network_geometry(network, centre, particles.radius, domain, options.network);
    renew_cache(options, network, centre, particles, domain, state.capillary_pressure, cache);
  }
}

void set_water_pressure(const Schedule& pressure, UnsaturatedCache& cache) {
  for (FlowBoundary& boundary : cache.model->boundaries)
    if (boundary.fluid == FluidPhase::wetting) boundary.schedule = pressure;
}

void rest_fluids(const UnsaturatedOptions& options, const PoreNetwork& network, const Particles& particles, GrainSystem& grains,
                 UnsaturatedState& state, UnsaturatedCache& cache, const TwoPhaseCallbacks& callbacks) {
  set_water_pressure(Schedule::constant(-state.capillary_pressure), cache);
  RestCriterion rest;
  // Newton's method leaves saturations within its tolerance; rest is no less than that.
  rest.saturation_change = std::max(rest.saturation_change, 10.0 * cache.model->options.steps.tolerance);
  state.fluid_steps += equilibrate_two_phase(network, *cache.model, rest, state.flow, callbacks).steps;
  if (options.bridges) {
    evaluate_forces(grains);
    state.bridge_water = follow_pores(*options.bridges, state.capillary_pressure, network, *cache.model, state.flow, grains);
  }
  set_fluid_forces(options, network, particles, grains, state, cache);
}

std::array<double, 2> ledger_errors(const PoreNetwork& network, const UnsaturatedState& state, const UnsaturatedCache& cache) {
  const Held held = held_by(network, state, *cache.model);
  const FluidLedger& l = state.flow.ledger;
  const double space = held.water + held.gas;
  const double water = held.water + state.bridge_water;
  return {(state.water_start + l.wetting_in.value() - l.wetting_out.value() - water) / space,
          (state.gas_start + l.nonwetting_in.value() - l.nonwetting_out.value() - held.gas) / space};
}

}  // namespace puadem
