#include "puadem/io/case_schema.hpp"

#include <fmt/format.h>

#include <cmath>
#include <type_traits>

#include "puadem/base/parallel.hpp"
#include "puadem/io/key_builders.hpp"
#include "puadem/io/units.hpp"

namespace puadem {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// [domain]

const Section<DomainOptions>& domain_section() {
  static const Section<DomainOptions> section = [] {
    Section<DomainOptions> s;
    s.fields.push_back(bind<DomainOptions>(
        noted(quantity("size", "m", above(0), between(1e-4, 1), R"(["12 mm", "12 mm", "12 mm"])",
                       "edge lengths x, y, z of the box of a packing file; a compaction takes their proportions only"),
              "from count, grading and porosity"),
        &DomainOptions::size));
    s.fields.push_back(bind<DomainOptions>(
        [] {
          KeyInfo info =
              number("shape", above(0), "proportions x : y : z of a box whose size follows from count, grading and porosity");
          info.type = "a list of three numbers";
          info.example = "[1, 1, 2]";
          return info;
        }(),
        &DomainOptions::shape));
    auto& shape = s.fields.back();
    shape.write = [write = shape.write](const DomainOptions& d) { return d.size ? std::string() : write(d); };
    KeyInfo periodic = choice("periodic", {"x", "y", "z"}, "directions without walls, continued by copies of the box");
    periodic.type = "a list of choices";
    periodic.example = R"(["x", "y"])";
    s.fields.push_back(bind<DomainOptions>(periodic, &DomainOptions::periodic));
    return s;
  }();
  return section;
}

// [motion]

const Section<MotionCase>& motion_section() {
  static const Section<MotionCase> section = [] {
    KeyInfo gravity = quantity("gravity", "m/s2", {}, between(-100, 100), R"(["0 m/s2", "0 m/s2", "-9.81 m/s2"])",
                               "acceleration of all grains, in every stage but \"compact\"");
    gravity.type = "a list of three accelerations";
    return Section<MotionCase>{
        {bind<MotionCase>(gravity, &MotionCase::gravity),
         bind<MotionCase>(number("safety", inside(0, 1), "time step as a share of the critical one", between(0.05, 0.6)),
                          &MotionCase::safety)}};
  }();
  return section;
}

// [fluids]

Section<Fluid> fluid_section(const Fluid& defaults) {
  Section<Fluid> section{{
      bind<Fluid>(quantity("viscosity", "Pa s", above(0), between(1e-7, 1e4), R"("1.0 mPa s")", "dynamic viscosity"),
                  &Fluid::viscosity),
      bind<Fluid>(quantity("density", "kg/m3", above(0), between(0.05, 2e4), R"("998 kg/m3")", "of the fluid"), &Fluid::density),
  }};
  section.fields[0].info.default_note = show(defaults.viscosity, "Pa s");
  section.fields[1].info.default_note = show(defaults.density, "kg/m3");
  return section;
}
const Section<Fluid>& wetting_section() {
  static const Section<Fluid> section = fluid_section(Fluids{}.wetting);
  return section;
}
const Section<Fluid>& nonwetting_section() {
  static const Section<Fluid> section = fluid_section(Fluids{}.nonwetting);
  return section;
}

const Section<Fluids>& fluids_section() {
  static const Section<Fluids> section{{
      bind<Fluids>(
          quantity("surface_tension", "N/m", above(0), between(1e-4, 0.6), R"("72.8 mN/m")", "gamma between the two fluids"),
          &Fluids::surface_tension),
      bind<Fluids>(quantity("contact_angle", "rad", Interval{0, 60 * degree, false, true}, {}, R"("0 deg")",
                            "theta, measured through the wetting fluid"),
                   &Fluids::contact_angle),
      bind_table<Fluids>(plain("wetting", "a table", "the wetting fluid"), wetting_section, &Fluids::wetting),
      bind_table<Fluids>(plain("nonwetting", "a table", "the non-wetting fluid"), nonwetting_section, &Fluids::nonwetting),
  }};
  return section;
}

// [output], [[overlay]], [expected]

const Section<FieldsAt>& fields_at_section() {
  KeyInfo saturation = number("saturation", inside(0, 1), "saturations at which fields and a picture are kept");
  saturation.type = "a list of numbers";
  saturation.example = "[0.9, 0.6, 0.3]";
  static const Section<FieldsAt> section{{bind<FieldsAt>(saturation, &FieldsAt::saturation)}};
  return section;
}

const Section<OutputOptions>& output_section() {
  static const Section<OutputOptions> section{{
      bind<OutputOptions>(flag("fields", "write grains, pores and throats as VTP files for ParaView"), &OutputOptions::fields),
      bind<OutputOptions>(whole("fields_every", 1, 1e9, "one set of files each so many equilibria of a retention stage", "1"),
                          &OutputOptions::fields_every),
      bind<OutputOptions>(
          whole("fields_count", 0, 1e6,
                "sets of files of grains and contacts of a stage that loads the grains, evenly spread over it", "10"),
          &OutputOptions::fields_count),
      bind<OutputOptions>(
          whole("history_rows", 1, 1e7,
                "rows of series/history.csv of such a stage, evenly spread over its strain, stress or time", "200"),
          &OutputOptions::history_rows),
      bind_table<OutputOptions>(plain("fields_at", "a table", "states of a stage with two fluids that move"), fields_at_section,
                                &OutputOptions::fields_at),
      bind<OutputOptions>(quantity("checkpoint_every", "s", at_least(0), {}, R"("5 min")",
                                   "wall time between two checkpoints, from which `puadem resume` goes on"),
                          &OutputOptions::checkpoint_every),
      bind_choice<OutputOptions>(
          choice("checkpoints", {"latest", "all"}, "those that stay: the last two until the run has come to its end, or all"),
          &OutputOptions::checkpoints),
  }};
  return section;
}

const Section<Overlay>& overlay_section() {
  static const Section<Overlay> section{{
      bind<Overlay>(needed(plain("label", "a text", "name in the legend of the report", R"("glass beads")")), &Overlay::label),
      bind<Overlay>(needed(plain("folder", "a path",
                                 "run folder, or folder with retention.csv and distributions.csv, relative to the case file",
                                 R"("reference")")),
                    &Overlay::folder),
  }};
  return section;
}

/// name = [low, high], { value, tolerance }, { min } or { max }.
void read_expected(const TomlValue& value, Problems& problems, Expected& out) {
  const KeyInfo bound = number("", {}, "");
  if (value.kind == TomlValue::Kind::array) {
    std::vector<double> bounds;
    const std::size_t before = problems.errors.size();
    read_value(value, bound, problems, bounds);
    if (problems.errors.size() > before) return;
    if (bounds.size() != 2 || bounds[0] > bounds[1])
      return problems.error(value.place, problems.key + " must be [low, high] with low <= high");
    out = {bounds[0], bounds[1]};
    return;
  }
  if (value.kind != TomlValue::Kind::table)
    return problems.error(
        value.place,
        problems.key + " must be [low, high], { value = , tolerance = }, { min = } or { max = }, not " + short_text(value));
  struct Bounds {
    std::optional<double> value, tolerance, min, max;
  } b;
  static const Section<Bounds> section{{bind<Bounds>(number("value", {}, ""), &Bounds::value),
                                        bind<Bounds>(number("tolerance", at_least(0), ""), &Bounds::tolerance),
                                        bind<Bounds>(number("min", {}, ""), &Bounds::min),
                                        bind<Bounds>(number("max", {}, ""), &Bounds::max)}};
  const std::size_t before = problems.errors.size();
  read_table(value, section, problems, b);
  if (problems.errors.size() > before) return;
  const bool has_value = b.value || b.tolerance, has_bound = b.min || b.max;
  if (has_value == has_bound || b.value.has_value() != b.tolerance.has_value() || (b.min && b.max && *b.min > *b.max))
    return problems.error(value.place, problems.key + " must be { value = , tolerance = }, { min = } or { max = }");
  if (b.value) out = {*b.value - *b.tolerance, *b.value + *b.tolerance};
  if (b.min) out.low = *b.min;
  if (b.max) out.high = *b.max;
}

Field<Case> expected_field() {
  Field<Case> field;
  field.info = plain("expected", "a table", "bounds of named results, checked at the end of a run");
  field.read = [](const TomlValue& value, Problems& problems, Case& c) {
    if (!expect_table(value, problems)) return;
    for (const TomlValue& entry : value.children) {
      problems.key = "expected." + entry.key;
      read_expected(entry, problems, c.expected[entry.key]);
    }
  };
  field.write_tables = [](const std::string& path, const Case& c) {
    if (c.expected.empty()) return std::string();
    std::string text = "\n[" + path + "]\n";
    for (const auto& [name, e] : c.expected) {
      const bool low = std::isfinite(e.low), high = std::isfinite(e.high);
      text += toml_key(name) + " = ";
      text += low && high ? fmt::format("[{}, {}]\n", e.low, e.high)
              : low       ? fmt::format("{{ min = {} }}\n", e.low)
                          : fmt::format("{{ max = {} }}\n", e.high);
    }
    return text;
  };
  field.describe = [info = field.info](const std::string& path, std::vector<KeyDoc>& out) {
    KeyDoc doc = describe_key(path + ".RESULT", info, "");
    doc.type = "[low, high], { value = , tolerance = }, { min = } or { max = }";
    doc.help = "bounds of a result named as in manifest.json, checked at the end of a run";
    doc.example = "[0.338, 0.342]";
    out.push_back(doc);
  };
  return field;
}

/// A packing file brings its box: then only the periodic directions are written.
Field<Case> domain_field() {
  Field<Case> field = bind_table<Case>(plain("domain", "a table", "the box"), domain_section, &Case::domain);
  field.write_tables = [](const std::string& path, const Case& c) {
    const Section<DomainOptions> with_file{{domain_section().fields.back()}};
    return fmt::format("\n[{}]\n{}", path, write_table(path, c.grains.file ? with_file : domain_section(), c.domain));
  };
  return field;
}

}  // namespace

const Section<Case>& case_section() {
  static const Section<Case> section{{
      bind<Case>(plain("title", "a text", "name of the case in reports and folders", R"("glass beads")"), &Case::title),
      bind<Case>(whole("seed", 0, 1e15, "of the random numbers: the same seed gives the same run", "1"), &Case::seed),
      only_with_grains(domain_field()),
      only_with_grains(bind_table<Case>(plain("grains", "a table", "where the grains come from"), grains_section, &Case::grains)),
      only_with_grains(materials_field()),
      only_with_grains(bind_table<Case>(plain("contact", "a table", "contacts of grains"), contact_section, &Case::contact)),
      only_with_grains(bind_table<Case>(plain("motion", "a table", "how grains are moved"), motion_section, &Case::motion)),
      only_with_grains(bridges_field()),
      network_field(),
      bind_table<Case>(plain("fluids", "a table", "the two fluids"), fluids_section, &Case::fluids),
      pores_field(),
      stages_field(),
      bind_table<Case>(plain("output", "a table", "what is written"), output_section, &Case::output),
      bind_tables<Case>(plain("overlay", "a list of tables", "finished results to draw beside this run's"), overlay_section,
                        &Case::overlays),
      expected_field(),
  }};
  return section;
}

}  // namespace puadem
