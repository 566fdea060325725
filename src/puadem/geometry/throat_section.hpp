#pragma once

#include <array>
#include <span>

#include "puadem/geometry/site.hpp"

namespace puadem {

/// Cross-section of a throat: the void between grains and walls cut by a plane. Its boundary is a ring
/// of sides (arcs of grains, straight walls); crevice k lies between side k and the next one and is
/// where a corner meniscus can stand. Lengths in metres.
struct ThroatSection {
  static constexpr int max_sides = 8;

  struct Side {
    bool is_wall = false;
    double radius = 0.0;  ///< of the grain
    double extent = 0.0;  ///< grain: angle psi of its sector [rad]; wall: length of its segment [m]
  };
  struct Crevice {
    double distance = 0.0;    ///< grain-grain: of the centres; grain-wall: of centre and wall; else unused
    double half_angle = 0.0;  ///< wall-wall: half of the inner angle [rad]; else unused
    double gap = 0.0;         ///< of the two surfaces, negative where they overlap; 0 where walls meet
  };

  int sides = 0;
  std::array<Side, max_sides> side{};
  std::array<Crevice, max_sides> crevice{};
  double facet_area = 0.0;        ///< grains included [m2]
  double void_area = 0.0;         ///< A_ij [m2]
  double inscribed_radius = 0.0;  ///< r_in; 0 where the grains leave no gap [m]

  /// Length of solid along a side [m].
  double solid_length(int k) const {
    const Side& s = side[static_cast<unsigned>(k)];
    return s.is_wall ? s.extent : s.radius * s.extent;
  }
  /// Length of all solid around the void [m].
  double solid_perimeter() const;
};

/// Section of the facet of three sites, at least one of them a grain; two walls stand at right angles
/// (theory 3.4).
ThroatSection throat_section(const std::array<Site, 3>& sites);

/// Section through grains whose centres lie in one plane and follow each other around the void, such
/// as the window of four grains in a simple cubic packing; 3 to 8 grains.
ThroatSection grain_window_section(std::span<const Site> grains);

/// Section of a straight tube: a convex polygon with corners (x, y) in counter-clockwise order, 3 to 8.
ThroatSection polygon_section(std::span<const std::array<double, 2>> corners);

/// Radius of the circle that fits between three sites whose centres span a plane (problem of
/// Apollonius; walls stand upright on the plane), at least one of them a grain. Touching each from
/// outside is linear in (centre, radius) once one grain's equation is subtracted, so the radius solves
/// one quadratic. @return 0 where they leave no gap [m]
double inscribed_circle_radius(const std::array<Site, 3>& sites);

}  // namespace puadem
