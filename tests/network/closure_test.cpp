#include <gtest/gtest.h>

#include <numeric>

#include "puadem/base/error.hpp"
#include "puadem/network/pore_units.hpp"
#include "support/packings.hpp"

using namespace puadem;
using namespace puadem::testing;

namespace {

PoreNetwork network_of(const Spheres& s, const NetworkOptions& options = {}) {
  return build_pore_network(s.centre, s.radius, s.domain, options);
}

void expect_closed(const Spheres& s, const PoreNetwork& network) {
  const double pores = std::accumulate(network.pore_volume.begin(), network.pore_volume.end(), 0.0);
  EXPECT_NEAR((pores + s.solid_volume()) / s.domain.volume(), 1.0, 1e-12);
  for (const double v : network.pore_volume) EXPECT_GT(v, 0.0);
}

constexpr NetworkOptions unmerged{MayerStowePrincen{}, 0.0, std::numeric_limits<double>::infinity(), 20};

struct Case {
  const char* name;
  std::array<bool, 3> periodic;
};
class Closure : public ::testing::TestWithParam<Case> {};

}  // namespace

TEST_P(Closure, RandomPolydisperse) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const Spheres s = random_spheres(300, 5.0, {1.0, 1.3, 0.9}, GetParam().periodic, seed);
    expect_closed(s, network_of(s));
    expect_closed(s, network_of(s, unmerged));
  }
}

TEST_P(Closure, SimpleCubic) {
  // Spheres touch each other and the walls: everything is degenerate.
  for (const double radius : {1.0, 0.7 * 0.35e-3}) {
    const Spheres s = simple_cubic(radius, 4, GetParam().periodic);
    expect_closed(s, network_of(s));
    expect_closed(s, network_of(s, unmerged));
  }
}

TEST_P(Closure, FewGrains) {
  for (int count = 1; count <= 5; ++count) {
    const Spheres s = random_spheres(count, 1.5, {1.0, 1.0, 1.0}, GetParam().periodic, static_cast<std::uint64_t>(count), 0.15);
    try {
      expect_closed(s, network_of(s));
    } catch (const InputError& e) {
      FAIL() << count << " grains, " << GetParam().name << ": " << e.what();
    }
  }
}

TEST_P(Closure, OverlappingGrains) {
  Spheres s = random_spheres(200, 2.0, {1.0, 1.0, 1.0}, GetParam().periodic, 5);
  for (double& r : s.radius) r *= 1.15;
  for (std::size_t i = 0; i < s.radius.size(); ++i)
    for (int a = 0; a < 3; ++a) ASSERT_TRUE(s.centre[i][a] > 0 || GetParam().periodic[static_cast<unsigned>(a)]);
  expect_closed(s, network_of(s));
}

INSTANTIATE_TEST_SUITE_P(Boundaries, Closure,
                         ::testing::Values(Case{"walls", {false, false, false}}, Case{"periodic", {true, true, true}},
                                           Case{"channel", {true, true, false}}, Case{"pipe", {false, false, true}}),
                         [](const auto& test) { return test.param.name; });

TEST(Closure, BodyAndFaceCentred) {
  for (int cells = 1; cells <= 3; ++cells) {
    const Spheres bcc = body_centred(1.0, cells), fcc = face_centred(1.0, cells);
    expect_closed(bcc, network_of(bcc));
    expect_closed(fcc, network_of(fcc));
    expect_closed(bcc, network_of(bcc, unmerged));
    expect_closed(fcc, network_of(fcc, unmerged));
  }
}
