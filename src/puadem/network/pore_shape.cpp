#include "puadem/network/pore_shape.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace puadem {

double inscribed_radius_coefficient(int faces) {
  struct Polyhedron {
    double faces, coefficient;
  };
  // Inscribed radius over the cube root of the volume of the regular polyhedra.
  static const std::array<Polyhedron, 5> table = [] {
    const double sqrt5 = std::sqrt(5.0);
    const double tetrahedron = std::sqrt(6.0) / 12.0 / std::cbrt(std::sqrt(2.0) / 12.0);
    const double octahedron = std::sqrt(6.0) / 6.0 / std::cbrt(std::sqrt(2.0) / 3.0);
    const double dodecahedron = 0.5 * std::sqrt(2.5 + 1.1 * sqrt5) / std::cbrt((15.0 + 7.0 * sqrt5) / 4.0);
    const double icosahedron = std::sqrt(3.0) / 12.0 * (3.0 + sqrt5) / std::cbrt(5.0 / 12.0 * (3.0 + sqrt5));
    return std::array<Polyhedron, 5>{{{4, tetrahedron}, {6, 0.5}, {8, octahedron}, {12, dodecahedron}, {20, icosahedron}}};
  }();
  constexpr double below_sphere = 0.605;
  const double n = std::max(static_cast<double>(faces), table.front().faces);
  std::size_t k = 0;
  while (k + 2 < table.size() && n > table[k + 1].faces) ++k;
  const double slope = (table[k + 1].coefficient - table[k].coefficient) / std::log(table[k + 1].faces / table[k].faces);
  return std::min(below_sphere, table[k].coefficient + slope * std::log(n / table[k].faces));
}

}  // namespace puadem
