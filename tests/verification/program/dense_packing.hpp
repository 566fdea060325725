#pragma once

#include <array>
#include <cstdint>

#include "support/packings.hpp"

namespace puadem::verification {

/// Grains of 0.8 to 1.2 mm, packed without friction at 10 kPa: as dense as a random packing gets.
testing::Spheres dense_packing(int count, const Vec3& shape, const std::array<bool, 3>& periodic, int seed);

/// Lengths `by` times as large.
testing::Spheres scaled(testing::Spheres s, double by);

/// The same grains in another order.
testing::Spheres shuffled(testing::Spheres s, std::uint64_t seed);

}  // namespace puadem::verification
