#include "puadem/dem/walls.hpp"

namespace puadem {

std::vector<Wall> box_walls(const Domain& domain, double friction) {
  std::vector<Wall> walls;
  const Vec3 size = domain.size();
  for (int face = 0; face < 6; ++face) {
    if (!domain.is_wall(face)) continue;
    const int axis = axis_of(face);
    Wall wall;
    wall.point = is_upper(face) ? domain.upper : domain.lower;
    wall.normal = -outward_normal(face);
    wall.face = face;
    wall.friction = friction;
    wall.area = domain.volume() / size[axis];
    walls.push_back(wall);
  }
  return walls;
}

}  // namespace puadem
