#pragma once

#include "puadem/coupling/case.hpp"
#include "puadem/io/case_fields.hpp"

namespace puadem {

/// What keys of a stage "two-phase-flow" exclude or need one another.
/// @param tree  of the stage
void check_two_phase_stage(const TwoPhaseStage& stage, const TomlValue& tree, int index, const Case& c, Problems& problems);

}  // namespace puadem
