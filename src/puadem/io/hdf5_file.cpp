#include "puadem/io/hdf5_file.hpp"

#include <hdf5.h>

#include <array>

#include "puadem/base/error.hpp"

namespace puadem {
namespace {

static_assert(sizeof(hid_t) == sizeof(std::int64_t));

/// A handle of the library, closed with its scope.
struct Handle {
  hid_t id;
  herr_t (*close)(hid_t);
  Handle(hid_t i, herr_t (*c)(hid_t)) : id(i), close(c) {}
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  ~Handle() {
    if (id >= 0) close(id);
  }
};

hid_t type_of(Hdf5Kind kind) {
  switch (kind) {
    case Hdf5Kind::int8:
      return H5T_NATIVE_INT8;
    case Hdf5Kind::uint8:
      return H5T_NATIVE_UINT8;
    case Hdf5Kind::int32:
      return H5T_NATIVE_INT32;
    case Hdf5Kind::int64:
      return H5T_NATIVE_INT64;
    case Hdf5Kind::float64:
      break;
  }
  return H5T_NATIVE_DOUBLE;
}

/// The library tells its errors by return values; its own prints would come beside ours.
void silence() {
  static const herr_t once = H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  static_cast<void>(once);
}

[[noreturn]] void cannot_write(const std::filesystem::path& path) {
  throw InputError(fmt::format(
      "cannot write '{}'; is the disk full, or the folder gone? Free space there, or choose another disk with --output",
      path.string()));
}

Handle text_type() {
  Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(type.id, H5T_VARIABLE);
  H5Tset_cset(type.id, H5T_CSET_UTF8);
  return {H5Tcopy(type.id), H5Tclose};
}

Handle open_dataset(std::int64_t file, const std::filesystem::path& path, const std::string& name) {
  Handle dataset(H5Dopen2(file, name.c_str(), H5P_DEFAULT), H5Dclose);
  require(dataset.id >= 0, "'{}' has no \"{}\": it is not whole, or of another version of puadem", path.string(), name);
  return {std::exchange(dataset.id, -1), H5Dclose};
}

}  // namespace

Hdf5File Hdf5File::create(const std::filesystem::path& path) {
  silence();
  const hid_t file = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
  if (file < 0) cannot_write(path);
  return {path, file};
}

Hdf5File Hdf5File::open(const std::filesystem::path& path) {
  silence();
  const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  require(file >= 0, "cannot read '{}': it is missing, cut off, or no HDF5 file", path.string());
  return {path, file};
}

Hdf5File::Hdf5File(Hdf5File&& other) noexcept : path_(std::move(other.path_)), file_(std::exchange(other.file_, -1)) {}

Hdf5File::~Hdf5File() {
  if (file_ >= 0) H5Fclose(file_);
}

bool Hdf5File::has(const std::string& name) const {
  for (std::size_t end = name.find('/');; end = name.find('/', end + 1)) {  // a link is only looked up where its group is
    if (H5Lexists(file_, name.substr(0, end).c_str(), H5P_DEFAULT) <= 0) return false;
    if (end == std::string::npos) return true;
  }
}

void Hdf5File::write(const std::string& name, const void* values, Hdf5Kind kind, std::size_t rows, std::size_t columns) {
  const std::array<hsize_t, 2> size{rows, columns};
  const Handle space(H5Screate_simple(2, size.data(), nullptr), H5Sclose);
  const Handle links(H5Pcreate(H5P_LINK_CREATE), H5Pclose);
  H5Pset_create_intermediate_group(links.id, 1);
  const Handle dataset(H5Dcreate2(file_, name.c_str(), type_of(kind), space.id, links.id, H5P_DEFAULT, H5P_DEFAULT), H5Dclose);
  if (dataset.id < 0) cannot_write(path_);
  if (rows > 0 && H5Dwrite(dataset.id, type_of(kind), H5S_ALL, H5S_ALL, H5P_DEFAULT, values) < 0) cannot_write(path_);
}

void Hdf5File::write(const std::string& name, const std::vector<std::string>& texts) {
  std::vector<const char*> pointers;
  for (const std::string& text : texts) pointers.push_back(text.c_str());
  const hsize_t size = texts.size();
  const Handle type = text_type(), space(H5Screate_simple(1, &size, nullptr), H5Sclose);
  const Handle links(H5Pcreate(H5P_LINK_CREATE), H5Pclose);
  H5Pset_create_intermediate_group(links.id, 1);
  const Handle dataset(H5Dcreate2(file_, name.c_str(), type.id, space.id, links.id, H5P_DEFAULT, H5P_DEFAULT), H5Dclose);
  if (dataset.id < 0) cannot_write(path_);
  if (size > 0 && H5Dwrite(dataset.id, type.id, H5S_ALL, H5S_ALL, H5P_DEFAULT, pointers.data()) < 0) cannot_write(path_);
}

std::size_t Hdf5File::rows(const std::string& name, Hdf5Kind kind, std::size_t columns) const {
  const Handle dataset = open_dataset(file_, path_, name);
  const Handle space(H5Dget_space(dataset.id), H5Sclose), type(H5Dget_type(dataset.id), H5Tclose);
  std::array<hsize_t, 2> size{};
  const bool fits = H5Sget_simple_extent_ndims(space.id) == 2 && H5Tequal(type.id, type_of(kind)) > 0 &&
                    H5Sget_simple_extent_dims(space.id, size.data(), nullptr) == 2 && size[1] == columns;
  require(fits, "\"{}\" in '{}' has not {} columns of the kind it should have", name, path_.string(), columns);
  return size[0];
}

void Hdf5File::read(const std::string& name, void* values, Hdf5Kind kind) const {
  const Handle dataset = open_dataset(file_, path_, name);
  require(H5Dread(dataset.id, type_of(kind), H5S_ALL, H5S_ALL, H5P_DEFAULT, values) >= 0, "cannot read \"{}\" in '{}'", name,
          path_.string());
}

std::vector<std::string> Hdf5File::read_texts(const std::string& name) const {
  const Handle dataset = open_dataset(file_, path_, name);
  const Handle space(H5Dget_space(dataset.id), H5Sclose), type = text_type();
  hsize_t size = 0;
  const Handle stored(H5Dget_type(dataset.id), H5Tclose);
  require(H5Sget_simple_extent_ndims(space.id) == 1 && H5Tis_variable_str(stored.id) > 0 &&
              H5Sget_simple_extent_dims(space.id, &size, nullptr) == 1,
          "\"{}\" in '{}' is no list of texts", name, path_.string());
  std::vector<char*> pointers(size);
  require(size == 0 || H5Dread(dataset.id, type.id, H5S_ALL, H5S_ALL, H5P_DEFAULT, pointers.data()) >= 0,
          "cannot read \"{}\" in '{}'", name, path_.string());
  std::vector<std::string> texts;
  for (const char* text : pointers) texts.emplace_back(text != nullptr ? text : "");
  if (size > 0) H5Dvlen_reclaim(type.id, space.id, H5P_DEFAULT, pointers.data());
  return texts;
}

void Hdf5File::close() {
  const herr_t closed = H5Fclose(std::exchange(file_, -1));
  if (closed < 0) cannot_write(path_);
}

}  // namespace puadem
