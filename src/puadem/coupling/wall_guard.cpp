#include "puadem/coupling/wall_guard.hpp"

#include <algorithm>
#include <limits>

#include "puadem/base/error.hpp"

namespace puadem {

void guard_walls(const GrainSystem& grains) {
  for (const Wall& wall : grains.walls) {
    if (!wall.target || wall.stiffness > 0.0) continue;
    double gap = std::numeric_limits<double>::infinity(), largest = 0.0;
    int nearest = -1;
    for (int k = 0; k < grains.owned; ++k) {
      const GrainRecord& r = grains.record[to_size(k)];
      const double distance = dot(vec3(r.place) - wall.point, wall.normal) - radius_of(r);
      largest = std::max(largest, radius_of(r));
      if (distance >= gap) continue;
      gap = distance;
      nearest = grains.identity[to_size(k)];
    }
    ensure(gap <= 2.0 * largest,
           "step {}: the {} wall, which holds {:.4g} Pa, has outrun the packing: the nearest grain, {}, is {:.4g} m away; the "
           "fluid carries all of the stress, or lifts the wall",
           grains.steps, wall.face >= 0 ? face_names[to_size(wall.face)] : "free", *wall.target, nearest, gap);
  }
}

}  // namespace puadem
