#include "dense_packing.hpp"

#include "puadem/base/random.hpp"
#include "puadem/dem/packing.hpp"

namespace puadem::verification {

using testing::Spheres;

Spheres dense_packing(int count, const Vec3& shape, const std::array<bool, 3>& periodic, int seed) {
  const Material grains{.name = "grains", .density = 2650, .youngs_modulus = 2e8, .poisson_ratio = 0.2};
  PackingSource source;
  source.grading.classes = {{0.8e-3, 1.2e-3, 1.0}};
  source.count = count;
  source.shape = shape;
  source.periodic = periodic;
  source.seed = static_cast<std::uint64_t>(seed);
  CompactionOptions compaction;
  compaction.friction_angle = 0.0;
  compaction.unbalanced = 5e-3;
  const Packing packing = make_packing(source, std::span(&grains, 1), {}, compaction);
  return {packing.particles.position, packing.particles.radius, packing.domain};
}

Spheres scaled(Spheres s, double by) {
  for (Vec3& c : s.centre) c *= by;
  for (double& r : s.radius) r *= by;
  s.domain.lower *= by;
  s.domain.upper *= by;
  return s;
}

Spheres shuffled(Spheres s, std::uint64_t seed) {
  Random random(seed);
  for (std::size_t i = s.centre.size(); i > 1; --i) {
    const auto j = std::min(i - 1, static_cast<std::size_t>(random.uniform() * static_cast<double>(i)));
    std::swap(s.centre[i - 1], s.centre[j]);
    std::swap(s.radius[i - 1], s.radius[j]);
  }
  return s;
}

}  // namespace puadem::verification
