#pragma once

#include <filesystem>
#include <string>

namespace puadem {

/// What `puadem info PATH` prints: of a packing file its grains and box, of a case file its summary, of a
/// run folder its outcome.
/// @throws InputError  for anything else, and as the readers of the three kinds
std::string inspect(const std::filesystem::path& path);

}  // namespace puadem
