#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace puadem {

/// Writes a whole file: into a temporary neighbour first, renamed when it is complete.
/// @throws InputError naming path, reason and remedy; the temporary file is removed
void write_file(const std::filesystem::path& path, std::string_view content);

/// A file that only grows. Each `append` reaches the file whole or not at all: where a write fails, the
/// file is cut back to its last good length.
class AppendFile {
 public:
  AppendFile() = default;
  /// Opens a new, empty file. @throws InputError
  explicit AppendFile(const std::filesystem::path& path);
  /// Opens a file that is there to go on behind its first `length` bytes; the rest is cut off.
  /// @throws InputError  where it is missing or shorter
  AppendFile(const std::filesystem::path& path, std::uintmax_t length);

  bool is_open() const { return file_ != nullptr; }
  /// Buffers text; it reaches the disk at the next `flush` or when the buffer is large.
  /// @throws InputError where the disk is full
  void append(std::string_view text);
  void flush();
  void close();
  /// Bytes known to be on disk.
  std::uintmax_t length() const { return length_; }
  const std::filesystem::path& path() const { return path_; }

 private:
  struct Closer {
    void operator()(std::FILE* f) const { std::fclose(f); }
  };
  std::unique_ptr<std::FILE, Closer> file_;
  std::filesystem::path path_;
  std::string buffer_;
  std::uintmax_t length_ = 0;
};

}  // namespace puadem
