#include "puadem/dem/growth.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "puadem/base/error.hpp"

namespace puadem {

namespace {

/// @param mass_of  its new mass, from a grain's identity, its mass so far and the ratio of the radii
template <class Mass>
void give_sizes(GrainSystem& s, std::span<const double> radius, const Mass& mass_of) {
  assert(!s.is_evaluated);
  require(size_of(radius) == s.owned, "{} new radii for {} grains", radius.size(), s.owned);
  double growth = 0.0;
  for (int k = 0; k < s.owned; ++k) {
    const int id = s.identity[to_size(k)];
    const double wanted = radius[to_size(id)];
    require(wanted > 0.0 && std::isfinite(wanted), "grain {}: a radius of {} m must be positive", id, wanted);
    GrainRecord& r = s.record[to_size(k)];
    const double ratio = wanted / radius_of(r), mass = mass_of(id, puadem::mass_of(r), ratio);
    growth = std::max(growth, wanted - radius_of(r));
    r.place[3] = wanted;
    r.spin[3] *= mass / puadem::mass_of(r) * ratio * ratio;
    r.drift[3] = mass;
  }
  s.grown += growth;
  s.slack += 2.0 * growth;
}

}  // namespace

void set_radii(GrainSystem& s, std::span<const double> radius) {
  give_sizes(s, radius, [](int, double mass, double ratio) { return mass * ratio * ratio * ratio; });
}

void set_radii(GrainSystem& s, std::span<const double> radius, std::span<const double> mass) {
  require(size_of(mass) == s.owned, "{} new masses for {} grains", mass.size(), s.owned);
  give_sizes(s, radius, [&](int id, double, double) {
    require(mass[to_size(id)] > 0.0 && std::isfinite(mass[to_size(id)]), "grain {}: a mass of {} kg must be positive", id,
            mass[to_size(id)]);
    return mass[to_size(id)];
  });
}

}  // namespace puadem
