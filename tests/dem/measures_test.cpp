// Fabric, rattlers and the stress of single grains.

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "puadem/dem/contacts.hpp"
#include "puadem/dem/fabric.hpp"
#include "puadem/dem/grain_stress.hpp"
#include "puadem/dem/motion.hpp"
#include "puadem/dem/packing.hpp"
#include "support.hpp"

namespace puadem {
namespace {

TEST(Tensor, PrincipalValuesAreThoseOfARotatedDiagonal) {
  Random random(3);
  for (int trial = 0; trial < 50; ++trial) {
    const auto any = [&] { return random.uniform(-1, 1); };
    const Vec3 u = normalized({any(), any(), any()}), v = normalized(cross(u, {any(), any(), any()})), w = cross(u, v);
    const Vec3 values{7.0, trial % 3 == 0 ? 7.0 : any(), -2.0};
    Tensor t{};
    add_outer(t, values.x * u, u);
    add_outer(t, values.y * v, v);
    add_outer(t, values.z * w, w);
    t[0].y += 0.3;  // an antisymmetric part does not count
    t[1].x -= 0.3;
    const Vec3 found = principal_values(t);
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(found[k], values[k], 1e-13);
    const double mean = trace(t) / 3, q = deviatoric_invariant(t);
    EXPECT_NEAR(q * q, 1.5 * (squared_norm(values) - 3 * mean * mean), 1e-11);
  }
}

TEST(Tensor, DeviatorInvariantIsTheStressDifferenceOfATriaxialTest) {
  EXPECT_NEAR(deviatoric_invariant({Vec3{100, 0, 0}, {0, 100, 0}, {0, 0, 340}}), 240, 1e-12);
  EXPECT_EQ(deviatoric_invariant({Vec3{5, 0, 0}, {0, 5, 0}, {0, 0, 5}}), 0.0);
}

/// Spheres of one size that touch on a lattice, in a periodic box, pressed together by a share of their radius.
GrainSystem lattice(const std::vector<Vec3>& cell, double edge, int n, double radius) {
  const Material m = test::material(1e8, 0.3, 2500);
  std::vector<Vec3> place;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      for (int k = 0; k < n; ++k)
        for (const Vec3& x : cell) place.push_back(edge * (Vec3{1.0 * i, 1.0 * j, 1.0 * k} + x));
  Domain box{{0, 0, 0}, {n * edge, n * edge, n * edge}, {true, true, true}};
  GrainSystem s =
      make_grain_system(make_particles(place, std::vector<double>(place.size(), radius), m), box, std::span(&m, 1), {}, {});
  evaluate_forces(s);
  return s;
}

TEST(Fabric, OfLatticesIsIsotropicWithTheirCoordination) {
  const GrainSystem cubic = lattice({{0.25, 0.25, 0.25}}, 2e-3, 4, 1.001e-3);
  const GrainSystem faces =
      lattice({{0.1, 0.1, 0.1}, {0.6, 0.6, 0.1}, {0.6, 0.1, 0.6}, {0.1, 0.6, 0.6}}, 2e-3 * std::sqrt(2.0), 3, 1.001e-3);
  for (const auto& [s, contacts] : {std::pair{&cubic, 6}, std::pair{&faces, 12}}) {
    const FabricMeasures m = measure_fabric(*s);
    for (unsigned a = 0; a < 3; ++a)
      for (int b = 0; b < 3; ++b) EXPECT_NEAR(m.fabric[a][b], a == static_cast<unsigned>(b) ? 1.0 / 3 : 0.0, 1e-12);
    EXPECT_NEAR(m.deviatoric, 0.0, 1e-11);
    EXPECT_NEAR(m.coordination, contacts, 1e-12);
    EXPECT_NEAR(m.coordination_mechanical, contacts, 1e-12);
    EXPECT_NEAR(m.coordination_backbone, contacts, 1e-12);
    EXPECT_EQ(m.rattlers, 0.0);
    for (const double moment : m.force_moment) EXPECT_NEAR(moment, 1.0, 1e-9);
  }
}

TEST(Fabric, OfOneDirectionIsTheMostAnisotropic) {
  const Material m = test::material(1e8, 0.3, 2500);
  GrainSystem s = test::free_grains(
      make_particles(std::vector<Vec3>{{0, 0, 0}, {0, 1.99e-3, 0}}, std::vector<double>{1e-3, 1e-3}, m), m, {}, 0.1);
  evaluate_forces(s);
  const FabricMeasures f = measure_fabric(s);
  EXPECT_NEAR(f.fabric[1].y, 1.0, 1e-12);
  EXPECT_NEAR(f.deviatoric, 7.5, 1e-10);
}

/// Four grains that all touch one another, a chain of three that hangs on one of them, and one on its own.
GrainSystem cluster_with_chain(double friction) {
  const Material m = test::material(1e8, 0.3, 2500, friction);
  const double a = 1.99e-3 / std::sqrt(2.0);
  std::vector<Vec3> place{{0, 0, 0}, {a, a, 0}, {a, 0, a}, {0, a, a}};
  for (int k = 1; k <= 3; ++k)
    place.push_back({-1.99e-3 / std::sqrt(3.0) * k, -1.99e-3 / std::sqrt(3.0) * k, -1.99e-3 / std::sqrt(3.0) * k});
  place.push_back({0.05, 0.05, 0.05});
  GrainSystem s = test::free_grains(make_particles(place, std::vector<double>(8, 1e-3), m), m, {}, 0.1);
  evaluate_forces(s);
  return s;
}

// With friction the chain falls off link by link; without, no grain of the cluster has the four contacts it needs.
TEST(Rattlers, AreTakenAwayUntilNoneIsLeft) {
  const FabricMeasures rough = measure_fabric(cluster_with_chain(0.5));
  EXPECT_DOUBLE_EQ(rough.rattlers, 4.0 / 8);
  EXPECT_DOUBLE_EQ(rough.coordination_backbone, 3.0);
  EXPECT_DOUBLE_EQ(rough.coordination, 18.0 / 8);
  EXPECT_DOUBLE_EQ(rough.coordination_mechanical, (18.0 - 1) / (8 - 1 - 1));
  const FabricMeasures smooth = measure_fabric(cluster_with_chain(0.0));
  EXPECT_DOUBLE_EQ(smooth.rattlers, 1.0);
  EXPECT_DOUBLE_EQ(smooth.coordination_backbone, 0.0);
}

PackingSource sand(std::array<bool, 3> periodic) {
  PackingSource source;
  source.grading = {Grading::By::mass, {{1.0e-3, 2.5e-3, 1.0}}};
  source.count = 300;
  source.shape = {1, 1.2, 0.9};
  source.periodic = periodic;
  source.seed = 11;
  return source;
}

class OfAPacking : public ::testing::TestWithParam<std::array<bool, 3>> {
 protected:
  static GrainSystem pack() {
    ContactOptions contact;
    contact.wall_friction = 0.3;
    return *make_packing(sand(GetParam()), std::vector<Material>(1), contact, {}).system;
  }
};

TEST_P(OfAPacking, RattlersAreThoseOfASlowCount) {
  const GrainSystem s = pack();
  std::vector<Contact> contacts = contacts_of(s);
  std::vector<char> is_rattler(to_size(s.owned), 0);
  for (bool changed = true; changed;) {
    changed = false;
    std::vector<int> count(to_size(s.owned), 0);
    for (const Contact& c : contacts) {
      if (c.first >= 0) ++count[to_size(c.first)];
      ++count[to_size(c.second)];
    }
    for (int k = 0; k < s.owned; ++k)
      if (count[to_size(k)] < 2 && is_rattler[to_size(k)] == 0) is_rattler[to_size(k)] = 1, changed = true;
    std::erase_if(contacts, [&](const Contact& c) {
      return is_rattler[to_size(c.second)] != 0 || (c.first >= 0 && is_rattler[to_size(c.first)] != 0);
    });
  }
  const GrainContacts found = count_contacts(s);
  for (int k = 0; k < s.owned; ++k) EXPECT_EQ(found.is_rattler[to_size(k)], is_rattler[to_size(s.identity[to_size(k)])]);
  long ends = 0;
  for (const Contact& c : contacts) ends += c.first >= 0 ? 2 : 1;
  EXPECT_EQ(found.backbone_ends, ends);
  EXPECT_GT(found.rattlers, 0);
}

TEST_P(OfAPacking, StressesOfGrainsAddToThatOfTheBox) {
  const GrainSystem s = pack();
  const GrainStresses g = grain_stresses(s);
  const GrainMeasures m = measure(s);
  EXPECT_NEAR(std::accumulate(g.volume.begin(), g.volume.end(), 0.0), s.domain.volume(), 1e-12 * s.domain.volume());
  Tensor mean{};
  for (std::size_t k = 0; k < g.volume.size(); ++k)
    for (unsigned a = 0; a < 3; ++a) mean[a] += g.volume[k] / s.domain.volume() * g.stress[k][a];
  for (unsigned a = 0; a < 3; ++a)
    for (int b = 0; b < 3; ++b) EXPECT_NEAR(mean[a][b], m.stress[a][b], 1e-12 * m.mean_stress);
  // A power cell holds its grain but for overlaps.
  for (int k = 0; k < s.owned; ++k) {
    const double r = radius_of(s.record[to_size(k)]);
    EXPECT_GT(g.volume[to_size(s.identity[to_size(k)])], 0.97 * 4.0 / 3.0 * std::numbers::pi * r * r * r);
  }
}

// One grain by hand: forces at the middles of its overlaps, about its centre.
TEST_P(OfAPacking, StressOfAGrainIsTheSumOverItsContacts) {
  const GrainSystem s = pack();
  const GrainStresses g = grain_stresses(s);
  std::vector<double> radius(to_size(s.owned));
  for (int k = 0; k < s.owned; ++k) radius[to_size(s.identity[to_size(k)])] = radius_of(s.record[to_size(k)]);
  for (const int grain : {0, 17, 299}) {
    Tensor sum{};
    int contacts = 0;
    for (const Contact& c : contacts_of(s)) {
      if (c.first != grain && c.second != grain) continue;
      ++contacts;
      const double length = norm(c.branch);
      const double overlap =
          c.wall >= 0 ? 2 * (radius[to_size(grain)] - length) : radius[to_size(c.first)] + radius[to_size(c.second)] - length;
      const Vec3 to_contact =  // from the centre
          (c.second == grain ? -1.0 : 1.0) * (radius[to_size(grain)] - 0.5 * overlap) / length * c.branch;
      add_outer(sum, c.second == grain ? -1.0 * c.force : c.force, to_contact);
    }
    EXPECT_EQ(g.contacts[to_size(grain)], contacts);
    for (unsigned a = 0; a < 3; ++a)
      for (int b = 0; b < 3; ++b)
        EXPECT_NEAR(g.stress[to_size(grain)][a][b], sum[a][b] / g.volume[to_size(grain)], 1e-9 * (1.0 + g.mean[to_size(grain)]));
  }
}

INSTANTIATE_TEST_SUITE_P(Boxes, OfAPacking,
                         ::testing::Values(std::array{false, false, false}, std::array{true, true, false},
                                           std::array{true, true, true}));

TEST(Fabric, CountsContactsThatSlide) {
  const Material m = test::material(1e8, 0.3, 2500, 0.2);
  Particles p = make_particles(std::vector<Vec3>{{0, 0, 0}, {1.99e-3, 0, 0}}, std::vector<double>{1e-3, 1e-3}, m);
  p.velocity[1].y = 1.0;
  GrainSystem s = test::free_grains(p, m, {}, 0.1);
  s.time_step = 1e-8;
  advance_grains(s, 1);
  evaluate_forces(s);
  EXPECT_EQ(measure_fabric(s).sliding, 0.0);
  s.time_step = 1e-6;
  advance_grains(s, 20);
  evaluate_forces(s);
  EXPECT_EQ(measure_fabric(s).sliding, 1.0);
}

}  // namespace
}  // namespace puadem
