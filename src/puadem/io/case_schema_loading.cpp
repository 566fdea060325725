#include "puadem/io/case_schema_stages.hpp"

namespace puadem {

namespace {

constexpr std::string_view quasi_static = "an inertial number of 5e-4";

template <class S>
Field<S> damping_field() {
  return bind<S>(number("damping", Interval{0, 1, false, true}, "Cundall damping", between(0, 0.7)), &S::damping);
}

template <class S>
Field<S> unbalanced_field() {
  return bind<S>(number("unbalanced", inside(0, 1), "ratio of unbalanced to contact force at which the grains are at rest",
                        between(1e-6, 0.1)),
                 &S::unbalanced);
}

template <class S>
Field<S> stress_field(std::string help) {
  return bind<S>(needed(quantity("stress", "Pa", above(0), between(10, 1e8), R"("100 kPa")", std::move(help))), &S::stress);
}

KeyInfo rate(std::string name, std::string help) {
  return noted(quantity(std::move(name), "1/s", above(0), between(1e-6, 1e3), R"("1.0 1/s")", std::move(help)),
               std::string(quasi_static));
}

/// Names of the three axes, stored as their number.
template <class S>
Field<S> axis_field(std::string name, std::string help, int S::*member) {
  const KeyInfo info = choice(std::move(name), {"x", "y", "z"}, std::move(help));
  return {info,
          [info, member](const TomlValue& value, Problems& problems, S& s) {
            if (const auto axis = read_choice(value, info, problems)) s.*member = *axis;
          },
          [info, member](const S& s) { return toml_text(info.choices[static_cast<std::size_t>(s.*member)]); }};
}

KeyInfo duration(std::string help) {
  return needed(quantity("time", "s", above(0), between(1e-6, 1e4), R"("0.1 s")", std::move(help)));
}

}  // namespace

template <>
const Section<IsotropicStage>& stage_section() {
  static const Section<IsotropicStage> section{{
      kind_field<IsotropicStage>("the box strains until all axes carry one stress and the grains are at rest"),
      stress_field<IsotropicStage>("mean stress, compression positive"),
      unbalanced_field<IsotropicStage>(),
      damping_field<IsotropicStage>(),
  }};
  return section;
}

template <>
const Section<OedometerStage>& stage_section() {
  static const Section<OedometerStage> section = [] {
    KeyInfo path = noted(quantity("path", "Pa", above(0), between(10, 1e9), R"(["200 kPa", "50 kPa", "400 kPa"])",
                                  "axial stresses to go to, one after the other: loading and unloading"),
                         "required without strain");
    path.type = "a list of stresses";
    return Section<OedometerStage>{{
        kind_field<OedometerStage>("lateral faces stand, the box is shortened or stretched along z"),
        bind<OedometerStage>(path, &OedometerStage::path),
        bind<OedometerStage>(
            noted(number("strain", Interval{-1, 1, true, true},
                         "logarithmic axial strain to reach, in place of a path; negative: extension", between(-0.5, 0.5)),
                  "as the path needs"),
            &OedometerStage::strain),
        bind<OedometerStage>(rate("strain_rate", "of the axial strain"), &OedometerStage::strain_rate),
        damping_field<OedometerStage>(),
    }};
  }();
  return section;
}

template <>
const Section<TriaxialStage>& stage_section() {
  static const Section<TriaxialStage> section{{
      kind_field<TriaxialStage>("shortened along z while the lateral stress, the mean stress or the volume is held"),
      stress_field<TriaxialStage>("lateral stress, or mean stress, to hold"),
      bind_choice<TriaxialStage>(choice("stress_path", {"constant-lateral", "constant-mean", "constant-volume"},
                                        "what is held: the stress along x and y, the mean stress, or the volume (undrained)"),
                                 &TriaxialStage::path),
      bind<TriaxialStage>(number("strain", Interval{-1, 1, true, true}, "logarithmic axial strain to reach; negative: extension",
                                 between(-0.5, 0.6)),
                          &TriaxialStage::strain),
      bind<TriaxialStage>(rate("strain_rate", "of the axial strain"), &TriaxialStage::strain_rate),
      damping_field<TriaxialStage>(),
  }};
  return section;
}

template <>
const Section<ShearStage>& stage_section() {
  static const Section<ShearStage> section{{
      kind_field<ShearStage>("the two walls of an axis slide against each other under a normal stress"),
      axis_field<ShearStage>("axis", "whose two walls slide; they need friction (contact.wall_friction)", &ShearStage::axis),
      axis_field<ShearStage>("direction", "of the sliding; periodic", &ShearStage::direction),
      bind<ShearStage>(
          needed(quantity("normal_stress", "Pa", above(0), between(10, 1e8), R"("100 kPa")", "that the upper wall holds")),
          &ShearStage::normal_stress),
      bind<ShearStage>(number("strain", above(0), "shear strain to reach: relative displacement / height", between(1e-3, 10)),
                       &ShearStage::strain),
      bind<ShearStage>(rate("shear_rate", "relative speed of the walls / height at the start"), &ShearStage::shear_rate),
      damping_field<ShearStage>(),
  }};
  return section;
}

template <>
const Section<SettleStage>& stage_section() {
  static const Section<SettleStage> section{{
      kind_field<SettleStage>("grains move under gravity in the box as it stands, until they are at rest"),
      bind<SettleStage>(duration("after which the stage ends, at rest or not"), &SettleStage::time),
      unbalanced_field<SettleStage>(),
      damping_field<SettleStage>(),
  }};
  return section;
}

template <>
const Section<StrainStage>& stage_section() {
  static const Section<StrainStage> section = [] {
    Section<StrainStage> s{{kind_field<StrainStage>("along every axis a rate of strain, or a stress that is held")}};
    for (int axis = 0; axis < 3; ++axis) {
      const std::string letter(1, "xyz"[axis]);
      s.fields.push_back(bind<StrainStage>(
          noted(quantity("stress_" + letter, "Pa", above(0), between(10, 1e8), R"("100 kPa")", "to hold along " + letter),
                "the axis strains at its rate"),
          [axis](auto& stage) -> auto& { return stage.stress[static_cast<std::size_t>(axis)]; }));
      s.fields.push_back(bind<StrainStage>(quantity("strain_rate_" + letter, "1/s", {}, between(-1e3, 1e3), R"("1.0 1/s")",
                                                    "along " + letter + " where no stress is held, shortening positive"),
                                           [axis](auto& stage) -> decltype(auto) { return stage.strain_rate[axis]; }));
    }
    s.fields.push_back(bind<StrainStage>(duration("of the stage"), &StrainStage::time));
    s.fields.push_back(damping_field<StrainStage>());
    return s;
  }();
  return section;
}

}  // namespace puadem
