#include "puadem/io/resume.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "puadem/base/error.hpp"
#include "puadem/io/case_file.hpp"
#include "puadem/io/checkpoint.hpp"
#include "puadem/io/text_file.hpp"

namespace puadem {

namespace fs = std::filesystem;

template <>
inline constexpr bool is_row<VtkFrame> = true;
template <>
inline constexpr bool is_row<FlowPicture> = true;

void fields(auto& a, Is<VtkFrame> auto& frame) {
  auto& [time, file] = frame;
  each(a, "time file", time, file);
}

void fields(auto& a, Is<FlowPicture> auto& picture) {
  auto& [stage, time, saturation, bytes] = picture;
  each(a, "stage time saturation bytes", stage, time, saturation, bytes);
}

namespace {

std::string checkpoint_name(int number) { return fmt::format("checkpoint_{:05}.h5", number); }

/// What the recording remembers, for the archive.
void each_memory(auto& a, auto& f) {
  each(a, "warnings started_utc wall_time has_result has_distributions equilibria events_seen", f.warnings, f.started_utc,
       f.wall_time_before, f.has_result, f.has_distributions, f.equilibria, f.events_seen);
  each(a, "history_stage fields_written flow_events_seen pictures last_stage checkpoints", f.history_stage, f.fields_written,
       f.flow_events_seen, f.pictures, f.last_stage, f.checkpoints);
  each(a, "grain_frames contact_frames pore_frames throat_frames flow_pore_frames flow_throat_frames", f.grain_frames,
       f.contact_frames, f.pore_frames, f.throat_frames, f.flow_pore_frames, f.flow_throat_frames);
}

void write_memory(ArchiveWriter archive, ResultsFolder& folder) {
  std::vector<std::string> names;
  std::vector<std::int64_t> lengths;
  for (AppendFile* file : append_files(folder)) {
    file->flush();
    names.push_back(file->is_open() ? file->path().lexically_relative(folder.path).string() : "");
    lengths.push_back(static_cast<std::int64_t>(file->length()));
  }
  each(archive, "files lengths", names, lengths);
  folder.wall_time_before = wall_seconds(folder);
  folder.started = std::chrono::steady_clock::now();
  each_memory(archive, folder);
}

void read_memory(ArchiveReader archive, ResultsFolder& folder) {
  std::vector<std::string> names;
  std::vector<std::int64_t> lengths;
  each(archive, "files lengths", names, lengths);
  const auto files = append_files(folder);
  require(names.size() == files.size() && lengths.size() == files.size(), "the checkpoint lists {} series in place of {}",
          names.size(), files.size());
  each_memory(archive, folder);
  for (std::size_t k = 0; k < files.size(); ++k)
    if (!names[k].empty()) *files[k] = AppendFile(folder.path / names[k], static_cast<std::uintmax_t>(lengths[k]));
}

/// Takes away what the run wrote after the checkpoint.
void cut_back(const ResultsFolder& folder) {
  std::set<std::string> fields, series;
  for (const auto* frames : {&folder.grain_frames, &folder.contact_frames, &folder.pore_frames, &folder.throat_frames,
                             &folder.flow_pore_frames, &folder.flow_throat_frames})
    for (const VtkFrame& frame : *frames) fields.insert(frame.file);
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder.path / "fields", ignored))
    if (entry.path().extension() == ".vtp" && !fields.contains(entry.path().filename().string()))
      fs::remove(entry.path(), ignored);
  for (const auto& entry : fs::directory_iterator(folder.path / "checkpoints", ignored)) {
    const bool is_later = checkpoint_name(folder.checkpoints) < entry.path().filename().string();
    if (is_later) fs::remove(entry.path(), ignored);
  }
  for (const char* name : {"manifest.json", "report.html"}) fs::remove(folder.path / name, ignored);
}

fs::path last_checkpoint(const fs::path& run) {
  std::error_code failed;
  fs::path last;
  for (const auto& entry : fs::directory_iterator(run / "checkpoints", failed))
    if (entry.path().extension() == ".h5" && entry.path().filename() > last.filename()) last = entry.path();
  require(!last.empty(),
          "'{}' has no checkpoint: the run ended before its first one was due (output.checkpoint_every); run it anew",
          run.string());
  return last;
}

/// Has the run come to its end?
bool is_finished(const fs::path& run) {
  std::error_code failed;
  if (!fs::exists(run / "manifest.json", failed)) return false;
  const auto manifest = nlohmann::json::parse(read_text_file(run / "manifest.json"), nullptr, false);
  return manifest.is_object() && manifest.value("exit_code", -1) == 0;
}

fs::path copied(const fs::path& run, const fs::path& output) {
  std::error_code failed;
  require(!fs::exists(output, failed) || fs::is_empty(output, failed),
          "the folder '{}' is not empty; a run never overwrites another: choose a new folder with --output", output.string());
  fs::copy(run, output, fs::copy_options::recursive | fs::copy_options::copy_symlinks, failed);
  require(!failed, "cannot copy '{}' to '{}': {}", run.string(), output.string(), failed.message());
  return output;
}

}  // namespace

void record_checkpoint(ResultsFolder& folder, const Case& c, const State& state, const RunResults& results) {
  const fs::path place = folder.path / "checkpoints";
  std::error_code ignored;
  fs::create_directory(place, ignored);
  ++folder.checkpoints;
  write_checkpoint(place / checkpoint_name(folder.checkpoints), folder.resolved_text, state, results,
                   [&](ArchiveWriter& archive) { write_memory(archive.inside("recording"), folder); });
  folder.last_checkpoint = std::chrono::steady_clock::now();
  if (c.output.checkpoints == OutputOptions::Checkpoints::latest && folder.checkpoints > 2)
    fs::remove(place / checkpoint_name(folder.checkpoints - 2), ignored);
}

Resumed resume_run(const fs::path& run, std::optional<fs::path> from, std::optional<fs::path> output) {
  const fs::path resolved = run / "case.resolved.toml";
  std::error_code failed;
  require(fs::exists(resolved, failed), "'{}' is no folder of a run: it has no case.resolved.toml", run.string());
  require(output || !is_finished(run),
          "the run in '{}' has come to its end; to go on from one of its checkpoints give a new "
          "folder with --output",
          run.string());
  Resumed r;
  r.checkpoint = from ? *from : last_checkpoint(run);
  require(fs::exists(r.checkpoint, failed), "there is no checkpoint '{}'", r.checkpoint.string());
  r.c = read_case(resolved).c;
  r.folder.path = fs::canonical(output ? copied(run, *output) : run);
  r.folder.created_from = r.folder.path / ".";
  r.folder.case_text = read_text_file(run / "case.toml");
  r.folder.resolved_text = read_text_file(resolved);
  read_checkpoint(r.checkpoint, r.c, r.folder.resolved_text, r.state, r.results,
                  [&](ArchiveReader& archive) { read_memory(archive.inside("recording"), r.folder); });
  cut_back(r.folder);
  return r;
}

}  // namespace puadem
