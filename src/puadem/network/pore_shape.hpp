#pragma once

#include <cstdint>

namespace puadem {

/// By what a pore unit is likened to a regular polyhedron.
enum class PoreShape : std::uint8_t {
  faces,     ///< as many faces: 4, 6, 8, 12, 20, log-linear between
  vertices,  ///< as many vertices: the straight line in their logarithm through the five solids
};

/// Inscribed radius coefficient chi_g of a pore unit with n_f faces, R = chi_g V^(1/3): at most 0.605,
/// below the sphere's (3 / 4 pi)^(1/3) (theory 3.6). Fewer than 4 faces count as 4.
double inscribed_radius_coefficient(int faces, PoreShape shape = PoreShape::faces);

}  // namespace puadem
