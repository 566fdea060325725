#include "puadem/coupling/wall_guard.hpp"

#include <algorithm>
#include <limits>

#include "puadem/base/error.hpp"

namespace puadem {

namespace {

std::string_view name_of(const Wall& wall) { return wall.face >= 0 ? face_names[to_size(wall.face)] : "free"; }

}  // namespace

void guard_walls(const GrainSystem& grains) {
  for (const Wall& wall : grains.walls) {
    double gap = std::numeric_limits<double>::infinity(), largest = 0.0;
    int nearest = -1;
    for (int k = 0; k < grains.owned; ++k) {
      const GrainRecord& r = grains.record[to_size(k)];
      const double height = dot(vec3(r.place) - wall.point, wall.normal);
      ensure(height >= 0.0,
             "step {}: grain {} of radius {:.4g} m has gone through the {} wall, to ({:.6g}, {:.6g}, {:.6g}) m: the forces on it "
             "are too large for its stiffness, or its step of {:.3g} s too long",
             grains.steps, grains.identity[to_size(k)], radius_of(r), name_of(wall), r.place[0], r.place[1], r.place[2],
             grains.time_step);
      largest = std::max(largest, radius_of(r));
      if (height - radius_of(r) >= gap) continue;
      gap = height - radius_of(r);
      nearest = grains.identity[to_size(k)];
    }
    const bool seeks_grains = wall.target && !(wall.stiffness > 0.0);
    ensure(!seeks_grains || gap <= 2.0 * largest,
           "step {}: the {} wall, which holds {:.4g} Pa, has outrun the packing: the nearest grain, {}, is {:.4g} m away; the "
           "fluid carries all of the stress, or lifts the wall",
           grains.steps, name_of(wall), wall.target.value_or(0.0), nearest, gap);
  }
}

}  // namespace puadem
