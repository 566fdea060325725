#include "puadem/io/case_summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <type_traits>

#include "puadem/base/parallel.hpp"
#include "puadem/flow/retention_path.hpp"
#include "puadem/geometry/domain.hpp"
#include "puadem/io/grading_statistics.hpp"
#include "puadem/io/initial_state.hpp"
#include "puadem/io/text.hpp"
#include "puadem/io/units.hpp"

namespace puadem {

namespace {

constexpr double pi = std::numbers::pi;
constexpr double loose_porosity = 0.38;  // of a packing whose porosity nothing fixes
constexpr double contacts_per_grain = 6.0;

/// What the estimates start from.
struct Basis {
  int grains = 0;
  GrainStatistics sizes;
  Vec3 box;
  double porosity = loose_porosity;
  bool box_is_estimate = true;
};

double target_porosity(const Case& c) {
  for (const Stage& stage : c.stages)
    if (const auto* compact = std::get_if<CompactStage>(&stage)) return compact->porosity.value_or(loose_porosity);
  return loose_porosity;
}

Basis basis_of(const Case& c, CaseSummary& summary) {
  Basis basis;
  if (c.grains.file) {
    const State state = initial_state(c, summary.warnings);
    basis.grains = state.particles.size();
    basis.sizes = statistics_of(state.particles.radius);
    basis.box = state.domain.size();
    basis.porosity = 1.0 - basis.grains * basis.sizes.mean_volume / state.domain.volume();
    basis.box_is_estimate = false;
    return basis;
  }
  basis.grains = c.grains.count;
  basis.sizes = statistics_of(c.grains.grading);
  basis.porosity = target_porosity(c);
  const double volume = basis.grains * basis.sizes.mean_volume / (1.0 - basis.porosity);
  const Vec3 shape = c.domain.size.value_or(c.domain.shape);
  basis.box = std::cbrt(volume / (shape.x * shape.y * shape.z)) * shape;
  if (c.domain.size) {
    basis.box = *c.domain.size;
    basis.box_is_estimate = false;
  }
  return basis;
}

void add(CaseSummary& summary, std::string_view heading, const std::string& text) {
  summary.text += fmt::format("{:<8}{}\n", heading, text);
}

std::string faces_text(const std::array<bool, 3>& periodic) {
  std::vector<std::string> directions;
  for (int axis = 0; axis < 3; ++axis)
    if (periodic[to_size(axis)]) directions.emplace_back(1, "xyz"[axis]);
  if (directions.empty()) return "six walls";
  return fmt::format("periodic in {}{}", joined(directions, " and "), directions.size() < 3 ? ", walls elsewhere" : "");
}

/// "glass", "70 % glass, 30 % rubber".
std::string materials_text(const Case& c) {
  std::string text;
  for (const GrainOptions::Share& share : c.grains.materials)
    text += fmt::format("{}{:.4g} % {}", text.empty() ? "" : ", ", 100.0 * share.fraction, share.name);
  return text.empty() ? c.grains.material : text;
}

void describe_grains(const Case& c, const Basis& basis, CaseSummary& summary) {
  const GrainStatistics& s = basis.sizes;
  add(summary, "grains",
      fmt::format("{} of {}{}", basis.grains, materials_text(c), c.grains.file ? ", from " + c.grains.file->string() : ""));
  const std::string range = s.smallest == s.largest
                                ? show(2 * s.smallest, "m")
                                : fmt::format("{} to {}", show(2 * s.smallest, "m"), show(2 * s.largest, "m"));
  add(summary, "",
      fmt::format("diameter {}; mean radius by number {}, Sauter radius {}", range, show(s.mean_radius, "m"),
                  show(s.sauter_radius, "m")));
  add(summary, "box",
      fmt::format("{}{} x {} x {}, porosity {}{:.3f}, {}", basis.box_is_estimate ? "about " : "", show(basis.box.x, "m", 3),
                  show(basis.box.y, "m", 3), show(basis.box.z, "m", 3), basis.box_is_estimate ? "about " : "", basis.porosity,
                  faces_text(c.domain.periodic)));
  const double narrowest = std::min({basis.box.x, basis.box.y, basis.box.z});
  if (narrowest < 6.0 * 2.0 * s.largest)
    summary.warnings.push_back(fmt::format("the box is {:.2g} largest diameters wide; walls shape the results below about 10",
                                           narrowest / (2.0 * s.largest)));
}

/// Capillary pressures at which a random packing drains, as multiples of gamma cos(theta) / <r>: from
/// 10 to 50 % air (theory 5.4).
std::pair<double, double> drainage_plateau(const EntryLaw& law) {
  return std::holds_alternative<Haines>(law) ? std::pair{5.5, 7.7} : std::pair{3.5, 5.0};
}

void describe_fluids(const Case& c, const Basis& basis, CaseSummary& summary) {
  const double scale = c.fluids.surface_tension / basis.sizes.mean_radius;
  const auto [low, high] = drainage_plateau(c.pores.entry_law);
  const double cosine = std::cos(c.fluids.contact_angle);
  add(summary, "fluids",
      fmt::format("surface tension {}, contact angle {}, viscosity ratio {:.3g}", show(c.fluids.surface_tension, "N/m"),
                  show(c.fluids.contact_angle, "rad"), c.fluids.nonwetting.viscosity / c.fluids.wetting.viscosity));
  add(summary, "",
      fmt::format("one unit of p_c* is {}; drainage is expected between about {} and {} ({})", show(scale, "Pa"),
                  show(low * cosine * scale, "Pa", 2), show(high * cosine * scale, "Pa", 2),
                  std::visit([](const auto& law) { return law.name; }, c.pores.entry_law)));
  // Gravity is left out: the Bond number says whether that is right.
  const double bond = std::abs(c.fluids.wetting.density - c.fluids.nonwetting.density) * 9.81 * basis.box.z / scale;
  add(summary, "", fmt::format("no gravity; over the height of the box it would be {:.2f} of gamma / <r>", bond));
  if (bond > 1.0)
    summary.warnings.push_back(fmt::format("gravity is left out, but over this box it is {:.2g} of gamma / <r>", bond));
  for (int i = 0; i < size_of(c.stages); ++i)
    if (const auto* retention = std::get_if<RetentionStage>(&c.stages[to_size(i)])) {
      const double top = *std::ranges::max_element(retention->path);
      if (top < low * cosine * scale)
        summary.warnings.push_back(
            fmt::format("stage.{}.path ends at {}, below the pressures at which air is expected to enter (about {})", i,
                        show(top, "Pa"), show(low * cosine * scale, "Pa", 2)));
    }
}

/// Critical time step of a typical grain of the smallest size under the target stress: the mean contact
/// force of a packing, its stiffness by the contact law, and the sums of theory 2.11.
std::string time_step_text(const Case& c, const CompactStage& stage, const Basis& basis) {
  const MaterialPairs pairs = material_pairs(c.materials, c.contact);
  int index = -1;  // of a mixture the one whose waves are fastest
  for (const MaterialShare& share : grain_materials(c)) {
    const auto stiffness = [&](int m) { return c.materials[to_size(m)].youngs_modulus / c.materials[to_size(m)].density; };
    if (index < 0 || stiffness(share.material) > stiffness(index)) index = share.material;
  }
  const PairConstants<double>& pair = pairs.grains[to_size(index * pairs.materials + index)];
  const double radius = basis.sizes.smallest, effective_radius = 0.5 * radius;
  const double force = 4.0 * pi * radius * radius * stage.stress / ((1.0 - basis.porosity) * contacts_per_grain);
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
  const double step = std::sqrt(2.0 / std::max(translation, rotation));
  return fmt::format("critical time step about {}, set by the {} of the smallest grains; overlaps about {:.1g} of a radius",
                     show(step, "s", 2), rotation > translation ? "rotation" : "translation", high / radius);
}

std::string path_text(const RetentionStage& stage, int& equilibria) {
  const auto stops = retention_stops({stage.path, stage.step, 1.0});
  equilibria = size_of(stops);
  std::string text;
  std::string branch;
  for (const RetentionStop& stop : stops)
    if (stop.branch != branch) {
      branch = stop.branch;
      text += (text.empty() ? "" : ", ") + branch;
    }
  std::vector<std::string> points;
  for (const double p : stage.path) points.push_back(show(p, "Pa"));
  return fmt::format("{} ({})", joined(points, " -> "), text);
}

void describe_stages(const Case& c, const Basis& basis, CaseSummary& summary) {
  int equilibria = 0, number = 0;
  for (const Stage& stage : c.stages) {
    ++number;
    if (const auto* compact = std::get_if<CompactStage>(&stage)) {
      const std::string porosity = compact->porosity
                                       ? fmt::format(" and a porosity of {} in the {}", *compact->porosity,
                                                     compact->porosity_region == CompactStage::Region::core ? "core" : "box")
                                       : "; the friction decides the porosity";
      add(summary, fmt::format("stage {}", number), fmt::format("compact to {}{}", show(compact->stress, "Pa"), porosity));
      add(summary, "", time_step_text(c, *compact, basis));
    } else {
      const auto& retention = std::get<RetentionStage>(stage);
      int stops = 0;
      add(summary, fmt::format("stage {}", number), "retention " + path_text(retention, stops));
      add(summary, "",
          fmt::format("air at the {}, water at the {}; {} equilibria", face_names[to_size(retention.invasion.nonwetting_face)],
                      face_names[to_size(retention.invasion.wetting_face)], stops));
      equilibria += stops;
    }
  }
  // Per grain: contacts and neighbours in the packing, then about 6 tetrahedra and 12 facets with their
  // geometry in the network.
  constexpr double bytes_per_grain = 9000.0, bytes_of_fields = 1800.0;
  const double memory = 30e6 + bytes_per_grain * basis.grains;
  add(summary, "memory", fmt::format("about {:.0f} MB", memory / 1e6));
  const int frames = c.output.fields ? (equilibria + c.output.fields_every - 1) / c.output.fields_every : 0;
  add(summary, "output",
      fmt::format("{} equilibria, {} sets of fields, about {:.0f} MB on disk", equilibria, frames,
                  1.0 + frames * bytes_of_fields * basis.grains / 1e6));
}

}  // namespace

CaseSummary summarise_case(const Case& c) {
  CaseSummary summary;
  const Basis basis = basis_of(c, summary);
  add(summary, "case", fmt::format("{} (seed {})", c.title, c.seed));
  describe_grains(c, basis, summary);
  describe_fluids(c, basis, summary);
  describe_stages(c, basis, summary);
  return summary;
}

}  // namespace puadem
