#pragma once

#include <array>
#include <cmath>
#include <numbers>

#include "support/packings.hpp"

namespace puadem::testing {

/// A cubic lattice of touching spheres of radius 1, in closed form: the throat between its pores, all alike, and the
/// flow of theory 3.8. The links of a pore add to zero, so that pressure is linear in the power centres and
/// k = (sum of g l^2 over the throats of a cell) / (3 cell).
struct LatticeFacts {
  const char* name;
  double solid_fraction;
  double facet_area, void_area, length, void_volume, solid_area;
  double inscribed_radius;  ///< of the throat's section
  double throats;           ///< of a cubic cell, those without resistance left out
  double cell;              ///< volume of the cubic cell
  double drag;              ///< K of exact Stokes flow, F = 6 pi mu a K U: k = 2 / (9 solid_fraction K)
  Spheres (*make)(int cells);

  double hydraulic_radius() const { return void_volume / solid_area; }
  double conductance() const { return 0.5 * void_area * hydraulic_radius() * hydraulic_radius() / length; }
  double permeability() const { return throats * conductance() * length * length / (3.0 * cell); }
  double stokes_permeability() const { return 2.0 / (9.0 * solid_fraction * drag); }
};

/// Simple, body-centred and face-centred cubic.
///
/// Drag: Zick and Homsy, J. Fluid Mech. 115, 13 (1982), doi 10.1017/S0022112082000627; 42.1 is in its Table 2. The other
/// two are quoted from that paper at second hand; a lattice-Boltzmann computation gives 42.8, 166.9 and 444 for the three.
inline std::array<LatticeFacts, 3> lattice_facts() {
  using std::numbers::pi;
  const double root2 = std::sqrt(2.0), root3 = std::sqrt(3.0), triple = 2.0 / root3 - 1.0;
  return {{
      // A square window is two facets, and the domains of six facets fill a cell.
      {"simple cubic", pi / 6, 2.0, 2.0 - pi / 2, 2.0, 4.0 / 3.0 - 2 * pi / 9, 2 * pi / 3, root2 - 1.0, 6.0, 8.0, 42.1,
       [](int cells) { return simple_cubic(1.0, cells); }},
      {"body-centred cubic", pi * root3 / 8, 4 * root2 / 3, 4 * root2 / 3 - pi / 2, std::sqrt(6.0) / 3, 8 * root3 / 27 - pi / 9,
       pi / 3, std::sqrt(1.5) - 1.0, 24.0, 64.0 / (3 * root3), 162.9, [](int cells) { return body_centred(1.0, cells); }},
      {"face-centred cubic", pi * root2 / 6, root3, root3 - pi / 2, std::sqrt(1.5), 1.0 / root2 - pi / 6, pi / 2, triple, 32.0,
       16 * root2, 435.0, [](int cells) { return face_centred(1.0, cells); }},
  }};
}

}  // namespace puadem::testing
