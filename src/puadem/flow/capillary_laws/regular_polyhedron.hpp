#pragma once

namespace puadem {

/// Numbers of a regular polyhedron, the picture behind the local laws of a pore unit with as many faces
/// (theory 4.1). Lengths in units of the cube root of its volume.
struct RegularPolyhedron {
  double inscribed_radius;  ///< chi_g = R_i / V^(1/3) [-], as the network has it
  double dihedral_angle;    ///< alpha, between two faces [rad]
  double edge_water;        ///< c_2: the edges hold the saturation c_2 (2 gamma / (p_c V^(1/3)))^2 [-]

  /// Saturation where the non-wetting bubble just touches all faces, 1 - 4/3 pi chi_g^3 [-].
  double touching_saturation() const;
};

/// Linear in ln(faces) between the five regular polyhedra; angle and edges of the icosahedron beyond
/// twenty faces.
/// @param faces  number of faces n_f, >= 4
RegularPolyhedron regular_polyhedron(int faces);

/// Largest contact angle at which the edges of a unit still hold wetting fluid, pi/2 - alpha/2 [rad].
double corner_angle_limit(int faces);

}  // namespace puadem
