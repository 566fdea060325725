#include "puadem/dem/particles.hpp"

#include <cmath>

#include "puadem/base/error.hpp"

namespace puadem {

Particles make_particles(std::span<const Vec3> position, std::span<const double> radius, const Material& material,
                         int material_index) {
  require(position.size() == radius.size(), "{} grain positions but {} radii", position.size(), radius.size());
  Particles particles;
  particles.position.assign(position.begin(), position.end());
  particles.radius.assign(radius.begin(), radius.end());
  const std::size_t n = radius.size();
  particles.velocity.resize(n);
  particles.angular_velocity.resize(n);
  particles.force.resize(n);
  particles.torque.resize(n);
  particles.mass.resize(n);
  particles.inertia.resize(n);
  particles.material.assign(n, material_index);
  for (std::size_t k = 0; k < n; ++k) {
    const double r = radius[k];
    require(std::isfinite(r) && r > 0.0, "grain {}: radius {} m must be positive", k, r);
    const Vec3& x = position[k];
    require(std::isfinite(x.x) && std::isfinite(x.y) && std::isfinite(x.z), "grain {}: position ({}, {}, {}) is not finite", k,
            x.x, x.y, x.z);
    particles.mass[k] = 4.0 / 3.0 * std::numbers::pi * r * r * r * material.density;
    particles.inertia[k] = 0.4 * particles.mass[k] * r * r;
  }
  return particles;
}

}  // namespace puadem
