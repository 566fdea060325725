#pragma once

#include <filesystem>
#include <functional>

#include "puadem/coupling/run.hpp"
#include "puadem/io/archive.hpp"

namespace puadem {

/// Version of what checkpoints hold; it changes with every change of a member.
inline constexpr int checkpoint_format = 3;

/// Writes state and results of a run at a safe place into an HDF5 file, beside its place first and then renamed: a
/// file of this name is whole.
///
/// @param resolved_case  SI copy of the case, which a checkpoint belongs to
/// @param more           hands the archive what else is to be kept; may be empty
/// @throws InputError  where the disk is full
void write_checkpoint(const std::filesystem::path& path, std::string_view resolved_case, const State& state,
                      const RunResults& results, const std::function<void(ArchiveWriter&)>& more = {});

/// Reads it back.
/// @throws InputError  for a file that is not whole, of another case or of another format
void read_checkpoint(const std::filesystem::path& path, const Case& c, std::string_view resolved_case, State& state,
                     RunResults& results, const std::function<void(ArchiveReader&)>& more = {});

}  // namespace puadem
