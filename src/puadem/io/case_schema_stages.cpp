#include "puadem/io/case_schema_stages.hpp"

#include <fmt/format.h>

#include <cmath>
#include <type_traits>

#include "puadem/base/parallel.hpp"
#include "puadem/geometry/domain.hpp"
#include "puadem/io/case_schema.hpp"

namespace puadem {

namespace {

/// A face of the box, stored as its number.
template <class Member>
Field<RetentionStage> face_field(std::string name, std::string help, Member member) {
  const KeyInfo info = choice(std::move(name), {face_names.begin(), face_names.end()}, std::move(help));
  return {info,
          [info, member](const TomlValue& value, Problems& problems, RetentionStage& s) {
            if (const auto face = read_face(value, info, problems)) s.invasion.*member = *face;
          },
          [info, member](const RetentionStage& s) { return toml_text(face_names[to_size(s.invasion.*member)]); }};
}

Field<RetentionStage> invasion_flag(std::string name, std::string help, bool InvasionOptions::*member) {
  return bind<RetentionStage>(
      flag(std::move(name), std::move(help)), [member](auto& s) -> auto& { return s.invasion.*member; });
}

Field<RetentionStage> trap_check_field() {
  const KeyInfo info = choice("trap_check", {"event", "step"},
                              "when it is looked at what is cut off: after each event, or once per output step, as some codes "
                              "do; the curve then depends on the step");
  return {info,
          [info](const TomlValue& value, Problems& problems, RetentionStage& s) {
            if (const auto index = read_choice(value, info, problems)) s.invasion.trap_check = static_cast<TrapCheck>(*index);
          },
          [info](const RetentionStage& s) { return toml_text(info.choices[static_cast<std::size_t>(s.invasion.trap_check)]); }};
}

Field<RetentionStage> grains_field() {
  const KeyInfo info =
      choice("grains", {"fixed", "moving"}, "whether grains move during the stage; only \"fixed\" in this version");
  return {info,
          [info](const TomlValue& value, Problems& problems, RetentionStage&) {
            const auto index = read_choice(value, info, problems);
            if (index && *index == 1)
              problems.error(value.place,
                             problems.key + " = \"moving\" is not available in this version; write grains = \"fixed\"");
          },
          [](const RetentionStage&) { return toml_text("fixed"); }};
}

}  // namespace

template <>
const Section<CompactStage>& stage_section() {
  static const Section<CompactStage> section{{
      kind_field<CompactStage>("a random cloud becomes a packing at rest under an isotropic stress"),
      bind<CompactStage>(
          needed(quantity("stress", "Pa", above(0), between(10, 1e8), R"("10 kPa")", "target mean stress, compression positive")),
          &CompactStage::stress),
      bind<CompactStage>(noted(number("porosity", inside(0, 1), "target porosity, reached by lowering friction while compacting",
                                      between(0.2, 0.7)),
                               "whatever the friction gives"),
                         &CompactStage::porosity),
      bind<CompactStage>(
          noted(quantity("friction_angle", "rad", Interval{0, 90 * degree, false, true}, between(0, 60 * degree), R"("0 deg")",
                         "between all grains while compacting, in place of a porosity: 0 deg gives a dense packing, a large "
                         "angle a loose one; then that of their materials is set again and the packing settles"),
                "that of the materials"),
          &CompactStage::friction_angle),
      bind_choice<CompactStage>(
          choice("porosity_region", {"core", "box"},
                 "where the porosity is measured: farther than one largest diameter from every wall, or the whole box"),
          &CompactStage::porosity_region),
      bind<CompactStage>(number("unbalanced", inside(0, 1),
                                "ratio of unbalanced to contact force at which the packing is at rest", between(1e-6, 0.1)),
                         &CompactStage::unbalanced),
      bind<CompactStage>(number("damping", Interval{0, 1, false, true}, "Cundall damping", between(0, 0.9)),
                         &CompactStage::damping),
  }};
  return section;
}

KeyInfo cooperative_filling_key() {
  return flag("cooperative_filling", "the more open throats a pore has, the lower the capillary pressure at which it refills");
}

KeyInfo filling_seed_key() {
  return whole("filling_seed", 0, 1e15, "of the random weights of the throats in cooperative filling", "1");
}

template <>
const Section<RetentionStage>& stage_section() {
  static const Section<RetentionStage> section = [] {
    KeyInfo path = needed(quantity("path", "Pa", at_least(0), between(1e-2, 1e9), R"(["400 Pa", "1300 Pa", "0 Pa"])",
                                   "turning points of the capillary pressure: rising is drainage, falling is imbibition"));
    path.type = "a list of pressures";
    return Section<RetentionStage>{{
        kind_field<RetentionStage>("capillary pressure steps, each to equilibrium"),
        grains_field(),
        face_field("air", "face of the non-wetting reservoir", &InvasionOptions::nonwetting_face),
        face_field("water", "face of the wetting reservoir", &InvasionOptions::wetting_face),
        bind<RetentionStage>(path, &RetentionStage::path),
        bind<RetentionStage>(quantity("step", "Pa", above(0), between(1e-2, 1e8), R"("100 Pa")",
                                      "output step along the path; with trap_check = \"event\" the curve does not depend on it"),
                             &RetentionStage::step),
        invasion_flag("snap_off", "open throats may close by their corner menisci in imbibition", &InvasionOptions::snap_off),
        invasion_flag("trap_wetting", "wetting fluid cut off from its reservoir keeps its volume",
                      &InvasionOptions::trap_wetting),
        invasion_flag("trap_nonwetting", "non-wetting fluid cut off from its reservoir keeps its volume",
                      &InvasionOptions::trap_nonwetting),
        invasion_flag("corner_films", "corner water connects through open throats", &InvasionOptions::corner_films),
        invasion_flag("corner_water", "an invaded unit keeps the water of the local retention law; else none",
                      &InvasionOptions::corner_water),
        invasion_flag("wall_throats", "throats along walls may be invaded", &InvasionOptions::wall_throats),
        invasion_flag("body_entry",
                      "the body of a pore resists entry as its throats do; false only together with corner_water = false",
                      &InvasionOptions::body_entry),
        invasion_flag("side_pores",
                      "pores at walls other than the reservoirs are counted and entered as all others; false: not counted, "
                      "and entered from inner pores only",
                      &InvasionOptions::side_pores),
        trap_check_field(),
        bind<RetentionStage>(
            cooperative_filling_key(), [](auto& s) -> auto& { return s.invasion.cooperative_filling; }),
        bind<RetentionStage>(
            filling_seed_key(), [](auto& s) -> auto& { return s.invasion.seed; }),
        bind_law<RetentionStage, AnyRetentionLaw>(
            "retention_law", "capillary pressure of a unit that holds both fluids",
            [](auto& s) -> auto& { return s.invasion.retention_law; }),
    }};
  }();
  return section;
}

namespace {

constexpr std::size_t stage_count = std::variant_size_v<Stage>;

/// Calls `visit` with an empty stage of every kind, in the order of the variant.
template <class Visit>
void for_each_kind(const Visit& visit) {
  [&]<std::size_t... I>(std::index_sequence<I...>) { (visit(std::variant_alternative_t<I, Stage>{}), ...); }
  (std::make_index_sequence<stage_count>{});
}

std::vector<std::string> stage_kinds() {
  std::vector<std::string> kinds;
  for_each_kind([&](const auto& stage) { kinds.emplace_back(stage.kind); });
  return kinds;
}

void read_stage(const TomlValue& value, std::string_view kind, Problems& problems, Case& c) {
  for_each_kind([&](auto stage) {
    if (stage.kind != kind) return;
    read_table(value, stage_section<decltype(stage)>(), problems, stage);
    c.stages.emplace_back(std::move(stage));
  });
}

}  // namespace

Field<Case> stages_field() {
  Field<Case> field;
  field.info = needed(plain("stage", "a list of tables", "what is done, in this order", ""));
  field.info.help += "; write [[stage]] with kind = " + joined(stage_kinds());
  field.read = [](const TomlValue& value, Problems& problems, Case& c) {
    if (value.kind != TomlValue::Kind::array)
      return problems.error(value.key_place, "stage must be a list of tables; write [[stage]] with two brackets");
    const KeyInfo kinds = choice("kind", stage_kinds(), "");
    for (std::size_t i = 0; i < value.children.size(); ++i) {
      const TomlValue& stage = value.children[i];
      problems.key = fmt::format("stage.{}", i);
      if (!expect_table(stage, problems)) continue;
      const TomlValue* kind = stage.find("kind");
      if (kind == nullptr) {
        problems.error(stage.place, fmt::format("missing key stage.{}.kind; allowed: {}", i, joined(kinds.choices)));
        continue;
      }
      problems.key += ".kind";
      const auto index = read_choice(*kind, kinds, problems);
      problems.key = fmt::format("stage.{}", i);
      if (index) read_stage(stage, kinds.choices[to_size(*index)], problems, c);
    }
  };
  field.write_tables = [](const std::string& path, const Case& c) {
    std::string text;
    for (const Stage& stage : c.stages) {
      text += "\n[[" + path + "]]\n";
      text += std::visit([](const auto& s) { return write_table("", stage_section<std::decay_t<decltype(s)>>(), s); }, stage);
    }
    return text;
  };
  field.describe = [](const std::string& path, std::vector<KeyDoc>& out) {
    for_each_kind([&](const auto& stage) {
      describe_table(fmt::format("{}[{}]", path, stage.kind), stage_section<std::decay_t<decltype(stage)>>(), out);
    });
  };
  return field;
}

}  // namespace puadem
