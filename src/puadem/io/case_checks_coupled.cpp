#include "puadem/io/case_checks_coupled.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "puadem/geometry/domain.hpp"

namespace puadem {

void CoupledStageChecks::error(std::string_view key, const std::string& text) const {
  const TomlValue* value = tree.find(key);
  problems.error(value != nullptr ? value->place : tree.place, fmt::format("stage.{}{}", index, text));
}

void CoupledStageChecks::need_wall(std::string_view key, int face) const {
  if (c.domain.periodic[to_size(axis_of(face))])
    error(key, fmt::format(".{}: \"{}\" is no wall: the direction {} is periodic", key, face_names[to_size(face)],
                           "xyz"[axis_of(face)]));
}

namespace {

struct Context : CoupledStageChecks {
  const SaturatedStage& stage;
};

bool is_drained(const SaturatedStage& s) {
  return s.inlet || std::ranges::any_of(s.drained, [](bool d) { return d; });
}

void check_inlet(const Context& at) {
  const SaturatedStage& s = at.stage;
  if (s.inlet.has_value() == s.inlet_pressure.empty())
    at.error(s.inlet ? "inlet" : "inlet_pressure", ".inlet and .inlet_pressure go together: give both or none");
  if (s.inlet && s.drained[to_size(*s.inlet)])
    at.error("inlet", fmt::format(".inlet = \"{}\" is drained too: it has one pressure", face_names[to_size(*s.inlet)]));
  if (s.inlet_pressure.size() > 1 && s.inlet_times.size() != s.inlet_pressure.size())
    at.error("inlet_pressure", fmt::format(".inlet_pressure has {} values, inlet_times {}; there must be as many",
                                           s.inlet_pressure.size(), s.inlet_times.size()));
  if (s.inlet_pressure.size() < 2 && !s.inlet_times.empty())
    at.error("inlet_times", ".inlet_times needs as many values in inlet_pressure");
  if (!std::ranges::is_sorted(s.inlet_times)) at.error("inlet_times", ".inlet_times must rise");
}

void check_load(const Context& at) {
  const SaturatedStage& s = at.stage;
  if (s.loaded.has_value() != s.stress.has_value())
    at.error(s.loaded ? "loaded" : "stress", ".loaded and .stress go together: give both or none");
  if (!s.loaded) return;
  const auto face = to_size(*s.loaded);
  if (!is_drained(s) && !s.bulk_modulus)
    at.error("loaded",
             ".loaded: no fluid can leave the box, and it does not yield: the wall cannot move; name a face in drained "
             "or give bulk_modulus");
  else if (!s.drained[face])
    at.error("loaded",
             fmt::format(".loaded = \"{0}\" is closed to the fluid: a wall without mass that rests on fluid alone has no motion "
                         "of its own; add \"{0}\" to drained, as under a porous plate",
                         face_names[face]));
}

}  // namespace

void check_saturated_stage(const SaturatedStage& stage, const TomlValue& tree, int index, const Case& c, Problems& problems) {
  const Context at{{tree, index, c, problems}, stage};
  for (int face = 0; face < 6; ++face)
    if (stage.drained[to_size(face)]) at.need_wall("drained", face);
  if (stage.inlet) at.need_wall("inlet", *stage.inlet);
  if (stage.loaded) at.need_wall("loaded", *stage.loaded);
  check_inlet(at);
  check_load(at);
  if (stage.duration.has_value() == stage.time_factor.has_value()) at.error("kind", " needs either duration or time_factor");
  if (stage.time_factor && !stage.loaded)
    at.error("time_factor", ".time_factor needs a loaded face: it is that of a consolidation");
}

}  // namespace puadem
