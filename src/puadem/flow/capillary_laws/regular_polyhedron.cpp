#include "puadem/flow/capillary_laws/regular_polyhedron.hpp"

#include <array>
#include <cassert>
#include <cmath>
#include <numbers>

namespace puadem {

namespace {

struct Solid {
  int faces, edges;
  double volume, inradius, dihedral_angle;  // for edges of length 1
};

const double root5 = std::sqrt(5.0);

const std::array<Solid, 5> solids{{
    {4, 6, std::sqrt(2.0) / 12.0, std::sqrt(6.0) / 12.0, std::acos(1.0 / 3.0)},
    {6, 12, 1.0, 0.5, std::numbers::pi / 2.0},
    {8, 12, std::sqrt(2.0) / 3.0, std::sqrt(6.0) / 6.0, std::acos(-1.0 / 3.0)},
    {12, 30, (15.0 + 7.0 * root5) / 4.0, std::sqrt((25.0 + 11.0 * root5) / 40.0), std::acos(-1.0 / root5)},
    {20, 30, 5.0 * (3.0 + root5) / 12.0, (3.0 + root5) / (4.0 * std::sqrt(3.0)), std::acos(-root5 / 3.0)},
}};

RegularPolyhedron shape_of(const Solid& solid) {
  const double edge = 1.0 / std::cbrt(solid.volume);
  const double half = 0.5 * solid.dihedral_angle;
  return {solid.inradius * edge, solid.dihedral_angle,
          0.25 * solid.edges * edge * (1.0 / std::tan(half) - (0.5 * std::numbers::pi - half))};
}

}  // namespace

double RegularPolyhedron::touching_saturation() const {
  return 1.0 - 4.0 / 3.0 * std::numbers::pi * inscribed_radius * inscribed_radius * inscribed_radius;
}

RegularPolyhedron regular_polyhedron(int faces) {
  assert(faces >= 4);
  if (faces >= solids.back().faces) return shape_of(solids.back());
  auto above = solids.begin();
  while (above->faces <= faces) ++above;
  const Solid& below = *(above - 1);
  const RegularPolyhedron a = shape_of(below), b = shape_of(*above);
  const double t = std::log(static_cast<double>(faces) / below.faces) / std::log(static_cast<double>(above->faces) / below.faces);
  return {std::lerp(a.inscribed_radius, b.inscribed_radius, t), std::lerp(a.dihedral_angle, b.dihedral_angle, t),
          std::lerp(a.edge_water, b.edge_water, t)};
}

double corner_angle_limit(int faces) { return 0.5 * (std::numbers::pi - regular_polyhedron(faces).dihedral_angle); }

}  // namespace puadem
