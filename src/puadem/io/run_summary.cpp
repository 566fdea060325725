#include "puadem/io/run_summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "puadem/base/parallel.hpp"
#include "puadem/io/manifest.hpp"
#include "puadem/io/progress_line.hpp"
#include "puadem/io/text.hpp"

namespace puadem {

namespace {

std::string retention_table(const State& state) {
  if (state.retention.empty()) return {};
  const bool has_grains = state.particles.size() > 0;  // without them there is no p_c*
  std::string text = fmt::format("{:<14} {:>10} {:>8} {:>10} {:>14} {:>12}\n", "branch", "p_c [Pa]", "p_c*", "saturation",
                                 "trapped water", "trapped air");
  // A long path is shown by an even choice of its rows and all its turning points.
  constexpr int shown = 60;
  const int rows = size_of(state.retention), stride = (rows + shown - 1) / shown;
  for (int i = 0; i < rows; ++i) {
    const RetentionRow& row = state.retention[to_size(i)];
    const bool turns = i + 1 == rows || state.retention[to_size(i + 1)].branch != row.branch;
    if (i % stride != 0 && !turns) continue;
    text += fmt::format("{:<14} {:>10.1f} {:>8} {:>10.4f} {:>14.4f} {:>12.4f}\n", row.branch, row.capillary_pressure,
                        has_grains ? fmt::format("{:.3f}", row.pc_star) : "-", row.saturation, row.trapped_wetting,
                        row.trapped_nonwetting);
  }
  return text;
}

/// The results that most readers want; the rest is in manifest.json.
bool is_shown(const Case& c, std::string_view name) {
  static constexpr std::array<std::string_view, 13> beginnings{
      "porosity_", "stress_mean_",  "unbalanced_",     "coordination_",           "radius_mean_", "pores",  "throats",
      "pc_half_",  "pc_star_half_", "saturation_end_", "trapped_nonwetting_end_", "loop_area_",   "ledger_"};
  const auto begins = [&](std::string_view beginning) {
    return beginning.ends_with('_') ? name.starts_with(beginning) : name == beginning;
  };
  for (int stage = 0; stage < size_of(c.stages); ++stage)
    if (begins(stage_name(c, stage) + "_")) return true;
  return std::ranges::any_of(beginnings, begins);
}

std::string bound_text(const Expected& e) {
  if (std::isinf(e.high)) return fmt::format(">= {:.6g}", e.low);
  if (std::isinf(e.low)) return fmt::format("<= {:.6g}", e.high);
  return fmt::format("in [{:.6g}, {:.6g}]", e.low, e.high);
}

}  // namespace

std::vector<std::string> missed_bounds(const Case& c, const RunResults& results) {
  std::vector<std::string> missed, names;
  for (const auto& [name, value] : results.scalars) names.push_back(name);
  for (const auto& [name, bounds] : c.expected) {
    const auto found = results.scalars.find(name);
    if (found == results.scalars.end())
      missed.push_back(fmt::format("{}: the run has no such result{}", name, did_you_mean(name, names)));
    else if (!(found->second >= bounds.low && found->second <= bounds.high))
      missed.push_back(fmt::format("{} = {:.6g}, expected {}", name, found->second, bound_text(bounds)));
  }
  return missed;
}

std::string run_text(const Case& c, const State& state, const RunResults& results, const RunOutcome& outcome) {
  std::string text = retention_table(state);
  if (!text.empty()) text += "\n";
  for (const auto& [name, value] : results.scalars)
    if (is_shown(c, name)) text += fmt::format("{:<40} {:.6g}\n", name, value);
  const std::size_t missed = missed_bounds(c, results).size();
  if (!c.expected.empty()) text += fmt::format("{} of {} expected bounds hold\n", c.expected.size() - missed, c.expected.size());
  text += fmt::format("\n{} wall time, {:.0f} MB peak memory\n", show_duration(outcome.wall_time),
                      static_cast<double>(peak_memory()) / 1e6);
  if (!outcome.folder.empty())
    text += fmt::format("results  {}\nreport   {}\n", outcome.folder.string(), (outcome.folder / "report.html").string());
  return text;
}

std::string run_json(const Case& c, const State& state, const RunResults& results, const RunOutcome& outcome) {
  using nlohmann::ordered_json;
  ordered_json retention = ordered_json::array();
  for (const RetentionRow& row : state.retention)
    retention.push_back({{"branch", row.branch},
                         {"pc_Pa", row.capillary_pressure},
                         {"pc_star", row.pc_star},
                         {"saturation", row.saturation},
                         {"trapped_wetting", row.trapped_wetting},
                         {"trapped_nonwetting", row.trapped_nonwetting}});
  const ordered_json out{{"exit_code", outcome.exit_code},
                         {"error", outcome.error},
                         {"title", c.title},
                         {"folder", outcome.folder.string()},
                         {"wall_time_s", outcome.wall_time},
                         {"peak_memory_bytes", peak_memory()},
                         {"results", results.scalars},
                         {"expected_missed", missed_bounds(c, results)},
                         {"retention", retention}};
  return out.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace puadem
