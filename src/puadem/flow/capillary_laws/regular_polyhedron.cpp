#include "puadem/flow/capillary_laws/regular_polyhedron.hpp"

#include <array>
#include <cassert>
#include <cmath>
#include <numbers>

#include "puadem/network/pore_shape.hpp"

namespace puadem {

namespace {

struct Solid {
  int faces, edges;
  double volume, dihedral_angle;  // for edges of length 1
};

const double root5 = std::sqrt(5.0);

const std::array<Solid, 5> solids{{
    {4, 6, std::sqrt(2.0) / 12.0, std::acos(1.0 / 3.0)},
    {6, 12, 1.0, std::numbers::pi / 2.0},
    {8, 12, std::sqrt(2.0) / 3.0, std::acos(-1.0 / 3.0)},
    {12, 30, (15.0 + 7.0 * root5) / 4.0, std::acos(-1.0 / root5)},
    {20, 30, 5.0 * (3.0 + root5) / 12.0, std::acos(-root5 / 3.0)},
}};

// Edge menisci are cylinders of radius gamma / p_c: c_2 = N lambda [cot(alpha/2) - (pi - alpha)/2] / 4
// for N edges of length lambda.
double edge_water_of(const Solid& solid) {
  const double half = 0.5 * solid.dihedral_angle;
  return 0.25 * solid.edges / std::cbrt(solid.volume) * (1.0 / std::tan(half) - (0.5 * std::numbers::pi - half));
}

}  // namespace

double RegularPolyhedron::touching_saturation() const {
  return 1.0 - 4.0 / 3.0 * std::numbers::pi * inscribed_radius * inscribed_radius * inscribed_radius;
}

RegularPolyhedron regular_polyhedron(int faces) {
  assert(faces >= 4);
  const double chi = inscribed_radius_coefficient(faces);
  const Solid& last = solids.back();
  if (faces >= last.faces) return {chi, last.dihedral_angle, edge_water_of(last)};
  auto above = solids.begin();
  while (above->faces <= faces) ++above;
  const Solid& below = *(above - 1);
  const double t = std::log(static_cast<double>(faces) / below.faces) / std::log(static_cast<double>(above->faces) / below.faces);
  return {chi, std::lerp(below.dihedral_angle, above->dihedral_angle, t),
          std::lerp(edge_water_of(below), edge_water_of(*above), t)};
}

double corner_angle_limit(int faces) { return 0.5 * (std::numbers::pi - regular_polyhedron(faces).dihedral_angle); }

}  // namespace puadem
