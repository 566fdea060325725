#pragma once

#include <filesystem>
#include <string>

namespace puadem {

/// Contents of a text file, as UTF-8 without byte order mark.
/// @throws InputError  for a file that is missing (with the nearest name beside it), a folder, unreadable,
///                     empty, binary, not UTF-8, or larger than a GiB
std::string read_text_file(const std::filesystem::path& path);

}  // namespace puadem
