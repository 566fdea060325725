#include "puadem/flow/interfacial_area.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "puadem/flow/capillary_laws/regular_polyhedron.hpp"

namespace puadem {

double interfacial_area(const CapillaryUnit& unit, double volume, double saturation, const AnyRetentionLaw& law) {
  using std::numbers::pi;
  if (saturation >= 1.0 || saturation <= 0.0) return 0.0;
  const RegularPolyhedron shape = regular_polyhedron(std::max(unit.faces, 4));
  if (saturation >= shape.touching_saturation()) {
    const double radius = std::cbrt(3.0 * volume * (1.0 - saturation) / (4.0 * pi));
    return 4.0 * pi * radius * radius;
  }
  const double pressure = std::visit([&](const auto& l) { return l.capillary_pressure(unit, saturation); }, law);
  const double x = std::min(unit.threshold / pressure, 1.0), length = std::cbrt(volume);
  const double inscribed = shape.inscribed_radius * length, edge_radius = inscribed * x / (2.0 - x);
  const double opening = pi - shape.dihedral_angle;
  const double edges = 4.0 * shape.edge_water / (1.0 / std::tan(0.5 * shape.dihedral_angle) - 0.5 * opening) * length;
  return edges * (1.0 - edge_radius / inscribed) * opening * edge_radius + 4.0 * pi * edge_radius * edge_radius;
}

}  // namespace puadem
