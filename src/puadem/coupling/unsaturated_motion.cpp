#include "puadem/coupling/unsaturated_motion.hpp"

#include <algorithm>

#include "puadem/coupling/saturated_step.hpp"
#include "puadem/coupling/wall_guard.hpp"
#include "puadem/coupling/wall_servo.hpp"
#include "puadem/dem/grain_statistics.hpp"
#include "puadem/dem/motion.hpp"
#include "puadem/dem/time_step.hpp"

namespace puadem {

namespace {

constexpr long time_step_interval = 50;  // steps of the grains between two looks at their time step
constexpr double farthest = 0.01;        // of the mean radius, that a grain goes under frozen forces

/// Steps of the grains, which grow after each of them. @return the time they took [s]
double advance(std::span<const Material> materials, double density, double longest, GrainSystem& grains, Particles& particles,
               UnsaturatedState& state) {
  double time = 0.0;
  renew_wall_areas(grains);
  for (long step = 0;; ++step) {
    if (step % time_step_interval == 0) {
      evaluate_forces(grains);
      renew_time_step(grains, longest);
    }
    if (step > 0 && time + grains.time_step > longest * (1.0 + 1e-9)) break;
    advance_grains(grains, 1);
    time += grains.time_step;
    ++state.grain_steps;
    if (state.swelling.size() > 0) swell_grains(materials, density, grains.time_step, grains, particles, state.swelling);
  }
  guard_walls(grains);
  state.grain_time += time;
  return time;
}

}  // namespace

double frozen_limit(const UnsaturatedOptions& options, const PoreNetwork& network, const Particles& particles,
                    const Domain& domain) {
  SaturatedOptions full;
  full.viscosity = options.fluids.wetting.viscosity;
  full.network = options.network;
  for (int face = 0; face < 6; ++face)
    if (options.water[to_size(face)]) full.faces[to_size(face)] = {FaceCondition::Kind::pressure, 0.0};
  SaturatedCache cache;
  renew_cache(full, network, particles.radius, place_of(network, particles, domain), cache);
  return coupling_limit(full, network, particles, domain, cache);
}

double move_in_time(const UnsaturatedOptions& options, std::span<const Material> materials, double longest,
                    const Schedule& pressure, double time, GrainSystem& grains, Particles& particles, PoreNetwork& network,
                    UnsaturatedState& state, UnsaturatedCache& cache) {
  SwellingShares shares;
  if (state.swelling.size() > 0)
    shares = set_wetting(network, *cache.model, state.flow, followed_centres(state.place, particles, grains.domain),
                         particles.radius, grains.domain, state.swelling);
  const std::vector<double> before = swelling_radii(particles, state.swelling);
  const double mean_radius = statistics_of(particles.radius).mean_radius;
  if (grains.drift_limit > 0.0) longest = std::min(longest, farthest * mean_radius / grains.drift_limit);
  const double taken = advance(materials, options.fluids.wetting.density, longest, grains, particles, state);

  const double began = state.flow.time;
  set_water_pressure(Schedule{{began, began + taken}, {-pressure.at(time), -pressure.at(time + taken)}}, cache);
  state.capillary_pressure = pressure.at(time + taken);
  std::vector<double> uptake;
  if (state.swelling.size() > 0) uptake = take_up(*cache.model, shares, before, taken, particles, state.swelling);
  follow_grains(options, taken, uptake, grains, particles, network, state, cache);
  set_fluid_forces(options, network, particles, grains, state, cache);
  return taken;
}

}  // namespace puadem
