#include "puadem/coupling/wall_servo.hpp"

#include <cmath>

namespace puadem {

namespace {

constexpr double servo_memory = 0.02;  // share of a lasting lag that is made up for in a step of the grains

}  // namespace

void correct_servo(double stress, long steps, GrainSystem& grains) {
  for (Wall& wall : grains.walls) {
    if (!wall.target || !(wall.stiffness > 0.0)) continue;
    const double held = -dot(wall.force + wall.fluid_force, wall.normal) / wall.area;
    *wall.target += (1.0 - std::pow(1.0 - servo_memory, static_cast<double>(steps))) * (stress - held);
  }
}

void renew_wall_areas(GrainSystem& grains) {
  const Vec3 size = grains.domain.size();
  for (Wall& wall : grains.walls) {
    if (wall.face < 0) continue;
    const int axis = axis_of(wall.face);
    wall.area = size[(axis + 1) % 3] * size[(axis + 2) % 3];
  }
}

}  // namespace puadem
