#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "puadem/geometry/domain.hpp"
#include "puadem/io/case_checks_coupled.hpp"

namespace puadem {

namespace {

void check_times(const UnsaturatedStage& s, bool bridges, const TomlValue& tree, const CoupledStageChecks& at) {
  if (s.times.empty()) {
    if (s.coupling_interval) at.error("coupling_interval", ".coupling_interval is used with times only; remove it");
    return;
  }
  if (s.times.size() != s.path.size())
    at.error("times",
             fmt::format(".times needs one time for each pressure of the path: {}, not {}", s.path.size(), s.times.size()));
  if (s.times.front() != 0.0) at.error("times", ".times begins at 0");
  if (s.times.size() < 2) at.error("times", ".times needs two times or more");
  if (!std::ranges::is_sorted(s.times, std::less_equal<>{})) at.error("times", ".times must rise");
  if (s.strain) at.error("times", ".times and .strain exclude each other; use a stage for each");
  if (tree.find("step") != nullptr) at.error("step", ".step is not used with times; remove it");
  if (bridges) at.error("times", ".times and [bridges] exclude each other: bridges follow fluids at rest");
}

void check_steps(const UnsaturatedStage& s, const CoupledStageChecks& at) {
  if (s.step.size() != 1 && s.step.size() + 1 != s.path.size()) {
    at.error("step",
             fmt::format(".step needs one value, or one for each leg of the path: {}, not {}", s.path.size() - 1, s.step.size()));
    return;
  }
  double steps = 0.0;
  for (std::size_t i = 1; i < s.path.size(); ++i)
    steps += std::abs(s.path[i] - s.path[i - 1]) / (s.step.size() == 1 ? s.step.front() : s.step[i - 1]);
  if (steps > 1e5) at.error("step", fmt::format(".step makes {:.3g} steps along the path; at most 1e5", steps));
}

}  // namespace

void check_unsaturated_stage(const UnsaturatedStage& s, const TomlValue& tree, int index, const Case& c, Problems& problems) {
  const CoupledStageChecks at{tree, index, c, problems};
  if (norm(c.motion.gravity) > 0.0)
    at.error("kind", " knows no weight of the fluids yet: take motion.gravity out, or use saturated-flow or two-phase-flow");
  at.need_wall("air", s.air);
  if (std::ranges::none_of(s.water, [](bool w) { return w; })) at.error("water", ".water names no face");
  if (s.water[to_size(s.air)])
    at.error("water", fmt::format(": air and water must lie at different faces, not both at {}", face_names[to_size(s.air)]));
  for (int face = 0; face < 6; ++face) {
    if (s.water[to_size(face)]) at.need_wall("water", face);
    if (s.loaded[to_size(face)]) at.need_wall("loaded", face);
  }
  if (s.is_loaded() != s.stress.has_value())
    at.error(s.stress ? "stress" : "loaded", ".loaded and .stress go together: give both or none");
  if (s.strain) {
    for (const int face : {4, 5}) at.need_wall("strain", face);
    if (!s.stress) at.error("strain", ".strain needs loaded faces and their stress: those beside z that hold it");
    if (*s.strain == 0.0) at.error("strain", ".strain must not be 0");
  }
  for (const char* key : {"strain_rate", "strain_step"})
    if (!s.strain && tree.find(key) != nullptr) at.error(key, fmt::format(".{} is used with strain only; remove it", key));
  for (std::size_t i = 1; i < s.path.size(); ++i)
    if (s.times.empty() && s.path[i] == s.path[i - 1]) at.error("path", ".path: a pressure must differ from the one before it");
  check_times(s, c.bridges.has_value(), tree, at);
  if (s.times.empty()) check_steps(s, at);
  if (s.start == UnsaturatedStage::Start::dry) {
    if (!s.path.empty() && s.path.front() == 0.0) at.error("start", ".start = \"dry\" needs a path that begins above 0 Pa");
    if (tree.find("initial_air_fraction") != nullptr)
      at.error("initial_air_fraction", ".initial_air_fraction is not used with start = \"dry\"; remove it");
  }
}

}  // namespace puadem
