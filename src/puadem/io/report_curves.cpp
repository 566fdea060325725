#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "puadem/base/error.hpp"
#include "puadem/io/report_column.hpp"
#include "puadem/io/report_data.hpp"
#include "puadem/io/series_writer.hpp"

namespace puadem {
namespace {

using nlohmann::json;
using Rows = std::span<const RetentionRow>;

/// Consecutive rows of one branch name.
std::vector<Rows> branches_of(Rows rows) {
  std::vector<Rows> branches;
  for (std::size_t begin = 0, end = 0; begin < rows.size(); begin = end) {
    while (end < rows.size() && rows[end].branch == rows[begin].branch) ++end;
    branches.push_back(rows.subspan(begin, end - begin));
  }
  return branches;
}

bool is_drainage(Rows branch) { return branch.front().branch.starts_with("drainage"); }

/// The fit and points on it, over the pressures of the branch.
json fit_json(Rows branch) {
  const std::optional<VanGenuchten> fit = fit_van_genuchten(branch);
  if (!fit) return nullptr;
  constexpr int points = 161;
  const auto [low, high] = std::ranges::minmax(branch, {}, &RetentionRow::capillary_pressure);
  json pressure = json::array(), saturation = json::array();
  for (int k = 0; k < points; ++k) {
    const double p = low.capillary_pressure + (high.capillary_pressure - low.capillary_pressure) * k / (points - 1);
    pressure.push_back(p);
    saturation.push_back(fit->saturation(p));
  }
  return {{"alpha", fit->alpha},
          {"n", fit->n},
          {"residual_saturation", fit->residual_saturation},
          {"maximal_saturation", fit->maximal_saturation},
          {"rms", fit->rms_error},
          {"pc", std::move(pressure)},
          {"saturation", std::move(saturation)}};
}

json branch_json(Rows branch) {
  return {{"name", branch.front().branch},
          {"drainage", is_drainage(branch)},
          {"step",
           [&] {
             json steps = json::array();
             for (const RetentionRow& row : branch) steps.push_back(row.step);
             return steps;
           }()},
          {"pc", column(branch, &RetentionRow::capillary_pressure)},
          {"saturation", column(branch, &RetentionRow::saturation)},
          {"trapped_wetting", column(branch, &RetentionRow::trapped_wetting)},
          {"trapped_nonwetting", column(branch, &RetentionRow::trapped_nonwetting)},
          {"fit", fit_json(branch)}};
}

json bins_json(const std::vector<Bin>& bins) {
  json low = json::array(), high = json::array(), density = json::array();
  double mean = 0.0;
  for (const Bin& bin : bins) {
    low.push_back(bin.low);
    high.push_back(bin.high);
    density.push_back(bin.density);
    mean += bin.density * (bin.high - bin.low) * 0.5 * (bin.low + bin.high);
  }
  return {{"low", std::move(low)}, {"high", std::move(high)}, {"pdf", std::move(density)}, {"mean", mean}};
}

/// p_c* over p_c [1/Pa], from the row of highest pressure; none for measured curves without the column.
std::optional<double> star_scale(Rows rows) {
  if (rows.empty()) return std::nullopt;
  const RetentionRow& top = *std::ranges::max_element(rows, {}, &RetentionRow::capillary_pressure);
  if (!(top.pc_star > 0.0)) return std::nullopt;
  return top.pc_star / top.capillary_pressure;
}

json loops_json(const std::vector<Rows>& branches) {
  json loops = json::array();
  for (std::size_t k = 0; k + 1 < branches.size(); ++k) {
    if (is_drainage(branches[k]) == is_drainage(branches[k + 1])) continue;
    const Rows upper = is_drainage(branches[k]) ? branches[k] : branches[k + 1];
    const Rows lower = is_drainage(branches[k]) ? branches[k + 1] : branches[k];
    loops.push_back({{"upper", upper.front().branch}, {"lower", lower.front().branch}, {"area_Pa", loop_area(upper, lower)}});
  }
  return loops;
}

bool is_there(const std::filesystem::path& file) {
  std::error_code error;
  return std::filesystem::exists(file, error);
}

/// A run folder keeps its series in series/; a folder of reference data has them at hand.
std::filesystem::path series_file(const std::filesystem::path& folder, const char* name) {
  const std::filesystem::path inside = folder / "series" / name;
  return is_there(inside) ? inside : folder / name;
}

}  // namespace

json curves_json(const std::string& label, Rows rows, const RadiusDistributions& radii, std::span<const HistoryRow> history) {
  const std::vector<Rows> branches = branches_of(rows);
  json drawn = json::array();
  for (const Rows branch : branches) drawn.push_back(branch_json(branch));
  const std::optional<double> scale = star_scale(rows);
  return {{"label", label},
          {"branches", std::move(drawn)},
          {"loops", loops_json(branches)},
          {"star_per_Pa", scale ? json(*scale) : json(nullptr)},
          {"pore", bins_json(radii.pore)},
          {"throat", bins_json(radii.throat)},
          {"loading", loading_json(history)}};
}

json overlays_json(const Case& c, std::vector<std::string>& warnings) {
  json overlays = json::array();
  for (const Overlay& overlay : c.overlays) {
    try {
      const auto distributions = series_file(overlay.folder, "distributions.csv"),
                 retention = series_file(overlay.folder, "retention.csv"), history = series_file(overlay.folder, "history.csv");
      // What nobody has is asked for by the name of the retention curve.
      const auto rows = is_there(retention) || !is_there(history) ? read_retention(retention) : std::vector<RetentionRow>{};
      overlays.push_back(curves_json(overlay.label, rows,
                                     is_there(distributions) ? read_distributions(distributions) : RadiusDistributions{},
                                     is_there(history) ? read_history(history) : std::vector<HistoryRow>{}));
    } catch (const InputError& failure) {
      warnings.push_back(fmt::format("overlay '{}' is not drawn: {}", overlay.label, failure.what()));
    }
  }
  return overlays;
}

}  // namespace puadem
