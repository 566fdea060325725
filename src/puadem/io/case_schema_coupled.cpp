#include "puadem/base/parallel.hpp"
#include "puadem/geometry/domain.hpp"
#include "puadem/io/case_schema_stages.hpp"

namespace puadem {

namespace {

using Fields = std::vector<Field<SaturatedStage>>;

/// A face of the box, or none.
Field<SaturatedStage> face_field(std::string name, std::string note, std::string help,
                                 std::optional<int> SaturatedStage::*member) {
  const KeyInfo info = noted(choice(std::move(name), {face_names.begin(), face_names.end()}, std::move(help)), std::move(note));
  return {info,
          [info, member](const TomlValue& value, Problems& problems, SaturatedStage& s) {
            if (const auto face = read_face(value, info, problems)) s.*member = *face;
          },
          [member](const SaturatedStage& s) { return s.*member ? toml_text(face_names[to_size(*(s.*member))]) : std::string(); }};
}

/// One value, or a list of them.
Field<SaturatedStage> list_field(KeyInfo info, std::string type, std::vector<double> SaturatedStage::*member) {
  info.type = std::move(type);
  return {info,
          [info, member](const TomlValue& value, Problems& problems, SaturatedStage& s) {
            if (value.kind == TomlValue::Kind::array) return read_value(value, info, problems, s.*member);
            read_value(value, info, problems, (s.*member).emplace_back());
          },
          [info, member](const SaturatedStage& s) { return (s.*member).empty() ? std::string() : write_value(info, s.*member); }};
}

void add_time(Fields& fields) {
  fields.push_back(
      bind<SaturatedStage>(noted(quantity("duration", "s", above(0), between(1e-6, 1e5), R"("0.1 s")", "of the stage"),
                                 "required without time_factor"),
                           &SaturatedStage::duration));
  fields.push_back(bind<SaturatedStage>(
      noted(number("time_factor", above(0),
                   "duration of a consolidation as Terzaghi's T_v = c_v t / H^2; stiffness and permeability of the packing are "
                   "measured before, and the degree of consolidation is recorded beside Terzaghi's",
                   between(0.01, 10)),
            "the duration is given"),
      &SaturatedStage::time_factor));
}

void add_faces(Fields& fields) {
  KeyInfo drained = choice("drained", {face_names.begin(), face_names.end()},
                           "faces through which the fluid comes and goes at a piezometric pressure of 0");
  drained.type = "a list of choices";
  drained.example = R"(["top"])";
  fields.push_back(bind<SaturatedStage>(drained, &SaturatedStage::drained));
  fields.push_back(face_field("inlet", "none", "face at a pressure of its own", &SaturatedStage::inlet));
  fields.push_back(list_field(noted(quantity("inlet_pressure", "Pa", {}, between(-1e7, 1e7), R"(["0 Pa", "400 Pa"])",
                                             "piezometric pressure there, above that of the drained faces: one, or one for each "
                                             "of inlet_times with straight lines between"),
                                    "required with inlet"),
                              "a pressure, or a list of them", &SaturatedStage::inlet_pressure));
  fields.push_back(list_field(noted(quantity("inlet_times", "s", at_least(0), {}, R"(["0 s", "0.5 s"])",
                                             "times of these pressures, from the stage's start"),
                                    "one pressure for all times"),
                              "a list of times", &SaturatedStage::inlet_times));
  fields.push_back(face_field("loaded", "all walls stand", "face whose wall moves to hold `stress`", &SaturatedStage::loaded));
  fields.push_back(bind<SaturatedStage>(noted(quantity("stress", "Pa", above(0), between(1, 1e8), R"("110 kPa")",
                                                       "of grains and fluid together on the loaded face"),
                                              "required with loaded"),
                                        &SaturatedStage::stress));
}

void add_coupling(Fields& fields) {
  fields.push_back(face_field("seat_loose_grains", "they stay where they are",
                              "face towards which grains that nothing holds are laid against their neighbours before the stage "
                              "begins; afloat, they would drift with the fluid and let more of it through (theory 7.4)",
                              &SaturatedStage::seat_loose_grains));
  fields.push_back(
      bind<SaturatedStage>(number("damping", Interval{0, 1, false, true}, "Cundall damping of the grains", between(0, 0.7)),
                           &SaturatedStage::damping));
  fields.push_back(bind<SaturatedStage>(
      noted(quantity("coupling_interval", "s", above(0), {}, R"("2 us")",
                     "time over which the forces of the fluid stay frozen; above the limit of stability the case is refused"),
            "coupling_safety times the limit, and no longer than a row of the history"),
      &SaturatedStage::coupling_interval));
  fields.push_back(bind<SaturatedStage>(
      number("coupling_safety", Interval{0, 1, true, true}, "share of the limit of stability", between(0.01, 0.95)),
      &SaturatedStage::coupling_safety));
  fields.push_back(bind<SaturatedStage>(
      number("remesh_displacement", above(0),
             "displacement of a grain since the pore network was made, over the mean radius, at which a new one is made",
             between(1e-3, 0.1)),
      &SaturatedStage::remesh_displacement));
  fields.push_back(bind<SaturatedStage>(
      noted(quantity("bulk_modulus", "Pa", above(0), between(1e3, 1e11), R"("2.2 GPa")", "of a fluid that yields a little"),
            "incompressible"),
      &SaturatedStage::bulk_modulus));
  fields.push_back(
      bind<SaturatedStage>(whole("layers", 1, 1e5, "layers of series/pressure_profile.csv", "20"), &SaturatedStage::layers));
}

}  // namespace

template <>
const Section<SaturatedStage>& stage_section() {
  static const Section<SaturatedStage> section = [] {
    Section<SaturatedStage> s;
    s.fields.push_back(kind_field<SaturatedStage>(
        "the wetting fluid fills all pores; it and the grains move each other: consolidation, seepage"));
    add_time(s.fields);
    add_faces(s.fields);
    add_coupling(s.fields);
    return s;
  }();
  return section;
}

}  // namespace puadem
