#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "puadem/base/vec3.hpp"

namespace puadem {

/// A named array of a VTK file; its length is the number of points or cells, or free for field data.
struct VtkArray {
  std::string name;  ///< a plain word: letters, digits, underscores
  std::variant<std::vector<double>, std::vector<float>, std::vector<std::int64_t>, std::vector<std::uint8_t>, std::vector<Vec3>>
      values;
};

/// Points, or lines between points, with their data: what a .vtp file holds. Without lines every point
/// is a cell of its own.
struct VtkPolyData {
  std::vector<Vec3> points;
  std::vector<std::array<int, 2>> lines;  ///< indices of points
  std::vector<VtkArray> point_data;
  std::vector<VtkArray> cell_data;
  std::vector<VtkArray> field_data;  ///< of the file as a whole
};

/// The bytes of a .vtp file (VTK XML PolyData 1.0): raw appended data, little endian, lengths as UInt64,
/// connectivity as Int64. Points are Float64.
std::string vtp_bytes(const VtkPolyData& data);

/// One file of a time series.
struct VtkFrame {
  double time;       ///< shown by ParaView: [s], or the number of the equilibrium
  std::string file;  ///< relative to the .pvd
};

/// The text of a .pvd file: the series of .vtp files that ParaView plays.
std::string pvd_text(std::span<const VtkFrame> frames);

}  // namespace puadem
