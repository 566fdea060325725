#include "puadem/io/network_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <numbers>

#include "puadem/base/error.hpp"
#include "puadem/flow/invasion.hpp"
#include "puadem/flow/permeability.hpp"
#include "puadem/network/pore_units.hpp"
#include "support/packings.hpp"
#include "support/temporary_folder.hpp"

using namespace puadem;
using namespace puadem::testing;
using ::testing::HasSubstr;

namespace {

void write(const std::filesystem::path& path, const std::string& text) { std::ofstream(path) << text; }

PoreNetwork packed(const Spheres& s, double merge_ratio = std::numeric_limits<double>::infinity()) {
  NetworkOptions options;
  options.merge_ratio = merge_ratio;
  return build_pore_network(s.centre, s.radius, s.domain, options);
}

double flow_through(const PoreNetwork& network, const Domain& box, int from) {
  SinglePhaseProblem problem;
  problem.viscosity = 1.0;
  problem.faces[to_size(from)] = {FaceCondition::Kind::pressure, 1.0};
  problem.faces[to_size(opposite(from))] = {FaceCondition::Kind::pressure, 0.0};
  SinglePhaseMemory memory;
  return solve_single_phase(network, box, problem, memory).face_inflow[to_size(from)];
}

/// Two pores in a row between the reservoirs, and one that nothing reaches.
void write_chain(const std::filesystem::path& prefix) {
  write(prefix.string() + "_node1.dat",
        "3 3e-4 1e-4 1e-4\n1 1e-4 5e-5 5e-5 2 -1 2 1 0 1 2\n2 2e-4 5e-5 5e-5 2 1 0 0 1 2 3\n3 2e-4 2e-5 5e-5 0 0 0\n");
  write(prefix.string() + "_node2.dat", "1 1e-13 2e-5 0.03 0\n2 2e-13 2e-5 0.0625 0\n3 1e-13 1e-5 0.03 0\n");
  write(prefix.string() + "_link1.dat", "3\n1 -1 1 1e-5 0.03 1e-4\n2 1 2 8e-6 0.079577 1e-4\n3 2 0 1e-5 0.0625 1e-4\n");
  write(prefix.string() + "_link2.dat", "1 -1 1 0 2e-5 8e-5 4e-15 0\n2 1 2 2e-5 2e-5 6e-5 2e-15 0\n3 2 0 2e-5 0 8e-5 0 0\n");
}

}  // namespace

TEST(NetworkFile, StatoilTubesInSeries) {
  const TemporaryFolder folder;
  const auto prefix = folder.path / "chain";
  write_chain(prefix);
  const NetworkFile file = read_statoil_network(prefix);
  const PoreNetwork& n = file.network;
  ASSERT_EQ(n.pores(), 4);  // two, and two reservoirs
  ASSERT_EQ(n.throats(), 3);
  EXPECT_THAT(file.warnings, ::testing::ElementsAre(HasSubstr("1 of 3 pores reach neither inlet nor outlet")));
  EXPECT_EQ(file.box.upper, (Vec3{3e-4, 1e-4, 1e-4}));
  EXPECT_NEAR(n.pore_volume[0], 1e-13 + 0.5 * 4e-15 + 0.5 * 2e-15, 1e-26);
  // Poiseuille: pi r^4 / 8 for the circle, 3/5 and 0.5623 A^2 G for triangle and square.
  const auto area = [](double r, double g) { return r * r / (4 * g); };
  const double triangle_pore = 0.6 * std::pow(area(2e-5, 0.03), 2) * 0.03,
               square_pore = 0.5623 * std::pow(area(2e-5, 0.0625), 2) * 0.0625;
  const double first = 2e-5 / triangle_pore + 8e-5 / (0.6 * std::pow(area(1e-5, 0.03), 2) * 0.03);
  const double second = 2e-5 / triangle_pore + 6e-5 / (std::numbers::pi * std::pow(8e-6, 4) / 8) + 2e-5 / square_pore;
  const double third = 2e-5 / square_pore + 8e-5 / (0.5623 * std::pow(area(1e-5, 0.0625), 2) * 0.0625);
  const double q = 1 / (first + second + third);
  EXPECT_NEAR(flow_through(n, file.box, 0), q, 1e-5 * q);  // of six digits of the circle's shape factor
  // A round tube is entered at 2 gamma / r.
  EXPECT_NEAR(n.throat_entry_radius[1], 4e-6, 1e-10);
}

TEST(NetworkFile, StatoilKeepsTheFlowOfAPacking) {
  const Spheres s = random_spheres(80, 1.5, {1.0, 1.1, 0.9}, {false, false, false}, 3, 0.3);
  const PoreNetwork network = packed(s);
  const TemporaryFolder folder;
  for (const int inlet : {0, 3, 4}) {
    write_statoil_network(folder.path / "bed", network, s.domain, inlet);
    const NetworkFile file = read_statoil_network(folder.path / "bed");
    EXPECT_TRUE(file.warnings.empty());
    EXPECT_EQ(file.network.pores(), network.pores() + 2);
    const double q = flow_through(network, s.domain, inlet);
    EXPECT_NEAR(flow_through(file.network, file.box, 0), q, 1e-4 * q) << inlet;
    EXPECT_NEAR(file.box.upper.x, s.domain.size()[axis_of(inlet)], 1e-15);
  }
}

TEST(NetworkFile, TablesKeepEveryBit) {
  for (const std::array<bool, 3>& periodic : {std::array{false, false, false}, {true, true, true}}) {
    const Spheres s = random_spheres(60, 1.5, {1.0, 1.1, 0.9}, periodic, 3, 0.3);
    const PoreNetwork network = packed(s, 0.9);
    const TemporaryFolder folder;
    write_csv_network(folder.path / "network.csv", network, s.domain);
    const NetworkFile file = read_csv_network(folder.path / "network.csv");
    EXPECT_TRUE(file.warnings.empty());
    EXPECT_EQ(file.box, s.domain);
    EXPECT_EQ(file.network.pore_centre, network.pore_centre);
    EXPECT_EQ(file.network.pore_volume, network.pore_volume);
    EXPECT_EQ(file.network.pore_radius, network.pore_radius);
    EXPECT_EQ(file.network.pore_faces, network.pore_faces);
    EXPECT_EQ(file.network.pore_walls, network.pore_walls);
    EXPECT_EQ(file.network.pore_throats, network.pore_throats);
    EXPECT_EQ(file.network.throat_pores, network.throat_pores);
    EXPECT_EQ(file.network.throat_shift, network.throat_shift);
    EXPECT_EQ(file.network.throat_area, network.throat_area);
    EXPECT_EQ(file.network.throat_length, network.throat_length);
    EXPECT_EQ(file.network.throat_conductance, network.throat_conductance);
    EXPECT_EQ(file.network.throat_radius, network.throat_radius);
    EXPECT_EQ(file.network.throat_entry_radius, network.throat_entry_radius);
    EXPECT_EQ(file.network.throat_snap_off_radius, network.throat_snap_off_radius);
    const Permeability k = measure_permeability(network, s.domain), back = measure_permeability(file.network, file.box);
    EXPECT_EQ(k.tensor, back.tensor);
  }
}

TEST(NetworkFile, ATableOfTubesIsEnough) {
  const TemporaryFolder folder;
  write(
      folder.path / "tubes.csv",
      "pore.coords[0],pore.coords[1],pore.coords[2],pore.volume,pore.left,pore.right,pore.colour,throat.conns[0],throat.conns[1],"
      "throat.diameter,throat.length\n"
      "0,0,0,1,True,False,3,0,1,0.2,1\n1,1,0,1,False,False,3,2,1,0.4,2\n2,0,1,1,False,True,3,,,,\n");
  const NetworkFile file = read_csv_network(folder.path / "tubes.csv");
  EXPECT_THAT(file.warnings, ::testing::ElementsAre(HasSubstr("the column \"pore.colour\" is not read")));
  EXPECT_EQ(file.box.upper, (Vec3{2, 1, 1}));
  const double a = std::numbers::pi * std::pow(0.1, 4) / 8, b = std::numbers::pi * std::pow(0.2, 4) / 16;
  EXPECT_NEAR(flow_through(file.network, file.box, 0), a * b / (a + b), 1e-15);
  EXPECT_EQ(file.network.throat_entry_radius[0], 0.05);
}

TEST(NetworkFile, ANetworkFromAFileDrains) {
  const Spheres s = random_spheres(150, 1.5, {1, 1, 1}, {false, false, false}, 9, 0.3);
  const TemporaryFolder folder;
  write_csv_network(folder.path / "network.csv", packed(s, 0.9), s.domain);
  const PoreNetwork network = read_csv_network(folder.path / "network.csv").network;
  const Fluids fluids;
  InvasionState ours = start_invasion(packed(s, 0.9), fluids, {}), file = start_invasion(network, fluids, {});
  EXPECT_EQ(ours.void_volume, file.void_volume);
}

TEST(NetworkFile, MessagesNameFileLineAndWhatIsAllowed) {
  const TemporaryFolder folder;
  const auto prefix = folder.path / "chain";
  const auto message = [&](const auto& read) -> std::string {
    try {
      read();
    } catch (const InputError& e) {
      return e.what();
    }
    return "no error";
  };
  const auto statoil = [&] { read_statoil_network(prefix); };
  EXPECT_THAT(message(statoil), HasSubstr("chain_node1.dat"));
  write_chain(prefix);
  write(prefix.string() + "_link1.dat", "3\n1 -1 1 1e-5 0.03 1e-4\n2 1 7 8e-6 0.08 1e-4\n");
  EXPECT_THAT(message(statoil),
              HasSubstr("chain_link1.dat:3: a pore of the throat (-1: inlet, 0: outlet) is 7: allowed are -1 to 3"));
  write(prefix.string() + "_link1.dat", "3\n1 -1 1 1e-5 0.03 1e-4\n");
  EXPECT_THAT(message(statoil), HasSubstr("the file ends before throat 2 of 3"));
  write(prefix.string() + "_link1.dat", "3\n1 -1 1 wide 0.03 1e-4\n");
  EXPECT_THAT(message(statoil), HasSubstr("the radius is \"wide\", which is no number"));

  const auto csv = folder.path / "network.csv";
  const auto table = [&] { read_csv_network(csv); };
  write(csv, "pore.coord[0],pore.volume\n1,1\n");
  EXPECT_THAT(message(table), HasSubstr("a column \"pore.coords[0]\" is needed"));
  write(csv,
        "pore.coords[0],pore.coords[1],pore.coords[2],pore.volume,throat.conns[0],throat.conns[1],throat.diameter,throat.length\n"
        "0,0,0,1,0,5,1,1\n1,1,1,1,,,,\n");
  EXPECT_THAT(message(table), HasSubstr("\"throat.conns[1]\" holds 5: allowed are whole numbers from 0 to 1"));
  write(csv, "pore.coords[0],pore.coords[1],pore.coords[2],pore.volume\n0,0,0\n");
  EXPECT_THAT(message(table), HasSubstr("network.csv:2: 3 values under 4 headings"));

  const Spheres s = random_spheres(20, 1.5, {1, 1, 1}, {true, true, true}, 3, 0.2);
  EXPECT_THAT(message([&] { write_statoil_network(prefix, packed(s), s.domain, 0); }), HasSubstr("periodic"));
}
