#pragma once

#include <filesystem>
#include <optional>

#include "puadem/io/results_folder.hpp"

namespace puadem {

/// Writes the next checkpoint of a run, checkpoints/checkpoint_00001.h5 and so on, with all that the recording must
/// remember. Unless the case keeps them all, only the last two stay.
/// @throws InputError  where the disk is full
void record_checkpoint(ResultsFolder& folder, const Case& c, const State& state, const RunResults& results);

/// Keeps a copy of a safe place in memory, now and then: in all it takes a hundredth of the time of the run.
void keep_safe_place(ResultsFolder& folder, const State& state, const RunResults& results);

/// Writes the copy, if there is one, as a checkpoint: for a run that has stopped with an error. A full disk is no more
/// than a warning then.
/// @return is there a checkpoint to go on from?
bool record_safe_place(ResultsFolder& folder, const Case& c);

/// A run taken up again.
struct Resumed {
  Case c;
  State state;
  RunResults results;
  ResultsFolder folder;
  std::filesystem::path checkpoint;  ///< where it goes on
};

/// Takes up a run that was stopped: its folder, cut back to what it held at the checkpoint.
///
/// @param run     folder of the run
/// @param from    checkpoint; none: the last one
/// @param output  new folder, a copy in which to go on; none: the folder itself
/// @throws InputError  for a folder that is no run's, a run that has come to its end and no new folder, a run without
///                     checkpoint, and as `read_checkpoint`
Resumed resume_run(const std::filesystem::path& run, std::optional<std::filesystem::path> from,
                   std::optional<std::filesystem::path> output);

}  // namespace puadem
