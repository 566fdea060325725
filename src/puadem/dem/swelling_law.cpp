#include "puadem/dem/swelling_law.hpp"

#include <algorithm>
#include <cmath>

namespace puadem {

double swollen_radius(const SwellingLaw& law, double start, double radius, double exposure) {
  const double largest = law.largest_ratio * start;
  // As a growth on top of the radius: over a time step it is near the last digits of the radius itself.
  const double fades = -std::expm1(-3.0 * law.diffusivity * largest / (start * start * start) * exposure);
  return radius + radius * (largest - radius) * fades / (radius + (largest - radius) * (1.0 - fades));
}

double unhindered_share(const SwellingLaw& law, double stress) {
  return law.largest_stress ? std::max(1.0 - stress / *law.largest_stress, 0.0) : 1.0;
}

}  // namespace puadem
