#include <fmt/format.h>

#include "puadem/geometry/domain.hpp"
#include "puadem/io/case_schema.hpp"
#include "puadem/io/key_builders.hpp"

namespace puadem {

namespace {

/// conductance_limits = [low, high].
Field<PoreOptions> limits_field() {
  KeyInfo info = noted(number("conductance_limits", above(0),
                              "bounds [low, high] of throat conductances, as multiples of their median; throats beyond them are "
                              "counted in the results"),
                       "no bounds");
  info.type = "a list of two numbers";
  info.example = "[1e-4, 100]";
  const auto read = [info](const TomlValue& value, Problems& problems, PoreOptions& pores) {
    std::vector<double> bounds;
    const std::size_t before = problems.errors.size();
    read_value(value, info, problems, bounds);
    if (problems.errors.size() > before) return;
    if (bounds.size() != 2 || bounds[0] > 1.0 || bounds[1] < 1.0)
      return problems.error(value.place, problems.key + " must be [low, high] with low <= 1 <= high");
    pores.conductance_limits = {bounds[0], bounds[1]};
  };
  const auto write = [](const PoreOptions& pores) {
    const auto& limits = pores.conductance_limits;
    return limits ? fmt::format("[{}, {}]", limits->low, limits->high) : std::string();
  };
  return {info, read, write};
}

}  // namespace

const Section<PoreOptions>& pores_section() {
  static const Section<PoreOptions> section = [] {
    const auto entry =
        bind_law<PoreOptions, EntryLaw>("entry_pressure", "law of the entry pressure of a throat", &PoreOptions::entry_law);
    KeyInfo ratio = number("merge_ratio", above(0),
                           "neighbouring pores merge where throat radius / smaller pore radius exceeds this; \"none\": never");
    ratio.word_for_infinity = "none";
    ratio.plausible = Interval{0.5, std::numeric_limits<double>::infinity(), false, false};
    // With the other criterion there is no such ratio, and the reader would say so.
    Field<PoreOptions> ratio_field = bind<PoreOptions>(ratio, &PoreOptions::merge_ratio);
    ratio_field.write = [write = ratio_field.write](const PoreOptions& pores) {
      return pores.merge_criterion == MergeCriterion::entry_ratio ? write(pores) : std::string();
    };
    KeyInfo no_slip = choice("no_slip", {face_names.begin(), face_names.end()},
                             "walls that hold the fluid as grains do; along the others it slips, as at a plane of symmetry");
    no_slip.type = "a list of faces";
    no_slip.example = R"(["bottom", "top"])";
    return Section<PoreOptions>{
        {entry,
         bind_choice<PoreOptions>(choice("merge_criterion", {"entry-ratio", "insphere-overlap"},
                                         "when neighbouring pores merge: by merge_ratio, or where the spheres between the grains "
                                         "of either overlap"),
                                  &PoreOptions::merge_criterion),
         ratio_field,
         bind<PoreOptions>(whole("merge_limit", 1, 1e6, "most tetrahedra in one pore unit", "20"), &PoreOptions::merge_limit),
         bind_choice<PoreOptions>(choice("pore_shape", {"faces", "vertices"},
                                         "a pore is likened to the regular polyhedron of as many faces, or of as many vertices"),
                                  &PoreOptions::pore_shape),
         bind_choice<PoreOptions>(choice("throat_section", {"facet", "window"},
                                         "entry of a throat: of each facet by itself, or of the whole flat window that several "
                                         "facets make between two pores"),
                                  &PoreOptions::throat_section),
         bind<PoreOptions>(no_slip, &PoreOptions::no_slip), limits_field()}};
  }();
  return section;
}

}  // namespace puadem
