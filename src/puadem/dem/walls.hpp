#pragma once

#include <optional>
#include <vector>

#include "puadem/base/vec3.hpp"
#include "puadem/geometry/domain.hpp"

namespace puadem {

/// What a servo wall holds: the stress of grains and fluid together, or that of the grains alone.
enum class ServoStress { total, net };

/// A plane wall. Grains stand on the side its normal points to.
struct Wall {
  Vec3 point;                    ///< any point of the plane [m]
  Vec3 normal;                   ///< unit vector into the grains [-]
  Vec3 velocity;                 ///< [m/s]
  Vec3 last_velocity;            ///< of the step before [m/s]
  int face = -1;                 ///< face of the box that it stands for; -1: a wall of its own
  double friction = 0.0;         ///< mu between this wall and grains [-]
  std::optional<double> target;  ///< servo: normal stress to hold [Pa]; none: the wall moves at `velocity`
  double area = 0.0;             ///< that the servo divides the force by [m2]
  Vec3 slide;                    ///< velocity of the wall within its plane while the servo sets the rest [m/s]
  double servo_gain = 0.5;       ///< share of the missing force made up for in one step [-]
  double speed_limit = 0.0;      ///< of the servo [m/s]
  ServoStress servo_stress = ServoStress::total;
  Vec3 force;              ///< of the grains on the wall, last evaluation [N]
  Vec3 fluid_force;        ///< of fluids on the wall, set from outside; 0 in dry runs [N]
  double stiffness = 0.0;  ///< sum of the contacts' normal stiffness, last evaluation [N/m]
};

/// The walls of a box, in the order of its faces, periodic faces left out. All at rest.
std::vector<Wall> box_walls(const Domain& domain, double friction);

}  // namespace puadem
