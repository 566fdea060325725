#pragma once

#include <vector>

#include "puadem/base/parallel.hpp"
#include "puadem/base/vec3.hpp"

namespace puadem {

/// Grains: one entry per sphere, SI units. Owned grains first, ghosts (periodic images) after them;
/// ghosts are refreshed from their owner and never integrated. The place of an owned grain in the
/// arrays is its identity: files, contacts and the pore network name grains by it.
struct Particles {
  std::vector<Vec3> position;          ///< [m]
  std::vector<Vec3> velocity;          ///< [m/s]
  std::vector<Vec3> angular_velocity;  ///< [rad/s]
  std::vector<Vec3> force;             ///< resultant of the last force evaluation [N]
  std::vector<Vec3> torque;            ///< [N m]
  std::vector<double> radius;          ///< [m]
  std::vector<double> mass;            ///< [kg]
  std::vector<double> inertia;         ///< 2/5 m R^2 [kg m2]
  std::vector<int> material;           ///< index into the materials of the case

  int size() const { return size_of(radius); }
};

}  // namespace puadem
