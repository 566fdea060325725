#include "puadem/io/results_folder.hpp"

#include <fmt/chrono.h>

#include <cctype>
#include <nlohmann/json.hpp>
#include <system_error>

#include "puadem/base/error.hpp"
#include "puadem/io/manifest.hpp"
#include "puadem/io/recording_parts.hpp"
#include "puadem/io/report.hpp"
#include "puadem/io/state_hash.hpp"

namespace puadem {
namespace {

namespace fs = std::filesystem;

/// "Glass beads, 5,000" -> "glass-beads-5-000": letters and digits of any file system.
std::string folder_name(const std::string& title) {
  constexpr std::size_t longest = 40;
  std::string name;
  for (const char c : title) {
    const auto u = static_cast<unsigned char>(c);
    if (u < 128 && std::isalnum(u))
      name += static_cast<char>(std::tolower(u));
    else if (!name.empty() && name.back() != '-')
      name += '-';
    if (name.size() == longest) break;
  }
  while (!name.empty() && name.back() == '-') name.pop_back();
  return name.empty() ? "run" : name;
}

/// Creates a folder that must not hold anything yet; returns the topmost folder that was missing.
fs::path create_empty(const fs::path& folder) {
  std::error_code error;
  require(!fs::exists(folder, error) || fs::is_directory(folder, error), "'{}' is a file; choose a folder with --output",
          folder.string());
  require(!fs::exists(folder, error) || fs::is_empty(folder, error),
          "the folder '{}' is not empty; a run never overwrites another: choose a new folder with --output", folder.string());
  fs::path topmost = folder;
  while (topmost.has_parent_path() && !fs::exists(topmost.parent_path(), error)) topmost = topmost.parent_path();
  const bool existed = fs::exists(folder, error);
  fs::create_directories(folder, error);
  require(!error, "cannot make the folder '{}': {}; choose a place you can write to with --output", folder.string(),
          error.message());
  return existed ? folder / "." : topmost;
}

/// runs/<time>_<name>_<hash>, with a number behind where that is taken.
fs::path free_run_folder(const std::string& stem) {
  fs::path folder = fs::path("runs") / stem;
  std::error_code error;
  for (int k = 2; fs::exists(folder, error); ++k) folder = fs::path("runs") / fmt::format("{}-{}", stem, k);
  return folder;
}

/// Points runs/latest to the run. A link is a convenience: a file system without links is told of, no more.
void link_latest(ResultsFolder& folder) {
  const fs::path link = folder.path.parent_path() / "latest";
  const fs::path temporary = folder.path.parent_path() / fmt::format(".latest.{}", folder.path.filename().string());
  std::error_code error;
  const fs::path previous = fs::read_symlink(link, error);
  folder.previous_latest = error ? "" : previous.string();
  error.clear();
  fs::create_directory_symlink(folder.path.filename(), temporary, error);
  if (!error) fs::rename(temporary, link, error);
  folder.linked = !error;
  if (folder.linked) return;
  std::error_code ignored;
  fs::remove(temporary, ignored);
  folder.warnings.push_back(fmt::format("'{}' could not be pointed to this run: {}", link.string(), error.message()));
}

void restore_latest(const ResultsFolder& folder) {
  const fs::path link = folder.path.parent_path() / "latest";
  std::error_code ignored;
  if (fs::read_symlink(link, ignored) != folder.path.filename()) return;  // a later run has taken it
  fs::remove(link, ignored);
  if (!folder.previous_latest.empty()) fs::create_directory_symlink(folder.previous_latest, link, ignored);
}

/// Takes away everything that this run made.
void remove_all_of(const ResultsFolder& folder) {
  std::error_code ignored;
  for (const char* name :
       {"series", "fields", "checkpoints", "packing.csv", "case.toml", "case.resolved.toml", "log.txt", "progress.jsonl"})
    fs::remove_all(folder.path / name, ignored);
  if (folder.linked) restore_latest(folder);
  if (folder.created_from.filename() == ".") return;  // the folder itself was there before
  for (fs::path p = folder.path; fs::remove(p, ignored) && p != folder.created_from;) p = p.parent_path();
}

void write_summary(ResultsFolder& folder, const Case& c, const State& state, const RunResults* results, int exit_code,
                   const std::string& error_message) {
  for (AppendFile* file : append_files(folder)) file->close();
  write_flow_records(folder, state);
  using Json = nlohmann::json;
  const Json manifest = make_manifest(folder, c, state, results, exit_code, error_message);
  write_file(folder.path / "manifest.json", manifest.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
  write_file(folder.path / "report.html", report_html(folder, c, state, results, exit_code, error_message));
}

}  // namespace

std::vector<AppendFile*> append_files(ResultsFolder& folder) {
  return {&folder.log,         &folder.progress,   &folder.retention,        &folder.events,
          &folder.compaction,  &folder.history,    &folder.pressure,         &folder.flow,
          &folder.flow_events, &folder.saturated,  &folder.pressure_profile, &folder.unsaturated,
          &folder.swelling,    &folder.pore_space, &folder.local_porosity};
}

double wall_seconds(const ResultsFolder& folder) {
  return folder.wall_time_before + std::chrono::duration<double>(std::chrono::steady_clock::now() - folder.started).count();
}

ResultsFolder open_results(const Case& c, const std::string& case_text, std::string resolved_text, std::optional<fs::path> output,
                           const std::string& name) {
  ResultsFolder folder;
  const std::time_t now = std::time(nullptr);
  folder.started_utc = fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(now));
  folder.case_text = case_text;
  folder.resolved_text = std::move(resolved_text);
  const std::string stem = fmt::format("{:%Y-%m-%dT%H%M}_{}_{}", fmt::gmtime(now), folder_name(name.empty() ? c.title : name),
                                       hex(fingerprint(folder.resolved_text)).substr(0, 6));
  folder.path = output ? *output : free_run_folder(stem);
  folder.created_from = create_empty(folder.path);
  try {
    for (const char* part : {"series", "fields"}) fs::create_directory(folder.path / part);
    write_file(folder.path / "case.toml", folder.case_text);
    write_file(folder.path / "case.resolved.toml", folder.resolved_text);
    folder.log = AppendFile(folder.path / "log.txt");
    folder.progress = AppendFile(folder.path / "progress.jsonl");
  } catch (const fs::filesystem_error& error) {
    remove_all_of(folder);
    throw InputError(fmt::format("cannot write into '{}': {}; choose a place you can write to with --output",
                                 folder.path.string(), error.code().message()));
  } catch (const InputError&) {
    remove_all_of(folder);
    throw;
  }
  if (!output) link_latest(folder);
  return folder;
}

void finish_results(ResultsFolder& folder, const Case& c, const State& state, const RunResults* results, int exit_code,
                    const std::string& error_message) {
  const bool failed = exit_code != 0;
  if (failed && !folder.has_result) {
    remove_all_of(folder);
    return;
  }
  try {
    folder.log.append(failed ? fmt::format("stopped: {}\n", error_message) : "finished\n");
    write_summary(folder, c, state, results, exit_code, error_message);
    std::error_code ignored;
    const bool is_done = exit_code == 0 && c.output.checkpoints == OutputOptions::Checkpoints::latest;
    if (is_done) fs::remove_all(folder.path / "checkpoints", ignored);
  } catch (const InputError&) {
    if (error_message.empty()) throw;  // else the first error is the one to tell
  }
}

}  // namespace puadem
