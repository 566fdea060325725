#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "puadem/dem/grain_statistics.hpp"
#include "puadem/io/report_coupled.hpp"
#include "puadem/io/report_data.hpp"
#include "puadem/io/report_two_phase.hpp"
#include "puadem/io/report_unsaturated.hpp"

namespace puadem {
namespace {

using nlohmann::json;

std::string trapping(const InvasionOptions& o) {
  if (o.trap_wetting && o.trap_nonwetting) return "both fluids";
  return o.trap_wetting ? "the wetting fluid" : o.trap_nonwetting ? "the non-wetting fluid" : "none";
}

std::string yes_no(bool value) { return value ? "yes" : "no"; }

std::string class_text(const GradingClass& g, Grading::By by) {
  const std::string share = fmt::format("{:.4g} % {}", 100.0 * g.fraction, by == Grading::By::mass ? "by mass" : "by number");
  if (g.diameter_min == g.diameter_max) return fmt::format("{}: {}", in_print(g.diameter_min, "m"), share);
  return fmt::format("{} to {}: {}", in_print(g.diameter_min, "m"), in_print(g.diameter_max, "m"), share);
}

void add_grading_rows(const Grading& g, json& rows) {
  const std::string by = g.by == Grading::By::mass ? "by mass" : "by number";
  for (const GradingClass& c : g.classes) rows.push_back({"Diameter", class_text(c, g.by)});
  if (g.table)
    for (std::size_t i = 0; i < g.table->diameter.size(); ++i)
      rows.push_back(
          {"Smaller than " + in_print(g.table->diameter[i], "m"), fmt::format("{:.4g} % {}", 100.0 * g.table->passing[i], by)});
  if (g.lognormal) {
    const GrainStatistics sizes = statistics_of(g);
    rows.push_back({"Diameter", fmt::format("log-normal {}, median {}, deviation {:.4g}, {} to {}", by,
                                            in_print(g.lognormal->median, "m"), g.lognormal->deviation,
                                            in_print(2.0 * sizes.smallest, "m"), in_print(2.0 * sizes.largest, "m"))});
  }
}

json grain_rows(const Case& c) {
  json rows = json::array();
  if (c.grains.file) {
    rows.push_back({"Packing file", c.grains.file->filename().string()});
  } else {
    rows.push_back({"Grains", std::to_string(c.grains.count)});
    add_grading_rows(c.grains.grading, rows);
  }
  for (const MaterialShare& share : c.materials.empty() ? std::vector<MaterialShare>() : grain_materials(c)) {
    const Material& m = c.materials[to_size(share.material)];
    rows.push_back(
        {"Material", share.fraction < 1.0 ? fmt::format("{:.4g} % {} by volume", 100.0 * share.fraction, m.name) : m.name});
    rows.push_back({"Density", fmt::format("{:.4g} kg/m³", m.density)});
    rows.push_back({"Young's modulus", in_print(m.youngs_modulus, "Pa")});
    rows.push_back({"Poisson's ratio", fmt::format("{:.4g}", m.poisson_ratio)});
    rows.push_back({"Friction angle", in_print(m.friction_angle, "rad")});
  }
  rows.push_back({"Contact law", c.contact.law == ContactOptions::Law::hertz_mindlin ? "Hertz–Mindlin" : "linear springs"});
  return rows;
}

json network_rows(const Case& c) {
  json rows = json::array();
  rows.push_back({"File", c.network_file->filename().string()});
  return rows;
}

/// Options of the network; those that few change are named where they are not the default.
void add_network_rows(const PoreOptions& o, json& rows) {
  if (o.merge_criterion == MergeCriterion::insphere_overlap)
    rows.push_back({"Pores merge", "where inscribed spheres overlap"});
  else
    rows.push_back({"Merge ratio", std::isfinite(o.merge_ratio) ? fmt::format("{:.4g}", o.merge_ratio) : "no merging"});
  if (o.pore_shape == PoreShape::vertices) rows.push_back({"Pores are likened to polyhedra", "of as many vertices"});
  if (o.throat_section == ThroatOutline::window) rows.push_back({"Throats are entered", "as whole windows"});
  std::string held;
  for (int face = 0; face < 6; ++face)
    if (o.no_slip[to_size(face)]) held += fmt::format("{}{}", held.empty() ? "" : ", ", face_names[to_size(face)]);
  if (!held.empty()) rows.push_back({"Walls that hold the fluid", held});
  if (const auto& limits = o.conductance_limits)
    rows.push_back({"Conductances over their median", fmt::format("{:.4g} to {:.4g}", limits->low, limits->high)});
}

json fluid_rows(const Case& c) {
  const auto has = [&](std::string_view kind) {
    return std::ranges::any_of(c.stages, [&](const Stage& s) { return kind_of(s) == kind; });
  };
  json rows = json::array();
  if (has(RetentionStage::kind) || has(TwoPhaseStage::kind) || has(UnsaturatedStage::kind)) {
    rows.push_back({"Surface tension γ", in_print(c.fluids.surface_tension, "N/m")});
    rows.push_back({"Contact angle θ", in_print(c.fluids.contact_angle, "rad")});
  }
  if (has(TwoPhaseStage::kind))
    rows.push_back({"Viscosities, water and air",
                    in_print(c.fluids.wetting.viscosity, "Pa s") + ", " + in_print(c.fluids.nonwetting.viscosity, "Pa s")});
  if (has(PermeabilityStage::kind) || has(SaturatedStage::kind))
    rows.push_back({"Viscosity μ", in_print(c.fluids.wetting.viscosity, "Pa s")});
  if (c.network_file) return rows;
  rows.push_back({"Entry pressure law", std::visit([](const auto& law) { return std::string(law.name); }, c.pores.entry_law)});
  add_network_rows(c.pores, rows);
  return rows;
}

json stage_rows(const CompactStage& s) {
  json rows = json::array({{"Stress", in_print(s.stress, "Pa")}});
  if (s.porosity)
    rows.push_back({"Porosity", fmt::format("{:.4g} in the {}", *s.porosity,
                                            s.porosity_region == CompactStage::Region::core ? "core" : "whole box")});
  if (s.friction_angle) rows.push_back({"Friction angle while compacting", in_print(*s.friction_angle, "rad")});
  rows.push_back({"At rest below an unbalanced force of", fmt::format("{:.4g}", s.unbalanced)});
  rows.push_back({"Damping", fmt::format("{:.4g}", s.damping)});
  return rows;
}

json stage_rows(const IsotropicStage& s) {
  return json::array({{"Stress", in_print(s.stress, "Pa")},
                      {"At rest below an unbalanced force of", fmt::format("{:.4g}", s.unbalanced)},
                      {"Damping", fmt::format("{:.4g}", s.damping)}});
}

std::string rate_text(const std::optional<double>& rate) {
  return rate ? fmt::format("{:.4g} 1/s", *rate) : "quasi-static, inertial number 5 × 10⁻⁴";
}

std::string path_of(const std::vector<double>& path) {
  std::string text;
  for (const double p : path) text += fmt::format("{}{}", text.empty() ? "" : " → ", in_print(p, "Pa"));
  return text;
}

json stage_rows(const OedometerStage& s) {
  json rows = json::array();
  if (s.strain)
    rows.push_back({"Axial strain to reach", fmt::format("{:.4g}", *s.strain)});
  else
    rows.push_back({"Axial stresses", path_of(s.path)});
  rows.push_back({"Rate of strain", rate_text(s.strain_rate)});
  rows.push_back({"Damping", fmt::format("{:.4g}", s.damping)});
  return rows;
}

json stage_rows(const TriaxialStage& s) {
  using Path = TriaxialStage::StressPath;
  json rows = json::array();
  if (s.path == Path::constant_volume)
    rows.push_back({"Held", "volume"});
  else
    rows.push_back({s.path == Path::constant_mean ? "Mean stress held" : "Lateral stress held", in_print(s.stress, "Pa")});
  rows.push_back({"Axial strain to reach", fmt::format("{:.4g}", s.strain)});
  rows.push_back({"Rate of strain", rate_text(s.strain_rate)});
  rows.push_back({"Damping", fmt::format("{:.4g}", s.damping)});
  return rows;
}

json stage_rows(const ShearStage& s) {
  return json::array({{"Walls that slide", fmt::format("those of {}, along {}", "xyz"[s.axis], "xyz"[s.direction])},
                      {"Normal stress held", in_print(s.normal_stress, "Pa")},
                      {"Shear strain to reach", fmt::format("{:.4g}", s.strain)},
                      {"Rate", rate_text(s.shear_rate)},
                      {"Damping", fmt::format("{:.4g}", s.damping)}});
}

json stage_rows(const SettleStage& s) {
  return json::array({{"Time at most", in_print(s.time, "s")},
                      {"At rest below an unbalanced force of", fmt::format("{:.4g}", s.unbalanced)},
                      {"Damping", fmt::format("{:.4g}", s.damping)}});
}

json stage_rows(const StrainStage& s) {
  json rows = json::array();
  for (int axis = 0; axis < 3; ++axis)
    rows.push_back({fmt::format("Along {}", "xyz"[axis]), s.stress[to_size(axis)]
                                                              ? in_print(*s.stress[to_size(axis)], "Pa") + " held"
                                                              : fmt::format("{:.4g} 1/s", s.strain_rate[axis])});
  rows.push_back({"Time", in_print(s.time, "s")});
  rows.push_back({"Damping", fmt::format("{:.4g}", s.damping)});
  return rows;
}

json stage_rows(const PermeabilityStage& s) {
  return json::array({{"Fluid enters at", std::string(face_names[to_size(s.inlet)])},
                      {"Pressure drop", in_print(s.pressure_drop, "Pa")},
                      {"Pores", s.merged ? "merged units" : "single tetrahedra"}});
}

json stage_rows(const RetentionStage& s) {
  const InvasionOptions& o = s.invasion;
  json rows = json::array({{"Path of p_c", path_of(s.path)},
                           {"Output step", in_print(s.step, "Pa")},
                           {"Non-wetting fluid enters at", std::string(face_names[to_size(o.nonwetting_face)])},
                           {"Wetting fluid leaves at", std::string(face_names[to_size(o.wetting_face)])},
                           {"Snap-off", yes_no(o.snap_off)},
                           {"Trapping", trapping(o)},
                           {"Corner films connect", yes_no(o.corner_films)},
                           {"Corner water stays", yes_no(o.corner_water)},
                           {"Invasion along walls", yes_no(o.wall_throats)}});
  if (o.cooperative_filling) rows.push_back({"Cooperative filling", fmt::format("yes, seed {}", o.seed)});
  // Conventions of other codes are named where they are in force.
  if (!o.body_entry) rows.push_back({"Bodies resist entry", yes_no(false)});
  if (!o.side_pores) rows.push_back({"Pores at side walls count", yes_no(false)});
  if (o.trap_check == TrapCheck::step) rows.push_back({"Trapping is looked at", "once per step"});
  return rows;
}

json stage_rows(const TwoPhaseStage& s) { return two_phase_rows(s); }
json stage_rows(const SaturatedStage& s) { return saturated_rows(s); }
json stage_rows(const UnsaturatedStage& s) { return unsaturated_rows(s); }

}  // namespace

json case_json(const Case& c) {
  json tables = json::array();
  tables.push_back(
      {{"title", c.network_file ? "Network" : "Grains"}, {"rows", c.network_file ? network_rows(c) : grain_rows(c)}});
  if (std::ranges::any_of(c.stages, puts_fluid) || std::ranges::any_of(c.stages, couples))
    tables.push_back({{"title", "Fluids and pores"}, {"rows", fluid_rows(c)}});
  int number = 0;
  for (const Stage& stage : c.stages) {
    tables.push_back({{"title", fmt::format("Stage {}: {}", ++number, kind_of(stage))},
                      {"rows", std::visit([](const auto& s) { return stage_rows(s); }, stage)}});
  }
  return tables;
}

}  // namespace puadem
