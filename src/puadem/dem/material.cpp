#include "puadem/dem/material.hpp"

#include <algorithm>
#include <cmath>

#include "puadem/base/error.hpp"
#include "puadem/dem/contact_law.hpp"

namespace puadem {

namespace {

void check(const Material& m) {
  require(m.density > 0.0 && std::isfinite(m.density), "material '{}': density {} kg/m3 must be positive", m.name, m.density);
  require(m.youngs_modulus > 0.0 && std::isfinite(m.youngs_modulus), "material '{}': youngs_modulus {} Pa must be positive",
          m.name, m.youngs_modulus);
  require(m.poisson_ratio > -1.0 && m.poisson_ratio <= 0.5, "material '{}': poisson_ratio {} must lie in (-1, 0.5]", m.name,
          m.poisson_ratio);
  require(m.friction_angle >= 0.0 && m.friction_angle < std::numbers::pi / 2,
          "material '{}': friction_angle {} rad must lie in [0, pi/2)", m.name, m.friction_angle);
}

double damping_ratio(std::optional<double> restitution, std::string_view key) {
  if (!restitution) return 0.0;
  const double e = *restitution;
  require(e > 0.0 && e <= 1.0, "{} = {} must lie in (0, 1]", key, e);
  const double log_e = std::log(e);
  return -log_e / std::sqrt(std::numbers::pi * std::numbers::pi + log_e * log_e);
}

double compliance(const Material& m) { return (1.0 - m.poisson_ratio * m.poisson_ratio) / m.youngs_modulus; }
double shear_compliance(const Material& m) {
  const double shear_modulus = m.youngs_modulus / (2.0 * (1.0 + m.poisson_ratio));
  return (2.0 - m.poisson_ratio) / shear_modulus;
}

int index_of(const std::string& name, std::span<const Material> materials) {
  std::string names;
  for (int m = 0; m < static_cast<int>(materials.size()); ++m) {
    const std::string& defined = materials[static_cast<std::size_t>(m)].name;
    if (defined == name) return m;
    names += (m == 0 ? "" : ", ") + defined;
  }
  throw InputError(fmt::format("contact.pair: no material '{}'; defined: {}", name, names));
}

void override_pair(const PairOverride& given, std::span<const Material> materials, MaterialPairs& pairs) {
  const int a = index_of(given.materials[0], materials), b = index_of(given.materials[1], materials);
  for (const auto& [i, j] : {std::pair{a, b}, std::pair{b, a}}) {
    PairConstants<double>& pair = pairs.grains[static_cast<std::size_t>(i * pairs.materials + j)];
    if (given.friction_angle) {
      require(*given.friction_angle >= 0.0 && *given.friction_angle < std::numbers::pi / 2,
              "contact.pair of '{}' and '{}': friction_angle {} rad must lie in [0, pi/2)", given.materials[0],
              given.materials[1], *given.friction_angle);
      pair.friction = std::tan(*given.friction_angle);
    }
    if (given.restitution)
      pair.damping = damping_ratio(
          given.restitution, fmt::format("restitution of contact.pair '{}' and '{}'", given.materials[0], given.materials[1]));
  }
}

}  // namespace

MaterialPairs material_pairs(std::span<const Material> materials, const ContactOptions& options) {
  require(!materials.empty(), "no material is given: a grain needs one");
  require(options.stiffness_ratio >= 0.0, "contact.stiffness_ratio = {} must not be negative", options.stiffness_ratio);
  require(options.wall_friction >= 0.0, "contact.wall_friction = {} must not be negative", options.wall_friction);
  require(options.rolling_stiffness >= 0.0 && options.rolling_friction >= 0.0 && options.twisting_stiffness >= 0.0 &&
              options.twisting_friction >= 0.0,
          "contact: rolling and twisting stiffness and friction ({}, {}, {}, {}) must not be negative", options.rolling_stiffness,
          options.rolling_friction, options.twisting_stiffness, options.twisting_friction);
  for (const Material& m : materials) check(m);

  const double damping = damping_ratio(options.restitution, "contact.restitution");
  MaterialPairs pairs;
  pairs.materials = static_cast<int>(materials.size());
  for (const Material& a : materials)
    for (const Material& b : materials)
      pairs.grains.push_back({.youngs = 1.0 / (compliance(a) + compliance(b)),
                              .shear = 1.0 / (shear_compliance(a) + shear_compliance(b)),
                              .spring_i = a.youngs_modulus,
                              .spring_j = b.youngs_modulus,
                              .stiffness_ratio = options.stiffness_ratio,
                              .friction = std::tan(std::min(a.friction_angle, b.friction_angle)),
                              .damping = damping});
  const double wall_share = options.wall_elasticity == ContactOptions::WallElasticity::rigid ? 0.0 : 1.0;
  for (const Material& a : materials)
    pairs.walls.push_back({.youngs = 1.0 / ((1.0 + wall_share) * compliance(a)),
                           .shear = 1.0 / ((1.0 + wall_share) * shear_compliance(a)),
                           .spring_i = a.youngs_modulus,
                           .spring_j = a.youngs_modulus,
                           .stiffness_ratio = options.stiffness_ratio,
                           .friction = options.wall_friction,
                           .damping = damping});
  for (const PairOverride& given : options.pairs) override_pair(given, materials, pairs);
  return pairs;
}

}  // namespace puadem
