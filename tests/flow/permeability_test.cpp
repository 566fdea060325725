#include "puadem/flow/permeability.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "puadem/base/parallel.hpp"
#include "puadem/network/pore_units.hpp"
#include "support/packings.hpp"

using namespace puadem;
using namespace puadem::testing;

namespace {

NetworkOptions unmerged() {
  NetworkOptions options;
  options.merge_ratio = std::numeric_limits<double>::infinity();
  return options;
}

PoreNetwork network_of(const Spheres& s, const NetworkOptions& options = unmerged()) {
  return build_pore_network(s.centre, s.radius, s.domain, options);
}

Permeability permeability_of(const Spheres& s) { return measure_permeability(network_of(s), s.domain); }

void expect_isotropic(const Permeability& k, double value, double tolerance) {
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < 3; ++b) EXPECT_NEAR(k.tensor[to_size(a)][b], a == b ? value : 0.0, tolerance * value) << a << b;
}

/// Axes exchanged: x to y, y to z, z to x.
Spheres turned(Spheres s) {
  const auto turn = [](const Vec3& v) { return Vec3{v.z, v.x, v.y}; };
  for (Vec3& c : s.centre) c = turn(c);
  s.domain.upper = turn(s.domain.upper);
  s.domain.periodic = {s.domain.periodic[2], s.domain.periodic[0], s.domain.periodic[1]};
  return s;
}

}  // namespace

// Lattices of touching spheres of radius 1: k = sum over the throats of a cell in closed form (theory 3.9).
TEST(Permeability, SimpleCubic) {
  // One pore a cube, joined to the next over the two halves of a square window: k = 2 g / (2 R).
  const double window = 2.0 - 0.5 * std::numbers::pi, space = 4.0 / 3.0 - 2.0 * std::numbers::pi / 9.0,
               solid = 2.0 * std::numbers::pi / 3.0;
  const double closed_form = 2.0 * 0.5 * window * std::pow(space / solid, 2) / 2.0 / 2.0;
  EXPECT_NEAR(closed_form, 0.009869824, 0.6e-9);
  for (int cells = 1; cells <= 3; ++cells) expect_isotropic(permeability_of(simple_cubic(1.0, cells)), closed_form, 1e-9);
}

TEST(Permeability, BodyCentredCubic) {
  for (int cells = 1; cells <= 2; ++cells) {
    const Permeability k = permeability_of(body_centred(1.0, cells));
    expect_isotropic(k, 0.002050798, 1e-6);
    EXPECT_LT(k.imbalance, 1e-12);
  }
}

TEST(Permeability, FaceCentredCubic) {
  for (int cells = 1; cells <= 2; ++cells) expect_isotropic(permeability_of(face_centred(1.0, cells)), 6.353184e-4, 1e-6);
}

TEST(Permeability, WallsWithSlipAreMirrorPlanes) {
  // The walls of this box lie where the lattice is its own mirror image, so that they change nothing.
  const double lattice_value = permeability_of(simple_cubic(1.0, 2)).tensor[2].z;
  for (const std::array<bool, 3>& periodic : {std::array{false, false, false}, {true, true, false}, {false, false, true}})
    expect_isotropic(permeability_of(simple_cubic(1.0, 3, periodic)), lattice_value, 1e-9);
}

TEST(Permeability, WallsWithoutSlipTakeTheirShare) {
  const Spheres s = simple_cubic(1.0, 3, {false, false, false});
  NetworkOptions held = unmerged();
  held.no_slip = {true, true, false, false, false, false};  // left and right
  const Permeability slip = permeability_of(s), k = measure_permeability(network_of(s, held), s.domain);
  EXPECT_NEAR(k.tensor[0].x, slip.tensor[0].x, 1e-9 * slip.tensor[0].x);
  EXPECT_LT(k.tensor[1].y, 0.9 * slip.tensor[1].y);
  EXPECT_NEAR(k.tensor[2].z, k.tensor[1].y, 1e-9 * slip.tensor[0].x);
}

TEST(Permeability, PeriodicTensorIsSymmetric) {
  const Permeability k = permeability_of(random_spheres(150, 3.0, {1.0, 1.3, 0.9}, {true, true, true}, 12, 0.35));
  for (int a = 0; a < 3; ++a) {
    EXPECT_GT(k.tensor[to_size(a)][a], 0.0);
    for (int b = 0; b < a; ++b) EXPECT_NEAR(k.tensor[to_size(a)][b], k.tensor[to_size(b)][a], 1e-11 * k.mean());
  }
}

TEST(Permeability, TurnsWithThePacking) {
  const Spheres s = random_spheres(150, 2.0, {1.0, 1.2, 0.8}, {true, false, true}, 3, 0.35);
  const Permeability k = permeability_of(s), t = permeability_of(turned(s));
  const auto to = [](int axis) { return (axis + 1) % 3; };
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < 3; ++b) EXPECT_NEAR(t.tensor[to_size(to(a))][to(b)], k.tensor[to_size(a)][b], 1e-8 * k.mean());
}

TEST(Permeability, ScalesWithTheSquareOfLengths) {
  const Spheres s = random_spheres(100, 2.0, {1, 1, 1}, {true, true, false}, 5, 0.3);
  Spheres small = s;
  const double scale = 2e-4;
  for (Vec3& c : small.centre) c *= scale;
  for (double& r : small.radius) r *= scale;
  small.domain.upper *= scale;
  const Permeability k = permeability_of(s), m = permeability_of(small);
  for (int a = 0; a < 3; ++a) EXPECT_NEAR(m.tensor[to_size(a)][a] / (scale * scale), k.tensor[to_size(a)][a], 1e-8 * k.mean());
}

TEST(Permeability, ARandomPackingIsIsotropicWithinItsNoise) {
  const Spheres s = random_spheres(1000, 1.5, {1, 1, 1}, {true, true, true}, 21, 0.35);
  const Permeability k = permeability_of(s);
  double r2 = 0.0, r3 = 0.0;
  for (const double r : s.radius) {
    r2 += r * r;
    r3 += r * r * r;
  }
  const double reference = kozeny_carman(0.65, r3 / r2);
  for (int a = 0; a < 3; ++a) {
    EXPECT_NEAR(k.tensor[to_size(a)][a] / k.mean(), 1.0, 0.1);
    EXPECT_NEAR(k.tensor[to_size(a)][(a + 1) % 3] / k.mean(), 0.0, 0.1);
  }
  EXPECT_GT(k.mean(), 0.5 * reference);  // which is meant for dense beds
  EXPECT_LT(k.mean(), 3.0 * reference);
}

TEST(Permeability, SameBitsOnAnyNumberOfThreads) {
  const Spheres s = random_spheres(300, 2.0, {1, 1, 1}, {true, false, false}, 8, 0.3);
  const auto tensor = [&](int count) {
    set_threads(count);
    const auto k = permeability_of(s).tensor;
    set_threads(0);
    return k;
  };
  EXPECT_EQ(tensor(1), tensor(2));
}

TEST(Permeability, LimitsAreCountedAndMatterLittle) {
  const Spheres s = random_spheres(300, 2.0, {1, 1, 1}, {true, true, true}, 9, 0.35);
  const PoreNetwork network = network_of(s);
  const Permeability free = measure_permeability(network, s.domain);
  const Permeability limited = measure_permeability(network, s.domain, {}, ConductanceLimits{1e-2, 1e2});
  EXPECT_EQ(free.limited_low + free.limited_high, 0);
  EXPECT_GT(limited.limited_low, 0);
  EXPECT_GT(limited.limited_high, 0);
  EXPECT_NEAR(limited.mean() / free.mean(), 1.0, 0.02);
}

// The numbers of the simple, body-centred and face-centred lattices.
TEST(Permeability, KozenyCarman) {
  EXPECT_NEAR(kozeny_carman(0.4764, 1.0), 8.76e-3, 0.6e-5);
  EXPECT_NEAR(kozeny_carman(0.3198, 1.0), 1.571e-3, 0.6e-6);
  EXPECT_NEAR(kozeny_carman(0.2595, 1.0), 7.08e-4, 0.6e-6);
}
