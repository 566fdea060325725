#include "puadem/io/report.hpp"

#include <nlohmann/json.hpp>

#include "puadem/build_info.hpp"
#include "puadem/io/manifest.hpp"
#include "puadem/io/report_assets.hpp"
#include "puadem/io/report_coupled.hpp"
#include "puadem/io/report_data.hpp"
#include "puadem/io/report_two_phase.hpp"
#include "puadem/io/report_unsaturated.hpp"
#include "puadem/io/state_hash.hpp"

namespace puadem {
namespace {

using nlohmann::json;

std::string replace_all(std::string text, std::string_view what, std::string_view by) {
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size()) text.replace(at, what.size(), by);
  return text;
}

/// Fills each {{name}} of the page once, left to right: what is filled in is never searched again.
std::string fill(std::string_view page, const std::vector<std::pair<std::string_view, std::string_view>>& values) {
  std::string html;
  while (true) {
    const std::size_t open = page.find("{{");
    html += page.substr(0, open);
    if (open == std::string_view::npos) return html;
    const std::size_t close = page.find("}}", open);
    const std::string_view name = page.substr(open + 2, close - open - 2);
    for (const auto& [key, value] : values)
      if (key == name) html += value;
    page.remove_prefix(close + 2);
  }
}

}  // namespace

std::string escape_html(std::string_view text) {
  std::string html;
  for (const char c : text) switch (c) {
      case '&':
        html += "&amp;";
        break;
      case '<':
        html += "&lt;";
        break;
      case '>':
        html += "&gt;";
        break;
      case '"':
        html += "&quot;";
        break;
      case '\'':
        html += "&#39;";
        break;
      default:
        html += c;
    }
  return html;
}

std::string escape_script(std::string text) { return replace_all(std::move(text), "<", "\\u003c"); }

json report_json(const ResultsFolder& folder, const Case& c, const State& state, const RunResults* results, int exit_code,
                 const std::string& error_message) {
  std::vector<std::string> warnings = folder.warnings;
  json runs = json::array({curves_json("this run", state.retention, radius_distributions(state), state.history)});
  for (json& overlay : overlays_json(c, warnings)) runs.push_back(std::move(overlay));
  json manifest = make_manifest(folder, c, state, results, exit_code, error_message);
  manifest["warnings"] = warnings;
  return {{"title", c.title},
          {"folder", folder.path.filename().string()},
          {"highlights", highlights_json(state, results)},
          {"runs", std::move(runs)},
          {"permeability", permeability_json(state)},
          {"flows", flows_json(folder, state)},
          {"saturated", saturated_json(state)},
          {"unsaturated", unsaturated_json(folder, state)},
          {"facts", facts_json(state)},
          {"scalars", scalars_json(results)},
          {"case", case_json(c)},
          {"case_text", folder.case_text},
          {"resolved_text", folder.resolved_text},
          {"manifest", std::move(manifest)}};
}

std::string report_html(const ResultsFolder& folder, const Case& c, const State& state, const RunResults* results, int exit_code,
                        const std::string& error_message) {
  const json data = report_json(folder, c, state, results, exit_code, error_message);
  return fill(report_page(), {{"title", escape_html(c.title)},
                              {"version", build_info::version},
                              {"style", report_style()},
                              {"data", escape_script(data.dump(-1, ' ', false, json::error_handler_t::replace))},
                              {"script", report_script()}});
}

}  // namespace puadem
