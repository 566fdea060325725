#include "puadem/io/case_checks_two_phase.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "puadem/geometry/domain.hpp"
#include "puadem/io/text.hpp"

namespace puadem {

namespace {

/// A stage with what messages need to point at it.
struct Context {
  const TwoPhaseStage& stage;
  const TomlValue& tree;
  int index;
  Problems& problems;

  bool has(std::string_view key) const { return tree.find(key) != nullptr; }
  /// An empty list counts as nothing given: so one can be taken out from the command line.
  bool is_given(std::string_view key) const {
    const TomlValue* value = tree.find(key);
    return value != nullptr && (value->kind != TomlValue::Kind::array || !value->children.empty());
  }
  void error(std::string_view key, const std::string& text) const {
    const TomlValue* value = tree.find(key);
    problems.error(value != nullptr ? value->place : tree.place, fmt::format("stage.{}{}", index, text));
  }
};

void check_places(const Context& at, const Case& c) {
  const TwoPhaseStage& s = at.stage;
  const bool is_disc = s.air == TwoPhaseStage::disc;
  if (is_disc && !s.disc_radius) at.error("air", ".air = \"disc\" needs disc_radius");
  if (!is_disc && s.disc_radius) at.error("disc_radius", ".disc_radius is used with air = \"disc\" only; remove it");
  if (std::ranges::none_of(s.water, [](bool w) { return w; })) at.error("water", ".water names no face");
  const auto periodic = [&](const char* key, int face) {
    if (c.domain.periodic[to_size(axis_of(face))])
      at.error(key, fmt::format(".{}: \"{}\" is no wall: the direction {} is periodic", key, face_names[to_size(face)],
                                "xyz"[axis_of(face)]));
  };
  if (!is_disc) {
    periodic("air", s.air);
    if (s.water[to_size(s.air)])
      at.error("water", fmt::format(": air and water must lie at different faces, not both at {}", face_names[to_size(s.air)]));
  }
  for (int face = 0; face < 6; ++face)
    if (s.water[to_size(face)]) periodic("water", face);
}

void check_driving(const Context& at) {
  const TwoPhaseStage& s = at.stage;
  const std::vector<std::string> ways{"path", "water_pressure", "withdrawal", "capillary_number"};
  const auto given = std::ranges::count_if(ways, [&](const std::string& key) { return at.is_given(key); });
  if (given != 1)
    at.error("kind", fmt::format(" needs one of {} to drive the flow, not {}", joined(ways), given == 0 ? "none" : "several"));
  const bool has_path = at.is_given("path");
  for (const char* key : {"step", "hold"})
    if (!has_path && at.has(key)) at.error(key, fmt::format(".{} is used with a path only; remove it", key));
  for (std::size_t k = 1; k < s.path.size(); ++k)
    if (s.path[k] == s.path[k - 1]) at.error("path", ".path: a pressure must differ from the one before it");
  if (has_path && s.duration) at.error("duration", ".duration is not used with a path; give hold, or neither to wait for rest");
  if (!has_path && !s.duration) at.error("kind", " needs a duration, after which it ends at the latest");
  if (s.water_pressure.size() > 1 && s.water_times.size() != s.water_pressure.size())
    at.error("water_pressure", fmt::format(".water_pressure has {} values, water_times {}; there must be as many",
                                           s.water_pressure.size(), s.water_times.size()));
  if (s.water_pressure.size() < 2 && !s.water_times.empty())
    at.error("water_times", ".water_times needs as many values in water_pressure");
  // Before air has entered a pore that is counted, neither fluid has room for the other: no rate can flow.
  for (const char* key : {"withdrawal", "capillary_number"})
    if (at.is_given(key) && !s.initial_air_fraction)
      at.error(key, fmt::format(".{} needs initial_air_fraction: water can only leave pores that air has begun to enter", key));
  if (!std::ranges::is_sorted(s.water_times)) at.error("water_times", ".water_times must rise");
}

}  // namespace

void check_two_phase_stage(const TwoPhaseStage& stage, const TomlValue& tree, int index, const Case& c, Problems& problems) {
  const Context at{stage, tree, index, problems};
  check_places(at, c);
  check_driving(at);
  if (stage.options.scheme == TwoPhaseScheme::impes && stage.options.gas != GasKind::connected)
    at.error("scheme", ".scheme = \"impes\" knows gas of one pressure only; write gas = \"connected\"");
}

}  // namespace puadem
