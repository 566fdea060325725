#include "puadem/dem/clump.hpp"

#include <cmath>
#include <numbers>

#include "puadem/base/error.hpp"

namespace puadem {

namespace {

constexpr int places_tried = 20;
constexpr int most_places = 20000;
constexpr double gap = 1e-6;  // share of the distance by which neighbours stay apart

Vec3 random_direction(Random& random) {
  const double z = random.uniform(-1, 1), angle = random.uniform(0, 2 * std::numbers::pi), s = std::sqrt(1 - z * z);
  return {s * std::cos(angle), s * std::sin(angle), z};
}

bool fits(std::span<const Vec3> place, std::span<const double> radius, const Vec3& x, double r) {
  for (std::size_t k = 0; k < place.size(); ++k)
    if (norm(place[k] - x) < radius[k] + r) return false;
  return true;
}

}  // namespace

std::vector<Vec3> make_clump(std::span<const double> radius, Random& random) {
  std::vector<Vec3> place;
  for (const double r : radius) {
    Vec3 best;
    bool found = place.empty();
    for (int trial = 0; !place.empty() && (trial < places_tried || !found); ++trial) {
      ensure(trial < most_places, "a clump finds no place for a grain of radius {:.4g} m in {} trials", r, most_places);
      const std::size_t beside = random.below(place.size());
      const Vec3 x = place[beside] + (1.0 + gap) * (radius[beside] + r) * random_direction(random);
      if ((found && norm(x) >= norm(best)) || !fits(place, radius, x, r)) continue;
      best = x;
      found = true;
    }
    place.push_back(best);
  }
  return place;
}

}  // namespace puadem
