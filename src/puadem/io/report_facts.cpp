#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "puadem/io/report_data.hpp"
#include "puadem/io/report_two_phase.hpp"
#include "puadem/io/units.hpp"

namespace puadem {
namespace {

using nlohmann::json;

/// 12345 -> "12 345", with the narrow space that no line breaks at; four digits stay together.
std::string count(long value) {
  std::string digits = std::to_string(value);
  if (digits.size() < 5) return digits;
  for (auto at = static_cast<std::ptrdiff_t>(digits.size()) - 3; at > 0; at -= 3)
    digits.insert(static_cast<std::size_t>(at), "\u202f");
  return digits;
}

std::string number(double value) { return fmt::format("{:.4g}", value); }
std::string percent(double share) { return fmt::format("{:.1f} %", 100.0 * share); }

/// "mean_stress_Pa" -> 10000.0 -> "10 kPa": results carry their unit at the end of their name.
std::string scalar_text(const std::string& name, double value) {
  constexpr std::array<std::array<const char*, 2>, 7> units{
      {{"_Pa", "Pa"}, {"_m3", "m3"}, {"_m2", "m2"}, {"_m", "m"}, {"_m_s", "m/s"}, {"_s", "s"}, {"_N", "N"}}};
  for (const auto& [suffix, unit] : units)
    if (name.ends_with(suffix)) return in_print(value, unit);
  return value == std::floor(value) && std::abs(value) < 1e9 ? count(static_cast<long>(value)) : fmt::format("{:.5g}", value);
}

double median(std::vector<double> values) {
  if (values.empty()) return std::nan("");
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

double grain_volume(const Particles& p) {
  double volume = 0.0;
  for (const double r : p.radius) volume += 4.0 / 3.0 * std::numbers::pi * r * r * r;
  return volume;
}

/// "12 × 12 × 24 mm": one unit for the three.
std::string lengths(const Vec3& v) {
  const double largest = std::max({v.x, v.y, v.z});
  const auto [scale, unit] = largest < 1e-3 ? std::pair{1e6, "µm"} : largest < 1.0 ? std::pair{1e3, "mm"} : std::pair{1.0, "m"};
  return fmt::format("{:.4g} × {:.4g} × {:.4g} {}", v.x * scale, v.y * scale, v.z * scale, unit);
}

json packing_rows(const State& state) {
  const Particles& p = state.particles;
  const auto [smallest, largest] = std::ranges::minmax(p.radius);
  std::string periodic;
  for (int axis = 0; axis < 3; ++axis)
    if (state.domain.periodic[to_size(axis)]) periodic += fmt::format("{}{}", periodic.empty() ? "" : ", ", "xyz"[axis]);
  json rows =
      json::array({{"Grains", count(p.size())},
                   {"Box", lengths(state.domain.size())},
                   {"Periodic directions", periodic.empty() ? "none (six walls)" : periodic},
                   {"Grain diameters", fmt::format("{} to {}", in_print(2 * smallest, "m", 3), in_print(2 * largest, "m", 3))},
                   {"Mean grain radius ⟨r⟩, by number", in_print(mean_radius(p), "m")},
                   {"Porosity of the whole box", number(1.0 - grain_volume(p) / state.domain.volume())}});
  return rows;
}

std::string entry_kinds(const PoreNetwork& n) {
  constexpr std::array names{"corner menisci", "wide edge", "half gap", "inscribed circle", "closed"};
  std::array<long, names.size()> found{};
  for (const EntryKind kind : n.throat_entry_kind) ++found[static_cast<std::size_t>(kind)];
  std::string text;
  for (std::size_t k = 0; k < names.size(); ++k)
    if (found[k] > 0)
      text += fmt::format("{}{} {}", text.empty() ? "" : ", ", names[k],
                          percent(static_cast<double>(found[k]) / static_cast<double>(n.throat_entry_kind.size())));
  return text;
}

json network_rows(const State& state) {
  const PoreNetwork& n = state.network;
  json rows =
      json::array({{state.particles.size() > 0 ? "Pore units" : "Pores", count(n.pores())}, {"Throats", count(n.throats())}});
  if (n.windows > 0) rows.push_back({"Windows of several facets", count(n.windows)});
  if (n.triangulation.cells() > 0)
    rows.push_back({"Tetrahedra", fmt::format("{}, {:.2f} per pore unit", count(n.triangulation.cells()),
                                              static_cast<double>(n.triangulation.cells()) / n.pores())});
  rows.push_back({"Throats per pore unit", fmt::format("{:.2f}", 2.0 * n.throats() / n.pores())});
  rows.push_back({"Median pore radius R_i", in_print(median(n.pore_radius), "m")});
  rows.push_back({"Median throat radius R_ij", in_print(median(n.throat_radius), "m")});
  if (n.triangulation.cells() == 0) rows.push_back({"Box", lengths(state.domain.size())});
  const auto at_wall = std::ranges::count(n.throat_at_wall, std::uint8_t{1});
  if (!n.throat_at_wall.empty() && n.throats() > 0)
    rows.push_back({"Throats along walls", percent(static_cast<double>(at_wall) / n.throats())});
  if (n.triangulation.cells() > 0) rows.push_back({"Entry pressure decided by", entry_kinds(n)});
  return rows;
}

json highlight(const std::string& label, const std::string& value, const std::string& note) {
  return {{"label", label}, {"value", value}, {"note", note}};
}

/// Peak and end of the last stage that sheared the grains.
std::vector<json> loading_highlights(const std::vector<HistoryRow>& history) {
  if (history.empty()) return {};
  const std::string& stage = history.back().stage;
  std::vector<HistoryRow> rows;
  std::ranges::copy_if(history, std::back_inserter(rows), [&](const auto& r) { return r.stage == stage; });
  const HistoryRow& last = rows.back();
  const std::string volume = fmt::format("{:.2f} % volumetric", 100.0 * last.volumetric);
  if (stage.starts_with("triaxial")) {
    const auto peak = std::ranges::max_element(rows, {}, [](const auto& r) { return std::abs(r.stress_ratio()); });
    return {highlight("Peak q/p", fmt::format("{:.3f}", peak->stress_ratio()),
                      fmt::format("q = {} at {:.1f} % axial strain", in_print(peak->deviator, "Pa", 3), 100.0 * peak->strain.z)),
            highlight("q/p at the end", fmt::format("{:.3f}", last.stress_ratio()),
                      fmt::format("at {:.1f} % axial strain, {}", 100.0 * last.strain.z, volume))};
  }
  if (stage.starts_with("oedometer"))
    return {highlight("Axial stress at the end", in_print(last.stress.z, "Pa", 3),
                      fmt::format("at {:.2f} % axial strain", 100.0 * last.strain.z))};
  if (stage.starts_with("shear"))
    return {highlight("Shear stress at the end", in_print(last.shear_stress, "Pa", 3),
                      fmt::format("at a shear strain of {:.3g}, {}", last.shear_strain, volume))};
  return {};
}

}  // namespace

json facts_json(const State& state) {
  json facts = json::array();
  if (state.particles.size() > 0) facts.push_back({{"title", "Packing"}, {"rows", packing_rows(state)}});
  if (state.network.pores() > 0) facts.push_back({{"title", "Pore network"}, {"rows", network_rows(state)}});
  return facts;
}

std::string in_print(double value, std::string_view unit, int digits) {
  std::string text = show(value, unit, digits);
  const auto replace_end = [&](std::string_view from, std::string_view to) {
    if (text.ends_with(from)) text.replace(text.size() - from.size(), from.size(), to);
  };
  replace_end(" um", " µm");
  replace_end(" deg", "°");
  replace_end(" m2", " m²");
  return text;
}

json scalars_json(const RunResults* results) {
  json rows = json::array();
  if (results)
    for (const auto& [name, value] : results->scalars) rows.push_back({name, scalar_text(name, value)});
  return rows;
}

json highlights_json(const State& state, const RunResults* results) {
  json top = json::array();
  const Particles& p = state.particles;
  if (p.size() > 0) top.push_back(highlight("Grains", count(p.size()), "in " + lengths(state.domain.size())));
  const double box_porosity = 1.0 - grain_volume(p) / state.domain.volume();
  if (results && results->scalars.contains("porosity_core"))
    top.push_back(highlight("Porosity of the core", fmt::format("{:.4f}", results->scalars.at("porosity_core")),
                            fmt::format("{:.4f} in the whole box", box_porosity)));
  else if (p.size() > 0)
    top.push_back(highlight("Porosity", fmt::format("{:.4f}", box_porosity), "whole box"));
  for (const auto& stage_highlight : loading_highlights(state.history)) top.push_back(stage_highlight);
  if (!state.permeability.empty()) {
    const PermeabilityResult& r = state.permeability.back();
    const auto reference = r.kozeny_carman();
    top.push_back(
        highlight("Permeability", fmt::format("{:.3g} m²", r.permeability.mean()),
                  reference ? fmt::format("{:.2f} of Kozeny–Carman", r.permeability.mean() / *reference) : "mean of its axes"));
  }
  if (state.network.pores() > 0)
    top.push_back(highlight(state.particles.size() > 0 ? "Pore units" : "Pores", count(state.network.pores()),
                            count(state.network.throats()) + " throats"));
  for (const auto& flow_highlight : two_phase_highlights(state, results)) top.push_back(flow_highlight);
  std::vector<RetentionRow> drainage;
  std::ranges::copy_if(state.retention, std::back_inserter(drainage), [](const auto& r) { return r.branch == "drainage-1"; });
  if (const auto half = capillary_pressure_at(drainage, 0.5)) {
    const double star = drainage.back().pc_star / drainage.back().capillary_pressure * *half;
    top.push_back(highlight("p_c at S = 0.5, drainage", count(std::lround(*half)) + " Pa",
                            star > 0.0 ? fmt::format("p_c⟨r⟩/γ = {:.2f}", star) : "of a network from a file"));
  }
  const auto last = std::find_if(state.retention.rbegin(), state.retention.rend(),
                                 [](const auto& row) { return row.branch == "imbibition-1"; });
  if (last != state.retention.rend())
    top.push_back(highlight("Trapped after imbibition", percent(last->trapped_nonwetting), "non-wetting fluid, of the void"));
  return top;
}

}  // namespace puadem
