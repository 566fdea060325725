#include "puadem/coupling/saturated_step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "puadem/base/error.hpp"
#include "puadem/base/random.hpp"
#include "puadem/coupling/wall_guard.hpp"
#include "puadem/dem/motion.hpp"

namespace puadem {

namespace {

bool is_closed(const SaturatedOptions& options) {
  for (const FaceCondition& face : options.faces)
    if (face.kind == FaceCondition::Kind::pressure) return false;
  return !options.bulk_modulus;
}

/// In a closed box the pores change at the expense of each other; what rounding leaves of their sum is shared among them.
void close_rates(std::span<const double> volume, std::vector<double>& rate) {
  const double excess = compensated_sum(rate), space = compensated_sum(volume);
  for (std::size_t p = 0; p < rate.size(); ++p) rate[p] -= excess * volume[p] / space;
}

SinglePhaseFlow solve(const SaturatedOptions& options, const PoreNetwork& network, const Domain& domain,
                      std::span<const double> rate, const std::optional<SlightCompressibility>& compressibility,
                      std::span<const double> guess, SaturatedCache& cache) {
  SinglePhaseProblem problem;
  problem.faces = options.faces;
  problem.viscosity = options.viscosity;
  problem.volume_rate = rate;
  problem.compressibility = compressibility;
  problem.conductance_limits = options.limits;
  problem.guess = guess;
  return solve_single_phase(network, domain, problem, cache.memory);
}

/// Hands the forces of the pressures, and buoyancy, to grains and walls.
void set_forces(const SaturatedOptions& options, const PoreNetwork& network, const Particles& particles, GrainSystem& grains,
                SaturatedState& state, const SaturatedCache& cache) {
  state.forces = pressure_forces(network, cache.areas, state.pressure, {}, particles.size());
  add_buoyancy(particles.radius, options.density, grains.motion.gravity, {}, state.forces.grain);
  freeze_forces(state.forces, grains);
}

/// Fluid over the time `dt` in which the pores came to `volume`.
void advance_fluid(const SaturatedOptions& options, const PoreNetwork& network, const Domain& domain, double dt,
                   std::vector<double> volume, SaturatedState& state, SaturatedCache& cache) {
  std::vector<double> rate(volume.size());
  for (std::size_t p = 0; p < rate.size(); ++p) rate[p] = (volume[p] - state.pore_volume[p]) / dt;
  // Where a wall moves the sum is no rounding, and the solve refuses it.
  const bool is_rounding = std::abs(compensated_sum(volume) - state.void_now) < 1e-12 * state.void_now;
  if (is_closed(options) && is_rounding) close_rates(network.pore_volume, rate);
  std::optional<SlightCompressibility> compressibility;
  if (options.bulk_modulus) compressibility = SlightCompressibility{*options.bulk_modulus, dt, state.pressure};
  SinglePhaseFlow flow = solve(options, network, domain, rate, compressibility, state.pressure, cache);
  for (int face = 0; face < 6; ++face) state.inflow[to_size(face)].add(dt * flow.face_inflow[to_size(face)]);
  if (options.bulk_modulus)
    for (std::size_t p = 0; p < rate.size(); ++p)
      state.stored.add(network.pore_volume[p] / *options.bulk_modulus * (flow.pressure[p] - state.pressure[p]));
  state.pressure = std::move(flow.pressure);
  state.void_now = compensated_sum(volume);
  state.pore_volume = std::move(volume);
}

/// The former pore that all cells of a pore belonged to, or -1.
int former_pore(const PoreNetwork& before, const RebuiltNetwork& now, int pore) {
  int former = -1;
  for (const int c : now.network.pore_tetrahedra[pore]) {
    const int old = now.match.before[to_size(c)];
    const int its = old < 0 ? -1 : before.tetrahedron_pore[to_size(old)];
    if (its < 0 || (former >= 0 && its != former)) return -1;
    former = its;
  }
  return former;
}

/// Pressures go over with the fluid: a pore of new cells has the mean of those whose place they take.
std::vector<double> carried_pressure(const PoreNetwork& before, const RebuiltNetwork& now, std::span<const double> pressure) {
  const PoreNetwork& network = now.network;
  std::vector<double> held(before.tetrahedron_void);
  for (std::size_t c = 0; c < held.size(); ++c) held[c] *= pressure[to_size(before.tetrahedron_pore[c])];
  const std::vector<double> carried = carry_over(now.match, held, network.tetrahedron_void),
                            space = carry_over(now.match, before.tetrahedron_void, network.tetrahedron_void);
  std::vector<double> result(to_size(network.pores()));
  for (int p = 0; p < network.pores(); ++p) {
    if (const int former = former_pore(before, now, p); former >= 0) {
      result[to_size(p)] = pressure[to_size(former)];
      continue;
    }
    double sum = 0.0, whole = 0.0;
    for (const int c : network.pore_tetrahedra[p]) {
      sum += carried[to_size(c)];
      whole += space[to_size(c)];
    }
    result[to_size(p)] = sum / whole;
  }
  return result;
}

/// The new cells tile the box: their voids add to what the moved ones added to.
void require_tiling(const PoreNetwork& before, const PoreNetwork& now, const Particles& particles, int inverted, double space,
                    long step) {
  constexpr double tolerance = 1e-9;  // of the void; rounding leaves 1e-13
  const double change = compensated_sum(now.pore_volume) / space - 1.0;
  if (std::abs(change) < tolerance) return;
  std::string place = "no cell has turned inside out";
  if (inverted >= 0) {
    const auto& vertices = before.triangulation.vertices[to_size(inverted)];
    const auto grain = std::ranges::find_if(vertices, [](const Vertex& v) { return !v.is_wall(); });
    const Vec3& x = particles.position[to_size(grain->index)];
    place = fmt::format("tetrahedron {} beside grain {} at ({:.6g}, {:.6g}, {:.6g}) m has turned inside out", inverted,
                        grain->index, x.x, x.y, x.z);
  }
  throw NumericalError(
      fmt::format("step {}: {}, and a new network does not mend it: its void differs by {:.3g} of all; grains have moved too far "
                  "within one coupled step",
                  step, place, change));
}

void renew_network(const SaturatedOptions& options, const std::vector<Vec3>& centre, int inverted, const Particles& particles,
                   const GrainSystem& grains, PoreNetwork& network, SaturatedState& state, SaturatedCache& cache) {
  RebuiltNetwork rebuilt = remesh(network, {}, centre, particles, grains.domain, options.network, state.place);
  require_tiling(network, rebuilt.network, particles, inverted, state.void_now, grains.steps);
  state.pressure = carried_pressure(network, rebuilt, state.pressure);
  state.pore_volume = rebuilt.network.pore_volume;
  state.cells_renewed += static_cast<long>(rebuilt.match.appeared.index.size());
  ++state.remeshes;
  network = std::move(rebuilt.network);
  renew_cache(options, network, particles.radius, state.place, cache);
}

}  // namespace

double SaturatedState::ledger_error() const {
  CompensatedSum sum = stored;
  for (const CompensatedSum& face : inflow) sum.add(-face.value());
  sum.add(void_now - void_start);
  return sum.value() / void_start;
}

void renew_cache(const SaturatedOptions& options, const PoreNetwork& network, std::span<const double> radius,
                 const NetworkPlace& place, SaturatedCache& cache) {
  cache.areas =
      pushed_areas(network, PackingSites(place.centre, radius, place.domain), ThroatShare::surface, options.network.no_slip);
  constexpr int cholesky_limit = 150'000;  // unknowns: one factor serves hundreds of steps
  PressureSolverOptions solver = cache.memory.solver;
  solver.cholesky_limit = std::max(solver.cholesky_limit, cholesky_limit);
  cache.memory = {};
  cache.memory.solver = solver;
}

SaturatedState start_saturated(const SaturatedOptions& options, const PoreNetwork& network, const Particles& particles,
                               GrainSystem& grains, SaturatedCache& cache) {
  SaturatedState state;
  state.place = place_of(network, particles, grains.domain);
  state.pore_volume = network.pore_volume;
  state.void_start = state.void_now = compensated_sum(network.pore_volume);
  state.pressure.assign(to_size(network.pores()), 0.0);
  renew_cache(options, network, particles.radius, state.place, cache);
  set_forces(options, network, particles, grains, state, cache);
  return state;
}

void saturated_step(const SaturatedOptions& options, long substeps, GrainSystem& grains, Particles& particles,
                    PoreNetwork& network, SaturatedState& state, SaturatedCache& cache) {
  advance_grains(grains, substeps);
  guard_walls(grains);
  collect_places(grains, particles);
  const double dt = static_cast<double>(substeps) * grains.time_step;

  const std::vector<Vec3> centre = followed_centres(state.place, particles, grains.domain);
  MovedVoids voids = moved_voids(network, state.place, centre, particles.radius, grains.domain);
  const double strain = std::abs(compensated_sum(voids.pore) / compensated_sum(network.pore_volume) - 1.0);
  const bool has_vanished = std::ranges::any_of(voids.pore, [](double space) { return space <= 0.0; });
  advance_fluid(options, network, grains.domain, dt, std::move(voids.pore), state, cache);
  set_forces(options, network, particles, grains, state, cache);

  if (voids.inverted >= 0 || has_vanished || strain > options.remesh_strain ||
      largest_displacement(state.place, centre) > options.remesh_displacement)
    renew_network(options, centre, voids.inverted, particles, grains, network, state, cache);
  ++state.steps;
}

double coupling_limit(const SaturatedOptions& options, const PoreNetwork& network, const Particles& particles,
                      const Domain& domain, SaturatedCache& cache) {
  constexpr int most_iterations = 60;
  constexpr double probe = 1e-6;  // of the mean radius: how far grains are moved to see their pores change
  SaturatedOptions drained = options;
  drained.bulk_modulus.reset();
  for (FaceCondition& face : drained.faces)
    if (face.kind == FaceCondition::Kind::pressure) face.value = 0.0;
  const NetworkPlace place = place_of(network, particles, domain);
  const double radius = compensated_sum(particles.radius) / particles.size();
  Random random(1);
  std::vector<Vec3> velocity(to_size(particles.size())), centre(velocity.size());
  for (Vec3& v : velocity) v = {random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0)};
  double rate = 0.0;
  for (int k = 0; k < most_iterations; ++k) {
    double fastest = 0.0;
    for (const Vec3& v : velocity) fastest = std::max(fastest, norm(v));
    const double dt = probe * radius / fastest;
    const auto voids_at = [&](double time) {
      for (std::size_t i = 0; i < centre.size(); ++i) centre[i] = place.centre[i] + time * velocity[i];
      return moved_voids(network, place, centre, particles.radius, domain).pore;
    };
    const std::vector<double> before = voids_at(-dt), after = voids_at(dt);
    std::vector<double> change(before.size());
    for (std::size_t p = 0; p < change.size(); ++p) change[p] = (after[p] - before[p]) / (2.0 * dt);
    if (is_closed(drained)) close_rates(network.pore_volume, change);
    const std::vector<double> pressure = solve(drained, network, domain, change, {}, {}, cache).pressure;
    const FluidForces forces = pressure_forces(network, cache.areas, pressure, {}, particles.size());
    double power = 0.0, kinetic = 0.0;
    for (std::size_t i = 0; i < velocity.size(); ++i) {
      power -= dot(forces.grain[i], velocity[i]);
      kinetic += particles.mass[i] * squared_norm(velocity[i]);
    }
    const double last = rate, size = std::sqrt(kinetic);
    for (std::size_t i = 0; i < velocity.size(); ++i) velocity[i] = forces.grain[i] / (-particles.mass[i] * size);
    rate = power / kinetic;
    if (std::abs(rate - last) < 1e-3 * rate) break;
  }
  return rate > 0.0 ? 2.0 / rate : std::numeric_limits<double>::infinity();
}

void require_below_limit(std::string_view stage, double interval, double limit) {
  require(
      interval < limit,
      "stage {}: coupling_interval = {:.4g} s: forces of the fluid that stay frozen that long make the grains swing ever more; "
      "the limit is {:.4g} s (theory 7.3)",
      stage, interval, limit);
}

}  // namespace puadem
