#pragma once

#include <array>
#include <concepts>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "puadem/dem/contact_laws/hertz_mindlin.hpp"
#include "puadem/dem/contact_laws/linear_spring.hpp"

namespace puadem {

/// What two materials have in common where it does not follow from each of them.
struct PairOverride {
  std::array<std::string, 2> materials;  ///< names, in either order
  std::optional<double> friction_angle;  ///< [rad]; none: the smaller one of the two
  std::optional<double> restitution;     ///< in (0, 1]; none: that of all contacts
};

/// Contact options of a case.
struct ContactOptions {
  enum class Law { linear_spring, hertz_mindlin };
  enum class WallElasticity { material, rigid };  ///< a wall of the grains' own constants, or one that does not yield
  Law law = Law::hertz_mindlin;
  double stiffness_ratio = 0.4;  ///< k_s / k_n of the linear law [-]
  double wall_friction = 0.0;    ///< mu between grains and walls [-]
  WallElasticity wall_elasticity = WallElasticity::material;
  std::optional<double> restitution;  ///< coefficient of normal restitution in (0, 1]; none: no viscous part
  double rolling_stiffness = 0.0;     ///< alpha_r: k_r = alpha_r k_s R_i R_j [-]
  double rolling_friction = 0.0;      ///< eta_r: moment up to eta_r min(R_i, R_j) F_n [-]; 0: grains roll freely
  double twisting_stiffness = 0.0;    ///< alpha_t, about the normal [-]
  double twisting_friction = 0.0;     ///< eta_t [-]; 0: grains twist freely
  std::vector<PairOverride> pairs{};
};

inline bool resists_rolling(const ContactOptions& o) { return o.rolling_friction > 0.0 || o.twisting_friction > 0.0; }

/// What a law of contact gives: a normal force and two tangent stiffnesses as functions of the overlap.
/// All else (slip, rotation of the history, Coulomb limit, viscous part) is the same for every law and
/// stands once, in contact_forces.cpp. `damping_factor` is c / (beta sqrt(m* k_n)), theory 2.8.
template <class Law>
concept ContactLaw = requires(const PairConstants<double>& pair, double length) {
  { Law::damping_factor } -> std::convertible_to<double>;
  { Law::energy_share } -> std::convertible_to<double>;      // normal energy / (k_n overlap^2), tangent k_n
  { Law::stores_shear } -> std::convertible_to<bool>;        // has the shear force a potential?
  { Law::stiffness_ratio(pair) } -> std::same_as<double>;    // k_s / k_n, the same at every overlap
  { Law::partial_dashpot(Lanes{}) } -> std::same_as<Lanes>;  // theory 2.8
  { Law::respond(pair, length, length, length) } -> std::same_as<ContactResponse<double>>;
};

/// Every law a case file can name.
using AnyContactLaw = std::variant<LinearSpring, HertzMindlin>;

inline AnyContactLaw contact_law(ContactOptions::Law law) {
  if (law == ContactOptions::Law::linear_spring) return LinearSpring{};
  return HertzMindlin{};
}

}  // namespace puadem
