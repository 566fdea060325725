#include "puadem/io/case_checks_bridges.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace puadem {

namespace {

constexpr std::array<const char*, 3> amounts{"water_content", "saturation", "volume"};

bool loads(const Stage& stage) {
  return std::visit([](const auto& s) { return is_loading<std::decay_t<decltype(s)>>; }, stage);
}

void check_amounts(const TomlValue& bridges, const Case& c, Problems& problems) {
  const BridgeCase& b = *c.bridges;
  const auto place = [&](std::string_view key) {
    const TomlValue* value = bridges.find(key);
    return value != nullptr ? value->key_place : bridges.key_place;
  };
  const bool at_suction = b.control == BridgeControl::suction;
  int given = 0;
  for (const char* key : amounts) {
    if (bridges.find(key) == nullptr) continue;
    ++given;
    if (at_suction)
      problems.error(place(key),
                     fmt::format("bridges.{} is not used with bridges.control = \"suction\", where the volume follows "
                                 "from bridges.capillary_pressure; remove it",
                                 key));
    else if (given == 2)
      problems.error(place(key), "bridges.water_content, bridges.saturation and bridges.volume exclude each other; keep one");
  }
  const bool is_wet_before_loading = c.stages.empty() || std::ranges::any_of(c.stages, loads);
  if (at_suction && bridges.find("capillary_pressure") == nullptr && is_wet_before_loading)
    problems.error(
        bridges.key_place,
        "missing key bridges.capillary_pressure: the suction of all bridges; write capillary_pressure = \"10 kPa\", or "
        "control = \"volume\" with a water_content");
  if (!at_suction && given == 0)
    problems.error(bridges.key_place,
                   "the table [bridges] needs the amount of water: write water_content = 0.01, or saturation, or volume");
  if (at_suction) {
    if (b.law != BridgeModel::Law::table)
      problems.error(place("law"),
                     "bridges.law: the published fits are for bridges of given volume; with bridges.control = "
                     "\"suction\" use \"table\"");
    for (const char* key : {"rupture", "exchange"})
      if (bridges.find(key) != nullptr)
        problems.error(place(key), fmt::format("bridges.{} is not used with bridges.control = \"suction\": water of a ruptured "
                                               "bridge joins the rest; remove it",
                                               key));
  } else if (bridges.find("capillary_pressure") != nullptr) {
    problems.error(place("capillary_pressure"),
                   "bridges.capillary_pressure is not used with bridges.control = \"volume\"; remove it");
  }
}

}  // namespace

void check_bridges(const TomlValue& tree, const Case& c, Problems& problems) {
  const TomlValue* bridges = tree.find("bridges");
  if (bridges == nullptr || bridges->kind != TomlValue::Kind::table || !c.bridges) return;
  if (std::ranges::none_of(problems.errors, [](const auto& e) { return e.key.starts_with("bridges"); }))
    check_amounts(*bridges, c, problems);
  const auto is_unsaturated = [](const Stage& stage) { return std::holds_alternative<UnsaturatedStage>(stage); };
  for (const Stage& stage : c.stages)
    if (couples(stage) && !is_unsaturated(stage))
      problems.error(bridges->key_place, fmt::format("[bridges] cannot be together with a stage \"{}\": there all water is in "
                                                     "the pores; remove one",
                                                     kind_of(stage)));
  const bool with_fluids = std::ranges::any_of(c.stages, is_unsaturated);
  if (with_fluids && c.bridges->control == BridgeControl::volume)
    problems.error(bridges->key_place,
                   "[bridges] have the suction of the fluids around them in a stage \"unsaturated-flow\": write control = "
                   "\"suction\", and the capillary_pressure of stages before it that load the grains");
  if (const TomlValue* key = bridges->find("coalescence_saturation"); key != nullptr && !with_fluids)
    problems.error(key->key_place, "bridges.coalescence_saturation is used in a stage \"unsaturated-flow\" only; remove it");
  const auto acts = [&](const Stage& stage) { return is_unsaturated(stage) || loads(stage); };
  if (!c.stages.empty() && std::ranges::none_of(c.stages, acts))
    problems.error(bridges->key_place,
                   "[bridges] acts in stages that load the grains, of which there is none; add one, such as \"isotropic\"");
}

}  // namespace puadem
