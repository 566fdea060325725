#pragma once

#include <filesystem>
#include <string>

#include "puadem/coupling/run.hpp"
#include "puadem/io/results_folder.hpp"

namespace puadem {

/// A made-up run: a cubic lattice of grains, pores in its cells, and retention rows on van Genuchten
/// curves. Every number a test needs of it is known.
struct SyntheticRun {
  Case c;
  State state;
  RunResults results;
};

/// @param side       grains along an edge of the box, at least 2
/// @param retention  with a retention stage; else a packing only
SyntheticRun make_synthetic_run(int side, bool retention = true);

/// Feeds the run to the observer as the program would.
void play(const SyntheticRun& run, const Observer& observer);

/// The bytes of a file.
std::string slurp(const std::filesystem::path& path);

}  // namespace puadem
