#pragma once

#include <cmath>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

#include "puadem/base/vec3.hpp"
#include "puadem/dem/material.hpp"
#include "puadem/dem/particles.hpp"
#include "puadem/geometry/domain.hpp"

namespace puadem::test {

/// The contact model written out as in theory 2.1 to 2.10, pair by pair over all pairs, with matrices of rotation and
/// places of the step before. Nothing is shared with the engine. One material, Hertz-Mindlin, walls or
/// periodic axes of a fixed box.
struct SlowDem {
  Particles p;
  Domain box;
  Material material;
  double wall_friction = 0.0;
  double damping = 0.0;
  double dt = 0.0;
  Vec3 gravity{};
  std::vector<Vec3> old_position;
  std::map<std::pair<int, int>, Vec3> history;  // walls as -1 - face

  static Vec3 rotate(const Vec3& v, const Vec3& axis, double angle) {
    return std::cos(angle) * v + std::sin(angle) * cross(axis, v) + (1 - std::cos(angle)) * dot(axis, v) * axis;
  }
  static Vec3 half_turn(const Vec3& spin, double dt) {
    const double w = norm(spin);
    return w > 0 ? std::tan(w * dt / 2) / w * spin : Vec3{};
  }
  /// Shear force after swing and twist of the contact, the slip and the Coulomb limit.
  static Vec3 advance(Vec3 shear, const Vec3& n_old, const Vec3& n, double half_twist, Vec3 slip, double stiffness,
                      double limit) {
    const Vec3 axis = cross(n_old, n);
    const double sine = norm(axis);
    if (sine > 0) shear = rotate(shear, axis / sine, std::atan2(sine, dot(n_old, n)));
    shear = rotate(shear, n, 2 * std::atan(half_twist));
    slip -= dot(slip, n) * n;
    shear -= stiffness * slip;
    const double size = norm(shear);
    return size > limit ? limit / size * shear : shear;
  }

  void pair(int i, int j) {
    const std::size_t a = to_size(i), b = to_size(j);
    Vec3 d = p.position[b] - p.position[a], d_old = old_position[b] - old_position[a];
    for (int axis = 0; axis < 3; ++axis)
      if (box.periodic[static_cast<unsigned>(axis)]) {
        const double image = box.size()[axis] * std::round(d[axis] / box.size()[axis]);
        d[axis] -= image;
        d_old[axis] -= image;
      }
    const double reach = p.radius[a] + p.radius[b], length = norm(d), overlap = reach - length;
    if (overlap <= 0) {
      history.erase({i, j});
      return;
    }
    const Vec3 n = d / length, n_old = normalized(d_old);
    const double nu = material.poisson_ratio, youngs = material.youngs_modulus / (2 * (1 - nu * nu));
    const double shear_modulus = material.youngs_modulus / (2 * (1 + nu)) / (2 * (2 - nu));
    const double contact_radius = std::sqrt(p.radius[a] * p.radius[b] / reach * overlap);
    const double normal_force = 4.0 / 3.0 * youngs * contact_radius * overlap, lever = reach / length;
    const Vec3 gi = half_turn(p.angular_velocity[a], dt), gj = half_turn(p.angular_velocity[b], dt);
    const Vec3 slip = reach * (n - n_old) - cross(p.radius[a] * gi + p.radius[b] * gj, n + n_old);
    Vec3& shear = history[{i, j}];
    shear = advance(shear, n_old, n, 0.5 * dot(gi + gj, n), slip, 8 * shear_modulus * contact_radius,
                    std::tan(material.friction_angle) * normal_force / lever);
    const Vec3 force = normal_force * n + lever * shear, moment = cross(n, shear);
    p.force[b] += force;
    p.force[a] -= force;
    p.torque[a] -= p.radius[a] * moment;
    p.torque[b] -= p.radius[b] * moment;
  }

  void wall(int face, int k) {
    const std::size_t b = to_size(k);
    const Vec3 n = -outward_normal(face);
    const double overlap = p.radius[b] - std::abs(p.position[b][axis_of(face)] - box.face_position(face));
    if (overlap <= 0) {
      history.erase({-1 - face, k});
      return;
    }
    const double nu = material.poisson_ratio, youngs = material.youngs_modulus / (2 * (1 - nu * nu));
    const double shear_modulus = material.youngs_modulus / (2 * (1 + nu)) / (2 * (2 - nu));
    const double contact_radius = std::sqrt(p.radius[b] * overlap), normal_force = 4.0 / 3.0 * youngs * contact_radius * overlap;
    const Vec3 g = half_turn(p.angular_velocity[b], dt);
    const Vec3 slip = p.position[b] - old_position[b] - 2 * p.radius[b] * cross(g, n);
    Vec3& shear = history[{-1 - face, k}];
    shear = advance(shear, n, n, 0.5 * dot(g, n), slip, 8 * shear_modulus * contact_radius, wall_friction * normal_force);
    p.force[b] += normal_force * n + shear;
    p.torque[b] -= p.radius[b] * cross(n, shear);
  }

  void forces() {
    if (old_position.empty())
      for (int k = 0; k < p.size(); ++k) old_position.push_back(p.position[to_size(k)] - dt * p.velocity[to_size(k)]);
    for (auto& f : p.force) f = {};
    for (auto& t : p.torque) t = {};
    for (int i = 0; i < p.size(); ++i)
      for (int j = i + 1; j < p.size(); ++j) pair(i, j);
    for (int face = 0; face < 6; ++face)
      if (box.is_wall(face))
        for (int k = 0; k < p.size(); ++k) wall(face, k);
    for (int k = 0; k < p.size(); ++k) p.force[to_size(k)] += p.mass[to_size(k)] * gravity;
  }

  double damped(double a, double v) const {
    const double power = a * (v + 0.5 * dt * a);
    return power > 0 ? a * (1 - damping) : power < 0 ? a * (1 + damping) : a;
  }

  void move() {
    for (int k = 0; k < p.size(); ++k) {
      const std::size_t b = to_size(k);
      old_position[b] = p.position[b];
      for (int axis = 0; axis < 3; ++axis) {
        p.velocity[b][axis] += dt * damped(p.force[b][axis] / p.mass[b], p.velocity[b][axis]);
        p.angular_velocity[b][axis] += dt * damped(p.torque[b][axis] / p.inertia[b], p.angular_velocity[b][axis]);
      }
      p.position[b] += dt * p.velocity[b];
    }
  }
};

}  // namespace puadem::test
