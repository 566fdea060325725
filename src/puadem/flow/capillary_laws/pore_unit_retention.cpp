#include "puadem/flow/capillary_laws/pore_unit_retention.hpp"

#include "puadem/base/error.hpp"
#include "puadem/flow/capillary_laws/regular_polyhedron.hpp"

namespace puadem {

namespace {

struct Polynomial {
  double square, cube;  // S = square x^2 + cube x^3

  explicit Polynomial(int faces) {
    const RegularPolyhedron shape = regular_polyhedron(faces);
    square = shape.edge_water * shape.inscribed_radius * shape.inscribed_radius;
    cube = shape.touching_saturation() - square;
  }
  double value(double x) const { return x * x * (square + cube * x); }
  double slope(double x) const { return x * (2.0 * square + 3.0 * cube * x); }

  // Newton from above: the polynomial is convex, so the iterates fall to the root.
  double root(double saturation) const {
    double x = std::sqrt(saturation / square);
    for (int iteration = 0; iteration < 100; ++iteration) {
      const double step = (value(x) - saturation) / slope(x);
      x -= step;
      if (std::abs(step) <= 4.0 * std::numeric_limits<double>::epsilon() * x) return x;
    }
    throw NumericalError(fmt::format("polyhedron retention law: no capillary pressure found for saturation {}", saturation));
  }
};

}  // namespace

double PolyhedronRetention::saturation(const CapillaryUnit& unit, double pressure) const {
  return Polynomial(unit.faces).value(unit.threshold / pressure);
}

double PolyhedronRetention::capillary_pressure(const CapillaryUnit& unit, double saturation) const {
  return unit.threshold / Polynomial(unit.faces).root(saturation);
}

double PolyhedronRetention::slope(const CapillaryUnit& unit, double saturation) const {
  const Polynomial polynomial(unit.faces);
  const double x = polynomial.root(saturation);
  return -unit.threshold / (x * x * polynomial.slope(x));
}

double PolyhedronRetention::largest_saturation(const CapillaryUnit& unit) const {
  return regular_polyhedron(unit.faces).touching_saturation();
}

}  // namespace puadem
