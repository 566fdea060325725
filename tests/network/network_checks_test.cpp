#include "puadem/network/network_checks.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "puadem/network/pore_units.hpp"
#include "support/packings.hpp"

using namespace puadem;
using namespace puadem::testing;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

namespace {

const Spheres& sample() {
  static const Spheres s = random_spheres(60, 2.0, {1, 1, 1}, {true, false, true}, 5);
  return s;
}

/// All faults of the sample's network after `harm` has been done to it, in one text.
template <class Harm>
std::string faults_after(const Harm& harm) {
  PoreNetwork network = build_pore_network(sample().centre, sample().radius, sample().domain, {});
  harm(network);
  std::string text;
  for (const std::string& fault : find_network_faults(network, sample().centre, sample().radius, sample().domain))
    text += fault + "\n";
  return text;
}

}  // namespace

TEST(NetworkChecks, NetworksOfPackingsAreSound) {
  EXPECT_EQ(faults_after([](PoreNetwork&) {}), "");
  for (const std::array<bool, 3>& periodic : {std::array{false, false, false}, {true, true, true}})
    for (const Spheres& s : {random_spheres(5, 1.5, {1, 1, 1}, periodic, 3, 0.15), simple_cubic(1.0, 2, periodic)})
      EXPECT_THAT(find_network_faults(build_pore_network(s.centre, s.radius, s.domain, {}), s.centre, s.radius, s.domain),
                  IsEmpty());
}

TEST(NetworkChecks, NameEveryFault) {
  EXPECT_THAT(faults_after([](PoreNetwork& n) { n.pore_volume[7] *= 1.001; }), HasSubstr("miss the volume of the box by"));
  const std::string nil = faults_after([](PoreNetwork& n) { n.pore_volume[7] = 0.0; });
  EXPECT_THAT(nil, HasSubstr("pore 7 at ("));
  EXPECT_THAT(nil, HasSubstr(", among "));
  EXPECT_THAT(nil, HasSubstr("has the volume 0 m3"));
  EXPECT_THAT(faults_after([](PoreNetwork& n) {
                n.throat_pores[4] = {-1, 2};
              }),
              HasSubstr("throat 4 leads from pore -1 to pore 2"));
  EXPECT_THAT(faults_after([](PoreNetwork& n) { std::swap(n.pore_throats.index[0], n.pore_throats.index.back()); }),
              HasSubstr("which does not lead to it"));
  EXPECT_THAT(faults_after([](PoreNetwork& n) {
                for (const int t : n.pore_throats[9]) n.throat_conductance[to_size(t)] = 0.0;
              }),
              HasSubstr("pore 9 at ("));
  EXPECT_THAT(faults_after([](PoreNetwork& n) {
                for (auto& cell : n.triangulation.vertices)
                  for (Vertex& v : cell)
                    if (v.index == 11) v.index = 12;
              }),
              HasSubstr("grain 11 at ("));
  EXPECT_THAT(faults_after([](PoreNetwork& n) { n.triangulation.neighbours[20][1].shift[0] ^= 1; }),
              HasSubstr("is not a facet of its neighbour"));
}

TEST(NetworkChecks, AnEmptyNetworkIsAFault) {
  EXPECT_THAT(find_network_faults({}), ::testing::ElementsAre(HasSubstr("no pores")));
}
