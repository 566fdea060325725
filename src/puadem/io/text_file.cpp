#include "puadem/io/text_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <system_error>
#include <vector>

#include "puadem/base/error.hpp"
#include "puadem/io/text.hpp"

namespace puadem {

namespace {

namespace fs = std::filesystem;

std::string reason() { return std::strerror(errno); }

/// An open file that closes itself.
struct Descriptor {
  int value = -1;
  Descriptor() = default;
  explicit Descriptor(int descriptor) : value(descriptor) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (value >= 0) ::close(value);
  }
};

std::string names_beside(const fs::path& path) {
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  std::error_code failed;
  if (!fs::is_directory(folder, failed)) return "; its folder does not exist either";
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder, failed)) names.push_back(entry.path().filename().string());
  return did_you_mean(path.filename().string(), names);
}

std::string read_bytes(const fs::path& path) {
  std::error_code failed;
  const fs::file_status status = fs::status(path, failed);
  require(fs::exists(status), "{}: no such file{}", path.string(), names_beside(path));
  require(!fs::is_directory(status), "{}: this is a folder; name a file", path.string());
  constexpr std::uintmax_t largest = std::uintmax_t{1} << 30U;
  require(!fs::is_regular_file(status) || fs::file_size(path, failed) <= largest, "{}: larger than 1 GiB; is it the right file?",
          path.string());

  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  require(file.value >= 0, "{}: cannot be read: {}", path.string(), reason());
  std::string text;
  std::vector<char> buffer(1U << 16U);
  for (;;) {
    const ssize_t count = ::read(file.value, buffer.data(), buffer.size());
    if (count < 0 && errno == EINTR) continue;
    require(count >= 0, "{}: cannot be read: {}", path.string(), reason());
    if (count == 0) return text;
    text.append(buffer.data(), static_cast<std::size_t>(count));
    require(text.size() <= largest, "{}: larger than 1 GiB; is it the right file?", path.string());
  }
}

}  // namespace

std::string read_text_file(const fs::path& path) {
  std::string text = read_bytes(path);
  if (text.starts_with("\xEF\xBB\xBF")) text.erase(0, 3);
  require(!text.empty(), "{}: the file is empty", path.string());
  const std::size_t zero = text.find('\0');
  require(zero == std::string::npos, "{}: this is a binary file (a zero byte at offset {}), not text", path.string(), zero);
  if (const auto bad = first_invalid_utf8(text)) {
    const Place place = place_of(text, *bad);
    throw InputError(fmt::format("{}:{}:{}: not UTF-8 text (byte 0x{:02X}); save the file as UTF-8", path.string(), place.line,
                                 place.column, static_cast<unsigned>(static_cast<unsigned char>(text[*bad]))));
  }
  return text;
}

}  // namespace puadem
