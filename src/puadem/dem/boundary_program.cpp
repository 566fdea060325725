#include "puadem/dem/boundary_program.hpp"

#include <algorithm>
#include <cmath>

#include "puadem/base/error.hpp"
#include "puadem/dem/motion.hpp"

namespace puadem {

BoxProgram oedometer(double strain_rate) {
  BoxProgram program;
  program.strain_rate.z = strain_rate;
  return program;
}

BoxProgram triaxial(double lateral_stress, double strain_rate, double rate_limit) {
  BoxProgram program;
  program.stress[0] = program.stress[1] = lateral_stress;
  program.strain_rate.z = strain_rate;
  program.rate_limit = rate_limit;
  return program;
}

namespace {

constexpr double memory = 3;  // relaxation times in which a lasting want becomes part of the steady rate

/// Stress to hold along an axis, if any.
std::optional<double> target_stress(const BoxProgram& program, const GrainMeasures& m, int axis) {
  if (program.mean_stress && axis < 2) return 0.5 * (3.0 * *program.mean_stress - m.stress[2].z);
  return program.stress[to_size(axis)];
}

}  // namespace

void steer_box(GrainSystem& s, const BoxProgram& program, const GrainMeasures& m, BoxServo& servo) {
  const Vec3 size = s.domain.size();
  const double limit = program.rate_limit;
  Vec3 rate;
  for (int axis = 0; axis < 3; ++axis) {
    double strain_rate = program.strain_rate[axis];
    if (const auto target = target_stress(program, m, axis)) {
      const double missing = *target - m.stress[to_size(axis)][axis], stiffness = m.affine_modulus[axis];
      const double wanted = stiffness > 0.0 ? missing / (stiffness * program.relaxation_steps * s.time_step) : limit;
      double& steady = servo.steady_rate[axis];
      strain_rate = std::clamp(steady + wanted, -limit, limit);
      // A rate at its limit says nothing of what would hold the stress.
      if (strain_rate == steady + wanted) steady += wanted * program.interval / (memory * program.relaxation_steps);
    }
    rate[axis] = -strain_rate * size[axis];
  }
  set_box_rate(s, rate);
}

void steer_box(GrainSystem& s, const BoxProgram& program, const GrainMeasures& m) {
  BoxServo none;
  steer_box(s, program, m, none);
}

double inertial_number(double strain_rate, double diameter, double density, double pressure) {
  return std::abs(strain_rate) * diameter * std::sqrt(density / pressure);
}

Vec3 axis_stress(const GrainSystem& s, const GrainMeasures& m) {
  Vec3 stress;
  for (int axis = 0; axis < 3; ++axis) {
    const std::size_t lower = to_size(2 * axis);
    stress[axis] = s.domain.periodic[to_size(axis)] ? m.stress[to_size(axis)][axis]
                                                    : 0.5 * (m.wall_stress[lower] + m.wall_stress[lower + 1]);
  }
  return stress;
}

ProgramRow program_row(const GrainSystem& s, const GrainMeasures& m, const Vec3& start_size, double time) {
  ProgramRow row;
  row.time = time;
  const Vec3 size = s.domain.size();
  row.stress = axis_stress(s, m);
  for (int axis = 0; axis < 3; ++axis) {
    row.strain[axis] = std::log(start_size[axis] / size[axis]);
    row.mean += row.stress[axis] / 3.0;
    row.volumetric += row.strain[axis];
  }
  row.deviator = row.stress.z - 0.5 * (row.stress.x + row.stress.y);
  row.unbalanced = m.unbalanced;
  row.coordination = m.coordination;
  return row;
}

std::vector<ProgramRow> run_program(GrainSystem& s, const BoxProgram& program, long steps, long row_interval,
                                    const std::function<bool(const ProgramRow&)>& watch) {
  require(program.interval > 0 && row_interval > 0 && row_interval % program.interval == 0,
          "rows every {} steps: that must be a multiple of the interval of the program, {} steps", row_interval,
          program.interval);
  const Vec3 start_size = s.domain.size();
  std::vector<ProgramRow> rows;
  BoxServo servo;
  double time = 0.0;
  for (long step = 0; step <= steps; step += program.interval) {
    evaluate_forces(s);
    const GrainMeasures m = measure(s);
    if (step % row_interval == 0) {
      rows.push_back(program_row(s, m, start_size, time));
      if (watch && !watch(rows.back())) break;
    }
    if (step == steps) break;
    steer_box(s, program, m, servo);
    const long now = std::min<long>(program.interval, steps - step);
    advance_grains(s, now);
    time += static_cast<double>(now) * s.time_step;
    if (now < program.interval) break;
  }
  return rows;
}

void shear_by_walls(GrainSystem& s, int axis, const Vec3& direction, double speed, double normal_stress,
                    double servo_speed_limit) {
  require(!s.domain.periodic[to_size(axis)], "shear between the walls of axis {}: that axis is periodic and has no walls", axis);
  Vec3 along = direction;
  along[axis] = 0.0;
  require(norm(along) > 0.0, "shear between the walls of axis {}: the direction must lie in them", axis);
  for (Wall& wall : s.walls) {
    if (wall.face < 0 || axis_of(wall.face) != axis) continue;
    wall.area = s.domain.volume() / s.domain.size()[axis];
    wall.slide = (is_upper(wall.face) ? 0.5 : -0.5) * speed * normalized(along);
    wall.velocity = wall.slide;
    if (is_upper(wall.face)) {
      wall.target = normal_stress;
      wall.speed_limit = servo_speed_limit;
    }
  }
}

}  // namespace puadem
