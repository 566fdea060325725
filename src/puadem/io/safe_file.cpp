#include "puadem/io/safe_file.hpp"

#include <cerrno>
#include <cstring>
#include <system_error>

#include "puadem/base/error.hpp"

namespace puadem {
namespace {

constexpr std::size_t buffer_limit = 1 << 16;

[[noreturn]] void refuse(const std::filesystem::path& path, int error) {
  const char* remedy = error == ENOSPC || error == EDQUOT ? "free space there, or choose another disk with --output"
                                                          : "choose a folder you can write to with --output";
  throw InputError(fmt::format("cannot write '{}': {}; {}", path.string(), std::strerror(error), remedy));
}

}  // namespace

void write_file(const std::filesystem::path& path, std::string_view content) {
  std::filesystem::path temporary = path;
  temporary += ".part";
  std::FILE* file = std::fopen(temporary.c_str(), "wb");
  if (!file) refuse(path, errno);
  const bool written = std::fwrite(content.data(), 1, content.size(), file) == content.size();
  int error = written ? 0 : errno;
  if (std::fclose(file) != 0 && error == 0) error = errno;
  if (error == 0 && std::rename(temporary.c_str(), path.c_str()) != 0) error = errno;
  if (error == 0) return;
  std::error_code ignored;
  std::filesystem::remove(temporary, ignored);
  refuse(path, error);
}

AppendFile::AppendFile(const std::filesystem::path& path) : file_(std::fopen(path.c_str(), "wb")), path_(path) {
  if (!file_) refuse(path, errno);
  std::setvbuf(file_.get(), nullptr, _IONBF, 0);  // the buffer is ours: it holds whole lines only
}

AppendFile::AppendFile(const std::filesystem::path& path, std::uintmax_t length) : path_(path), length_(length) {
  std::error_code failed;
  const std::uintmax_t there = std::filesystem::file_size(path, failed);
  require(!failed && there >= length, "'{}' is missing or cut off: it had {} bytes when the checkpoint was written",
          path.string(), length);
  std::filesystem::resize_file(path, length, failed);
  if (!failed) file_.reset(std::fopen(path.c_str(), "ab"));
  if (!file_) refuse(path, failed ? failed.value() : errno);
  std::setvbuf(file_.get(), nullptr, _IONBF, 0);
}

void AppendFile::append(std::string_view text) {
  buffer_ += text;
  if (buffer_.size() >= buffer_limit) flush();
}

void AppendFile::flush() {
  if (!file_ || buffer_.empty()) return;
  const bool written = std::fwrite(buffer_.data(), 1, buffer_.size(), file_.get()) == buffer_.size();
  const int error = errno;
  const std::size_t size = buffer_.size();
  buffer_.clear();
  if (written) {
    length_ += size;
    return;
  }
  std::error_code ignored;  // a device cannot be cut back; a file can
  std::filesystem::resize_file(path_, length_, ignored);
  file_.reset();
  refuse(path_, error);
}

void AppendFile::close() {
  flush();
  file_.reset();
}

}  // namespace puadem
