#include "puadem/dem/particles.hpp"

#include <cmath>

#include "puadem/base/error.hpp"

namespace puadem {

namespace {

/// @param density  of each grain [kg/m3], or one for all
Particles particles_of(std::span<const Vec3> position, std::span<const double> radius, std::span<const double> density) {
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
  for (std::size_t k = 0; k < n; ++k) {
    const double r = radius[k];
    require(std::isfinite(r) && r > 0.0, "grain {}: radius {} m must be positive", k, r);
    const Vec3& x = position[k];
    require(std::isfinite(x.x) && std::isfinite(x.y) && std::isfinite(x.z), "grain {}: position ({}, {}, {}) is not finite", k,
            x.x, x.y, x.z);
    particles.mass[k] = 4.0 / 3.0 * std::numbers::pi * r * r * r * (density.size() == 1 ? density[0] : density[k]);
    particles.inertia[k] = 0.4 * particles.mass[k] * r * r;
  }
  return particles;
}

}  // namespace

Particles make_particles(std::span<const Vec3> position, std::span<const double> radius, std::span<const Material> materials,
                         std::span<const int> material) {
  require(material.size() == radius.size(), "{} grain materials but {} radii", material.size(), radius.size());
  std::vector<double> density;
  for (const int m : material) {
    require(m >= 0 && m < size_of(materials), "grains of material {} of {} materials", m, materials.size());
    density.push_back(materials[to_size(m)].density);
  }
  Particles particles = particles_of(position, radius, density);
  particles.material.assign(material.begin(), material.end());
  return particles;
}

Particles make_particles(std::span<const Vec3> position, std::span<const double> radius, const Material& material,
                         int material_index) {
  Particles particles = particles_of(position, radius, std::span(&material.density, 1));
  particles.material.assign(radius.size(), material_index);
  return particles;
}

}  // namespace puadem
