#pragma once

#include <array>
#include <limits>
#include <optional>

namespace puadem {

/// One of the two bodies that a liquid bridge joins: a sphere, or a plane as a sphere of infinite radius.
struct BridgeEnd {
  double radius = std::numeric_limits<double>::infinity();  ///< > 0; infinite: a plane [m]
  double contact_angle = 0.0;                               ///< theta in the liquid, in [0, pi/2) [rad]
};

/// The part of a bridge between its neck plane and one end. Where the meniscus has no neck between the ends, the plane
/// is that of the continued meniscus, and lengths and volume of one side are negative.
struct BridgeSide {
  double reach = 0.0;           ///< from the neck plane to the tip of the end [m]
  double volume = 0.0;          ///< liquid [m^3]
  double meniscus_area = 0.0;   ///< liquid-gas [m^2]
  double wetted_area = 0.0;     ///< liquid-solid [m^2]
  double contact_radius = 0.0;  ///< of the contact line, a circle around the axis [m]
  double filling_angle = 0.0;   ///< half of the opening angle of the contact line seen from the centre; 0 at a plane [rad]
  double arc = 0.0;             ///< length of the meridian from the neck to the contact line [m]
};

/// A bridge without gravity: a surface of constant mean curvature between two ends (theory 8.1).
struct BridgeShape {
  double suction = 0.0;      ///< p_c / gamma, twice the mean curvature; negative in a liquid under pressure [1/m]
  double pull = 0.0;         ///< F / (2 pi gamma), > 0 where the ends attract each other [m]
  double gap = 0.0;          ///< D between the surfaces; negative where the ends would overlap [m]
  double volume = 0.0;       ///< V of the liquid [m^3]
  double neck_radius = 0.0;  ///< least radius of the (continued) meniscus [m]
  std::array<BridgeSide, 2> sides{};
};

/// The bridge that has this suction and this pull; none where no meniscus of that curvature meets both ends at their
/// contact angles. A meniscus meets an end on either of two circles, theory 8.1: on the smaller one, save at `wide_end`.
/// @param suction   p_c / gamma [1/m]
/// @param pull      F / (2 pi gamma) > 0 [m]
/// @param wide_end  0 or 1, or none of both
std::optional<BridgeShape> bridge_shape(const std::array<BridgeEnd, 2>& ends, double suction, double pull,
                                        std::optional<int> wide_end = std::nullopt);

/// Greatest pull with which an end can bear a meniscus of this suction: there both circles are one (theory 8.1) [m].
double greatest_pull(const BridgeEnd& end, double suction);

/// Least suction with which an end can bear a meniscus of this pull, the inverse of `greatest_pull` [1/m].
double least_suction(const BridgeEnd& end, double pull);

/// Energy of the surfaces of a bridge over gamma, A_lg - sum of cos(theta) A_ls (theory 8.2) [m^2].
double surface_energy(const std::array<BridgeEnd, 2>& ends, const BridgeShape& shape);

/// R* = 2 R_1 R_2 / (R_1 + R_2), the radius of equal spheres with the same gap near the axis [m].
double reduced_radius(const std::array<BridgeEnd, 2>& ends);

}  // namespace puadem
