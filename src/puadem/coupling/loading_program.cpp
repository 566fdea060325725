#include "puadem/coupling/loading_program.hpp"

#include <algorithm>
#include <cmath>

#include "puadem/base/error.hpp"

namespace puadem {

namespace {

constexpr double servo_inertial_number = 4e-3;  // of the strain that holds a stress, at most

/// Rate of strain at an inertial number of one [1/s].
double natural_rate(const LoadingScale& scale, double pressure) { return std::sqrt(pressure / scale.density) / scale.diameter; }

/// A program at a pressure and a rate; without a rate, the quasi-static one.
LoadingProgram program_at(const LoadingScale& scale, double pressure, std::optional<double> rate, double damping) {
  require(pressure > 0.0,
          "a stage that strains the grains at no stress of its own needs grains that carry some already: put a stage "
          "\"isotropic\" before it");
  LoadingProgram program;
  program.damping = damping;
  program.pressure = pressure;
  program.strain_rate = std::abs(rate.value_or(default_inertial_number * natural_rate(scale, pressure)));
  program.inertial_number = inertial_number(program.strain_rate, scale.diameter, scale.density, pressure);
  return program;
}

BoxProgram box_of(const LoadingProgram& program, const LoadingScale& scale) {
  BoxProgram box;
  box.rate_limit = std::max(servo_inertial_number * natural_rate(scale, program.pressure), 4.0 * program.strain_rate);
  return box;
}

double mean(const Vec3& v) { return (v.x + v.y + v.z) / 3.0; }

}  // namespace

std::string inertia_warning(const LoadingProgram& program) {
  return fmt::format("inertial number {:.2g} at a rate of {:.3g} 1/s, above {:g}: not quasi-static; lower the rate",
                     program.inertial_number, program.strain_rate, quasi_static_inertial_number);
}

LoadingProgram loading_program(const IsotropicStage& stage, const Case&, const LoadingScale& scale) {
  LoadingProgram program = program_at(scale, stage.stress, 0.0, stage.damping);
  program.unbalanced = stage.unbalanced;
  BoxProgram box = box_of(program, scale);
  box.stress = {stage.stress, stage.stress, stage.stress};
  program.legs.push_back({box, LoadingLeg::End::rest, 0.0});
  return program;
}

LoadingProgram loading_program(const OedometerStage& stage, const Case&, const LoadingScale& scale) {
  const double lowest = stage.path.empty() ? scale.stress.z : std::min(scale.stress.z, *std::ranges::min_element(stage.path));
  const double highest = stage.path.empty() ? scale.stress.z : *std::ranges::max_element(stage.path);
  // Quasi-static at the lowest stress is quasi-static all along.
  LoadingProgram program = program_at(scale, lowest > 0.0 ? lowest : highest, stage.strain_rate, stage.damping);
  BoxProgram box = box_of(program, scale);
  if (stage.strain) {
    box.strain_rate.z = std::copysign(program.strain_rate, *stage.strain);
    program.legs.push_back({box, LoadingLeg::End::strain, *stage.strain});
  }
  double stress = scale.stress.z;
  for (const double target : stage.path) {
    box.strain_rate.z = std::copysign(program.strain_rate, target - stress);
    program.legs.push_back({box, LoadingLeg::End::axial_stress, target});
    stress = target;
  }
  return program;
}

LoadingProgram loading_program(const TriaxialStage& stage, const Case&, const LoadingScale& scale) {
  LoadingProgram program = program_at(scale, stage.stress, stage.strain_rate, stage.damping);
  BoxProgram box = box_of(program, scale);
  const double rate = std::copysign(program.strain_rate, stage.strain);
  box.strain_rate.z = rate;
  switch (stage.path) {
    case TriaxialStage::StressPath::constant_lateral:
      box.stress[0] = box.stress[1] = stage.stress;
      break;
    case TriaxialStage::StressPath::constant_mean:
      box.mean_stress = stage.stress;
      break;
    case TriaxialStage::StressPath::constant_volume:
      box.strain_rate.x = box.strain_rate.y = -0.5 * rate;
      break;
  }
  program.legs.push_back({box, LoadingLeg::End::strain, stage.strain});
  return program;
}

LoadingProgram loading_program(const ShearStage& stage, const Case&, const LoadingScale& scale) {
  LoadingProgram program = program_at(scale, stage.normal_stress, stage.shear_rate, stage.damping);
  const BoxProgram box = box_of(program, scale);
  const double height = scale.size[stage.axis];
  program.box_strains = false;
  program.slide = WallSlide{.axis = stage.axis,
                            .direction = stage.direction,
                            .speed = program.strain_rate * height,
                            .normal_stress = stage.normal_stress,
                            .speed_limit = box.rate_limit * height};
  program.legs.push_back({box, LoadingLeg::End::shear_strain, stage.strain});
  return program;
}

LoadingProgram loading_program(const SettleStage& stage, const Case& c, const LoadingScale& scale) {
  const double gravity = norm(c.motion.gravity);
  double height = 0.0;
  for (int axis = 0; axis < 3; ++axis) height = std::max(height, scale.size[axis] * std::abs(c.motion.gravity[axis]) / gravity);
  // Grains that fall through the box: a Hertzian impact at speed v has a mean contact stress of about
  // E (rho v^2 / E)^(3/5) / 4, above that of their weight.
  const double speed2 = 2.0 * gravity * height;
  LoadingProgram program;
  program.box_strains = false;
  program.damping = stage.damping;
  program.unbalanced = stage.unbalanced;
  program.pressure = 0.25 * scale.youngs_modulus * std::pow(scale.density * speed2 / scale.youngs_modulus, 0.6);
  program.legs.push_back({BoxProgram{}, LoadingLeg::End::rest, stage.time});
  return program;
}

LoadingProgram loading_program(const StrainStage& stage, const Case&, const LoadingScale& scale) {
  double rate = 0.0, held = 0.0;
  int stresses = 0;
  for (int axis = 0; axis < 3; ++axis)
    if (const auto stress = stage.stress[to_size(axis)]) {
      held += *stress;
      ++stresses;
    } else {
      rate = std::max(rate, std::abs(stage.strain_rate[axis]));
    }
  // Between wet grains at no stress the contacts carry what the bridges pull.
  const double pressure = (stresses > 0 ? held / stresses : mean(scale.stress)) + scale.bridge_stress;
  LoadingProgram program = program_at(scale, pressure, rate, stage.damping);
  BoxProgram box = box_of(program, scale);
  box.stress = stage.stress;
  box.strain_rate = stage.strain_rate;
  program.legs.push_back({box, LoadingLeg::End::time, stage.time});
  return program;
}

}  // namespace puadem
