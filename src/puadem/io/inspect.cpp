#include "puadem/io/inspect.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "puadem/base/error.hpp"
#include "puadem/dem/grain_statistics.hpp"
#include "puadem/io/case_file.hpp"
#include "puadem/io/case_summary.hpp"
#include "puadem/io/network_file.hpp"
#include "puadem/io/packing_file.hpp"
#include "puadem/io/text_file.hpp"
#include "puadem/io/units.hpp"

namespace puadem {

namespace {

std::string inspect_packing(const std::filesystem::path& path) {
  const PackingFile file = read_packing(path);
  const GrainStatistics s = statistics_of(file.radius);
  const Vec3 size = file.box.size();
  const double solid = s.mean_volume * static_cast<double>(file.radius.size());
  std::string text = fmt::format(
      "packing {}\ngrains  {}\nbox     {} x {} x {}\nradius  {} to {}; mean {}, Sauter {}\nporosity of the box {:.4f}\n",
      path.string(), file.radius.size(), show(size.x, "m"), show(size.y, "m"), show(size.z, "m"), show(s.smallest, "m"),
      show(s.largest, "m"), show(s.mean_radius, "m"), show(s.sauter_radius, "m"), 1.0 - solid / file.box.volume());
  for (const std::string& warning : file.warnings) text += "warning: " + warning + "\n";
  return text;
}

std::string inspect_network(const std::filesystem::path& path) {
  const NetworkFile file = read_network(path);
  const PoreNetwork& n = file.network;
  const Vec3 size = file.box.size();
  double space = 0.0;
  for (int p = 0; p < n.pores() - file.reservoir_pores; ++p) space += n.pore_volume[to_size(p)];
  const auto closed = std::ranges::count(n.throat_conductance, 0.0);
  std::string text = fmt::format(
      "network {}\npores   {}{}\nthroats {}, {} closed\nbox     {} x {} x {}\nfaces   {}\nporosity of the box {:.4f}\ncontact "
      "angle of "
      "the entry radii {}\n",
      path.string(), n.pores(), file.reservoir_pores > 0 ? fmt::format(", {} of them reservoirs", file.reservoir_pores) : "",
      n.throats(), closed, show(size.x, "m"), show(size.y, "m"), show(size.z, "m"), faces_with_pores(n),
      space / file.box.volume(), show(file.contact_angle, "rad"));
  for (const std::string& warning : file.warnings) text += "warning: " + warning + "\n";
  return text;
}

std::string inspect_case(const std::filesystem::path& path) {
  const CaseFile file = read_case(path);
  const CaseSummary summary = summarise_case(file.c);
  return summary.text;
}

std::string inspect_run(const std::filesystem::path& folder) {
  const std::filesystem::path path = folder / "manifest.json";
  const auto manifest = nlohmann::ordered_json::parse(read_text_file(path), nullptr, false);
  require(manifest.is_object(), "{}: not a manifest of puadem", path.string());
  std::string text = fmt::format("run     {}\n", folder.string());
  for (const auto& [key, value] : manifest.items()) {
    if (value.is_string())
      text += fmt::format("{:<24} {}\n", key, value.get<std::string>());
    else if (value.is_number() || value.is_boolean())
      text += fmt::format("{:<24} {}\n", key, value.dump());
    else if (value.is_object() && (key == "results" || key == "scalars" || key == "ledger"))
      for (const auto& [name, number] : value.items()) text += fmt::format("{:<24} {}\n", key + "." + name, number.dump());
  }
  return text;
}

}  // namespace

std::string inspect(const std::filesystem::path& path) {
  std::error_code failed;
  if (std::filesystem::is_directory(path, failed)) {
    require(std::filesystem::exists(path / "manifest.json", failed), "{}: a folder without manifest.json is no run of puadem",
            path.string());
    return inspect_run(path);
  }
  if (is_network(path)) return inspect_network(path);
  if (path.extension() == ".toml") return inspect_case(path);
  if (path.extension() == ".csv") return inspect_packing(path);
  const std::string text = read_text_file(path);
  require(text.find("# box") != std::string::npos,
          "{}: neither a case file (.toml), a packing or network (.csv) nor a run folder", path.string());
  return inspect_packing(path);
}

}  // namespace puadem
