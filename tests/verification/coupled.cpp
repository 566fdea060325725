#include "coupled.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "puadem/base/random.hpp"
#include "puadem/coupling/run.hpp"
#include "puadem/dem/energy.hpp"
#include "puadem/dem/motion.hpp"
#include "puadem/dem/time_step.hpp"

namespace puadem::verification {

namespace {

constexpr double radius = 1e-3;  // [m], of the largest grain

Vec3 sum_of(std::span<const Vec3> forces) {
  Vec3 sum;
  for (const Vec3& f : forces) sum += f;
  return sum;
}

double size_of_all(std::span<const Vec3> forces) {
  double sum = 0.0;
  for (const Vec3& f : forces) sum += norm(f);
  return sum;
}

testing::Spheres box(int count, std::array<bool, 3> periodic, double solid = 0.33) {
  return testing::random_spheres(count, 1.5, {1, 1, 1}, periodic, 7, solid);
}

constexpr std::array<bool, 3> all_periodic{true, true, true}, all_walls{false, false, false}, layer{true, true, false};

/// Pressures between -1 and 1 kPa.
std::vector<double> random_pressures(int pores) {
  Random random(5);
  std::vector<double> p(to_size(pores));
  for (double& v : p) v = random.uniform(-1e3, 1e3);
  return p;
}

FluidForces forces_of(const CoupledBed& bed, std::span<const double> pressure, const Vec3& jump = {}) {
  return pressure_forces(bed.network, bed.cache.areas, pressure, jump, bed.particles.size());
}

void add_archimedes(std::vector<Identity>& found) {
  CoupledBed bed(box(200, layer), 1e-3, true);
  const Vec3 gravity{0, 0, -9.81};
  FluidForces f = forces_of(bed, std::vector<double>(to_size(bed.network.pores()), 7e4));
  add_buoyancy(bed.particles.radius, 998.0, gravity, {}, f.grain);
  double worst = 0.0, whole = 0.0;
  for (int k = 0; k < bed.particles.size(); ++k) {
    const double water = 998.0 * 4.0 / 3.0 * std::numbers::pi * std::pow(bed.particles.radius[to_size(k)], 3);
    worst = std::max(worst, norm(f.grain[to_size(k)] + water * gravity) / (water * norm(gravity)));
    whole += water;
  }
  found.push_back({"Archimedes: a grain in water at rest", worst});
  found.push_back({"Archimedes: all grains together", norm(sum_of(f.grain) + whole * gravity) / (whole * norm(gravity))});
}

/// A column compacted in the dry.
Case column(int count, double stress, double youngs_modulus) {
  Case c;
  c.seed = 3;
  c.domain.periodic = layer;
  c.materials = {Material{.name = "glass", .density = 2500.0, .youngs_modulus = youngs_modulus, .friction_angle = 0.4}};
  c.grains.count = count;
  c.grains.material = "glass";
  c.grains.grading = {Grading::By::mass, {{0.8e-3, 1.2e-3, 1.0}}};
  c.contact.law = ContactOptions::Law::linear_spring;
  CompactStage compact;
  compact.stress = stress;
  c.stages = {compact};
  return c;
}

}  // namespace

CoupledBed::CoupledBed(testing::Spheres s, double viscosity, bool is_drained)
    : materials{Material{.name = "glass", .density = 2500.0, .youngs_modulus = 1e7, .friction_angle = 0.0}} {
  s = scaled_to(radius, std::move(s));
  particles = make_particles(s.centre, s.radius, materials.front());
  ContactOptions contact;
  contact.law = ContactOptions::Law::linear_spring;
  grains = make_grain_system(particles, s.domain, materials, contact, {});
  options.viscosity = viscosity;
  options.remesh_displacement = 0.02 * radius;
  options.network.merge_ratio = std::numeric_limits<double>::infinity();
  if (is_drained) options.faces[5] = {FaceCondition::Kind::pressure, 0.0};
  network = build_pore_network(particles.position, particles.radius, grains.domain, options.network);
  state = start_saturated(options, network, particles, grains, cache);
}

void CoupledBed::shake(double speed) {
  Random random(1);
  for (GrainRecord& r : grains.record)
    for (int axis = 0; axis < 3; ++axis) r.drift[axis] = random.uniform(-speed, speed);
}

std::vector<Identity> force_identities() {
  std::vector<Identity> found;
  {
    const CoupledBed bed(box(300, all_periodic), 1e-3);
    const std::vector<double> p = random_pressures(bed.network.pores());
    const FluidForces f = forces_of(bed, p);
    found.push_back({"random pressures, periodic box: sum of the forces", norm(sum_of(f.grain)) / size_of_all(f.grain)});
    const Vec3 gradient{300.0, -200.0, 100.0}, size = bed.grains.domain.size();
    const FluidForces g = forces_of(bed, p, {gradient.x * size.x, gradient.y * size.y, gradient.z * size.z});
    found.push_back({"with a mean gradient: sum less - grad p V",
                     norm(sum_of(g.grain) + bed.grains.domain.volume() * gradient) / size_of_all(g.grain)});
  }
  {
    const CoupledBed bed(box(200, all_walls), 1e-3);
    const FluidForces f = forces_of(bed, random_pressures(bed.network.pores()));
    found.push_back({"random pressures between walls: grains and walls together",
                     norm(sum_of(f.grain) + sum_of(f.wall)) / size_of_all(f.grain)});
    const double p = 2.5e4;
    const FluidForces one = forces_of(bed, std::vector<double>(to_size(bed.network.pores()), p));
    const Vec3 size = bed.grains.domain.size();
    found.push_back({"one pressure: largest force on a grain, over p R^2", size_of_all(one.grain) / (p * radius * radius)});
    double worst = 0.0;
    for (int face = 0; face < 6; ++face) {
      const double push = p * bed.grains.domain.volume() / size[axis_of(face)];
      worst = std::max(worst, norm(one.wall[to_size(face)] - push * outward_normal(face)) / push);
    }
    found.push_back({"one pressure: force on a wall less p A", worst});
  }
  add_archimedes(found);
  return found;
}

RestingBed rest_in_water(int count) {
  Case c = column(count, 50.0, 2e6);
  State state;
  run(c, state, {});
  GrainSystem& grains = *state.grains;
  for (Wall& wall : grains.walls) {
    wall.target.reset();
    wall.velocity = wall.slide = {};
    wall.friction = 0.0;
    if (wall.face == 5) wall.point.z += radius;  // bears nothing
  }
  grains.domain.upper.z += radius;
  grains.motion.gravity = {0, 0, -9.81};
  grains.motion.damping = 0.5;
  collect(grains, state.particles);
  SaturatedOptions options;
  options.faces[5] = {FaceCondition::Kind::pressure, 0.0};
  options.remesh_displacement = 0.02 * radius;
  options.network.merge_ratio = std::numeric_limits<double>::infinity();
  PoreNetwork network = build_pore_network(state.particles.position, state.particles.radius, grains.domain, options.network);
  SaturatedCache cache;
  SaturatedState fluid = start_saturated(options, network, state.particles, grains, cache);

  RestingBed bed;
  for (int k = 0; k < state.particles.size(); ++k) {
    const double r = state.particles.radius[to_size(k)];
    bed.weight += 9.81 * (state.particles.mass[to_size(k)] - options.density * 4.0 / 3.0 * std::numbers::pi * r * r * r);
  }
  constexpr double at_rest = 1e-6;
  constexpr int most = 2000;
  for (int k = 0; k < most; ++k) {
    evaluate_forces(grains);
    const GrainMeasures m = measure(grains);
    bed.unbalanced = m.unbalanced;
    for (const Wall& wall : grains.walls)
      if (wall.face == 4) bed.force = -wall.force.z;
    if (k > 10 && bed.unbalanced < at_rest) break;
    saturated_step(options, 50, grains, state.particles, network, fluid, cache);
  }
  return bed;
}

EnergyGain gain_of_energy(long substeps) {
  CoupledBed bed(box(250, all_walls), 0.02);
  bed.options.remesh_displacement = std::numeric_limits<double>::infinity();
  bed.shake(0.05);
  evaluate_forces(bed.grains);
  bed.grains.time_step = 2e-6;
  open_energy_book(bed.grains);
  const double start = energies(bed.grains).stored();
  EnergyGain gain;
  gain.interval = static_cast<double>(substeps) * bed.grains.time_step /
                  coupling_limit(bed.options, bed.network, bed.particles, bed.grains.domain, bed.cache);
  for (long k = 0; k < 400 / substeps; ++k) {
    const std::vector<Vec3> before = bed.particles.position;
    bed.step(substeps);
    for (std::size_t i = 0; i < before.size(); ++i)
      gain.taken -= dot(bed.state.forces.grain[i], bed.particles.position[i] - before[i]) / start;
    evaluate_forces(bed.grains);
    gain.gained = std::max(gain.gained, energies(bed.grains).stored() / start + gain.taken - 1.0);
  }
  return gain;
}

double time_step_change_by_remeshing() {
  const auto step_with = [](double displacement) {
    Case c = column(100, 50e3, 5e7);
    SaturatedStage stage;
    stage.loaded = 5;
    stage.stress = 55e3;
    stage.duration = 5e-5;
    stage.remesh_displacement = displacement;
    c.fluids.wetting = {0.1, 950.0};
    c.stages.emplace_back(stage);
    State state;
    run(c, state, {});
    return state.grains->time_step;
  };
  return step_with(1e-9) / step_with(1.0) - 1.0;
}

}  // namespace puadem::verification
