#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "puadem/base/error.hpp"
#include "puadem/network/network_checks.hpp"
#include "puadem/network/pore_units.hpp"
#include "support/packings.hpp"

using namespace puadem;
using namespace puadem::testing;

namespace {

/// The same cases in every run; RC_PARAMS in the environment asks for others.
[[maybe_unused]] const int fixed_cases = setenv("RC_PARAMS", "seed=1 max_success=60", 0);

std::array<bool, 3> any_boundary() {
  const int bits = *rc::gen::inRange(0, 8);
  return {(bits & 1) != 0, (bits & 2) != 0, (bits & 4) != 0};
}

std::uint64_t any_seed() { return static_cast<std::uint64_t>(*rc::gen::inRange(1, 1 << 30)); }

NetworkOptions any_options() {
  NetworkOptions options;
  if (*rc::gen::arbitrary<bool>()) options.entry_law = Haines{};
  options.contact_angle = *rc::gen::element(0.0, 0.3, 1.0);
  options.merge_ratio = *rc::gen::element(0.5, 0.9, std::numeric_limits<double>::infinity());
  options.merge_criterion = *rc::gen::element(MergeCriterion::entry_ratio, MergeCriterion::insphere_overlap);
  options.pore_shape = *rc::gen::element(PoreShape::faces, PoreShape::vertices);
  options.throat_section = *rc::gen::element(ThroatOutline::facet, ThroatOutline::window);
  return options;
}

/// Moves every grain by at most `amplitude`, inside the box.
Spheres shaken(Spheres s, double amplitude, std::uint64_t seed) {
  Random random(seed);
  for (Vec3& c : s.centre)
    for (int axis = 0; axis < 3; ++axis) {
      const double to = c[axis] + random.uniform(-amplitude, amplitude);
      if (to > s.domain.lower[axis] && to < s.domain.upper[axis]) c[axis] = to;
    }
  return s;
}

/// A network without a fault, or a fault or an error that says what is wrong with the grains.
/// @param refusals  what those may say; empty: the packing must be accepted
void expect_sound_or_refused(const Spheres& s, const std::vector<std::string>& refusals = {}) {
  const NetworkOptions options = any_options();
  const auto judge = [&](const std::string& message) {
    if (std::ranges::none_of(refusals, [&](const std::string& words) { return message.find(words) != std::string::npos; }))
      RC_FAIL(message);
  };
  try {
    const PoreNetwork network = build_pore_network(s.centre, s.radius, s.domain, options);
    for (const std::string& fault : find_network_faults(network, s.centre, s.radius, s.domain)) judge(fault);
    for (int t = 0; t < network.throats(); ++t) {
      RC_ASSERT(network.throat_conductance[to_size(t)] >= 0.0);
      RC_ASSERT(network.throat_entry_radius[to_size(t)] >= 0.0);
      RC_ASSERT(std::isfinite(network.throat_entry_radius[to_size(t)]));
      RC_ASSERT(std::isfinite(network.throat_length[to_size(t)]));
    }
  } catch (const std::runtime_error& e) {
    judge(e.what());
  }
}

}  // namespace

RC_GTEST_PROP(AnyPacking, Random, ()) {
  const double ratio = *rc::gen::element(1.0, 2.0, 5.0, 20.0);
  expect_sound_or_refused(
      random_spheres(*rc::gen::inRange(6, 60), ratio, {1.0, 1.2, 0.9}, any_boundary(), any_seed(), *rc::gen::element(0.03, 0.1)),
      {"too few grains"});
}

RC_GTEST_PROP(AnyPacking, ShakenLattice, ()) {
  const int cells = *rc::gen::inRange(1, 4);
  const double amplitude = std::pow(10.0, -*rc::gen::inRange(2, 17));
  const int kind = *rc::gen::inRange(0, 3);
  const Spheres lattice = kind == 0   ? simple_cubic(1.0, cells, any_boundary())
                          : kind == 1 ? body_centred(1.0, cells)
                                      : face_centred(1.0, cells);
  expect_sound_or_refused(shaken(lattice, amplitude, any_seed()));
}

RC_GTEST_PROP(AnyPacking, FewGrains, ()) {
  expect_sound_or_refused(random_spheres(*rc::gen::inRange(1, 6), 1.5, {1, 1, 1}, any_boundary(), any_seed(), 0.12),
                          {"too few grains"});
}

RC_GTEST_PROP(AnyPacking, OneLayer, ()) {
  // All centres in a plane that may lie anywhere between two walls; some on a line.
  const Spheres flat = random_spheres(*rc::gen::inRange(3, 25), 1.5, {1, 1, 1}, {false, false, false}, any_seed(), 0.05);
  Spheres s = flat;
  const double height = *rc::gen::element(0.5, 0.2, 0.9);
  const bool line = *rc::gen::arbitrary<bool>();
  for (std::size_t i = 0; i < s.centre.size(); ++i) {
    s.centre[i].z = height;
    if (line) s.centre[i] = {(static_cast<double>(i) + 0.5) / static_cast<double>(s.centre.size()), 0.5, height};
    s.radius[i] = 0.4 / static_cast<double>(s.centre.size());
  }
  expect_sound_or_refused(s);
}

RC_GTEST_PROP(AnyPacking, GrainsAtTheWalls, ()) {
  // Grains that touch one wall, two or three, exactly: sites of one plane with the wall, and of one line with an edge.
  Spheres s = random_spheres(*rc::gen::inRange(1, 40), *rc::gen::element(1.0, 3.0, 20.0), {1, 1, 1}, {false, false, false},
                             any_seed(), 0.05);
  const Spheres loose = s;
  s.centre.clear();
  s.radius.clear();
  for (std::size_t i = 0; i < loose.centre.size(); ++i) {
    Vec3 c = loose.centre[i];
    const double r = loose.radius[i];
    for (int axis = 0; axis < 3; ++axis)
      if (const int to = *rc::gen::inRange(0, 4); to < 2) c[axis] = to == 0 ? r : 1.0 - r;
    bool is_free = true;
    for (std::size_t k = 0; k < s.centre.size(); ++k) is_free = is_free && norm(c - s.centre[k]) > r + s.radius[k];
    if (!is_free) continue;
    s.centre.push_back(c);
    s.radius.push_back(r);
  }
  expect_sound_or_refused(s);
}

RC_GTEST_PROP(AnyPacking, Overlapping, ()) {
  Spheres s = random_spheres(*rc::gen::inRange(6, 60), 2.0, {1, 1, 1}, any_boundary(), any_seed(), 0.1);
  const double growth = *rc::gen::element(1.2, 1.5, 2.0, 3.5);
  for (double& r : s.radius) r *= growth;
  expect_sound_or_refused(s, {"is hidden", "too few grains", "overlap too far", "are cut off from the rest"});
}

TEST(AnyPacking, NearTiesBetweenWallsAreCutAlikeForAllImages) {
  // Shaken by some steps of the finest grid of the predicates: a quarter of these tie but for the walls' curvature.
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Spheres s = shaken(simple_cubic(1.0, 3, {true, false, false}), 1e-11, seed);
    EXPECT_NO_THROW(build_pore_network(s.centre, s.radius, s.domain, {})) << seed;
  }
}

TEST(AnyPacking, EmptyIsRefused) { EXPECT_THROW(build_pore_network({}, {}, Domain{}, {}), InputError); }
