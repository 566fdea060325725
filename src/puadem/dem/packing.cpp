#include "puadem/dem/packing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "puadem/base/error.hpp"
#include "puadem/dem/boundary_program.hpp"
#include "puadem/dem/guards.hpp"
#include "puadem/dem/motion.hpp"
#include "puadem/dem/sphere_in_box.hpp"
#include "puadem/dem/time_step.hpp"

namespace puadem {

namespace {

constexpr int control_interval = 10;     // steps between two settings of the box's rate of strain
constexpr int check_interval = 50;       // steps between two looks at porosity, rest and time step
constexpr double loose_inertia = 0.05;   // inertial number of the straining cloud
constexpr double dense_inertia = 4e-3;   // of a packing that carries stress
constexpr double relaxation_steps = 60;  // in which the box makes up for a missing stress

/// A compaction under way.
struct Compaction {
  GrainSystem& system;
  const CompactionOptions& options;
  const CompactionCallback& callback;
  Particles& particles;
  double largest_radius;
  double natural_rate;                           ///< strain rate at an inertial number of one [1/s]
  double longest_step;                           ///< time step while nothing touches yet [s]
  std::vector<PairConstants<double>> own_pairs;  ///< of the grains, with the friction of their materials
  GrainMeasures measures;
  double porosity = 1.0;  ///< of the region asked for
  double fraction = 0.0;
  bool stopped = false;
};

/// Largest relative distance of an axis from the target stress, and of a wall where side walls without friction
/// leave the two walls of an axis alike.
double stress_error(const Compaction& c) {
  const auto is_rough = [](const Wall& wall) { return wall.friction > 0.0; };
  const bool rough = std::any_of(c.system.walls.begin(), c.system.walls.end(), is_rough);
  double error = 0.0;
  for (int face = 0; face < 6; ++face) {
    const auto axis = static_cast<unsigned>(axis_of(face));
    const double stress = c.system.domain.is_wall(face) && !rough ? c.measures.wall_stress[static_cast<unsigned>(face)]
                                                                  : c.measures.stress[axis][axis_of(face)];
    error = std::max(error, std::abs(stress / c.options.stress - 1.0));
  }
  return error;
}

double mean_axis_stress(const Compaction& c) {
  const Vec3 stress = axis_stress(c.system, c.measures);
  return (stress.x + stress.y + stress.z) / 3.0;
}

double region_porosity(const Compaction& c, CompactionOptions::Region region) {
  const Domain& box = c.system.domain;
  return porosity_of(c.particles.position, c.particles.radius,
                     region == CompactionOptions::Region::core ? core_of(box, 2.0 * c.largest_radius) : box);
}

/// Rate of strain that makes up for the missing stress of every axis, within the inertial number allowed.
void control_box(Compaction& c) {
  GrainSystem& s = c.system;
  c.measures = measure(s);
  const GrainMeasures& m = c.measures;
  const double target = c.options.stress;
  const bool loose = m.mean_stress < 0.02 * target && m.coordination < 4.0;
  const double limit = c.natural_rate * (loose ? loose_inertia : dense_inertia);
  BoxProgram program{
      .stress = {target, target, target}, .strain_rate = {}, .rate_limit = limit, .relaxation_steps = relaxation_steps};
  if (loose) program = {.stress = {}, .strain_rate = {limit, limit, limit}};
  steer_box(s, program, m);
}

/// Runs `check_interval` steps and looks; sooner where the shrinking box has brought the porosity to `enough`.
void run_interval(Compaction& c, double enough = 0.0) {
  const double solid = (1.0 - c.porosity) * c.system.domain.volume();
  for (int step = 0; step < check_interval && 1.0 - solid / c.system.domain.volume() > enough; ++step) {
    evaluate_forces(c.system);
    if (step % control_interval == 0) control_box(c);
    move_grains(c.system);
  }
  evaluate_forces(c.system);
  guard_grains(c.system);
  c.measures = measure(c.system);
  renew_time_step(c.system, c.longest_step);
  collect(c.system, c.particles);
  c.porosity = region_porosity(c, c.options.region);
  ensure(c.system.steps < c.options.max_steps,
         "step {}: the packing is not at rest after {} steps; mean stress {:.4g} Pa of {:.4g}, porosity {:.4f}, unbalanced force "
         "{:.2g}",
         c.system.steps, c.options.max_steps, c.measures.mean_stress, c.options.stress, c.porosity, c.measures.unbalanced);
  if (c.callback)
    c.stopped = !c.callback({c.system.steps, c.porosity, c.measures.mean_stress, c.measures.unbalanced, c.fraction});
}

bool at_rest(const Compaction& c, double unbalanced, double stress_tolerance) {
  return c.measures.unbalanced < unbalanced && stress_error(c) < stress_tolerance;
}

/// The same friction between all grains; the time step depends on it.
void set_friction(Compaction& c, double friction) {
  for (auto& pair : c.system.pairs.grains) pair.friction = friction;
  renew_time_step(c.system, c.longest_step);
}

/// Each pair keeps its own friction where that is lower.
void limit_friction(Compaction& c, double friction) {
  for (std::size_t k = 0; k < c.own_pairs.size(); ++k)
    c.system.pairs.grains[k].friction = std::min(c.own_pairs[k].friction, friction);
}

void restore_friction(Compaction& c) {
  c.system.pairs.grains = c.own_pairs;
  renew_time_step(c.system, c.longest_step);
}

/// The cloud is strained until it carries the stress, near rest.
void build_stress(Compaction& c) {
  const double start = c.porosity;
  while (!c.stopped && !at_rest(c, 1e-2, 0.03)) {
    run_interval(c);
    const double strained = std::clamp((start - c.porosity) / (start - 0.38), 0.0, 1.0);
    c.fraction = std::max(c.fraction, 0.4 * strained);
  }
}

/// Porosity that the missing stress will take away. The grains move among each other too, so the packing is
/// softer than its springs under a homogeneous strain; half their stiffness is usual.
double coming_compression(const Compaction& c) {
  double strain = 0.0;
  for (int axis = 0; axis < 3; ++axis) {
    const double missing = c.options.stress - c.measures.stress[static_cast<unsigned>(axis)][axis];
    if (missing > 0.0 && c.measures.affine_modulus[axis] > 0.0) strain += missing / (0.5 * c.measures.affine_modulus[axis]);
  }
  return (1.0 - c.porosity) * strain;
}

/// Lowers the friction, near rest all the time, until the porosity is reached. A step aims at a third of what
/// is left, by the fall of porosity that the last step has brought.
/// @return lowest friction used
double lower_friction(Compaction& c, double friction, double target) {
  constexpr double least_friction = 1e-3;
  const double start = c.porosity;
  double slope = 0.015;  // dn / d ln(mu), a guess for the first step
  limit_friction(c, friction);
  double last_porosity = start, last_step = 0.0;
  while (!c.stopped && c.porosity > target + coming_compression(c)) {
    if (at_rest(c, 1.5e-2, 0.03)) {
      if (last_step > 0.0) slope = std::clamp((last_porosity - c.porosity) / last_step, 0.003, 0.03);
      last_porosity = c.porosity;
      last_step = std::clamp(0.33 * (c.porosity - target) / slope, 0.03, 0.4);
      friction *= std::exp(-last_step);
      if (friction < least_friction) return least_friction;
      limit_friction(c, friction);
    }
    run_interval(c, target + coming_compression(c));
    c.fraction = std::max(c.fraction, 0.4 + 0.5 * std::clamp((start - c.porosity) / (start - target), 0.0, 1.0));
  }
  return friction;
}

/// Next to no friction is left: without any, compacts as far as it goes, or to the target.
void compact_frictionless(Compaction& c, double target) {
  set_friction(c, 0.0);
  while (!c.stopped && c.porosity > target + coming_compression(c) && !at_rest(c, c.options.unbalanced, 0.01))
    run_interval(c, target + coming_compression(c));
  require(c.stopped || c.porosity <= target + coming_compression(c),
          "porosity {:.4f} of the {} cannot be reached: frictionless grains of this grading pack to {:.4f} at {:.4g} Pa; ask for "
          "more than that",
          target, c.options.region == CompactionOptions::Region::core ? "core" : "box", c.porosity, c.options.stress);
}

void settle(Compaction& c) {
  do {
    run_interval(c);
    c.fraction = std::max(c.fraction, 0.9);
  } while (!c.stopped &&
           !(at_rest(c, c.options.unbalanced, 0.015) && std::abs(c.measures.mean_stress / c.options.stress - 1.0) < 0.005));
}

/// From a packing under stress to one of the target porosity.
/// @return lowest friction used
double compact_to_porosity(Compaction& c, double friction, double target) {
  constexpr double near_enough = 4e-4;
  if (c.stopped) return friction;
  require(c.porosity > target - 0.002,
          "porosity {:.4f} cannot be reached: with the grains' own friction the packing is {:.4f} already; ask for less, or "
          "raise the friction angle",
          target, c.porosity);
  // The stop allows for what the last of the stress takes away; where it allowed too much, again.
  for (int round = 0; round < 8 && !c.stopped && (round == 0 || c.porosity > target + near_enough); ++round) {
    friction = lower_friction(c, friction, target);
    if (c.porosity > target + coming_compression(c)) compact_frictionless(c, target);
    restore_friction(c);
    if (!c.stopped) settle(c);
  }
  return friction;
}

/// Takes away the last velocities of a packing at rest.
void stop_motion(GrainSystem& s) {
  set_box_rate(s, {});
  for (Wall& wall : s.walls) wall.velocity = wall.last_velocity = {};
  for (GrainRecord& r : s.record) {
    for (Lanes* motion : {&r.drift, &r.turn, &r.spin}) *motion = Lanes{0.0, 0.0, 0.0, (*motion)[3]};
  }
  s.drift_limit = 0.0;
}

void finish_report(const Compaction& c, double friction, CompactionReport& report) {
  report.porosity_box = region_porosity(c, CompactionOptions::Region::box);
  try {
    report.porosity_core = region_porosity(c, CompactionOptions::Region::core);
  } catch (const InputError&) {
    report.porosity_core = std::numeric_limits<double>::quiet_NaN();
  }
  report.mean_stress = mean_axis_stress(c);
  report.axis_stress = axis_stress(c.system, c.measures);
  report.unbalanced = c.measures.unbalanced;
  report.coordination = c.measures.coordination;
  report.friction_used = friction;
  report.largest_overlap = c.measures.largest_overlap;
  report.time_step = c.system.time_step;
  report.steps = c.system.steps;
  report.list_builds = c.system.list_builds;
}

void check(const CompactionOptions& o) {
  require(o.stress > 0.0 && std::isfinite(o.stress), "compact: stress {} Pa must be positive", o.stress);
  require(!o.porosity || (*o.porosity > 0.0 && *o.porosity < 1.0), "compact: porosity {} must lie in (0, 1)",
          o.porosity.value_or(0.0));
  require(!o.friction_angle || (*o.friction_angle >= 0.0 && *o.friction_angle < std::numbers::pi / 2),
          "compact: friction_angle {} rad must lie in [0, pi/2)", o.friction_angle.value_or(0.0));
  require(!o.porosity || !o.friction_angle,
          "compact: porosity and friction_angle exclude each other: to reach a porosity the friction is found by itself");
  require(o.unbalanced > 0.0 && o.unbalanced < 1.0, "compact: unbalanced {} must lie in (0, 1)", o.unbalanced);
  require(o.damping >= 0.0 && o.damping < 1.0, "compact: damping {} must lie in [0, 1)", o.damping);
  require(o.safety > 0.0 && o.safety < 1.0, "compact: share {} of the critical time step must lie in (0, 1)", o.safety);
}

}  // namespace

Packing make_packing(const PackingSource& source, std::span<const Material> materials, const ContactOptions& contact,
                     const CompactionOptions& options, const CompactionCallback& callback) {
  check(options);
  Packing packing = random_cloud(source, materials);
  Particles& particles = packing.particles;
  const MotionOptions motion{.damping = options.damping, .safety = options.safety, .strain_with_box = true};
  GrainSystem system = make_grain_system(particles, packing.domain, materials, contact, motion);
  const double largest = *std::max_element(particles.radius.begin(), particles.radius.end());
  double diameter = 0.0, mass = 0.0;
  for (const double r : particles.radius) diameter += 2.0 * r / particles.size();
  for (const double m : particles.mass) mass += m;
  const double density = mass / ((1.0 - packing.report.porosity_box) * packing.domain.volume());
  Compaction c{.system = system,
               .options = options,
               .callback = callback,
               .particles = particles,
               .largest_radius = largest,
               .natural_rate = std::sqrt(options.stress / density) / diameter,
               .longest_step = options.safety * critical_time_step_at(system, options.stress),
               .own_pairs = system.pairs.grains,
               .measures = {}};
  c.porosity = packing.report.porosity_box;
  system.time_step = c.longest_step;

  double friction = 0.0;
  for (const auto& pair : c.own_pairs) friction = std::max(friction, pair.friction);
  if (options.porosity) {
    build_stress(c);
    friction = compact_to_porosity(c, friction, *options.porosity);
  } else if (options.friction_angle) {
    friction = std::tan(*options.friction_angle);
    set_friction(c, friction);
    build_stress(c);
    if (!c.stopped) settle(c);
    restore_friction(c);
    if (!c.stopped) settle(c);
  } else {
    build_stress(c);
    if (!c.stopped) settle(c);
  }

  finish_report(c, friction, packing.report);
  stop_motion(system);
  collect(system, particles);
  packing.domain = system.domain;
  packing.system = std::move(system);
  return packing;
}

GrainMeasures evaluate_packing(Particles& particles, const Domain& domain, std::span<const Material> materials,
                               const ContactOptions& contact) {
  GrainSystem system = make_grain_system(particles, domain, materials, contact, {});

  evaluate_forces(system);
  collect(system, particles);
  return measure(system);
}

}  // namespace puadem
