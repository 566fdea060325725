#include "puadem/io/resume.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

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

template <>
inline constexpr bool is_row<CutGrain> = true;

void fields(auto& a, Is<CutGrain> auto& grain) {
  auto& [across, up, radius, force_across, force_up, moved_across, moved_up] = grain;
  each(a, "across up radius force_across force_up moved_across moved_up", across, up, radius, force_across, force_up,
       moved_across, moved_up);
}

void fields(auto& a, Is<UnsaturatedPicture> auto& picture) {
  auto& [stage, row, gives_way, saturation, pc_star, axis, columns, rows, pixel, bytes, grains] = picture;
  each(a, "stage row gives_way saturation pc_star axis columns rows pixel bytes grains", stage, row, gives_way, saturation,
       pc_star, axis, columns, rows, pixel, bytes, grains);
}

void fields(auto& a, Is<FlowPicture> auto& picture) {
  auto& [stage, time, saturation, bytes] = picture;
  each(a, "stage time saturation bytes", stage, time, saturation, bytes);
}

void fields(auto& a, Is<RecordingMemory> auto& memory) {
  auto& [warnings, wall_time_before, started_utc, has_result, grain_frames, contact_frames, bridge_frames, pore_frames,
         throat_frames, flow_pore_frames, flow_throat_frames, has_distributions, equilibria, events_seen, history_stage,
         fields_written, flow_events_seen, pictures, unsaturated_pictures, last_stage, checkpoints, files, lengths] = memory;
  each(a, "warnings wall_time_before started_utc has_result grain_frames contact_frames bridge_frames pore_frames throat_frames",
       warnings, wall_time_before, started_utc, has_result, grain_frames, contact_frames, bridge_frames, pore_frames,
       throat_frames);
  each(a, "flow_pore_frames flow_throat_frames has_distributions equilibria events_seen history_stage fields_written",
       flow_pore_frames, flow_throat_frames, has_distributions, equilibria, events_seen, history_stage, fields_written);
  each(a, "flow_events_seen pictures unsaturated_pictures last_stage checkpoints files lengths", flow_events_seen, pictures,
       unsaturated_pictures, last_stage, checkpoints, files, lengths);
}

namespace {

std::string checkpoint_name(int number) { return fmt::format("checkpoint_{:05}.h5", number); }

/// What the recording is to remember, with all series on disk.
RecordingMemory remember(ResultsFolder& folder) {
  folder.files.clear();
  folder.lengths.clear();
  for (AppendFile* file : append_files(folder)) {
    file->flush();
    folder.files.push_back(file->is_open() ? file->path().lexically_relative(folder.path).string() : "");
    folder.lengths.push_back(static_cast<std::int64_t>(file->length()));
  }
  folder.wall_time_before = wall_seconds(folder);
  folder.started = std::chrono::steady_clock::now();
  return folder;
}

/// Opens the series where they ended.
void open_series(ResultsFolder& folder) {
  const auto files = append_files(folder);
  require(folder.files.size() == files.size() && folder.lengths.size() == files.size(),
          "the checkpoint lists {} series in place of {}", folder.files.size(), files.size());
  for (std::size_t k = 0; k < files.size(); ++k)
    if (!folder.files[k].empty())
      *files[k] = AppendFile(folder.path / folder.files[k], static_cast<std::uintmax_t>(folder.lengths[k]));
}

void write_next_checkpoint(ResultsFolder& folder, const Case& c, const State& state, const RunResults& results,
                           RecordingMemory recording) {
  const fs::path place = folder.path / "checkpoints";
  std::error_code ignored;
  fs::create_directory(place, ignored);
  recording.checkpoints = ++folder.checkpoints;
  write_checkpoint(place / checkpoint_name(folder.checkpoints), folder.resolved_text, state, results,
                   [&](ArchiveWriter& archive) { archive("recording", recording); });
  folder.last_checkpoint = std::chrono::steady_clock::now();
  if (c.output.checkpoints == OutputOptions::Checkpoints::latest && folder.checkpoints > 2)
    fs::remove(place / checkpoint_name(folder.checkpoints - 2), ignored);
}

/// Takes away what the run wrote after the checkpoint.
void cut_back(const ResultsFolder& folder) {
  std::set<std::string> fields, series;
  for (const auto* frames : {&folder.grain_frames, &folder.contact_frames, &folder.bridge_frames, &folder.pore_frames,
                             &folder.throat_frames, &folder.flow_pore_frames, &folder.flow_throat_frames})
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
  folder.safe_place.reset();
  write_next_checkpoint(folder, c, state, results, remember(folder));
}

void keep_safe_place(ResultsFolder& folder, const State& state, const RunResults& results) {
  using Clock = std::chrono::steady_clock;
  constexpr double copies_worth = 100.0;  // of its own time between two copies
  const auto begin = Clock::now();
  if (begin - folder.last_copy < copies_worth * folder.copy_time) return;
  folder.safe_place = {state, results, remember(folder)};
  folder.last_copy = Clock::now();
  folder.copy_time = folder.last_copy - begin;
}

bool record_safe_place(ResultsFolder& folder, const Case& c) {
  if (!folder.has_result) return false;  // a run without any leaves no folder behind
  const auto place = std::exchange(folder.safe_place, std::nullopt);
  try {
    if (place) write_next_checkpoint(folder, c, place->state, place->results, place->recording);
  } catch (const InputError& error) {
    folder.warnings.emplace_back(error.what());
    return false;
  }
  return folder.checkpoints > 0;
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
                  [&](ArchiveReader& archive) { archive("recording", static_cast<RecordingMemory&>(r.folder)); });
  open_series(r.folder);
  cut_back(r.folder);
  return r;
}

}  // namespace puadem
