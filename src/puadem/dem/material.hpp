#pragma once

#include <numbers>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "puadem/dem/contact_laws/pair_constants.hpp"
#include "puadem/dem/swelling_law.hpp"

namespace puadem {

struct ContactOptions;

/// What a grain is made of. SI units.
struct Material {
  std::string name = "glass";
  double density = 2650.0;                                  ///< [kg/m3]
  double youngs_modulus = 150e6;                            ///< E [Pa]
  double poisson_ratio = 0.3;                               ///< nu [-]
  double friction_angle = 30.0 / 180.0 * std::numbers::pi;  ///< phi [rad], mu = tan(phi)
  std::optional<SwellingLaw> swelling{};                    ///< none: grains keep their size
};

/// Constants of every ordered pair of materials, and of every material against a wall.
struct MaterialPairs {
  int materials = 0;
  std::vector<PairConstants<double>> grains;  ///< row i, column j: a contact of materials i and j
  std::vector<PairConstants<double>> walls;   ///< a contact of material i with a wall
};

/// Table of pair constants, theory 2.5 to 2.8. Friction between grains is that of the smaller angle unless the
/// options name the pair.
/// @throws InputError  a modulus, Poisson ratio, friction angle or restitution out of range; a pair of unknown materials
MaterialPairs material_pairs(std::span<const Material> materials, const ContactOptions& options);

}  // namespace puadem
