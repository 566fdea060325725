#include "puadem/io/report_unsaturated.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "puadem/coupling/pore_space.hpp"
#include "puadem/coupling/unsaturated_results.hpp"
#include "puadem/geometry/domain.hpp"
#include "puadem/io/report_column.hpp"
#include "puadem/io/report_data.hpp"
#include "puadem/io/text.hpp"

namespace puadem {
namespace {

using nlohmann::json;
using Row = UnsaturatedRow;

json fit_json(std::span<const Row> branch) {
  const auto fit = fit_chi(branch, &Row::chi_contact);
  if (!fit) return nullptr;
  return {{"slope", fit->slope}, {"offset", fit->offset}, {"residual", fit->residual}, {"from_saturation", fit->from_saturation}};
}

json regimes_json(std::span<const Row> branch) {
  const auto regimes = branch.front().branch.starts_with("drainage") ? drainage_regimes(branch) : std::nullopt;
  if (!regimes) return nullptr;
  return {{"air_entry", regimes->air_entry}, {"pendular", regimes->pendular}};
}

/// Mean of the stresses along the axes.
json mean_column(std::span<const Row> branch, Vec3 Row::*stress) {
  return column(branch, [=](const Row& r) { return ((r.*stress).x + (r.*stress).y + (r.*stress).z) / 3.0; });
}

json branch_json(std::span<const Row> branch) {
  return {{"name", branch.front().branch},
          {"fit", fit_json(branch)},
          {"regimes", regimes_json(branch)},
          {"pc", column(branch, &Row::capillary_pressure)},
          {"pc_star", column(branch, &Row::pc_star)},
          {"saturation", column(branch, &Row::saturation)},
          {"strain", column(branch, &Row::strain)},
          {"volume_strain", column(branch, &Row::volume_strain)},
          {"chi_contact", column(branch, &Row::chi_contact)},
          {"chi_fluid", column(branch, &Row::chi_fluid)},
          {"deviator", column(branch, contact_deviator)},
          {"contact_mean", mean_column(branch, &Row::contact_stress)},
          {"force_ratio", column(branch, &Row::mean_force_ratio)},
          {"contact_anisotropy", column(branch, &Row::contact_anisotropy)},
          {"capillary_anisotropy", column(branch, &Row::capillary_anisotropy)},
          {"pressure_force", column(branch, &Row::pressure_force)},
          {"tension_force", column(branch, &Row::tension_force)},
          {"capillary_force", column(branch, &Row::capillary_force)},
          {"porosity", column(branch, &Row::porosity)},
          {"stress_fluids", mean_column(branch, &Row::fluid_stress)},
          {"stress_bridges", mean_column(branch, &Row::bridge_stress)},
          {"bridges", column(branch, &Row::bridges)},
          {"bridge_force", column(branch, &Row::bridge_force)},
          {"bridge_saturation", column(branch, &Row::bridge_saturation)}};
}

json pictures_json(const ResultsFolder& folder, const std::string& stage) {
  json pictures = json::array();
  for (const UnsaturatedPicture& p : folder.unsaturated_pictures)
    if (p.stage == stage)
      pictures.push_back({{"row", p.row},
                          {"saturation", p.saturation},
                          {"pc_star", p.pc_star},
                          {"axis", std::string(1, "xyz"[p.axis])},
                          {"columns", p.columns},
                          {"rows", p.rows},
                          {"pixel", p.pixel},
                          {"picture", p.bytes},
                          {"across", column(p.grains, &CutGrain::across)},
                          {"up", column(p.grains, &CutGrain::up)},
                          {"force_across", column(p.grains, &CutGrain::force_across)},
                          {"force_up", column(p.grains, &CutGrain::force_up)},
                          {"radius", column(p.grains, &CutGrain::radius)},
                          {"moved_across", column(p.grains, &CutGrain::moved_across)},
                          {"moved_up", column(p.grains, &CutGrain::moved_up)}});
  return pictures;
}

/// Spreads at the start, in the middle and at the end of the first branch.
json spreads_json(const UnsaturatedRecord& record, std::size_t end) {
  json spreads = json::array();
  std::vector<std::size_t> chosen{0};
  for (const double s : {0.5, record.rows.front().saturation > 0.5 ? 0.0 : 1.0}) {
    std::size_t best = chosen.back();
    for (std::size_t k = 0; k < end; ++k)
      if (std::abs(record.rows[k].saturation - s) < std::abs(record.rows[best].saturation - s)) best = k;
    if (best != chosen.back()) chosen.push_back(best);
  }
  for (const std::size_t k : chosen)
    spreads.push_back({{"saturation", record.rows[k].saturation},
                       {"contact", record.spreads[k].contact},
                       {"capillary", record.spreads[k].capillary}});
  return spreads;
}

json sizes_json(const UnsaturatedRecord& record, const PoreSizes& sizes, int per_unit) {
  json parts = json::array();
  for (int k = 0; k < sizes.parts; ++k) {
    const NormalPart& p = sizes.part[to_size(k)];
    parts.push_back({{"weight", p.weight}, {"mean", p.mean}, {"deviation", p.deviation}});
  }
  const auto begin = record.pore_density.begin() + sizes.density_begin;
  return {{"samples", sizes.samples},
          {"mean", sizes.mean},
          {"deviation", sizes.deviation},
          {"parts", std::move(parts)},
          {"first", sizes.first_class},
          {"per_unit", per_unit},
          {"density", std::vector<double>(begin, begin + sizes.classes)}};
}

json local_json(const UnsaturatedRecord& record, int row) {
  const LocalChange change = local_change(record, row);
  return {{"saturation", change.saturation},
          {"porosity_change", change.porosity_change},
          {"wet", json_of(change.wet)},
          {"dry", json_of(change.dry)},
          {"correlation", json_of(change.correlation)}};
}

/// Sizes at telling rows; blocks at those and at the rows that have pictures.
json pore_space_json(const ResultsFolder& folder, const UnsaturatedRecord& record) {
  json sizes = json::array(), blocks = json::object();
  const auto [pores, throats, units] = pore_space_classes;
  for (const int row : telling_rows(record)) {
    const PoreSpaceRow& p = record.pore_space[to_size(row)];
    sizes.push_back({{"row", row},
                     {"saturation", record.rows[to_size(row)].saturation},
                     {"pc", record.rows[to_size(row)].capillary_pressure},
                     {"pore_radius", sizes_json(record, p.pore_radius, pores)},
                     {"throat_radius", sizes_json(record, p.throat_radius, throats)},
                     {"porosity", sizes_json(record, p.porosity, units)}});
    blocks[std::to_string(row)] = local_json(record, row);
  }
  for (const UnsaturatedPicture& p : folder.unsaturated_pictures)
    if (p.stage == record.stage) blocks[std::to_string(p.row)] = local_json(record, p.row);
  return {{"counts", record.blocks}, {"rows", std::move(sizes)}, {"blocks", std::move(blocks)}};
}

/// Swelling grains in time.
json swelling_json(const UnsaturatedRecord& record) {
  using Swelling = SwellingRow;
  std::vector<Row> rows;
  std::vector<Swelling> swollen;
  for (std::size_t k = 0; k < record.swelling.size(); ++k)
    if (record.rows[k].time) {
      rows.push_back(record.rows[k]);
      swollen.push_back(record.swelling[k]);
    }
  if (rows.empty()) return nullptr;
  return {{"time", column(rows, &Row::time)},
          {"saturation", column(rows, &Row::saturation)},
          {"porosity", column(rows, &Row::porosity)},
          {"radius_mean", column(swollen, &Swelling::radius_mean)},
          {"radius_least", column(swollen, &Swelling::radius_least)},
          {"radius_most", column(swollen, &Swelling::radius_most)},
          {"wetted", column(swollen, &Swelling::wetted)},
          {"grown", column(swollen, &Swelling::grown)},
          {"from_pores", column(swollen, &Swelling::from_pores)},
          {"from_reservoirs", column(swollen, &Swelling::from_reservoirs)},
          {"p", column(swollen, &Swelling::mean_stress)},
          {"q", column(swollen, &Swelling::deviatoric_stress)},
          {"q_mean", column(swollen, &Swelling::grain_deviator_mean)},
          {"q_deviation", column(swollen, &Swelling::grain_deviator_deviation)}};
}

}  // namespace

json unsaturated_json(const ResultsFolder& folder, const State& state) {
  json stages = json::array();
  for (const UnsaturatedRecord& record : state.unsaturated_flows) {
    const std::span<const Row> rows(record.rows);
    if (rows.empty()) continue;
    json branches = json::array();
    std::size_t first_end = rows.size();
    for (std::size_t first = 0; first < rows.size();) {
      std::size_t end = first;
      while (end < rows.size() && rows[end].branch == rows[first].branch) ++end;
      if (first == 0) first_end = end;
      branches.push_back(branch_json(rows.subspan(first, end - first)));
      first = end;
    }
    stages.push_back({{"name", record.stage},
                      {"axis", std::string(1, "xyz"[record.axis])},
                      {"width", ForceSpread::width},
                      {"branches", std::move(branches)},
                      {"swelling", swelling_json(record)},
                      {"pictures", pictures_json(folder, record.stage)},
                      {"pore_space", pore_space_json(folder, record)},
                      {"spreads", spreads_json(record, first_end)}});
  }
  return stages;
}

json unsaturated_rows(const UnsaturatedStage& s) {
  const auto faces = [](const std::array<bool, 6>& is_in) {
    std::vector<std::string> names;
    for (int face = 0; face < 6; ++face)
      if (is_in[to_size(face)]) names.emplace_back(face_names[to_size(face)]);
    return joined(names);
  };
  std::string path;
  for (const double p : s.path) path += fmt::format("{}{}", path.empty() ? "" : " → ", in_print(p, "Pa"));
  std::string times;
  for (const double t : s.times) times += fmt::format("{}{}", times.empty() ? "" : " → ", in_print(t, "s"));
  std::string steps;
  for (const double p : s.step) steps += fmt::format("{}{}", steps.empty() ? "" : ", ", in_print(p, "Pa"));
  json rows = json::array({{"Path of p_c", path},
                           s.times.empty() ? json{"Output step", steps} : json{"Reached after", times},
                           {"Start", s.start == UnsaturatedStage::Start::dry ? "dry" : "saturated"},
                           {"Air enters at", std::string(face_names[to_size(s.air)])},
                           {"Water leaves at", faces(s.water)}});
  if (s.stress) rows.push_back({"Loaded", fmt::format("{}, {}", faces(s.loaded), in_print(*s.stress, "Pa"))});
  if (s.strain) {
    rows.push_back({"Strain along z after the path", fmt::format("{:.4g}", *s.strain)});
    rows.push_back(
        {"Rate of strain", s.strain_rate ? fmt::format("{:.4g} 1/s", *s.strain_rate) : "quasi-static, inertial number 5 × 10⁻⁴"});
    rows.push_back({"Fluids follow after a strain of", fmt::format("{:.4g}", s.strain_step)});
  }
  if (s.coupling_interval) rows.push_back({"Forces of the fluids stay for", in_print(*s.coupling_interval, "s")});
  rows.push_back({"Damping", fmt::format("{:.4g}", s.damping)});
  rows.push_back({"Grains at rest below an unbalanced force of", fmt::format("{:.4g}", s.unbalanced)});
  rows.push_back(
      {"All at rest below changes of saturation, strain", fmt::format("{:.4g}, {:.4g}", s.saturation_change, s.strain_change)});
  rows.push_back({"New network after", fmt::format("{:.4g} of the mean radius", s.remesh_displacement)});
  rows.push_back({"Corner films connect", s.corner_films ? "yes" : "no"});
  rows.push_back({"Snap-off", s.snap_off ? "yes" : "no"});
  return rows;
}

}  // namespace puadem
