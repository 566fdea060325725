#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "puadem/coupling/run.hpp"
#include "puadem/io/safe_file.hpp"
#include "puadem/io/section_map.hpp"
#include "puadem/io/vtk_writer.hpp"

namespace puadem {

/// The saturation in a section of the box at one time.
struct FlowPicture {
  std::string stage;
  double time = 0.0;        ///< [s]
  double saturation = 1.0;  ///< of the whole [-]
  std::string bytes;        ///< see section_picture
};

/// The same at a row of a stage "unsaturated-flow", with the grains in the section.
struct UnsaturatedPicture {
  std::string stage;
  int row = 0;              ///< of the stage's
  bool gives_way = false;   ///< to the picture of the next row
  double saturation = 1.0;  ///< of the whole [-]
  double pc_star = 0.0;     ///< p_c <r> / gamma [-]
  int axis = 2, columns = 0, rows = 0;
  double pixel = 0.0;  ///< [m]
  std::string bytes;   ///< see section_picture
  std::vector<CutGrain> grains;
};

/// What a recording must remember to go on from a checkpoint.
struct RecordingMemory {
  std::vector<std::string> warnings;  ///< messages that begin with "warning: ", without that word
  double wall_time_before = 0.0;      ///< of a run that was taken up again, until then [s]
  std::string started_utc;            ///< ISO 8601
  bool has_result = false;            ///< a packing or an equilibrium is on disk
  std::vector<VtkFrame> grain_frames, contact_frames, bridge_frames, pore_frames, throat_frames, flow_pore_frames,
      flow_throat_frames;
  bool has_distributions = false;
  int equilibria = 0;
  long events_seen = 0;
  std::string history_stage;  ///< of the last history row
  int fields_written = 0;     ///< sets of files of that stage
  long flow_events_seen = 0;
  std::vector<FlowPicture> pictures;
  std::vector<UnsaturatedPicture> unsaturated_pictures;
  std::string last_stage;
  int checkpoints = 0;                ///< written so far
  std::vector<std::string> files;     ///< the series below the folder; empty: not begun
  std::vector<std::int64_t> lengths;  ///< of them [B]
};

/// A place a run can go on from.
struct SafePlace {
  State state;
  RunResults results;
  RecordingMemory recording;
};

/// The folder of one run, and what must be remembered between calls of the observer. It must outlive
/// the observer that writes into it.
///
/// Whole files are written beside their place and renamed; series grow line by line and are cut back
/// to their last whole line where a write fails. Nothing half-written is ever seen.
struct ResultsFolder : RecordingMemory {
  std::filesystem::path path;
  std::string case_text;      ///< the case file, as given
  std::string resolved_text;  ///< the same in SI units

  // Progress of the recording.
  std::chrono::steady_clock::time_point started = std::chrono::steady_clock::now();
  std::filesystem::path created_from;  ///< topmost folder made for this run; ends in "." where there was none
  std::string previous_latest;         ///< what `latest` pointed to before; empty: nothing
  bool linked = false;                 ///< `latest` was set to this run
  AppendFile log, progress, retention, events, compaction, history, pressure, flow, flow_events;  ///< opened when first needed
  AppendFile saturated, pressure_profile, unsaturated, swelling, pore_space, local_porosity;      ///< the same
  std::optional<SectionMap> section;                                                              ///< of the pictures
  int section_pores = 0;  ///< of the network it was cut from
  std::chrono::steady_clock::time_point last_progress{};
  std::chrono::steady_clock::time_point last_checkpoint = std::chrono::steady_clock::now();
  std::optional<SafePlace> safe_place;  ///< the last of a stage that moves grains, of which no checkpoint is on disk
  std::chrono::steady_clock::time_point last_copy{};
  std::chrono::duration<double> copy_time{};  ///< that it took
};

/// The files that grow, in a fixed order.
std::vector<AppendFile*> append_files(ResultsFolder& folder);

/// Of the run so far [s].
double wall_seconds(const ResultsFolder& folder);

/// Makes the folder of a run and writes case.toml and case.resolved.toml into it.
///
/// @param case_text      the case file as read
/// @param resolved_text  its SI copy
/// @param output         the folder itself; none: runs/<UTC time>_<name>_<hash of the resolved case> under
///                       the working directory, with runs/latest pointing to it
/// @param name           for the folder's name; empty: from the title
/// @throws InputError  where the folder exists and is not empty, or cannot be written: a run never
///                     overwrites another
ResultsFolder open_results(const Case& c, const std::string& case_text, std::string resolved_text,
                           std::optional<std::filesystem::path> output, const std::string& name = {});

/// Writes log.txt, progress.jsonl, series/, fields/ and checkpoints/ as the run goes on. Folder and case must outlive
/// the observer. A message that begins with
/// "warning: " goes into the manifest and the report too. Progress always asks to go on: combine it
/// with an observer of your own to stop a run or to draw a progress line.
/// @throws InputError (from its calls) where the disk is full or the folder is gone
Observer recording_observer(ResultsFolder& folder, const Case& c);

/// Writes manifest.json and report.html and closes the series. A run that failed before its first
/// result leaves no folder behind; any other keeps what is whole.
///
/// @param results        null where the run ended early
/// @param exit_code      of the program, see product documentation: 0 ok, 1 input, 2 physics, 3 interrupted
/// @param error_message  why it ended; empty for exit code 0
/// @throws InputError where the disk is full; what is on disk by then is whole
void finish_results(ResultsFolder& folder, const Case& c, const State& state, const RunResults* results, int exit_code,
                    const std::string& error_message);

/// True where every bound of `[expected]` holds; a name that the results do not have counts as failed.
bool expected_bounds_hold(const Case& c, const RunResults& results);

}  // namespace puadem
