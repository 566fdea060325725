#pragma once

namespace puadem {

/// Contact options of a case.
struct ContactOptions {
  enum class Law { linear_spring, hertz_mindlin };
  Law law = Law::hertz_mindlin;
  double stiffness_ratio = 0.4;  ///< k_s / k_n of the linear law [-]
  double wall_friction = 0.0;    ///< mu between grains and walls [-]
};

}  // namespace puadem
