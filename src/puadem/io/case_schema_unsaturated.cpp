#include "puadem/base/parallel.hpp"
#include "puadem/geometry/domain.hpp"
#include "puadem/io/case_schema_stages.hpp"

namespace puadem {

namespace {

using S = UnsaturatedStage;
using Fields = std::vector<Field<S>>;

KeyInfo faces(std::string name, std::string help, std::string example) {
  KeyInfo info = choice(std::move(name), {face_names.begin(), face_names.end()}, std::move(help));
  info.type = "a list of choices";
  info.example = std::move(example);
  return info;
}

Field<S> step_field() {
  KeyInfo info = quantity("step", "Pa", above(0), between(1e-2, 1e8), R"(["10 kPa", "50 Pa"])",
                          "along the path, one for all of it or one for each of its legs");
  info.type = "a pressure or a list of pressures";
  return {info,
          [info](const TomlValue& value, Problems& problems, S& s) {
            if (value.kind == TomlValue::Kind::array) return read_value(value, info, problems, s.step);
            s.step.resize(1);
            read_value(value, info, problems, s.step.front());
          },
          [info](const S& s) { return s.step.size() == 1 ? write_value(info, s.step.front()) : write_value(info, s.step); }};
}

void add_path(Fields& fields) {
  fields.push_back(bind<S>(needed(quantity("path", "Pa", at_least(0), between(1e-2, 1e9), R"(["0 Pa", "2 kPa", "0 Pa"])",
                                           "turning points of the capillary pressure between the reservoirs")),
                           &S::path));
  fields.back().info.type = "a list of pressures";
  fields.push_back(bind<S>(
      noted(quantity(
                "times", "s", at_least(0), between(1e-9, 1e6), R"(["0 s", "50 ms"])",
                "when the reservoirs reach each pressure of the path, straight lines between, the first at 0: from rest at the "
                "first pressure grains and fluids then move in time, and grains of materials with swelling grow"),
            "rest at every step of the path"),
      &S::times));
  fields.back().info.type = "a list of times";
  fields.push_back(bind<S>(noted(quantity("coupling_interval", "s", above(0), between(1e-9, 1), R"("0.1 ms")",
                                          "with times: longest time over which the fluids' forces stay the same"),
                                 "half of the limit of theory 7.3"),
                           &S::coupling_interval));
  fields.push_back(step_field());
  fields.back().write = [write = fields.back().write](const S& s) { return s.times.empty() ? write(s) : std::string(); };
}

void add_places(Fields& fields) {
  fields.push_back(bind_choice<S>(choice("start", {"saturated", "dry"},
                                         "water everywhere at no capillary pressure; or gas, at the first pressure of the path, "
                                         "with water in the corners of pores and, with [bridges], in these"),
                                  &S::start));
  const KeyInfo air = choice("air", {face_names.begin(), face_names.end()}, "face where the non-wetting fluid comes from");
  fields.push_back({air,
                    [air](const TomlValue& value, Problems& problems, S& s) {
                      if (const auto face = read_face(value, air, problems)) s.air = *face;
                    },
                    [air](const S& s) { return toml_text(air.choices[to_size(s.air)]); }});
  fields.push_back(bind<S>(faces("water", "faces of the wetting reservoir", R"(["bottom"])"), &S::water));
  fields.push_back(
      bind<S>(number("initial_air_fraction", inside(0, 1), "air in the pores at its face at the start", between(1e-9, 0.5)),
              &S::initial_air_fraction));
  fields.back().write = [write = fields.back().write](const S& s) {
    return s.start == S::Start::saturated ? write(s) : std::string();
  };
}

void add_load(Fields& fields) {
  fields.push_back(
      bind<S>(faces("loaded", "faces whose walls move to hold `stress`; all others stand", R"(["top"])"), &S::loaded));
  fields.push_back(bind<S>(noted(quantity("stress", "Pa", above(0), between(1, 1e8), R"("10 kPa")",
                                          "of grains and fluids together on the loaded faces, over the pressure of the air"),
                                 "required with loaded"),
                           &S::stress));
  fields.push_back(bind<S>(
      noted(number("strain", {},
                   "logarithmic strain along z to reach after the path, under its last pressure; the walls of z then move",
                   between(-0.5, 0.5)),
            "none after the path"),
      &S::strain));
  fields.push_back(
      bind<S>(noted(quantity("strain_rate", "1/s", above(0), {}, R"("1 1/s")", "its magnitude"), "at an inertial number of 5e-4"),
              &S::strain_rate));
  fields.push_back(bind<S>(
      number("strain_step", above(0), "strain after which the fluids follow the grains and come to rest", between(1e-6, 1e-2)),
      &S::strain_step));
  fields.back().write = [write = fields.back().write](const S& s) { return s.strain ? write(s) : std::string(); };
  fields.push_back(
      bind<S>(number("damping", Interval{0, 1, false, true}, "Cundall damping of the grains", between(0, 0.7)), &S::damping));
}

void add_rest(Fields& fields) {
  fields.push_back(
      bind<S>(number("unbalanced", above(0), "unbalanced force ratio at which the grains are at rest", between(1e-6, 1e-2)),
              &S::unbalanced));
  fields.push_back(bind<S>(
      number("saturation_change", above(0), "change of the saturation in a round below which all rest", between(1e-6, 1e-2)),
      &S::saturation_change));
  fields.push_back(
      bind<S>(number("strain_change", above(0), "change of the strain in a round below which all rest", between(1e-8, 1e-3)),
              &S::strain_change));
  fields.push_back(bind<S>(whole("rounds", 2, 1e6, "most rounds at one capillary pressure", "50"), &S::rounds));
  fields.push_back(bind<S>(number("remesh_displacement", above(0),
                                  "displacement of a grain since the pore network was made, over the mean radius, at which a new "
                                  "one is made",
                                  between(1e-3, 0.5)),
                           &S::remesh_displacement));
}

void add_physics(Fields& fields) {
  fields.push_back(
      bind<S>(flag("corner_films", "the wetting fluid flows through the corners of open throats"), &S::corner_films));
  fields.push_back(bind<S>(flag("snap_off", "open throats may close by their corner menisci"), &S::snap_off));
  fields.push_back(bind_law<S, AnyRetentionLaw>(
      "retention_law", "capillary pressure of a unit that holds both fluids", [](auto& s) -> auto& { return s.retention_law; }));
}

}  // namespace

template <>
const Section<UnsaturatedStage>& stage_section() {
  static const Section<UnsaturatedStage> section = [] {
    Section<UnsaturatedStage> s;
    s.fields.push_back(kind_field<UnsaturatedStage>(
        "steps of the capillary pressure, at each of which two fluids and the grains move each other until all rest"));
    add_path(s.fields);
    add_places(s.fields);
    add_load(s.fields);
    add_rest(s.fields);
    add_physics(s.fields);
    return s;
  }();
  return section;
}

}  // namespace puadem
