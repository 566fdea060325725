#pragma once

#include <array>

#include "puadem/geometry/throat_section.hpp"

namespace puadem {

/// Domain of a throat: the two pyramids on its facet whose tops are the power centres of the cells on
/// either side (theory 3.8). The domains tile the void.
struct ThroatDomain {
  double length = 0.0;                 ///< distance of the power centres [m]
  double void_volume = 0.0;            ///< V_ij [m3]
  std::array<double, 3> solid_area{};  ///< Gamma: surface of each grain, area of each wall [m2]
};

/// @param section   of the same facet
/// @param from, to  power centres of the cells behind and before the facet [m]
ThroatDomain throat_domain(const std::array<Site, 3>& sites, const ThroatSection& section, const Vec3& from, const Vec3& to);

/// Conductance of a throat times the viscosity, q = g (p_i - p_j) / mu (theory 3.8) [m3]. Infinite where
/// the power centres coincide: the two cells are one pore. 0 where the domain holds no void.
///
/// @param void_area   of the section [m2]
/// @param solid_area  surface that holds the fluid: of grains, and of walls without slip [m2]
/// @param grain_size  radius of the smallest grain of the facet, the scale of coincidence [m]
double throat_conductance(const ThroatDomain& domain, double void_area, double solid_area, double grain_size);

}  // namespace puadem
