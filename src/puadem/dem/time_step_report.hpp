#pragma once

#include <string>

#include "puadem/dem/motion.hpp"

namespace puadem {

/// What binds the time step, in words: "critical step 1.2e-06 s: translation of grain 17 (R = 0.3 mm, 6
/// contacts, 1 of them with walls)".
/// @param limit  of this system at the forces last evaluated
std::string time_step_text(const GrainSystem& system, const TimeStepLimit& limit);

}  // namespace puadem
