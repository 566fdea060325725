#include "puadem/io/report_two_phase.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "puadem/geometry/domain.hpp"
#include "puadem/io/report_column.hpp"
#include "puadem/io/report_data.hpp"
#include "puadem/io/text.hpp"

namespace puadem {
namespace {

using nlohmann::json;

json boxes_json(const FlowRecord& record) {
  json boxes = json::array();
  if (!record.pattern) return boxes;
  const auto add = [&](const char* name, const BoxCount& b) {
    if (b.size.size() > 1) boxes.push_back({{"name", name}, {"size", b.size}, {"boxes", b.boxes}, {"dimension", b.dimension}});
  };
  add("mostly invaded", record.pattern->mostly);
  add("any pore invaded", record.pattern->projected);
  return boxes;
}

json jump_json(const FlowRecord& record) {
  if (!record.jump) return nullptr;
  const auto values = [](const std::vector<double>& pressures) {
    json list = json::array();
    for (const double p : pressures) list.push_back(std::isnan(p) ? json(nullptr) : json(p));
    return list;
  };
  return {{"time", record.jump->time},
          {"invaded", values(record.jump->invaded_pressure)},
          {"retracting", values(record.jump->retracting_pressure)}};
}

json pictures_json(const ResultsFolder& folder, const std::string& stage) {
  json pictures = json::array();
  for (const FlowPicture& p : folder.pictures)
    if (p.stage == stage) pictures.push_back({{"time", p.time}, {"saturation", p.saturation}, {"picture", p.bytes}});
  return pictures;
}

json section_json(const ResultsFolder& folder) {
  if (!folder.section) return nullptr;
  const SectionMap& s = *folder.section;
  return {{"columns", s.columns},
          {"rows", s.rows},
          {"planes", s.planes},
          {"pixel", s.pixel},
          {"axis", std::string(1, "xyz"[s.axis])}};
}

double void_volume(const State& state) {
  double volume = 0.0;
  for (const double v : state.network.pore_volume) volume += v;
  return volume;
}

std::string faces_text(const std::array<bool, 6>& faces) {
  std::vector<std::string> names;
  for (int face = 0; face < 6; ++face)
    if (faces[to_size(face)]) names.emplace_back(face_names[to_size(face)]);
  return joined(names);
}

void add_driving(const TwoPhaseStage& s, json& rows) {
  std::string path;
  for (const double p : s.path) path += fmt::format("{}{}", path.empty() ? "" : " → ", in_print(p, "Pa"));
  if (!path.empty()) {
    rows.push_back({"Path of p_c", path});
    rows.push_back({"Step", in_print(s.step, "Pa")});
    rows.push_back({"Each pressure is held", s.hold ? in_print(*s.hold, "s") : "until the fluids rest"});
  }
  for (std::size_t k = 0; k < s.water_pressure.size(); ++k)
    rows.push_back({s.water_times.empty() ? "Water pressure" : "Water pressure at " + in_print(s.water_times[k], "s"),
                    in_print(s.water_pressure[k], "Pa")});
  if (s.withdrawal) rows.push_back({"Water drawn off", fmt::format("{:.4g} mm³/s", *s.withdrawal * 1e9)});
  if (s.capillary_number) rows.push_back({"Water drawn off at Ca", fmt::format("{:.3g}", *s.capillary_number)});
  if (s.duration) rows.push_back({"Duration at most", in_print(*s.duration, "s")});
  if (s.until_saturation > 0.0) rows.push_back({"Ends at a saturation of", fmt::format("{:.4g}", s.until_saturation)});
  if (s.until_breakthrough) rows.push_back({"Ends", "at breakthrough"});
}

}  // namespace

json flows_json(const ResultsFolder& folder, const State& state) {
  json flows = json::array();
  const double voids = void_volume(state), box = state.domain.volume();
  for (const FlowRecord& record : state.flows) {
    const auto& rows = record.rows;
    if (rows.empty()) continue;
    flows.push_back({{"name", record.stage},
                     {"time", column(rows, [](const auto& r) { return r.time; })},
                     {"saturation", column(rows, [](const auto& r) { return r.saturation; })},
                     {"pc", column(rows, [](const auto& r) { return r.capillary_pressure; })},
                     {"wetting_in", column(rows, [&](const auto& r) { return r.wetting_in / voids; })},
                     {"wetting_out", column(rows, [&](const auto& r) { return r.wetting_out / voids; })},
                     {"nonwetting_in", column(rows, [&](const auto& r) { return r.nonwetting_in / voids; })},
                     {"nonwetting_out", column(rows, [&](const auto& r) { return r.nonwetting_out / voids; })},
                     {"area", column(rows, [&](const auto& r) { return r.meniscus_area / box * 1e-3; })},
                     {"euler_wetting", column(rows, [](const auto& r) { return r.wetting.euler(); })},
                     {"euler_nonwetting", column(rows, [](const auto& r) { return r.nonwetting.euler(); })},
                     {"section", section_json(folder)},
                     {"snapshots", pictures_json(folder, record.stage)},
                     {"boxes", boxes_json(record)},
                     {"jump", jump_json(record)}});
  }
  return flows;
}

json two_phase_rows(const TwoPhaseStage& s) {
  const TwoPhaseOptions& o = s.options;
  const auto yes_no = [](bool value) { return std::string(value ? "yes" : "no"); };
  json rows = json::array();
  rows.push_back({"Air enters at", s.air == TwoPhaseStage::disc ? "a disc of radius " + in_print(s.disc_radius.value_or(0.0), "m")
                                                                : std::string(face_names[to_size(s.air)])});
  rows.push_back({"Water leaves at", faces_text(s.water)});
  add_driving(s, rows);
  rows.push_back({"Scheme", o.scheme == TwoPhaseScheme::impes ? "impes" : "implicit"});
  rows.push_back({"Gas", o.gas == GasKind::connected        ? "of one pressure"
                         : o.gas == GasKind::incompressible ? "incompressible where cut off"
                                                            : "ideal where cut off"});
  rows.push_back({"Corner films flow", yes_no(o.corner_films)});
  rows.push_back({"Snap-off", yes_no(o.snap_off)});
  if (o.cooperative_filling) rows.push_back({"Cooperative filling", fmt::format("yes, seed {}", o.seed)});
  if (norm(o.gravity) > 0.0)
    rows.push_back({"Gravity", fmt::format("{:.4g}, {:.4g}, {:.4g} m/s²", o.gravity.x, o.gravity.y, o.gravity.z)});
  rows.push_back({"Change of the front in a step", fmt::format("{:.4g}", o.steps.front_change)});
  return rows;
}

std::vector<json> two_phase_highlights(const State& state, const RunResults* results) {
  if (state.flows.empty() || results == nullptr) return {};
  const std::string& name = state.flows.back().stage;
  std::vector<json> top;
  const auto add = [&](const char* label, const std::string& key, const char* note, const char* form) {
    if (const auto found = results->scalars.find(name + key); found != results->scalars.end())
      top.push_back({{"label", label}, {"value", fmt::format(fmt::runtime(form), found->second)}, {"note", note}});
  };
  add("Ca", "_capillary_number", "through the first boundary of the air, at half of the displacement", "{:.2e}");
  add("S at breakthrough", "_breakthrough_saturation", "air stands beside the water's reservoir", "{:.3f}");
  add("Box dimension", "_box_dimension", "of the region that is mostly invaded", "{:.2f}");
  if (top.size() < 2) add("S at the end", "_saturation_end", "of the stage", "{:.3f}");
  return top;
}

}  // namespace puadem
