#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>

#include "puadem/flow/permeability.hpp"
#include "puadem/network/pore_units.hpp"
#include "support/any_packing.hpp"

using namespace puadem;
using namespace puadem::testing;

namespace {

/// A permeability that conserves fluid and has a sign, or an error that says why there is none.
void expect_permeable_or_refused(const Spheres& s) {
  const std::array<std::string, 2> refusals{"too few grains", "use more grains between the two"};
  NetworkOptions options;
  options.merge_ratio = std::numeric_limits<double>::infinity();
  try {
    const Permeability k = measure_permeability(build_pore_network(s.centre, s.radius, s.domain, options), s.domain);
    RC_ASSERT(k.imbalance < 1e-10);
    bool is_periodic = true;
    for (int a = 0; a < 3; ++a) {
      RC_ASSERT(std::isfinite(k.mean()));
      RC_ASSERT(k.tensor[to_size(a)][a] > 0.0);
      is_periodic = is_periodic && s.domain.periodic[to_size(a)];
    }
    if (!is_periodic) return;
    // Throats of 1e-9 radii leave their neighbours few digits in the sums of the matrix.
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < a; ++b) RC_ASSERT(std::abs(k.tensor[to_size(a)][b] - k.tensor[to_size(b)][a]) < 1e-4 * k.mean());
  } catch (const std::runtime_error& e) {
    const std::string message = e.what();
    for (const std::string& words : refusals)
      if (message.find(words) != std::string::npos) return;
    RC_FAIL(message);
  }
}

}  // namespace

RC_GTEST_PROP(AnyPermeability, Random, ()) { expect_permeable_or_refused(any_random_packing()); }

RC_GTEST_PROP(AnyPermeability, ShakenLattice, ()) { expect_permeable_or_refused(any_shaken_lattice()); }

RC_GTEST_PROP(AnyPermeability, GrainsAtTheWalls, ()) { expect_permeable_or_refused(any_packing_at_walls()); }

RC_GTEST_PROP(AnyPermeability, OneLayer, ()) { expect_permeable_or_refused(any_layer()); }
