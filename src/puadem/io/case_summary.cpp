#include "puadem/io/case_summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "puadem/base/parallel.hpp"
#include "puadem/geometry/domain.hpp"
#include "puadem/io/case_summary_basis.hpp"
#include "puadem/io/initial_state.hpp"
#include "puadem/io/network_file.hpp"
#include "puadem/io/text.hpp"
#include "puadem/io/units.hpp"

namespace puadem {

namespace {

double target_porosity(const Case& c) {
  for (const Stage& stage : c.stages)
    if (const auto* compact = std::get_if<CompactStage>(&stage)) return compact->porosity.value_or(loose_porosity);
  return loose_porosity;
}

SummaryBasis basis_of(const Case& c, CaseSummary& summary) {
  SummaryBasis basis;
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
  if (text.empty()) text = c.grains.material;
  for (const GrainOptions::Added& added : c.grains.added)
    text += fmt::format(" and {} of {}, {}", added.count, added.material, show(added.diameter, "m"));
  return text;
}

void describe_grains(const Case& c, const SummaryBasis& basis, CaseSummary& summary) {
  const GrainStatistics& s = basis.sizes;
  add_line(summary, "grains",
           fmt::format("{} of {}{}", basis.grains, materials_text(c), c.grains.file ? ", from " + c.grains.file->string() : ""));
  const std::string range = s.smallest == s.largest
                                ? show(2 * s.smallest, "m")
                                : fmt::format("{} to {}", show(2 * s.smallest, "m"), show(2 * s.largest, "m"));
  add_line(summary, "",
           fmt::format("diameter {}; mean radius by number {}, Sauter radius {}", range, show(s.mean_radius, "m"),
                       show(s.sauter_radius, "m")));
  add_line(summary, "box",
           fmt::format("{}{} x {} x {}, porosity {}{:.3f}, {}", basis.box_is_estimate ? "about " : "", show(basis.box.x, "m", 3),
                       show(basis.box.y, "m", 3), show(basis.box.z, "m", 3), basis.box_is_estimate ? "about " : "",
                       basis.porosity, faces_text(c.domain.periodic)));
  std::array<double, 3> sides{basis.box.x, basis.box.y, basis.box.z};
  std::ranges::sort(sides);
  // A thin bed is meant to be thin: there the next side counts.
  const double narrowest = sides[0] < 0.5 * sides[1] ? sides[1] : sides[0];
  constexpr int fewest = 50;  // grains that make a packing
  if (basis.grains >= fewest && narrowest < 6.0 * 2.0 * s.largest)
    summary.warnings.push_back(fmt::format("the box is {:.2g} largest diameters wide; walls shape the results below about 10",
                                           narrowest / (2.0 * s.largest)));
}

/// Capillary pressures at which a random packing drains, as multiples of gamma cos(theta) / <r>: from
/// 10 to 50 % air (theory 5.4).
std::pair<double, double> drainage_plateau(const EntryLaw& law) {
  return std::holds_alternative<Haines>(law) ? std::pair{5.5, 7.7} : std::pair{3.5, 5.0};
}

void describe_fluids(const Case& c, const SummaryBasis& basis, CaseSummary& summary) {
  const double scale = c.fluids.surface_tension / basis.sizes.mean_radius;
  const auto [low, high] = drainage_plateau(c.pores.entry_law);
  const double cosine = std::cos(c.fluids.contact_angle);
  add_line(summary, "fluids",
           fmt::format("surface tension {}, contact angle {}, viscosity ratio {:.3g}", show(c.fluids.surface_tension, "N/m"),
                       show(c.fluids.contact_angle, "rad"), c.fluids.nonwetting.viscosity / c.fluids.wetting.viscosity));
  add_line(summary, "",
           fmt::format("one unit of p_c* is {}; drainage is expected between about {} and {} ({})", show(scale, "Pa"),
                       show(low * cosine * scale, "Pa", 2), show(high * cosine * scale, "Pa", 2),
                       std::visit([](const auto& law) { return law.name; }, c.pores.entry_law)));
  // Gravity is left out: the Bond number says whether that is right.
  const double bond = std::abs(c.fluids.wetting.density - c.fluids.nonwetting.density) * 9.81 * basis.box.z / scale;
  add_line(summary, "", fmt::format("no gravity; over the height of the box it would be {:.2f} of gamma / <r>", bond));
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

CaseSummary summarise_network_case(const Case& c) {
  CaseSummary summary;
  const State state = initial_state(c, summary.warnings);
  const Vec3 size = state.domain.size();
  add_line(summary, "case", c.title);
  add_line(
      summary, "network",
      fmt::format("{} pores, {} throats, from {}", state.network.pores(), state.network.throats(), c.network_file->string()));
  add_line(summary, "box",
           fmt::format("{} x {} x {}; pores at the faces {}", show(size.x, "m", 3), show(size.y, "m", 3), show(size.z, "m", 3),
                       faces_with_pores(state.network)));
  SummaryBasis basis;
  basis.grains = state.network.pores() / 4;  // of a packing with as many pores
  basis.box = size;
  describe_stages(c, basis, summary);
  return summary;
}

}  // namespace

void add_line(CaseSummary& summary, std::string_view heading, const std::string& text) {
  summary.text += fmt::format("{:<8}{}\n", heading, text);
}

CaseSummary summarise_case(const Case& c) {
  if (c.network_file) return summarise_network_case(c);
  CaseSummary summary;
  const SummaryBasis basis = basis_of(c, summary);
  add_line(summary, "case", fmt::format("{} (seed {})", c.title, c.seed));
  describe_grains(c, basis, summary);
  const bool has_fluids = std::ranges::any_of(c.stages, [](const Stage& s) {
    return std::holds_alternative<RetentionStage>(s) || std::holds_alternative<TwoPhaseStage>(s);
  });
  if (has_fluids) describe_fluids(c, basis, summary);
  describe_stages(c, basis, summary);
  return summary;
}

}  // namespace puadem
