#pragma once

#include "puadem/coupling/case.hpp"
#include "puadem/io/case_fields.hpp"

namespace puadem {

/// A coupled stage, with what messages need to point at it.
struct CoupledStageChecks {
  const TomlValue& tree;
  int index;
  const Case& c;
  Problems& problems;

  void error(std::string_view key, const std::string& text) const;
  /// A face along a periodic direction is no wall.
  void need_wall(std::string_view key, int face) const;
};

/// What cannot be together in a stage "saturated-flow". @param tree  of the stage
void check_saturated_stage(const SaturatedStage& stage, const TomlValue& tree, int index, const Case& c, Problems& problems);

/// The same of a stage "unsaturated-flow".
void check_unsaturated_stage(const UnsaturatedStage& stage, const TomlValue& tree, int index, const Case& c, Problems& problems);

}  // namespace puadem
