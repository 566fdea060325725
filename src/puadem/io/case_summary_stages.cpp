#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "puadem/base/error.hpp"
#include "puadem/coupling/loading_program.hpp"
#include "puadem/flow/retention_path.hpp"
#include "puadem/geometry/domain.hpp"
#include "puadem/io/case_summary_basis.hpp"
#include "puadem/io/progress_line.hpp"
#include "puadem/io/text.hpp"
#include "puadem/io/units.hpp"

namespace puadem {

namespace {

constexpr double pi = std::numbers::pi;
constexpr double contacts_per_grain = 6.0;
constexpr double grain_steps_per_second = 5e6;  // on one core, roughly

void add_stage(CaseSummary& summary, int number, const std::string& text) {
  add_line(summary, fmt::format("stage {}", number), text);
}

/// A grain of the smallest size in a packing under a stress.
struct StepEstimate {
  double critical = 0.0;  ///< [s]
  double overlap = 0.0;   ///< as a share of the radius [-]
  bool rotation = false;  ///< binds
};

/// The material of the grains whose waves are fastest.
int fastest_material(const Case& c) {
  int fastest = -1;
  const auto stiffness = [&](int m) { return c.materials[to_size(m)].youngs_modulus / c.materials[to_size(m)].density; };
  for (const MaterialShare& share : grain_materials(c))
    if (fastest < 0 || stiffness(share.material) > stiffness(fastest)) fastest = share.material;
  return fastest;
}

/// Mean contact force of a packing, its stiffness by the contact law, and the sums of theory 2.11.
StepEstimate estimate_step(const Case& c, double stress, const SummaryBasis& basis) {
  const MaterialPairs pairs = material_pairs(c.materials, c.contact);
  const int index = fastest_material(c);
  const PairConstants<double>& pair = pairs.grains[to_size(index * pairs.materials + index)];
  const double radius = basis.sizes.smallest, effective_radius = 0.5 * radius;
  const double force = 4.0 * pi * radius * radius * stress / ((1.0 - basis.porosity) * contacts_per_grain);
  const auto respond = [&](double overlap) {
    return std::visit([&](const auto& law) { return law.respond(pair, overlap, effective_radius, 0.5); },
                      contact_law(c.contact.law));
  };
  // The force grows with the overlap: halve the interval.
  double low = 0.0, high = radius;
  for (int k = 0; k < 100; ++k) {
    const double middle = 0.5 * (low + high);
    (respond(middle).force < force ? low : high) = middle;
  }
  const auto stiffness = respond(high);
  const double mass = c.materials[to_size(index)].density * 4.0 / 3.0 * pi * radius * radius * radius;
  const double translation = contacts_per_grain / 3.0 * (stiffness.normal + 2.0 * stiffness.shear) / mass;
  const double rotation = contacts_per_grain * 2.0 / 3.0 * stiffness.shear / (0.4 * mass);
  return {std::sqrt(2.0 / std::max(translation, rotation)), high / radius, rotation > translation};
}

std::string step_text(const StepEstimate& step) {
  return fmt::format("critical time step about {}, set by the {} of the smallest grains; overlaps about {:.1g} of a radius",
                     show(step.critical, "s", 2), step.rotation ? "rotation" : "translation", step.overlap);
}

std::string points_text(const std::vector<double>& path) {
  std::vector<std::string> points;
  for (const double p : path) points.push_back(show(p, "Pa"));
  return joined(points, " -> ");
}

std::string path_text(const RetentionStage& stage, int& equilibria) {
  const auto stops = retention_stops({stage.path, {stage.step}, 1.0});
  equilibria = size_of(stops);
  std::string text;
  std::string branch;
  for (const RetentionStop& stop : stops)
    if (stop.branch != branch) {
      branch = stop.branch;
      text += (text.empty() ? "" : ", ") + branch;
    }
  return fmt::format("{} ({})", points_text(stage.path), text);
}

/// What goes on from stage to stage.
struct Walk {
  const Case& c;
  const SummaryBasis& basis;
  CaseSummary& summary;
  LoadingScale scale;
  int number = 0;
  int equilibria = 0, histories = 0, flows = 0;
};

void describe(const CompactStage& stage, Walk& w) {
  const std::string state = stage.porosity ? fmt::format(" and a porosity of {} in the {}", *stage.porosity,
                                                         stage.porosity_region == CompactStage::Region::core ? "core" : "box")
                            : stage.friction_angle
                                ? fmt::format(" at a friction of {} while compacting", show(*stage.friction_angle, "rad"))
                                : "; the friction decides the porosity";
  add_stage(w.summary, w.number, fmt::format("compact to {}{}", show(stage.stress, "Pa"), state));
  add_line(w.summary, "", step_text(estimate_step(w.c, stage.stress, w.basis)));
  w.scale.stress = stage.stress * Vec3{1, 1, 1};
}

void describe(const PermeabilityStage& stage, Walk& w) {
  add_stage(
      w.summary, w.number,
      fmt::format("permeability along x, y and z; fluid of {} driven from the {} by {}",
                  show(w.c.fluids.wetting.viscosity, "Pa s"), face_names[to_size(stage.inlet)], show(stage.pressure_drop, "Pa")));
  ++w.flows;
}

void describe(const RetentionStage& stage, Walk& w) {
  int stops = 0;
  add_stage(w.summary, w.number, "retention " + path_text(stage, stops));
  add_line(w.summary, "",
           fmt::format("air at the {}, water at the {}; {} equilibria", face_names[to_size(stage.invasion.nonwetting_face)],
                       face_names[to_size(stage.invasion.wetting_face)], stops));
  w.equilibria += stops;
}

std::string driven_text(const TwoPhaseStage& s) {
  if (!s.path.empty())
    return fmt::format("capillary pressures {}, each {}", points_text(s.path),
                       s.hold ? "for " + show(*s.hold, "s") : "until the fluids rest");
  if (s.withdrawal) return fmt::format("{:.3g} m3/s of water drawn off", *s.withdrawal);
  if (s.capillary_number) return fmt::format("water drawn off at Ca = {:.3g}", *s.capillary_number);
  return "water at " + points_text(s.water_pressure);
}

void describe(const TwoPhaseStage& stage, Walk& w) {
  std::vector<std::string> water;
  for (int face = 0; face < 6; ++face)
    if (stage.water[to_size(face)]) water.emplace_back(face_names[to_size(face)]);
  add_stage(w.summary, w.number, "two-phase-flow, " + driven_text(stage));
  add_line(w.summary, "",
           fmt::format("air at the {}, water at the {}{}",
                       stage.air == TwoPhaseStage::disc ? "disc in the middle" : face_names[to_size(stage.air)], joined(water),
                       stage.duration ? fmt::format("; {} at most", show(*stage.duration, "s")) : ""));
  w.equilibria += 1 + size_of(w.c.output.fields_at.saturation);
}

void describe(const SaturatedStage& stage, Walk& w) {
  std::string text = stage.time_factor ? fmt::format("to a time factor of {}", *stage.time_factor)
                                       : "for " + show(stage.duration.value_or(0.0), "s");
  if (stage.loaded)
    text += fmt::format(", {} on the {}", show(stage.stress.value_or(0.0), "Pa"), face_names[to_size(*stage.loaded)]);
  if (stage.inlet) text += fmt::format(", {} at the {}", points_text(stage.inlet_pressure), face_names[to_size(*stage.inlet)]);
  add_stage(w.summary, w.number, fmt::format("{} {}", SaturatedStage::kind, text));
  ++w.histories;
  if (stage.stress) w.scale.stress[axis_of(*stage.loaded)] = *stage.stress;
}

void describe(const UnsaturatedStage& stage, Walk& w) {
  const bool moves = !stage.times.empty();
  const auto stops = stage.path.empty() || moves ? std::vector<RetentionStop>{} : retention_stops({stage.path, stage.step, 1.0});
  std::string text = points_text(stage.path);
  if (moves) text += fmt::format(" in {}", show(stage.times.back(), "s"));
  if (stage.stress) text += fmt::format(", {} on the loaded walls", show(*stage.stress, "Pa"));
  if (stage.strain) text += fmt::format(", then to a strain of {} along z", *stage.strain);
  if (!moves) text += fmt::format(", {} equilibria", stops.size());
  if (stage.start == UnsaturatedStage::Start::dry) text += ", from dry";
  add_stage(w.summary, w.number, fmt::format("{} {}", UnsaturatedStage::kind, text));
  w.equilibria += size_of(stops);
  if (moves) ++w.histories;
  if (!stage.stress) return;
  for (int face = 0; face < 6; ++face)
    if (stage.loaded[to_size(face)]) w.scale.stress[axis_of(face)] = *stage.stress;
}

std::string held_text(const IsotropicStage& s) { return fmt::format("to {} on all axes, until at rest", show(s.stress, "Pa")); }
std::string held_text(const OedometerStage& s) {
  return s.strain ? fmt::format("to an axial strain of {}", *s.strain) : "to an axial stress of " + points_text(s.path);
}
std::string held_text(const TriaxialStage& s) {
  const std::string held =
      s.path == TriaxialStage::StressPath::constant_volume
          ? "volume held"
          : fmt::format("{} of {} held", s.path == TriaxialStage::StressPath::constant_mean ? "mean stress" : "lateral stress",
                        show(s.stress, "Pa"));
  return fmt::format("to an axial strain of {}, {}", s.strain, held);
}
std::string held_text(const ShearStage& s) {
  return fmt::format("walls of {} along {} to a shear strain of {} under {}", "xyz"[s.axis], "xyz"[s.direction], s.strain,
                     show(s.normal_stress, "Pa"));
}
std::string held_text(const SettleStage& s) { return fmt::format("under gravity until at rest, {} at most", show(s.time, "s")); }
std::string held_text(const StrainStage& s) {
  std::string text = "for " + show(s.time, "s");
  for (int axis = 0; axis < 3; ++axis)
    text += s.stress[to_size(axis)] ? fmt::format(", {} at {}", "xyz"[axis], show(*s.stress[to_size(axis)], "Pa"))
                                    : fmt::format(", {} at {:.3g} 1/s", "xyz"[axis], s.strain_rate[axis]);
  return text;
}

/// Time that the program takes, as far as it is known beforehand [s].
std::optional<double> duration_of(const LoadingProgram& program) {
  double time = 0.0;
  for (const LoadingLeg& leg : program.legs) {
    if (leg.end == LoadingLeg::End::axial_stress || leg.target == 0.0) return std::nullopt;
    time += leg.end == LoadingLeg::End::strain || leg.end == LoadingLeg::End::shear_strain
                ? std::abs(leg.target) / program.strain_rate
                : leg.target;
  }
  return time;
}

template <class S>
requires is_loading<S>
void describe(const S& stage, Walk& w) {
  add_stage(w.summary, w.number, fmt::format("{} {}", S::kind, held_text(stage)));
  ++w.histories;
  const LoadingProgram program = loading_program(stage, w.c, w.scale);
  const double step = w.c.motion.safety * estimate_step(w.c, program.pressure, w.basis).critical;
  std::string text;
  if (program.inertial_number > 0.0)
    text = fmt::format("rate {:.3g} 1/s, inertial number {:.2g}", program.strain_rate, program.inertial_number);
  if (const auto time = duration_of(program))
    text += fmt::format("{}{} in about {:.2g} steps of {}, about {} on one core", text.empty() ? "" : "; ", show(*time, "s", 3),
                        *time / step, show(step, "s", 2), show_duration(*time / step * w.basis.grains / grain_steps_per_second));
  if (!text.empty()) add_line(w.summary, "", text);
  if (program.inertial_number > quasi_static_inertial_number)
    w.summary.warnings.push_back(fmt::format("stage {}: {}", w.number, inertia_warning(program)));
  for (int axis = 0; axis < 3; ++axis)
    if (const auto stress = program.legs.back().box.stress[to_size(axis)]) w.scale.stress[axis] = *stress;
}

}  // namespace

void describe_stages(const Case& c, const SummaryBasis& basis, CaseSummary& summary) {
  Walk w{c, basis, summary, {}};
  if (!c.network_file) {
    const Material& material = c.materials[to_size(fastest_material(c))];
    w.scale.diameter = 2.0 * basis.sizes.mean_radius;
    // Rumpf's estimate with the force of a small bridge in contact, 2 pi gamma r cos(theta).
    if (c.bridges)
      w.scale.bridge_stress = (1.0 - basis.porosity) * contacts_per_grain * c.fluids.surface_tension *
                              std::cos(c.fluids.contact_angle) / (2.0 * basis.sizes.mean_radius);
    w.scale.density = material.density;
    w.scale.youngs_modulus = material.youngs_modulus;
    w.scale.size = basis.box;
  }
  for (const Stage& stage : c.stages) {
    ++w.number;
    std::visit([&](const auto& s) { describe(s, w); }, stage);
  }
  // Per grain: contacts and neighbours in the packing, then about 6 tetrahedra and 12 facets with their
  // geometry in the network.
  const double bytes_per_grain = w.flows > 0 ? 25000.0 : w.equilibria > 0 ? 9000.0 : 2000.0;
  constexpr double bytes_of_fields = 1800.0, bytes_of_grains = 450.0;
  add_line(summary, "memory", fmt::format("about {:.0f} MB", (30e6 + bytes_per_grain * basis.grains) / 1e6));
  const int frames = c.output.fields ? (w.equilibria + c.output.fields_every - 1) / c.output.fields_every : 0;
  const int grain_frames = c.output.fields && w.histories > 0 ? w.histories * (c.output.fields_count + 1) : 0;
  std::string text;
  if (w.equilibria > 0) text += fmt::format("{} equilibria, ", w.equilibria);
  if (w.histories > 0) text += fmt::format("about {} rows of history, ", w.histories * c.output.history_rows);
  add_line(summary, "output",
           fmt::format("{}{} sets of fields, about {:.0f} MB on disk", text, frames + grain_frames,
                       1.0 + (frames * bytes_of_fields + grain_frames * bytes_of_grains) * basis.grains / 1e6));
}

}  // namespace puadem
