#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <system_error>
#include <type_traits>

#include "puadem/base/error.hpp"
#include "puadem/base/parallel.hpp"
#include "puadem/dem/grain_statistics.hpp"
#include "puadem/geometry/domain.hpp"
#include "puadem/io/case_checks_bridges.hpp"
#include "puadem/io/case_checks_coupled.hpp"
#include "puadem/io/case_checks_two_phase.hpp"
#include "puadem/io/case_file.hpp"
#include "puadem/io/units.hpp"

namespace puadem {

namespace {

/// Place of a dotted key, or of the nearest table above it that exists.
Place place_of_key(const TomlValue& tree, std::initializer_list<std::string_view> parts) {
  const TomlValue* value = &tree;
  for (const std::string_view part : parts) {
    const TomlValue* next = value->find(part);
    if (next == nullptr) break;
    value = next;
  }
  return value->key.empty() ? value->place : value->key_place;
}

bool has(const TomlValue& tree, std::string_view table, std::string_view key) {
  const TomlValue* found = tree.find(table);
  return found != nullptr && found->find(key) != nullptr;
}

template <class S>
bool has_stage(const Case& c) {
  for (const Stage& stage : c.stages)
    if (std::holds_alternative<S>(stage)) return true;
  return false;
}

void check_domain(const TomlValue& tree, const Case& c, Problems& problems) {
  if (has(tree, "domain", "size") && has(tree, "domain", "shape"))
    problems.error(place_of_key(tree, {"domain", "shape"}), "domain.size and domain.shape exclude each other; remove one");
  if (!c.grains.file) return;
  for (const std::string_view key : {"size", "shape"})
    if (has(tree, "domain", key))
      problems.error(
          place_of_key(tree, {"domain", key}),
          fmt::format("domain.{} is not used with grains.file: the line \"# box\" of the packing gives the size; remove it",
                      key));
}

void check_grading(const TomlValue& tree, const Case& c, Problems& problems) {
  if (std::ranges::any_of(problems.errors, [](const auto& e) { return e.key.starts_with("grains.grading"); })) return;
  Place place = place_of_key(tree, {"grains", "grading"});
  for (const std::string_view form : {"lognormal", "table", "classes"})
    if (tree.find("grains")->find("grading")->find(form) != nullptr) place = place_of_key(tree, {"grains", "grading", form});
  try {
    const GrainStatistics sizes = statistics_of(c.grains.grading);
    if (sizes.largest > 50.0 * sizes.smallest)
      problems.warning(place, fmt::format("the largest grain is {:.3g} times the smallest; such packings need very many grains",
                                          sizes.largest / sizes.smallest));
  } catch (const InputError& error) {
    problems.error(place, error.what());
  }
}

void check_grains(const TomlValue& tree, const Case& c, Problems& problems) {
  const TomlValue* grains = tree.find("grains");
  if (grains == nullptr && tree.find("network") == nullptr)
    return problems.error(tree.place,
                          "missing key grains: where the grains come from; write [grains] with count and grading, or file; or "
                          "[network] with the file of a network");
  if (grains == nullptr || grains->kind != TomlValue::Kind::table) return;
  if (c.grains.file) {
    for (const std::string_view key : {"count", "grading"})
      if (grains->find(key) != nullptr)
        problems.error(place_of_key(tree, {"grains", key}),
                       fmt::format("grains.file and grains.{} exclude each other; remove one", key));
    std::error_code failed;
    const Place place = grains->find("file")->place;
    if (!std::filesystem::exists(*c.grains.file, failed))
      problems.error(place, fmt::format("no such file: {}", c.grains.file->string()));
    else if (std::filesystem::is_directory(*c.grains.file, failed))
      problems.error(place, fmt::format("this is a folder, not a packing file: {}", c.grains.file->string()));
    return;
  }
  if (grains->find("file") != nullptr) return;  // its error is reported already
  const bool has_grading = grains->find("grading") != nullptr, has_count = grains->find("count") != nullptr;
  if (!has_grading && !has_count) {
    problems.error(grains->key_place, "the table [grains] needs either file, or count and grading");
    return;
  }
  if (!has_count) problems.error(grains->key_place, "missing key grains.count: number of grains; write count = 5000");
  if (!has_grading)
    problems.error(grains->key_place,
                   "missing key grains.grading: sizes of the grains; write grading = { by = \"mass\", classes = "
                   "[{ diameter = \"0.6 mm\", fraction = 1.0 }] }");
  else if (grains->find("grading")->kind == TomlValue::Kind::table)
    check_grading(tree, c, problems);
}

void check_pores(const TomlValue& tree, const Case& c, Problems& problems) {
  if (c.pores.merge_criterion == MergeCriterion::insphere_overlap && has(tree, "pores", "merge_ratio"))
    problems.error(place_of_key(tree, {"pores", "merge_ratio"}),
                   "pores.merge_ratio is not used with pores.merge_criterion = \"insphere-overlap\"; remove it");
  for (int face = 0; face < 6; ++face)
    if (c.pores.no_slip[to_size(face)] && c.domain.periodic[to_size(axis_of(face))])
      problems.error(place_of_key(tree, {"pores", "no_slip"}),
                     fmt::format("pores.no_slip: \"{}\" is no wall: the direction {} is periodic", face_names[to_size(face)],
                                 "xyz"[axis_of(face)]));
}

/// The error of a name that no material has.
std::string no_material(const std::string& name, std::string_view user, const std::vector<std::string>& names) {
  return fmt::format("no table [materials.{}] for {}; defined: {}{}", name, user, joined(names), did_you_mean(name, names));
}

void check_mixture(const TomlValue& tree, const Case& c, const std::vector<std::string>& names, Problems& problems) {
  const Place place = place_of_key(tree, {"grains", "materials"});
  if (has(tree, "grains", "material"))
    problems.error(place, "grains.material and grains.materials exclude each other; remove one");
  double sum = 0.0;
  for (const GrainOptions::Share& share : c.grains.materials) {
    sum += share.fraction;
    if (!share.name.empty() && std::ranges::find(names, share.name) == names.end())
      problems.error(place, no_material(share.name, "a share of grains.materials", names));
  }
  if (std::abs(sum - 1.0) > 1e-3)
    problems.error(place, fmt::format("the fractions of grains.materials add to {:.6g}; they must add to 1", sum));
}

void check_added(const TomlValue& tree, const Case& c, const std::vector<std::string>& names, Problems& problems) {
  for (const GrainOptions::Added& added : c.grains.added) {
    const Place place = place_of_key(tree, {"grains", "added"});
    if (!added.material.empty() && std::ranges::find(names, added.material) == names.end())
      problems.error(place, no_material(added.material, "grains.added", names));
    if (added.at && added.count != 1)
      problems.error(place, "grains.added: at is the place of one grain; leave count out, or leave the place to chance");
    if (c.grains.file) problems.error(place, "grains.file and grains.added exclude each other; remove one");
  }
}

void check_pairs(const TomlValue& tree, const Case& c, const std::vector<std::string>& names, Problems& problems) {
  for (const PairOverride& pair : c.contact.pairs)
    for (const std::string& name : pair.materials)
      if (!name.empty() && std::ranges::find(names, name) == names.end())
        problems.error(place_of_key(tree, {"contact", "pair"}), no_material(name, "contact.pair", names));
}

/// A case that never needs the material of its grains may leave it out.
void check_materials(const TomlValue& tree, Case& c, Problems& problems) {
  std::vector<std::string> names;
  for (const Material& m : c.materials) names.push_back(m.name);
  check_pairs(tree, c, names, problems);
  check_added(tree, c, names, problems);
  if (has(tree, "grains", "materials")) return check_mixture(tree, c, names, problems);
  if (std::ranges::find(names, c.grains.material) != names.end()) return;
  const bool is_named = has(tree, "grains", "material");
  if (c.materials.empty() && !is_named && std::ranges::all_of(c.stages, puts_fluid)) {
    c.materials.emplace_back().name = c.grains.material;
    return;
  }
  problems.error(place_of_key(tree, {"grains", "material"}),
                 fmt::format("no table [materials.{}] for the material of the grains{}", c.grains.material,
                             names.empty() ? "; add it with density, youngs_modulus, poisson_ratio and friction_angle"
                                           : "; defined: " + joined(names) + did_you_mean(c.grains.material, names)));
}

/// One stage with what messages need to point at it.
struct StageContext {
  const TomlValue& tree;  ///< of the stage
  int index;
  const Case& c;

  Place place(std::string_view key) const { return place_of_key(tree, {key}); }
  Place value_place(std::string_view key) const {
    const TomlValue* value = tree.find(key);
    return value != nullptr ? value->place : tree.place;
  }
};

void check_strain(const std::optional<double>& strain, const StageContext& at, Problems& problems) {
  if (strain && *strain == 0.0)
    problems.error(at.value_place("strain"), fmt::format("stage.{}.strain = 0 leaves nothing to do", at.index));
}

void check_stage(const CompactStage& stage, const StageContext& at, Problems& problems) {
  if (at.c.grains.file)
    problems.error(
        at.value_place("kind"),
        "a stage \"compact\" makes its grains from grains.count and grains.grading; with grains.file remove the stage");
  if (at.index != 0) problems.error(at.value_place("kind"), "a stage \"compact\" must come first");
  if (stage.porosity && stage.friction_angle)
    problems.error(at.place("friction_angle"),
                   fmt::format("stage.{0}.porosity and stage.{0}.friction_angle exclude each other: to reach a porosity the "
                               "friction is found by itself; remove one",
                               at.index));
  const auto is_used = [&](const Material& m) {
    if (at.c.grains.materials.empty()) return m.name == at.c.grains.material;
    return std::ranges::find(at.c.grains.materials, m.name, &GrainOptions::Share::name) != at.c.grains.materials.end();
  };
  for (const Material& m : at.c.materials)
    if (is_used(m) && stage.stress > 0.01 * m.youngs_modulus)
      problems.warning(at.value_place("stress"),
                       fmt::format("stage.{}.stress is {:.2g} of the modulus of {}: grains will overlap deeply", at.index,
                                   stage.stress / m.youngs_modulus, m.name));
}

void check_stage(const PermeabilityStage& stage, const StageContext& at, Problems& problems) {
  if (at.c.network_file && stage.merged)
    problems.error(at.value_place("merged"),
                   fmt::format("stage.{}.merged is not used with network.file: its pores are taken as they are", at.index));
}

void check_stage(const RetentionStage& stage, const StageContext& at, Problems& problems) {
  const int air = stage.invasion.nonwetting_face, water = stage.invasion.wetting_face;
  if (air == water)
    problems.error(at.value_place(at.tree.find("water") != nullptr ? "water" : "air"),
                   fmt::format("air and water must lie at different faces, not both at {}", face_names[to_size(air)]));
  for (const auto& [key, face] : {std::pair{"air", air}, std::pair{"water", water}})
    if (at.c.domain.periodic[to_size(axis_of(face))])
      problems.error(at.value_place(key), fmt::format("stage.{}.{} = \"{}\" is no wall: the direction {} is periodic", at.index,
                                                      key, face_names[to_size(face)], "xyz"[axis_of(face)]));
  if (!stage.invasion.body_entry && stage.invasion.corner_water)
    problems.error(at.value_place("body_entry"),
                   fmt::format("stage.{0}.body_entry = false needs stage.{0}.corner_water = false", at.index));
  if (at.tree.find("path") == nullptr) return;
  const std::size_t given = at.tree.find("path")->children.size();
  if (given != stage.path.size()) return;  // values with errors of their own
  if (given < 2)
    problems.error(at.value_place("path"),
                   fmt::format("stage.{}.path needs at least two pressures, a start and an end", at.index));
  for (std::size_t i = 1; i < stage.path.size(); ++i)
    if (stage.path[i] == stage.path[i - 1])
      problems.error(at.tree.find("path")->children[i].place,
                     fmt::format("stage.{}.path: a pressure must differ from the one before it", at.index));
  double span = 0.0;
  for (std::size_t i = 1; i < stage.path.size(); ++i) span += std::abs(stage.path[i] - stage.path[i - 1]);
  if (span / stage.step > 1e6)
    problems.error(at.value_place("step"), fmt::format("stage.{}.step = {} makes {:.3g} steps along the path; at most 1e6",
                                                       at.index, show(stage.step, "Pa"), span / stage.step));
}

void check_stage(const TwoPhaseStage& stage, const StageContext& at, Problems& problems) {
  check_two_phase_stage(stage, at.tree, at.index, at.c, problems);
}

void check_stage(const SaturatedStage& stage, const StageContext& at, Problems& problems) {
  check_saturated_stage(stage, at.tree, at.index, at.c, problems);
}

void check_stage(const UnsaturatedStage& stage, const StageContext& at, Problems& problems) {
  check_unsaturated_stage(stage, at.tree, at.index, at.c, problems);
}

/// Stages that load grains and walls: what they need of the box, and what cannot be both.
void check_stage(const IsotropicStage&, const StageContext&, Problems&) {}

void check_stage(const OedometerStage& stage, const StageContext& at, Problems& problems) {
  if (stage.path.empty() == !stage.strain)
    problems.error(at.value_place(stage.strain ? "strain" : "kind"),
                   fmt::format("stage.{0} needs either stage.{0}.path, axial stresses to go to, or stage.{0}.strain", at.index));
  for (std::size_t i = 1; i < stage.path.size(); ++i)
    if (stage.path[i] == stage.path[i - 1])
      problems.error(at.value_place("path"), fmt::format("stage.{}.path: a stress must differ from the one before it", at.index));
  check_strain(stage.strain, at, problems);
}

void check_stage(const TriaxialStage& stage, const StageContext& at, Problems& problems) {
  check_strain(stage.strain, at, problems);
}

void check_stage(const ShearStage& stage, const StageContext& at, Problems& problems) {
  const auto& periodic = at.c.domain.periodic;
  const char axis = "xyz"[stage.axis], direction = "xyz"[stage.direction];
  if (stage.axis == stage.direction)
    return problems.error(
        at.value_place("direction"),
        fmt::format("stage.{0}.direction = \"{1}\" must lie in the walls: not along stage.{0}.axis = \"{1}\"", at.index, axis));
  if (periodic[to_size(stage.axis)])
    problems.error(at.value_place("axis"),
                   fmt::format("stage.{}: the axis {} is periodic and has no walls to slide; take it out of domain.periodic",
                               at.index, axis));
  if (!periodic[to_size(stage.direction)])
    problems.error(
        at.value_place("direction"),
        fmt::format(
            "stage.{}: grains sheared along {} would pile up at its walls; make it periodic: domain.periodic = [\"{}\", ...]",
            at.index, direction, direction));
  if (!(at.c.contact.wall_friction > 0.0))
    problems.error(at.value_place("kind"),
                   fmt::format("stage.{}: walls without friction cannot shear grains; set contact.wall_friction", at.index));
}

void check_stage(const SettleStage&, const StageContext& at, Problems& problems) {
  const Vec3& g = at.c.motion.gravity;
  if (squared_norm(g) == 0.0)
    return problems.error(at.value_place("kind"), fmt::format("stage.{}: nothing makes the grains settle; set motion.gravity = "
                                                              "[0, 0, \"-9.81 m/s2\"], or use a stage \"isotropic\"",
                                                              at.index));
  for (int axis = 0; axis < 3; ++axis)
    if (g[axis] != 0.0 && at.c.domain.periodic[to_size(axis)])
      problems.error(at.value_place("kind"),
                     fmt::format("stage.{}: gravity acts along the periodic direction {}: grains would fall for ever", at.index,
                                 "xyz"[axis]));
}

void check_stage(const StrainStage& stage, const StageContext& at, Problems& problems) {
  for (int axis = 0; axis < 3; ++axis)
    if (stage.stress[to_size(axis)] && stage.strain_rate[axis] != 0.0)
      problems.error(at.value_place(fmt::format("strain_rate_{}", "xyz"[axis])),
                     fmt::format("stage.{0}.stress_{1} and stage.{0}.strain_rate_{1} exclude each other; remove one", at.index,
                                 "xyz"[axis]));
  if (stage.strain_rate == Vec3{} && !stage.stress[0] && !stage.stress[1] && !stage.stress[2])
    problems.error(at.value_place("kind"),
                   fmt::format("stage.{}: neither a rate nor a stress is given for any axis, nothing would happen", at.index));
}

/// Grains swell in time, which only one kind of stage knows.
void check_swelling(const TomlValue& tree, const Case& c, Problems& problems) {
  const auto has_time = [](const Stage& stage) {
    const auto* s = std::get_if<UnsaturatedStage>(&stage);
    return s != nullptr && !s->times.empty();
  };
  for (const Material& m : c.materials)
    if (m.swelling && std::ranges::none_of(c.stages, has_time))
      problems.warning(place_of_key(tree, {"materials", m.name, "swelling"}),
                       fmt::format("materials.{}: nothing swells, for no stage \"unsaturated-flow\" has times", m.name));
}

void check_stages(const TomlValue& tree, const Case& c, Problems& problems) {
  const TomlValue* stages = tree.find("stage");
  if (stages == nullptr || stages->kind != TomlValue::Kind::array) return;
  if (stages->children.empty()) problems.error(stages->key_place, "no stage; add [[stage]] with a kind: puadem keys stage");
  if (stages->children.size() != c.stages.size()) return;  // a stage with an error of its own
  for (int i = 0; i < size_of(c.stages); ++i)
    std::visit(
        [&](const auto& stage) {
          check_stage(stage, {stages->children[to_size(i)], i, c}, problems);
        },
        c.stages[to_size(i)]);
  if (!c.grains.file && !c.stages.empty() && !has_stage<CompactStage>(c) && has(tree, "grains", "grading"))
    problems.error(stages->children[0].place,
                   "grains from a grading need a stage \"compact\" first; or give a packing by grains.file");
}

void check_overlays(const TomlValue& tree, const Case& c, Problems& problems) {
  const TomlValue* overlays = tree.find("overlay");
  if (overlays == nullptr || overlays->children.size() != c.overlays.size()) return;
  for (std::size_t i = 0; i < c.overlays.size(); ++i) {
    std::error_code failed;
    const std::filesystem::path& folder = c.overlays[i].folder;
    if (!folder.empty() && !std::filesystem::is_directory(folder, failed))
      problems.warning(place_of_key(overlays->children[i], {"folder"}),
                       fmt::format("no such folder: {}; the report will lack this overlay", folder.string()));
  }
}

}  // namespace

void check_case(const TomlValue& tree, Case& c, Problems& problems) {
  problems.key.clear();
  if (c.network_file) {
    check_network_case(tree, c, problems);
  } else {
    check_domain(tree, c, problems);
    check_grains(tree, c, problems);
    check_pores(tree, c, problems);
    check_materials(tree, c, problems);
    check_bridges(tree, c, problems);
  }
  check_stages(tree, c, problems);
  check_swelling(tree, c, problems);
  check_overlays(tree, c, problems);
  // One angle for the network and the fluids.
  c.pores.contact_angle = c.fluids.contact_angle;
}

}  // namespace puadem
