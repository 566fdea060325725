#include <fmt/format.h>

#include "puadem/io/case_schema.hpp"
#include "puadem/io/key_builders.hpp"

namespace puadem {

namespace {

// [grains]

/// A diameter, or the two bounds of a class.
Field<GradingClass> diameter_field() {
  KeyInfo info = needed(quantity("diameter", "m", above(0), between(1e-6, 0.1), R"("0.35 mm")",
                                 "diameter of a class, or its two bounds [\"1.0 mm\", \"1.4 mm\"]"));
  info.type = "a length, or a list of two";
  Field<GradingClass> field;
  field.read = [info](const TomlValue& value, Problems& problems, GradingClass& c) {
    if (value.kind != TomlValue::Kind::array) {
      read_value(value, info, problems, c.diameter_min);
      c.diameter_max = c.diameter_min;
      return;
    }
    std::vector<double> bounds;
    const std::size_t before = problems.errors.size();
    read_value(value, info, problems, bounds);
    if (problems.errors.size() > before) return;
    if (bounds.size() != 2 || bounds[0] > bounds[1])
      return problems.error(value.place, problems.key + " must be one diameter or two, the smaller first");
    c.diameter_min = bounds[0];
    c.diameter_max = bounds[1];
  };
  field.write = [info](const GradingClass& c) {
    if (c.diameter_min == c.diameter_max) return c.diameter_min > 0 ? write_value(info, c.diameter_min) : std::string();
    return write_value(info, std::vector<double>{c.diameter_min, c.diameter_max});
  };
  field.info = std::move(info);
  return field;
}

const Section<GradingClass>& class_section() {
  static const Section<GradingClass> section{{
      diameter_field(),
      bind<GradingClass>(
          number("fraction", Interval{0, 1, true, false}, "share of the class in the measure of `by`; the shares add to 1"),
          &GradingClass::fraction),
  }};
  return section;
}

const Section<GradingTable>& table_section() {
  static const Section<GradingTable> section = [] {
    KeyInfo diameter = needed(quantity("diameter", "m", above(0), between(1e-6, 0.1), R"(["0.1 mm", "0.2 mm", "0.4 mm"])",
                                       "sieve sizes of a cumulative curve, ascending; in place of classes"));
    diameter.type = "a list of lengths";
    KeyInfo passing = needed(number("passing", between(0, 1), "share that passes each size, from 0 % to 100 %"));
    passing.type = "a list of numbers";
    passing.example = R"(["0 %", "35 %", "100 %"])";
    return Section<GradingTable>{{
        bind<GradingTable>(diameter, &GradingTable::diameter),
        bind<GradingTable>(passing, &GradingTable::passing),
        bind_choice<GradingTable>(choice("interpolation", {"logarithmic", "linear"},
                                         "between two sizes the curve is straight over the logarithm of the diameter, or over "
                                         "the diameter"),
                                  &GradingTable::interpolation),
    }};
  }();
  return section;
}

const Section<LogNormalGrading>& lognormal_section() {
  static const Section<LogNormalGrading> section{{
      bind<LogNormalGrading>(needed(quantity("median", "m", above(0), between(1e-6, 0.1), R"("0.4 mm")",
                                             "median diameter d_50 of log-normal sizes; in place of classes")),
                             &LogNormalGrading::median),
      bind<LogNormalGrading>(
          [] {
            KeyInfo info = needed(number("deviation", above(1), "geometric standard deviation d_84 / d_50", between(1, 5)));
            info.example = "1.5";
            return info;
          }(),
          &LogNormalGrading::deviation),
      bind<LogNormalGrading>(
          noted(quantity("smallest", "m", above(0), between(1e-6, 0.1), R"("0.2 mm")", "lower cut-off: no grain is smaller"),
                "median / deviation^2"),
          &LogNormalGrading::smallest),
      bind<LogNormalGrading>(
          noted(quantity("largest", "m", above(0), between(1e-6, 0.1), R"("0.9 mm")", "upper cut-off: no grain is larger"),
                "median * deviation^2"),
          &LogNormalGrading::largest),
  }};
  return section;
}

const Section<Grading>& grading_section() {
  static const Section<Grading> section{{
      bind_choice<Grading>(
          choice("by", {"mass", "number"}, "what the shares, the curve of a table and lognormal are measured in"), &Grading::by),
      bind_tables<Grading>(plain("classes", "a list of tables", "size classes of the grading"), class_section, &Grading::classes),
      bind_table<Grading>(plain("table", "a table", "cumulative curve"), table_section, &Grading::table),
      bind_table<Grading>(plain("lognormal", "a table", "log-normal sizes"), lognormal_section, &Grading::lognormal),
  }};
  return section;
}

// [materials.NAME]

const Section<SwellingLaw>& swelling_section() {
  static const Section<SwellingLaw> section{{
      bind<SwellingLaw>(needed(quantity("diffusivity", "m2/s", above(0), between(1e-14, 1e-4), R"("5e-8 m2/s")",
                                        "D of the growth law of theory 7.9")),
                        &SwellingLaw::diffusivity),
      bind<SwellingLaw>(needed(number("largest_ratio", above(1), "largest radius over that of the dry grain", between(1, 10))),
                        &SwellingLaw::largest_ratio),
      bind<SwellingLaw>(
          noted(quantity("largest_stress", "Pa", above(0), between(1, 1e8), R"("10 kPa")",
                         "mean stress in a grain at which it takes up nothing more; its growth falls with the stress "
                         "along a straight line"),
                "stress does not hinder the growth"),
          &SwellingLaw::largest_stress),
  }};
  return section;
}

const Section<Material>& material_section() {
  static const Section<Material> section{{
      bind<Material>(quantity("density", "kg/m3", above(0), between(100, 2e4), R"("2650 kg/m3")", "of the solid grain"),
                     &Material::density),
      bind<Material>(quantity("youngs_modulus", "Pa", above(0), between(1e5, 1e12), R"("150 MPa")",
                              "E; lower than the mineral's for speed, high against the stress"),
                     &Material::youngs_modulus),
      bind<Material>(number("poisson_ratio", Interval{-1, 0.5, true, false}, "nu", between(0, 0.5)), &Material::poisson_ratio),
      bind<Material>(quantity("friction_angle", "rad", Interval{0, 90 * degree, false, true}, between(0, 60 * degree),
                              R"("30 deg")", "between grains, mu = tan(angle)"),
                     &Material::friction_angle),
      bind_table<Material>(plain("swelling", "a table", "grains that take up the wetting fluid and grow"), swelling_section,
                           &Material::swelling),
  }};
  return section;
}

const Section<GrainOptions::Share>& share_section() {
  using Share = GrainOptions::Share;
  static const Section<Share> section{{
      bind<Share>(needed(plain("name", "a name", "of a material in a mixture: a table [materials.NAME]", R"("glass")")),
                  &Share::name),
      bind<Share>(number("fraction", Interval{0, 1, true, false},
                         "share of the solid volume; the shares add to 1, and every size of grain holds the mixture"),
                  &Share::fraction),
  }};
  return section;
}

const Section<GrainOptions::Added>& added_section() {
  using Added = GrainOptions::Added;
  static const Section<Added> section = [] {
    Section<Added> s{{
        bind<Added>(needed(quantity("diameter", "m", above(0), between(1e-6, 0.1), R"("0.5 mm")", "of these grains, all alike")),
                    &Added::diameter),
        bind<Added>(needed(plain("material", "a name", "a table [materials.NAME]", R"("hydrogel")")), &Added::material),
        bind<Added>(whole("count", 1, 1e7, "how many", "1"), &Added::count),
    }};
    KeyInfo at = noted(number("at", between(0, 1),
                              "place of a single one before the compaction, as shares of the box: there it stays but for the "
                              "motion of the compaction"),
                       "anywhere");
    at.type = "a list of three numbers";
    at.example = "[0.5, 0.5, 0.5]";
    s.fields.push_back(bind<Added>(at, &Added::at));
    return s;
  }();
  return section;
}

/// Two names.
Field<PairOverride> pair_names_field() {
  KeyInfo info = needed(plain("materials", "a list of two names", "the two materials that touch", R"(["glass", "rubber"])"));
  return {info,
          [info](const TomlValue& value, Problems& problems, PairOverride& p) {
            if (value.kind != TomlValue::Kind::array || value.children.size() != 2)
              return problems.error(value.place, problems.key + " must be a list of two names, such as " + info.example);
            for (std::size_t k = 0; k < 2; ++k) read_value(value.children[k], info, problems, p.materials[k]);
          },
          [](const PairOverride& p) {
            return p.materials[0].empty() ? std::string()
                                          : "[" + toml_text(p.materials[0]) + ", " + toml_text(p.materials[1]) + "]";
          }};
}

const Section<PairOverride>& pair_section() {
  static const Section<PairOverride> section{{
      pair_names_field(),
      bind<PairOverride>(noted(quantity("friction_angle", "rad", Interval{0, 90 * degree, false, true}, between(0, 60 * degree),
                                        R"("20 deg")", "between grains of the two materials"),
                               "the smaller one of the two materials"),
                         &PairOverride::friction_angle),
      bind<PairOverride>(
          noted(number("restitution", Interval{0, 1, true, false}, "coefficient of normal restitution of the pair"),
                "that of [contact]"),
          &PairOverride::restitution),
  }};
  return section;
}

}  // namespace

const Section<GrainOptions>& grains_section() {
  static const Section<GrainOptions> section = [] {
    Section<GrainOptions> s{{
        bind<GrainOptions>(
            noted(plain("file", "a path", "packing to use as it is: CSV x,y,z,r in metres, relative to the case file",
                        R"("packing.csv")"),
                  "grains are made from count and grading"),
            &GrainOptions::file),
        bind<GrainOptions>(noted(whole("count", 1, 1e8, "number of grains; with grading", "5000"), "required without file"),
                           &GrainOptions::count),
        bind<GrainOptions>(plain("material", "a name", "what the grains are made of: a table [materials.NAME]", R"("glass")"),
                           &GrainOptions::material),
        bind_choice<GrainOptions>(
            choice("cloud", {"uniform", "clumped"},
                   "how the grains lie before they are compacted: one by one, or in clumps, which leave large pores and a "
                   "loose, collapsible packing; clumps are no rigid bodies, their grains move freely"),
            &GrainOptions::cloud),
        bind<GrainOptions>(
            number("clump_size", at_least(1), "mean number of grains in a clump of a clumped cloud", between(2, 1000)),
            &GrainOptions::clump_size),
        bind_table<GrainOptions>(plain("grading", "a table", "sizes of the grains"), grading_section, &GrainOptions::grading),
        bind_tables<GrainOptions>(plain("materials", "a list of tables", "a mixture, in place of material"), share_section,
                                  &GrainOptions::materials),
        bind_tables<GrainOptions>(plain("added", "a list of tables", "grains beside those of count and grading"), added_section,
                                  &GrainOptions::added),
    }};
    auto& material = s.fields[2];
    material.write = [write = material.write](const GrainOptions& g) { return g.materials.empty() ? write(g) : std::string(); };
    // A packing file replaces count and grading.
    auto& count = s.fields[1];
    count.write = [write = count.write](const GrainOptions& g) { return g.file ? std::string() : write(g); };
    auto& grading = s.fields[5];
    grading.write_tables = [write = grading.write_tables](const std::string& path, const GrainOptions& g) {
      return g.file || !g.grading.is_given() ? std::string() : write(path, g);
    };
    return s;
  }();
  return section;
}

/// Tables with names of the user's choice.
Field<Case> materials_field() {
  Field<Case> field;
  field.info = plain("materials", "a table of tables", "one table [materials.NAME] for each material");
  field.read = [](const TomlValue& value, Problems& problems, Case& c) {
    if (!expect_table(value, problems)) return;
    for (const TomlValue& entry : value.children) {
      problems.key = "materials." + entry.key;
      Material material;
      material.name = entry.key;
      read_table(entry, material_section(), problems, material);
      c.materials.push_back(material);
    }
  };
  field.write_tables = [](const std::string& path, const Case& c) {
    std::string text;
    for (const Material& m : c.materials)
      text += "\n[" + path + "." + toml_key(m.name) + "]\n" + write_table(path + "." + toml_key(m.name), material_section(), m);
    return text;
  };
  field.describe = [](const std::string& path, std::vector<KeyDoc>& out) {
    describe_table(path + ".NAME", material_section(), out);
  };
  return field;
}

const Section<ContactOptions>& contact_section() {
  static const Section<ContactOptions> section{{
      bind_choice<ContactOptions>(choice("law", {"linear-spring", "hertz-mindlin"}, "contact law"), &ContactOptions::law),
      bind<ContactOptions>(number("stiffness_ratio", above(0), "k_s / k_n of the linear law", between(0.05, 2)),
                           &ContactOptions::stiffness_ratio),
      bind_choice<ContactOptions>(
          choice("wall_elasticity", {"material", "rigid"}, "walls of the grains' own constants, or walls that do not yield"),
          &ContactOptions::wall_elasticity),
      bind<ContactOptions>(
          noted(number("restitution", Interval{0, 1, true, false}, "coefficient of normal restitution"), "no viscous part"),
          &ContactOptions::restitution),
      bind<ContactOptions>(
          number("wall_friction", at_least(0), "friction coefficient mu between grains and walls", between(0, 2)),
          &ContactOptions::wall_friction),
      bind<ContactOptions>(
          number("rolling_stiffness", at_least(0), "alpha_r: rolling stiffness alpha_r k_s R_i R_j", between(0, 5)),
          &ContactOptions::rolling_stiffness),
      bind<ContactOptions>(
          number("rolling_friction", at_least(0), "eta_r: rolling moment up to eta_r min(R_i, R_j) F_n", between(0, 1)),
          &ContactOptions::rolling_friction),
      bind<ContactOptions>(number("twisting_stiffness", at_least(0), "alpha_t: the same about the normal", between(0, 5)),
                           &ContactOptions::twisting_stiffness),
      bind<ContactOptions>(number("twisting_friction", at_least(0), "eta_t: the same about the normal", between(0, 1)),
                           &ContactOptions::twisting_friction),
      bind_tables<ContactOptions>(plain("pair", "a list of tables", "two materials whose contact has constants of its own"),
                                  pair_section, &ContactOptions::pairs),
  }};
  return section;
}

}  // namespace puadem
