#include "remesh.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "puadem/base/random.hpp"
#include "puadem/coupling/fluid_transfer.hpp"
#include "puadem/coupling/ready_grains.hpp"
#include "puadem/dem/motion.hpp"

namespace puadem::verification {

namespace {

constexpr double mean_radius = 0.2e-3;  // [m]
constexpr double always = -1.0;         // displacement at which a new network is made

Case layer(int count, double height) {
  Case c;
  c.seed = 3;
  c.domain.periodic = {true, true, false};
  c.domain.shape = {1, 1, height};
  c.materials = {Material{.name = "glass", .density = 2650.0, .youngs_modulus = 1.5e8, .friction_angle = 0.5}};
  c.grains.count = count;
  c.grains.material = "glass";
  c.grains.grading = {Grading::By::number, {{0.26e-3, 0.54e-3, 1.0}}};
  c.contact.law = ContactOptions::Law::linear_spring;
  CompactStage compact;
  compact.stress = TwoFluidLayer::stress;
  compact.friction_angle = 0.1;
  c.stages = {compact};
  return c;
}

/// The errors of both books.
double ledger_of(const TwoFluidLayer& bed) {
  const auto [water, gas] = ledger_errors(bed.network, bed.fluids, bed.cache);
  return std::max(std::abs(water), std::abs(gas));
}

/// What the fullest pore holds over its volume, less one.
double overfull(const TwoFluidLayer& bed) {
  double most = -1.0;
  for (std::size_t p = 0; p < bed.network.pore_volume.size(); ++p)
    most = std::max(most, bed.fluids.flow.wetting_volume[p] / bed.network.pore_volume[p] - 1.0);
  return most;
}

void follow(TwoFluidLayer& bed) {
  follow_grains(bed.options, bed.grains, bed.particles, bed.network, bed.fluids, bed.cache);
  bed.domain = bed.grains.domain;
}

double height_of(const TwoFluidLayer& bed) { return bed.grains.domain.size().z; }

/// Pores at the present places of the grains; each keeps its saturation.
MovedVoids move_pores(TwoFluidLayer& bed) {
  TwoPhaseState& flow = bed.fluids.flow;
  const auto centre = followed_centres(bed.fluids.place, bed.particles, bed.domain);
  MovedVoids voids = moved_voids(bed.network, bed.fluids.place, centre, bed.particles.radius, bed.domain);
  for (std::size_t p = 0; p < voids.pore.size(); ++p) flow.wetting_volume[p] *= voids.pore[p] / bed.network.pore_volume[p];
  bed.network.pore_volume = voids.pore;
  return voids;
}

/// A new network at the present places, without any flow. @return cells renewed
long carry_to_new_network(std::span<const double> cell_void, TwoFluidLayer& bed) {
  TwoPhaseState& flow = bed.fluids.flow;
  const auto centre = followed_centres(bed.fluids.place, bed.particles, bed.domain);
  RebuiltNetwork now =
      remesh(bed.network, fluid_kinds(flow), centre, bed.particles, bed.domain, bed.options.network, bed.fluids.place);
  const TwoPhaseModel former = *bed.cache.model;
  renew_cache(bed.options, now.network, bed.particles, bed.domain, bed.fluids, bed.cache);
  flow = carry_fluids(bed.network, cell_void, former, now, *bed.cache.model, flow);
  const long cells = now.match.appeared.index.size();
  bed.network = std::move(now.network);
  return cells;
}

/// Grains that have left through a periodic face come in through the opposite one.
void wrap(TwoFluidLayer& bed) {
  const Vec3 size = bed.domain.size();
  for (Vec3& x : bed.particles.position)
    for (int axis = 0; axis < 2; ++axis) x[axis] -= size[axis] * std::floor((x[axis] - bed.domain.lower[axis]) / size[axis]);
}

/// Water below a height, air above it.
void fill_below(double front, TwoFluidLayer& bed) {
  TwoPhaseState& flow = bed.fluids.flow;
  for (int p = 0; p < bed.network.pores(); ++p) {
    const auto i = to_size(p);
    const bool gas = bed.network.pore_centre[i].z > front;
    flow.nonwetting.holds[i] = gas;
    flow.wetting.holds[i] = !gas;
    flow.wetting_volume[i] = gas ? 0.0 : bed.network.pore_volume[i];
  }
}

}  // namespace

TwoFluidLayer::TwoFluidLayer(int count, double height) {
  const Case c = layer(count, height);
  State state;
  run(c, state, {});
  grains = ready_grains(c, state, {});
  particles = std::move(state.particles);
  collect(grains, particles);
  hold_stress(5, stress, loading_scale(c, grains, particles, measure(grains)), grains);
  grains.motion.strain_with_box = false;
  grains.motion.damping = 0.3;
  domain = grains.domain;
  options.flow.gas = GasKind::connected;
  options.flow.touching_first = true;
  options.remesh_displacement = always;
  network = build_pore_network(particles.position, particles.radius, domain, options.network);
  fluids = start_unsaturated(options, network, particles, grains, cache);
}

void TwoFluidLayer::rest_fluids() { puadem::rest_fluids(options, network, particles, grains, fluids, cache); }

void TwoFluidLayer::drain_to(double saturation) {
  for (; saturation_now() > saturation; fluids.capillary_pressure += 50.0) rest_fluids();
}

ShearedLayer shear_under_suction(int count, int remeshes) {
  constexpr double speed = 0.02;  // of the wall [m/s]: an inertial number of 1e-3
  TwoFluidLayer bed(count, 1.0);
  for (Wall& wall : bed.grains.walls) {
    wall.friction = 0.5;
    if (wall.face == 5) wall.slide = {speed, 0.0, 0.0};
  }
  bed.drain_to(0.6);
  ShearedLayer found;
  found.saturation = bed.saturation_now();
  const double begin = bed.fluids.grain_time;
  for (; found.remeshes < remeshes; ++found.remeshes) {
    for (int batch = 0; batch < 4; ++batch)
      move_grains(bed.options, 50.0 * bed.grains.time_step, bed.grains, bed.particles, bed.fluids);
    follow(bed);
    found.ledger = std::max(found.ledger, ledger_of(bed));
    found.overfull = std::max(found.overfull, overfull(bed));
    bed.rest_fluids();
    found.ledger = std::max(found.ledger, ledger_of(bed));
  }
  found.cells_renewed = bed.fluids.cells_renewed;
  found.shear = speed * (bed.fluids.grain_time - begin) / height_of(bed);
  found.saturation_last = bed.saturation_now();
  return found;
}

int bits_changed_at_rest(int count, int remeshes) {
  TwoFluidLayer bed(count, 1.0);
  bed.drain_to(0.6);
  const PoreNetwork before = bed.network;
  const TwoPhaseState fluids = bed.fluids.flow;
  const FluidForces forces = bed.fluids.forces;
  for (int k = 0; k < remeshes; ++k) carry_to_new_network(bed.network.tetrahedron_void, bed);
  set_fluid_forces(bed.options, bed.network, bed.particles, bed.grains, bed.fluids, bed.cache);
  int changed = 0;
  const auto compare = [&](const auto& now, const auto& then) {
    changed += now.size() != then.size();
    for (std::size_t k = 0; k < std::min(now.size(), then.size()); ++k) changed += now[k] != then[k];
  };
  compare(bed.network.pore_volume, before.pore_volume);
  compare(bed.network.throat_conductance, before.throat_conductance);
  compare(bed.network.throat_entry_radius, before.throat_entry_radius);
  compare(bed.network.tetrahedron_pore, before.tetrahedron_pore);
  compare(bed.fluids.flow.wetting_volume, fluids.wetting_volume);
  compare(bed.fluids.flow.wetting_pressure, fluids.wetting_pressure);
  compare(bed.fluids.flow.nonwetting.holds, fluids.nonwetting.holds);
  compare(bed.fluids.flow.nonwetting.passes, fluids.nonwetting.passes);
  compare(bed.fluids.forces.grain, forces.grain);
  return changed;
}

RemeshedFront front_through(int count, int remeshes, double displacement) {
  TwoFluidLayer bed(count, 3.0);
  const double front = bed.domain.lower.z + 0.5 * height_of(bed), diameter = 2.0 * mean_radius;
  fill_below(front, bed);
  const auto water_of = [&] {
    return std::accumulate(bed.fluids.flow.wetting_volume.begin(), bed.fluids.flow.wetting_volume.end(), 0.0);
  };
  const double water = water_of();
  const std::vector<Vec3> home = bed.particles.position;
  Random random(7);
  RemeshedFront found;
  for (; found.remeshes < remeshes; ++found.remeshes) {
    for (std::size_t k = 0; k < home.size(); ++k)
      for (int axis = 0; axis < 3; ++axis)
        bed.particles.position[k][axis] = home[k][axis] + displacement * mean_radius * random.uniform(-1.0, 1.0);
    wrap(bed);
    found.cells_renewed += carry_to_new_network(move_pores(bed).cell, bed);
  }
  double above = 0.0, space = 0.0;
  for (int p = 0; p < bed.network.pores(); ++p) {
    const auto i = to_size(p);
    const double beyond = bed.network.pore_centre[i].z - front, volume = bed.network.pore_volume[i],
                 s = bed.fluids.flow.wetting_volume[i] / volume;
    space += volume;
    if (beyond > 0.0) above += bed.fluids.flow.wetting_volume[i];
    if (beyond > 0.0 ? s > 0.5 : s < 0.5) found.farthest = std::max(found.farthest, std::abs(beyond) / diameter);
  }
  found.passed = above / space * height_of(bed) / diameter;
  found.water = water_of() / water - 1.0;
  return found;
}

RemeshedDrainage drain_with_remeshes(int count, int every, int stops) {
  constexpr double step = 182.0;  // [Pa]: half of gamma / <r>
  TwoFluidLayer bed(count, 2.0);
  RemeshedDrainage found;
  const auto strain = [&](double first) { return std::log(first / height_of(bed)); };
  double first = height_of(bed);
  int coupled_steps = 0;
  for (int stop = 0; stop <= stops; ++stop) {
    bed.fluids.capillary_pressure = stop * step;
    bed.fluids.settling_steps = 0;
    for (double saturation_before = 2.0, strain_before = 1.0;;) {
      bool rested = false;
      while (!rested) {
        bed.rest_fluids();
        bed.options.remesh_displacement = always;  // the grains stop after 50 steps
        rested = rest_grains(bed.options, bed.grains, bed.particles, bed.fluids);
        if (++coupled_steps % every != 0) bed.options.remesh_displacement = std::numeric_limits<double>::infinity();
        follow(bed);
      }
      const double s = bed.saturation_now(), e = strain(first);
      if (std::abs(s - saturation_before) < 1e-3 && std::abs(e - strain_before) < 1e-5) break;
      saturation_before = s;
      strain_before = e;
    }
    if (stop == 0) first = height_of(bed);
    found.capillary_pressure.push_back(bed.fluids.capillary_pressure);
    found.saturation.push_back(bed.saturation_now());
    found.strain.push_back(strain(first));
  }
  found.remeshes = bed.fluids.remeshes;
  return found;
}

}  // namespace puadem::verification
