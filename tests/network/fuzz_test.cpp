#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "puadem/base/error.hpp"
#include "puadem/network/network_checks.hpp"
#include "puadem/network/pore_units.hpp"
#include "support/any_packing.hpp"

using namespace puadem;
using namespace puadem::testing;

namespace {

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

RC_GTEST_PROP(AnyPacking, Random, ()) { expect_sound_or_refused(any_random_packing(), {"too few grains"}); }

RC_GTEST_PROP(AnyPacking, ShakenLattice, ()) { expect_sound_or_refused(any_shaken_lattice()); }

RC_GTEST_PROP(AnyPacking, FewGrains, ()) {
  expect_sound_or_refused(random_spheres(*rc::gen::inRange(1, 6), 1.5, {1, 1, 1}, any_boundary(), any_seed(), 0.12),
                          {"too few grains"});
}

RC_GTEST_PROP(AnyPacking, OneLayer, ()) { expect_sound_or_refused(any_layer()); }

RC_GTEST_PROP(AnyPacking, GrainsAtTheWalls, ()) { expect_sound_or_refused(any_packing_at_walls()); }

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
