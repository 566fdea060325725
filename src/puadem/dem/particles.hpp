#pragma once

#include <span>
#include <vector>

#include "puadem/base/parallel.hpp"
#include "puadem/base/vec3.hpp"
#include "puadem/dem/material.hpp"

namespace puadem {

/// Grains: one entry per sphere, SI units. The place of a grain in the arrays is its identity: files,
/// contacts and the pore network name grains by it. Images across periodic faces are private to the
/// grain engine and never stand here.
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

/// Grains at rest from places, radii and materials. Fills mass and inertia.
/// @throws InputError  a radius that is not positive, a material that does not exist, or sizes of the lists that differ
Particles make_particles(std::span<const Vec3> position, std::span<const double> radius, std::span<const Material> materials,
                         std::span<const int> material);

/// The same, all of one material.
Particles make_particles(std::span<const Vec3> position, std::span<const double> radius, const Material& material,
                         int material_index = 0);

}  // namespace puadem
