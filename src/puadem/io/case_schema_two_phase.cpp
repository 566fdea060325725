#include <fmt/format.h>

#include "puadem/base/parallel.hpp"
#include "puadem/geometry/domain.hpp"
#include "puadem/io/case_schema_stages.hpp"
#include "puadem/io/text.hpp"

namespace puadem {

namespace {

Field<TwoPhaseStage> air_field() {
  std::vector<std::string> places(face_names.begin(), face_names.end());
  places.emplace_back("disc");
  const KeyInfo info =
      choice("air", places, "where the non-wetting fluid comes from: a face, or an upright disc about the middle of the box");
  return {info,
          [info](const TomlValue& value, Problems& problems, TwoPhaseStage& s) {
            if (const auto place = read_face(value, info, problems)) s.air = *place;
          },
          [info](const TwoPhaseStage& s) { return toml_text(info.choices[to_size(s.air)]); }};
}

/// One pressure, or a list of them.
Field<TwoPhaseStage> water_pressure_field() {
  KeyInfo info = noted(quantity("water_pressure", "Pa", {}, between(-1e7, 1e7), R"("-5 kPa")",
                                "of the wetting reservoir: one, or one for each of water_times with straight lines between"),
                       "the flow is driven otherwise");
  info.type = "a pressure, or a list of them";
  return {
      info,
      [info](const TomlValue& value, Problems& problems, TwoPhaseStage& s) {
        if (value.kind == TomlValue::Kind::array) return read_value(value, info, problems, s.water_pressure);
        read_value(value, info, problems, s.water_pressure.emplace_back());
      },
      [info](const TwoPhaseStage& s) { return s.water_pressure.empty() ? std::string() : write_value(info, s.water_pressure); }};
}

template <class Member>
Field<TwoPhaseStage> list_field(KeyInfo info, std::string type, Member member) {
  info.type = std::move(type);
  Field<TwoPhaseStage> field = bind<TwoPhaseStage>(info, member);
  field.write = [info, member](const TwoPhaseStage& s) {
    return std::invoke(member, s).empty() ? std::string() : write_value(info, std::invoke(member, s));
  };
  return field;
}

/// Key of the flow's options, or of its steps.
template <class Member>
Field<TwoPhaseStage> option(KeyInfo info, Member member) {
  return bind<TwoPhaseStage>(
      std::move(info), [member](auto& s) -> auto& { return s.options.*member; });
}
template <class Member>
Field<TwoPhaseStage> steps(KeyInfo info, Member member) {
  return bind<TwoPhaseStage>(
      std::move(info), [member](auto& s) -> auto& { return s.options.steps.*member; });
}
template <class E>
Field<TwoPhaseStage> option_choice(const KeyInfo& info, E TwoPhaseOptions::*member) {
  return {
      info,
      [info, member](const TomlValue& value, Problems& problems, TwoPhaseStage& s) {
        if (const auto index = read_choice(value, info, problems)) s.options.*member = static_cast<E>(*index);
      },
      [info, member](const TwoPhaseStage& s) { return toml_text(info.choices[static_cast<std::size_t>(s.options.*member)]); }};
}

using Fields = std::vector<Field<TwoPhaseStage>>;

void add_places(Fields& fields) {
  KeyInfo water = choice("water", {face_names.begin(), face_names.end()}, "faces of the wetting reservoir");
  water.type = "a list of choices";
  water.example = R"(["left", "right"])";
  fields.push_back(air_field());
  fields.push_back(bind<TwoPhaseStage>(
      noted(quantity("disc_radius", "m", above(0), between(1e-5, 1), R"("1 mm")", "of the disc where air = \"disc\""),
            "required with air = \"disc\""),
      &TwoPhaseStage::disc_radius));
  fields.push_back(bind<TwoPhaseStage>(water, &TwoPhaseStage::water));
  fields.push_back(bind<TwoPhaseStage>(
      noted(number("initial_air_fraction", inside(0, 1),
                   "air in the pores at its place at the start; they then drain like all others", between(1e-9, 0.5)),
            "these pores belong to the reservoir"),
      &TwoPhaseStage::initial_air_fraction));
}

void add_driving(Fields& fields) {
  fields.push_back(bind<TwoPhaseStage>(quantity("air_pressure", "Pa", {}, between(-1e7, 1e7), R"("0 Pa")", "of its reservoir"),
                                       &TwoPhaseStage::air_pressure));
  fields.push_back(list_field(noted(quantity("path", "Pa", at_least(0), between(1e-2, 1e9), R"(["400 Pa", "1300 Pa"])",
                                             "turning points of the capillary pressure between the reservoirs"),
                                    "the flow is driven otherwise"),
                              "a list of pressures", &TwoPhaseStage::path));
  fields.push_back(bind<TwoPhaseStage>(quantity("step", "Pa", above(0), between(1e-2, 1e8), R"("100 Pa")", "along the path"),
                                       &TwoPhaseStage::step));
  fields.back().write = [write = fields.back().write](const TwoPhaseStage& s) { return s.path.empty() ? "" : write(s); };
  fields.push_back(bind<TwoPhaseStage>(
      noted(quantity("hold", "s", above(0), between(1e-6, 1e6), R"("0.5 s")", "how long each pressure of the path is held"),
            "until the fluids rest"),
      &TwoPhaseStage::hold));
  fields.push_back(water_pressure_field());
  fields.push_back(list_field(
      noted(quantity("water_times", "s", at_least(0), {}, R"(["0 s", "1 s"])", "times of the pressures of the wetting reservoir"),
            "one pressure for all times"),
      "a list of times", &TwoPhaseStage::water_times));
  fields.push_back(bind<TwoPhaseStage>(
      noted(quantity("withdrawal", "m3/s", above(0), {}, R"("2 mm3/s")", "rate at which the wetting fluid is drawn off"),
            "the flow is driven otherwise"),
      &TwoPhaseStage::withdrawal));
  fields.push_back(bind<TwoPhaseStage>(
      noted(number("capillary_number", above(0),
                   "the same rate as mu_w Q / (gamma A), with the area A of the face or of the disc's mantle", between(1e-9, 1)),
            "the flow is driven otherwise"),
      &TwoPhaseStage::capillary_number));
}

void add_end(Fields& fields) {
  fields.push_back(bind<TwoPhaseStage>(
      noted(quantity("duration", "s", above(0), between(1e-9, 1e6), R"("0.2 s")", "after which the stage ends"),
            "required without a path"),
      &TwoPhaseStage::duration));
  fields.push_back(bind<TwoPhaseStage>(
      number("until_saturation", Interval{0, 1, false, true}, "the stage ends earlier at this saturation", {}),
      &TwoPhaseStage::until_saturation));
  fields.push_back(
      bind<TwoPhaseStage>(flag("until_breakthrough", "the stage ends earlier where the air stands beside the wetting reservoir"),
                          &TwoPhaseStage::until_breakthrough));
  fields.push_back(bind<TwoPhaseStage>(
      noted(number("record_jump", inside(0, 1), "the first invasion below this saturation is recorded in fine steps of its own"),
            "none is recorded"),
      &TwoPhaseStage::record_jump));
}

void add_physics(Fields& fields) {
  using O = TwoPhaseOptions;
  fields.push_back(option_choice(
      choice(
          "scheme", {"impes", "implicit"},
          "pressures first and saturations after them, or both together by Newton's method; the first needs gas = \"connected\""),
      &O::scheme));
  fields.push_back(option_choice(choice("gas", {"connected", "incompressible", "ideal"},
                                        "the non-wetting fluid: of one pressure everywhere; with viscosity and, where it is cut "
                                        "off, of constant volume; or of constant pressure times volume there"),
                                 &O::gas));
  fields.push_back(option(quantity("reference_pressure", "Pa", above(0), between(1e3, 1e7), R"("101325 Pa")",
                                   "absolute pressure where pressures of the case are 0, for gas = \"ideal\""),
                          &O::reference_pressure));
  fields.push_back(option(flag("snap_off", "open throats may close by their corner menisci"), &O::snap_off));
  fields.push_back(option(cooperative_filling_key(), &O::cooperative_filling));
  fields.push_back(option(filling_seed_key(), &O::seed));
  fields.push_back(option(flag("corner_films", "the wetting fluid flows through the corners of open throats"), &O::corner_films));
  fields.push_back(
      option(flag("touching_first", "gas leaves a pore only once its bubble touches the walls of the pore"), &O::touching_first));
  fields.push_back(option(flag("wall_throats", "throats along walls may be invaded"), &O::wall_throats));
  KeyInfo gravity =
      quantity("gravity", "m/s2", {}, between(-100, 100), R"(["0 m/s2", "0 m/s2", "-9.81 m/s2"])", "acceleration of the fluids");
  gravity.type = "a list of three accelerations";
  fields.push_back(option(gravity, &O::gravity));
  fields.push_back(bind_law<TwoPhaseStage, AnyRetentionLaw>(
      "retention_law", "capillary pressure of a unit that holds both fluids",
      [](auto& s) -> auto& { return s.options.retention_law; }));
}

void add_steps(Fields& fields) {
  using T = TwoPhaseSteps;
  fields.push_back(steps(
      number("front_change", above(0),
             "volume that may change hands in a step, over that of the pores at the front: steps aim at it", between(1e-4, 1)),
      &T::front_change));
  KeyInfo longest = quantity("longest_step", "s", above(0), {}, R"("1 ms")", "longest time step");
  longest.word_for_infinity = "none";
  fields.push_back(steps(longest, &T::longest));
}

}  // namespace

template <>
const Section<TwoPhaseStage>& stage_section() {
  static const Section<TwoPhaseStage> section = [] {
    Section<TwoPhaseStage> s;
    s.fields.push_back(kind_field<TwoPhaseStage>("two fluids move, from the wetting one everywhere; grains stand still"));
    add_places(s.fields);
    add_driving(s.fields);
    add_end(s.fields);
    add_physics(s.fields);
    add_steps(s.fields);
    return s;
  }();
  return section;
}

}  // namespace puadem
