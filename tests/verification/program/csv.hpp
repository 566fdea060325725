#pragma once

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace puadem::verification {

/// A CSV file of the results folder.
struct Csv {
  std::ofstream file;
  Csv(const std::filesystem::path& path, const char* header) : file(path) { file << header << '\n'; }
  template <class... Cells>
  void row(const Cells&... cells) {
    std::string line;
    ((line += fmt::format("{}{}", line.empty() ? "" : ",", cells)), ...);
    file << line << '\n';
  }
};

}  // namespace puadem::verification
