#include "puadem/io/vtk_writer.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <map>
#include <regex>

#include "puadem/io/vtk_fields.hpp"
#include "synthetic_run.hpp"

namespace puadem {
namespace {

/// A reader of its own: finds each DataArray by its attributes and its bytes by the offset, knowing
/// nothing of how the writer lays them out.
struct VtpReader {
  struct Array {
    std::string type, section;
    int components = 0;
    std::vector<double> values;
  };
  std::map<std::string, Array> arrays;
  std::map<std::string, int> counts;  ///< NumberOfPoints, NumberOfLines, ...
  std::string head;

  explicit VtpReader(const std::string& bytes) {
    const std::string mark = "<AppendedData encoding=\"raw\">";
    const std::size_t tag = bytes.find(mark);
    head = bytes.substr(0, tag);
    const std::size_t data = bytes.find('_', tag + mark.size()) + 1;
    const std::regex array_tag(
        "<(\\w+)>|<DataArray type=\"(\\w+)\" Name=\"(\\w+)\" NumberOfComponents=\"(\\d+)\"[^>]*"
        "format=\"appended\" offset=\"(\\d+)\"/>");
    std::string section;
    for (std::sregex_iterator it(head.begin(), head.end(), array_tag), end; it != end; ++it) {
      const std::smatch& m = *it;
      if (m[1].matched) {
        section = m[1];
        continue;
      }
      arrays[section + "/" + m[3].str()] = Array{m[2], section, std::stoi(m[4]), numbers(bytes, data + std::stoul(m[5]), m[2])};
    }
    const std::regex count("(NumberOf\\w+)=\"(\\d+)\"");
    const std::size_t piece = head.find("<Piece");
    const std::string piece_tag = head.substr(piece, head.find('>', piece) - piece);
    for (std::sregex_iterator it(piece_tag.begin(), piece_tag.end(), count), end; it != end; ++it)
      counts[(*it)[1]] = std::stoi((*it)[2]);
    EXPECT_TRUE(bytes.ends_with("\n  </AppendedData>\n</VTKFile>\n"));
  }

  template <class T>
  static std::vector<double> as(const char* from, std::size_t bytes) {
    std::vector<T> values(bytes / sizeof(T));
    if (!values.empty()) std::memcpy(values.data(), from, bytes);
    return {values.begin(), values.end()};
  }

  static std::vector<double> numbers(const std::string& bytes, std::size_t at, const std::string& type) {
    std::uint64_t length = 0;
    std::memcpy(&length, bytes.data() + at, sizeof length);
    const char* from = bytes.data() + at + sizeof length;
    EXPECT_LE(at + sizeof length + length, bytes.size());
    if (type == "Float64") return as<double>(from, length);
    if (type == "Float32") return as<float>(from, length);
    if (type == "Int64") return as<std::int64_t>(from, length);
    return as<std::uint8_t>(from, length);
  }
};

TEST(VtkWriter, LinesReadBackToTheSameNumbers) {
  VtkPolyData data;
  data.points = {{0, 0.1, 1e-300}, {1.0 / 3.0, -2, 3}, {4, 5, 6}};
  data.lines = {{0, 2}, {2, 1}};
  data.point_data = {{"radius", std::vector<double>{1.5, 2.5, 3.5}}, {"half", std::vector<float>{0.5F, 0.25F, 0.125F}}};
  data.cell_data = {{"open", std::vector<std::uint8_t>{1, 0}}, {"id", std::vector<std::int64_t>{-1, 1LL << 40}}};
  data.field_data = {{"capillary_pressure", std::vector<double>{700.0}}};
  const VtpReader read(vtp_bytes(data));

  EXPECT_EQ(read.counts.at("NumberOfPoints"), 3);
  EXPECT_EQ(read.counts.at("NumberOfLines"), 2);
  EXPECT_EQ(read.counts.at("NumberOfVerts"), 0);
  EXPECT_EQ(read.arrays.at("Points/Points").components, 3);
  EXPECT_EQ(read.arrays.at("Points/Points").values, (std::vector<double>{0, 0.1, 1e-300, 1.0 / 3.0, -2, 3, 4, 5, 6}));
  EXPECT_EQ(read.arrays.at("Lines/connectivity").type, "Int64");
  EXPECT_EQ(read.arrays.at("Lines/connectivity").values, (std::vector<double>{0, 2, 2, 1}));
  EXPECT_EQ(read.arrays.at("Lines/offsets").values, (std::vector<double>{2, 4}));
  EXPECT_EQ(read.arrays.at("PointData/radius").values, (std::vector<double>{1.5, 2.5, 3.5}));
  EXPECT_EQ(read.arrays.at("PointData/half").values, (std::vector<double>{0.5, 0.25, 0.125}));
  EXPECT_EQ(read.arrays.at("CellData/open").values, (std::vector<double>{1, 0}));
  EXPECT_EQ(read.arrays.at("CellData/id").values, (std::vector<double>{-1, std::ldexp(1.0, 40)}));
  EXPECT_EQ(read.arrays.at("FieldData/capillary_pressure").values, std::vector<double>{700.0});
  EXPECT_NE(read.head.find("header_type=\"UInt64\""), std::string::npos);
}

TEST(VtkWriter, PointsWithoutLinesAreCellsOfTheirOwn) {
  VtkPolyData data;
  data.points = {{1, 2, 3}, {4, 5, 6}};
  const VtpReader read(vtp_bytes(data));
  EXPECT_EQ(read.counts.at("NumberOfVerts"), 2);
  EXPECT_EQ(read.arrays.at("Verts/connectivity").values, (std::vector<double>{0, 1}));
  EXPECT_EQ(read.arrays.at("Verts/offsets").values, (std::vector<double>{1, 2}));
}

TEST(VtkWriter, VectorsHaveThreeComponents) {
  VtkPolyData data;
  data.points = {{0, 0, 0}, {1, 0, 0}};
  data.point_data = {{"velocity", std::vector<Vec3>{{1, 2, 3}, {-4, 5e-9, 6}}}};
  const VtpReader file(vtp_bytes(data));
  const auto& velocity = file.arrays.at("PointData/velocity");
  EXPECT_EQ(velocity.type, "Float64");
  EXPECT_EQ(velocity.components, 3);
  EXPECT_EQ(velocity.values, (std::vector<double>{1, 2, 3, -4, 5e-9, 6}));
}

TEST(VtkWriter, WritesNothingAsAnEmptyPiece) {
  const VtpReader read(vtp_bytes({}));
  EXPECT_EQ(read.counts.at("NumberOfPoints"), 0);
  EXPECT_TRUE(read.arrays.at("Points/Points").values.empty());
}

TEST(VtkWriter, SeriesNamesEveryFrameWithItsTime) {
  const std::vector<VtkFrame> frames{{0.0, "pores_00000.vtp"}, {2.5, "pores_00001.vtp"}};
  const std::string text = pvd_text(frames);
  EXPECT_NE(text.find("timestep=\"0\" part=\"0\" file=\"pores_00000.vtp\""), std::string::npos);
  EXPECT_NE(text.find("timestep=\"2.5\" part=\"0\" file=\"pores_00001.vtp\""), std::string::npos);
}

TEST(VtkFields, GrainsAndPoresCarryTheirSizes) {
  const SyntheticRun run = make_synthetic_run(3);
  const VtpReader grains(vtp_bytes(grain_fields(run.state)));
  EXPECT_EQ(grains.arrays.at("PointData/radius").values, run.state.particles.radius);
  const VtpReader pores(vtp_bytes(pore_fields(run.state)));
  EXPECT_EQ(pores.arrays.at("PointData/radius").values, run.state.network.pore_radius);
  EXPECT_EQ(pores.arrays.at("PointData/volume").values, run.state.network.pore_volume);
  EXPECT_EQ(pores.arrays.at("PointData/saturation").values, run.state.saturation);
}

TEST(VtkFields, FluxPointsTheWayOfTheFlow) {
  PoreNetwork n;
  n.pore_centre = {{0.1, 0, 0}, {0.9, 0, 0}};
  n.pore_volume = n.pore_radius = {1, 1};
  n.throat_pores = {{0, 1}, {0, 1}};
  n.throat_shift = {{0, 0, 0}, {-1, 0, 0}};  // the second throat leads the other way, across the face
  n.throat_radius = {0.1, 0.1};
  n.throat_area = {0.5, 0.25};
  const std::vector<double> pressure{3, 1}, flow{2, 2};
  Domain domain;
  domain.upper = {1, 1, 1};
  const VtkPolyData throats = flow_throat_fields({n, pressure, flow}, domain);
  EXPECT_EQ(std::get<std::vector<Vec3>>(throats.cell_data[1].values), (std::vector<Vec3>{{4, 0, 0}, {-8, 0, 0}}));
  EXPECT_EQ(std::get<std::vector<double>>(flow_pore_fields({n, pressure, flow}).point_data[2].values), pressure);
}

TEST(VtkFields, ThroatsJoinTheirPores) {
  SyntheticRun run = make_synthetic_run(2);
  PoreNetwork& n = run.state.network;
  n.throat_shift[1] = {1, 0, -1};  // pore j of throat 1 is an image
  n.throat_entry_radius[2] = 0.0;  // never entered
  run.state.invasion.emplace();
  run.state.invasion->nonwetting.passes.assign(n.throat_pores.size(), 0);
  run.state.invasion->nonwetting.passes[0] = 1;

  const VtpReader read(vtp_bytes(throat_fields(run.state, run.c.fluids)));

  const std::vector<double>& points = read.arrays.at("Points/Points").values;
  const std::vector<double>& radius = read.arrays.at("PointData/radius").values;
  const auto point = [&](int p) { return Vec3{points[to_size(3 * p)], points[to_size(3 * p + 1)], points[to_size(3 * p + 2)]}; };
  for (int t = 0; t < n.throats(); ++t) {
    const auto [i, j] = n.throat_pores[to_size(t)];
    const Vec3 shift = t == 1 ? Vec3{2e-3, 0, -2e-3} : Vec3{};  // the box is two lattice cells of 1 mm wide
    EXPECT_EQ(point(2 * t), n.pore_centre[to_size(i)]);
    EXPECT_LT(norm(point(2 * t + 1) - (n.pore_centre[to_size(j)] + shift)), 1e-15);
    EXPECT_EQ(radius[to_size(2 * t)], n.throat_radius[to_size(t)]);
    EXPECT_EQ(radius[to_size(2 * t + 1)], n.throat_radius[to_size(t)]);
  }
  const std::vector<double>& entry = read.arrays.at("CellData/entry_pressure").values;
  EXPECT_DOUBLE_EQ(entry[0], run.c.fluids.surface_tension / n.throat_entry_radius[0]);
  EXPECT_TRUE(std::isinf(entry[2]));
  EXPECT_EQ(read.arrays.at("CellData/open").values[0], 1.0);
  EXPECT_EQ(read.arrays.at("CellData/open").values[1], 0.0);
}

}  // namespace
}  // namespace puadem
