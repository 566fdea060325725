#include "puadem/dem/growth.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "puadem/base/error.hpp"

namespace puadem {

void set_radii(GrainSystem& s, std::span<const double> radius) {
  assert(!s.is_evaluated);
  require(size_of(radius) == s.owned, "{} new radii for {} grains", radius.size(), s.owned);
  double growth = 0.0;
  for (int k = 0; k < s.owned; ++k) {
    const int id = s.identity[to_size(k)];
    const double wanted = radius[to_size(id)];
    require(wanted > 0.0 && std::isfinite(wanted), "grain {}: a radius of {} m must be positive", id, wanted);
    GrainRecord& r = s.record[to_size(k)];
    const double ratio = wanted / radius_of(r);
    growth = std::max(growth, wanted - radius_of(r));
    r.place[3] = wanted;
    r.drift[3] *= ratio * ratio * ratio;
    r.spin[3] *= ratio * ratio * ratio * ratio * ratio;
  }
  s.grown += growth;
  s.slack += 2.0 * growth;
}

}  // namespace puadem
