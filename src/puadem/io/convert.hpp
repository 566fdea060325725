#pragma once

#include <array>
#include <filesystem>
#include <limits>
#include <string>

namespace puadem {

/// What a conversion makes, and how a packing becomes a network on the way.
struct ConvertOptions {
  enum class Target { by_name, packing, network, statoil };
  Target target = Target::by_name;  ///< by_name: Statoil's format where OUT has no ending, else a table of what IN is
  int inlet = 0;                    ///< face where Statoil's network begins; its flow goes to the opposite one
  std::array<bool, 3> periodic{};   ///< axes of a packing without walls
  double merge_ratio = 0.9;         ///< of a packing's pores; infinity: none merge
};

/// Reads a packing (.csv), a network (.csv, or four files of Statoil's format) or the packing of a run folder, whose network
/// follows the options of its case, and writes it in another form. Returns what was written and what it does not hold.
/// @throws InputError  where IN cannot be read, OUT exists, or IN has no such form
std::string convert(const std::filesystem::path& in, const std::filesystem::path& out, const ConvertOptions& options);

}  // namespace puadem
