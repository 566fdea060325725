#include <algorithm>
#include <nlohmann/json.hpp>

#include "puadem/io/report_column.hpp"
#include "puadem/io/report_data.hpp"

namespace puadem {
namespace {

using nlohmann::json;
using Rows = std::span<const HistoryRow>;

/// Terms of the energy book [J].
json energy_json(Rows rows) {
  const auto term = [&](double Energies::*member) { return column(rows, [=](const HistoryRow& r) { return r.energy.*member; }); };
  return {{"kinetic", term(&Energies::kinetic)},
          {"normal", term(&Energies::normal)},
          {"shear", term(&Energies::shear)},
          {"friction", term(&Energies::friction)},
          {"shear_work", term(&Energies::shear_work)},
          {"rolling", term(&Energies::roll_work)},
          {"viscous", term(&Energies::viscous)},
          {"damping", term(&Energies::damping)},
          {"bridges", term(&Energies::bridges)},
          {"wetting", term(&Energies::wetting)},
          {"input", term(&Energies::input)}};
}

/// "triaxial-2" -> "triaxial".
std::string kind_in(const std::string& stage) { return stage.substr(0, stage.find('-')); }

/// Liquid bridges beside contacts; null for dry grains.
json bridges_json(Rows rows) {
  if (!std::ranges::all_of(rows, [](const HistoryRow& r) { return r.bridges.has_value(); })) return nullptr;
  const auto term = [&](const auto& of) { return column(rows, [&](const HistoryRow& r) { return of(*r.bridges); }); };
  return {{"per_grain", term([](const BridgeRow& b) { return b.coordination; })},
          {"force", term([](const BridgeRow& b) { return b.mean_force; })},
          {"contact_force", term([](const BridgeRow& b) { return b.mean_contact_force; })},
          {"stress", term([](const BridgeRow& b) { return b.mean_stress; })},
          {"water", term([](const BridgeRow& b) { return b.water; })},
          {"films", term([](const BridgeRow& b) { return b.film; })}};
}

json stage_json(Rows rows) {
  return {{"name", rows.front().stage},
          {"kind", kind_in(rows.front().stage)},
          {"time", column(rows, [](const auto& r) { return r.time; })},
          {"axial_strain", column(rows, [](const auto& r) { return r.strain.z; })},
          {"volumetric_strain", column(rows, [](const auto& r) { return r.volumetric; })},
          {"void_ratio", column(rows, [](const auto& r) { return r.void_ratio(); })},
          {"axial_stress", column(rows, [](const auto& r) { return r.stress.z; })},
          {"p", column(rows, [](const auto& r) { return r.mean; })},
          {"q", column(rows, [](const auto& r) { return r.deviator; })},
          {"shear_strain", column(rows, [](const auto& r) { return r.shear_strain; })},
          {"normal_stress", column(rows, [](const auto& r) { return r.normal_stress; })},
          {"shear_stress", column(rows, [](const auto& r) { return r.shear_stress; })},
          {"unbalanced", column(rows, [](const auto& r) { return r.unbalanced; })},
          {"coordination", column(rows, [](const auto& r) { return r.coordination; })},
          {"bridges", bridges_json(rows)},
          {"energy", energy_json(rows)}};
}

}  // namespace

json loading_json(Rows rows) {
  json stages = json::array();
  for (std::size_t begin = 0, end = 0; begin < rows.size(); begin = end) {
    while (end < rows.size() && rows[end].stage == rows[begin].stage) ++end;
    stages.push_back(stage_json(rows.subspan(begin, end - begin)));
  }
  return stages;
}

}  // namespace puadem
