#include "puadem/io/report_coupled.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "puadem/geometry/domain.hpp"
#include "puadem/io/report_column.hpp"
#include "puadem/io/report_data.hpp"
#include "puadem/io/text.hpp"

namespace puadem {
namespace {

using nlohmann::json;

json profile_json(const PressureProfile& profile) {
  json place = json::array(), pressure = json::array(), theory = json::array();
  for (const PressureLayer& layer : profile.layers) {
    place.push_back(layer.place);
    pressure.push_back(layer.pressure);
    theory.push_back(layer.linear);
  }
  return {{"time", profile.time},
          {"time_factor", json_of(profile.time_factor)},
          {"place", std::move(place)},
          {"pressure", std::move(pressure)},
          {"theory", std::move(theory)}};
}

json reference_json(const std::optional<ConsolidationReference>& r) {
  if (!r) return nullptr;
  return {{"load", r->load},
          {"stiffness", r->stiffness},
          {"permeability", r->permeability},
          {"coefficient", r->coefficient},
          {"length", r->drainage_length}};
}

}  // namespace

json saturated_json(const State& state) {
  json stages = json::array();
  for (const SaturatedRecord& record : state.saturated_flows) {
    if (record.rows.empty()) continue;
    const auto& rows = record.rows;
    json profiles = json::array();
    for (const PressureProfile& profile : record.profiles) profiles.push_back(profile_json(profile));
    stages.push_back({{"name", record.stage},
                      {"axis", std::string(1, "xyz"[record.axis])},
                      {"reference", reference_json(record.reference)},
                      {"time", column(rows, &SaturatedRow::time)},
                      {"time_factor", column(rows, &SaturatedRow::time_factor)},
                      {"settlement", column(rows, &SaturatedRow::settlement)},
                      {"degree", column(rows, &SaturatedRow::degree)},
                      {"degree_pressure", column(rows, &SaturatedRow::degree_pressure)},
                      {"degree_terzaghi", column(rows, &SaturatedRow::degree_terzaghi)},
                      {"pressure", column(rows, &SaturatedRow::pressure_mean)},
                      {"gradient", column(rows, &SaturatedRow::gradient)},
                      {"lower", column(rows, &SaturatedRow::contact_stress_lower)},
                      {"upper", column(rows, &SaturatedRow::contact_stress_upper)},
                      {"profiles", std::move(profiles)}});
  }
  return stages;
}

json saturated_rows(const SaturatedStage& s) {
  json rows = json::array();
  std::vector<std::string> drained;
  for (int face = 0; face < 6; ++face)
    if (s.drained[to_size(face)]) drained.emplace_back(face_names[to_size(face)]);
  rows.push_back({"Drained", drained.empty() ? "nowhere" : joined(drained)});
  if (s.inlet) rows.push_back({"Inlet", std::string(face_names[to_size(*s.inlet)])});
  for (std::size_t k = 0; k < s.inlet_pressure.size(); ++k)
    rows.push_back({s.inlet_times.empty() ? "Inlet pressure" : "Inlet pressure at " + in_print(s.inlet_times[k], "s"),
                    in_print(s.inlet_pressure[k], "Pa")});
  if (s.loaded) rows.push_back({"Loaded", fmt::format("{}, {}", face_names[to_size(*s.loaded)], in_print(*s.stress, "Pa"))});
  if (s.duration) rows.push_back({"Duration", in_print(*s.duration, "s")});
  if (s.time_factor) rows.push_back({"Time factor", fmt::format("{:.4g}", *s.time_factor)});
  if (s.seat_loose_grains)
    rows.push_back({"Loose grains seated towards", std::string(face_names[to_size(*s.seat_loose_grains)])});
  rows.push_back({"Damping", fmt::format("{:.4g}", s.damping)});
  rows.push_back({"Forces of the fluid frozen for", s.coupling_interval ? in_print(*s.coupling_interval, "s")
                                                                        : fmt::format("{:.4g} of the limit", s.coupling_safety)});
  rows.push_back({"New network after", fmt::format("{:.4g} of the mean radius", s.remesh_displacement)});
  rows.push_back({"Fluid", s.bulk_modulus ? "bulk modulus " + in_print(*s.bulk_modulus, "Pa") : "incompressible"});
  return rows;
}

}  // namespace puadem
