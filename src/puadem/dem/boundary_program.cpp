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

void steer_box(GrainSystem& s, const BoxProgram& program, const GrainMeasures& m) {
  const Vec3 size = s.domain.size();
  Vec3 rate;
  for (int axis = 0; axis < 3; ++axis) {
    double strain_rate = program.strain_rate[axis];
    if (const auto& target = program.stress[to_size(axis)]) {
      const double missing = *target - m.stress[to_size(axis)][axis], stiffness = m.affine_modulus[axis];
      const double wanted = stiffness > 0.0 ? missing / (stiffness * program.relaxation_steps * s.time_step) : program.rate_limit;
      strain_rate = std::clamp(wanted, -program.rate_limit, program.rate_limit);
    }
    rate[axis] = -strain_rate * size[axis];
  }
  set_box_rate(s, rate);
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

namespace {

ProgramRow row_of(const GrainSystem& s, const GrainMeasures& m, const Vec3& start_size, double time) {
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

}  // namespace

std::vector<ProgramRow> run_program(GrainSystem& s, const BoxProgram& program, long steps, long row_interval,
                                    const std::function<bool(const ProgramRow&)>& watch) {
  require(program.interval > 0 && row_interval > 0 && row_interval % program.interval == 0,
          "rows every {} steps: that must be a multiple of the interval of the program, {} steps", row_interval,
          program.interval);
  const Vec3 start_size = s.domain.size();
  std::vector<ProgramRow> rows;
  double time = 0.0;
  for (long step = 0; step <= steps; step += program.interval) {
    evaluate_forces(s);
    const GrainMeasures m = measure(s);
    if (step % row_interval == 0) {
      rows.push_back(row_of(s, m, start_size, time));
      if (watch && !watch(rows.back())) break;
    }
    if (step == steps) break;
    steer_box(s, program, m);
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
    wall.slide = (is_upper(wall.face) ? 0.5 : -0.5) * speed * normalized(along);
    wall.velocity = wall.slide;
    if (is_upper(wall.face)) {
      wall.target = normal_stress;
      wall.speed_limit = servo_speed_limit;
    }
  }
}

}  // namespace puadem
