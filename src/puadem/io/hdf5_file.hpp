#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace puadem {

/// Kinds of numbers in a data set.
enum class Hdf5Kind : std::uint8_t { int8, uint8, int32, int64, float64 };

template <class T>
inline constexpr Hdf5Kind hdf5_kind = [] {
  static_assert(std::is_arithmetic_v<T>);
  if constexpr (std::is_floating_point_v<T>) return Hdf5Kind::float64;
  if constexpr (sizeof(T) == 1) return std::is_signed_v<T> ? Hdf5Kind::int8 : Hdf5Kind::uint8;
  return sizeof(T) == 4 ? Hdf5Kind::int32 : Hdf5Kind::int64;
}();

/// Tables of numbers and lists of texts under names such as "state/particles/radius", in an HDF5 file. Rows have as
/// many columns as what they hold has numbers.
class Hdf5File {
 public:
  /// A new file. @throws InputError  where it cannot be written
  static Hdf5File create(const std::filesystem::path& path);
  /// A file to read. @throws InputError  where it cannot be read, or is cut off or no HDF5
  static Hdf5File open(const std::filesystem::path& path);
  Hdf5File(Hdf5File&& other) noexcept;
  Hdf5File& operator=(Hdf5File&&) = delete;
  ~Hdf5File();

  bool has(const std::string& name) const;

  /// @throws InputError  where the disk is full
  void write(const std::string& name, const void* values, Hdf5Kind kind, std::size_t rows, std::size_t columns);
  void write(const std::string& name, const std::vector<std::string>& texts);
  /// Rows of a table. @throws InputError  where there is none of this kind and number of columns
  std::size_t rows(const std::string& name, Hdf5Kind kind, std::size_t columns) const;
  void read(const std::string& name, void* values, Hdf5Kind kind) const;
  std::vector<std::string> read_texts(const std::string& name) const;

  /// Ends the writing. @throws InputError  where the disk is full
  void close();

 private:
  Hdf5File(std::filesystem::path path, std::int64_t file) : path_(std::move(path)), file_(file) {}
  std::filesystem::path path_;
  std::int64_t file_ = -1;
};

}  // namespace puadem
