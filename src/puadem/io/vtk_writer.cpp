#include "puadem/io/vtk_writer.hpp"

#include <fmt/format.h>

#include <bit>
#include <cassert>
#include <cstring>

#include "puadem/base/parallel.hpp"

namespace puadem {
namespace {

static_assert(std::endian::native == std::endian::little, "the writer copies numbers as they lie in memory");

template <class T>
constexpr const char* type_name() {
  if constexpr (std::is_same_v<T, double>) return "Float64";
  if constexpr (std::is_same_v<T, float>) return "Float32";
  if constexpr (std::is_same_v<T, std::int64_t>) return "Int64";
  if constexpr (std::is_same_v<T, std::uint8_t>) return "UInt8";
}

/// The XML head, and the blocks it points into: each a UInt64 length and the bytes.
struct Document {
  std::string head;
  std::string blocks;

  template <class T>
  void add_block(std::span<const T> values) {
    const std::uint64_t bytes = values.size_bytes();
    const std::size_t at = blocks.size();
    blocks.resize(at + sizeof bytes + bytes);
    std::memcpy(blocks.data() + at, &bytes, sizeof bytes);
    if (bytes > 0) std::memcpy(blocks.data() + at + sizeof bytes, values.data(), bytes);
  }

  template <class T>
  void add_array(std::string_view name, int components, std::span<const T> values, std::string_view more = {}) {
    head += fmt::format(
        "        <DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\"{} format=\"appended\" offset=\"{}\"/>\n",
        type_name<T>(), name, components, more, blocks.size());
    add_block(values);
  }

  /// One entry an array; a vector has three components.
  template <class T>
  void add_values(std::string_view name, const std::vector<T>& values, std::string_view more = {}) {
    if constexpr (std::is_same_v<T, Vec3>) {
      static_assert(sizeof(Vec3) == 3 * sizeof(double));
      const auto* numbers = values.empty() ? nullptr : &values.front().x;
      add_array(name, 3, std::span<const double>(numbers, 3 * values.size()), more);
    } else {
      add_array(name, 1, std::span(values), more);
    }
  }

  void add_arrays(std::string_view element, const std::vector<VtkArray>& arrays, [[maybe_unused]] std::size_t length) {
    head += fmt::format("      <{}>\n", element);
    for (const VtkArray& array : arrays)
      std::visit(
          [&]<class T>(const std::vector<T>& values) {
            assert(values.size() == length);
            add_values(array.name, values);
          },
          array.values);
    head += fmt::format("      </{}>\n", element);
  }

  void add_cells(std::string_view element, int cells, int points_per_cell, std::span<const std::int64_t> connectivity) {
    std::vector<std::int64_t> offsets(to_size(cells));
    for (int c = 0; c < cells; ++c) offsets[to_size(c)] = std::int64_t{c + 1} * points_per_cell;
    head += fmt::format("      <{}>\n", element);
    add_array<std::int64_t>("connectivity", 1, connectivity);
    add_array<std::int64_t>("offsets", 1, offsets);
    head += fmt::format("      </{}>\n", element);
  }
};

std::vector<std::int64_t> connectivity_of(const VtkPolyData& data) {
  std::vector<std::int64_t> connectivity;
  if (data.lines.empty())
    for (int p = 0; p < size_of(data.points); ++p) connectivity.push_back(p);
  for (const auto& line : data.lines) connectivity.insert(connectivity.end(), line.begin(), line.end());
  return connectivity;
}

}  // namespace

std::string vtp_bytes(const VtkPolyData& data) {
  const bool has_lines = !data.lines.empty();
  const int cells = has_lines ? size_of(data.lines) : size_of(data.points);
  Document d;
  d.head =
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n  <PolyData>\n";
  if (!data.field_data.empty()) {
    d.head += "    <FieldData>\n";
    for (const VtkArray& array : data.field_data)
      std::visit(
          [&]<class T>(const std::vector<T>& values) {
            d.add_values(array.name, values, fmt::format(" NumberOfTuples=\"{}\"", values.size()));
          },
          array.values);
    d.head += "    </FieldData>\n";
  }
  d.head += fmt::format(
      "    <Piece NumberOfPoints=\"{}\" NumberOfVerts=\"{}\" NumberOfLines=\"{}\" NumberOfStrips=\"0\" NumberOfPolys=\"0\">\n",
      data.points.size(), has_lines ? 0 : cells, has_lines ? cells : 0);
  d.add_arrays("PointData", data.point_data, data.points.size());
  d.add_arrays("CellData", data.cell_data, to_size(cells));
  d.head += "      <Points>\n";
  d.add_values("Points", data.points);
  d.head += "      </Points>\n";
  d.add_cells(has_lines ? "Lines" : "Verts", cells, has_lines ? 2 : 1, connectivity_of(data));
  d.head += "    </Piece>\n  </PolyData>\n  <AppendedData encoding=\"raw\">\n   _";
  return d.head + d.blocks + "\n  </AppendedData>\n</VTKFile>\n";
}

std::string pvd_text(std::span<const VtkFrame> frames) {
  std::string text =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\">\n  <Collection>\n";
  for (const VtkFrame& frame : frames)
    text += fmt::format("    <DataSet timestep=\"{}\" part=\"0\" file=\"{}\"/>\n", frame.time, frame.file);
  return text + "  </Collection>\n</VTKFile>\n";
}

}  // namespace puadem
