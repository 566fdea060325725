#include "puadem/network/pore_shape.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace puadem {

namespace {

struct Polyhedron {
  double faces, vertices, coefficient;  // inscribed radius over the cube root of the volume
};

/// The regular polyhedra, ascending in faces.
const std::array<Polyhedron, 5>& regular_polyhedra() {
  static const std::array<Polyhedron, 5> table = [] {
    const double sqrt5 = std::sqrt(5.0);
    const double tetrahedron = std::sqrt(6.0) / 12.0 / std::cbrt(std::sqrt(2.0) / 12.0);
    const double octahedron = std::sqrt(6.0) / 6.0 / std::cbrt(std::sqrt(2.0) / 3.0);
    const double dodecahedron = 0.5 * std::sqrt(2.5 + 1.1 * sqrt5) / std::cbrt((15.0 + 7.0 * sqrt5) / 4.0);
    const double icosahedron = std::sqrt(3.0) / 12.0 * (3.0 + sqrt5) / std::cbrt(5.0 / 12.0 * (3.0 + sqrt5));
    return std::array<Polyhedron, 5>{
        {{4, 4, tetrahedron}, {6, 8, 0.5}, {8, 6, octahedron}, {12, 20, dodecahedron}, {20, 12, icosahedron}}};
  }();
  return table;
}

double by_faces(double faces) {
  const auto& table = regular_polyhedra();
  std::size_t k = 0;
  while (k + 2 < table.size() && faces > table[k + 1].faces) ++k;
  const double slope = (table[k + 1].coefficient - table[k].coefficient) / std::log(table[k + 1].faces / table[k].faces);
  return table[k].coefficient + slope * std::log(faces / table[k].faces);
}

double by_vertices(double vertices) {
  static const std::array<double, 2> line = [] {  // intercept and slope of the least squares
    double x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
    for (const Polyhedron& p : regular_polyhedra()) {
      const double l = std::log(p.vertices);
      x += l / 5.0;
      y += p.coefficient / 5.0;
      xx += l * l / 5.0;
      xy += l * p.coefficient / 5.0;
    }
    const double slope = (xy - x * y) / (xx - x * x);
    return std::array{y - slope * x, slope};
  }();
  return line[0] + line[1] * std::log(vertices);
}

}  // namespace

double inscribed_radius_coefficient(int faces, PoreShape shape) {
  constexpr double below_sphere = 0.605;
  const double n = std::max(static_cast<double>(faces), 4.0);
  // A closed surface of n triangles has n / 2 + 2 vertices.
  return std::min(below_sphere, shape == PoreShape::faces ? by_faces(n) : by_vertices(0.5 * n + 2.0));
}

}  // namespace puadem
