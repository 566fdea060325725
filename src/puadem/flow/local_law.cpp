#include "puadem/flow/local_law.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "puadem/flow/capillary_laws/regular_polyhedron.hpp"

namespace puadem {

namespace {

/// A law with its unit; from `touching` on `bend` is taken off its slope.
template <class Law>
struct BentLaw {
  const Law& law;
  const CapillaryUnit& unit;
  double touching = 1.0, bend = 0.0;

  BentLaw(const Law& any, const CapillaryUnit& of, double drop) : law(any), unit(of) {
    if (drop == 0.0) return;
    touching = regular_polyhedron(unit.faces).touching_saturation();
    bend = drop / (1.0 - touching);
  }

  bool ends_at(double saturation) const { return saturation >= law.largest_saturation(unit); }
  double pressure(double saturation) const {
    const double p = ends_at(saturation) ? law.saturated_pressure(unit) : law.capillary_pressure(unit, saturation);
    return p - bend * std::max(saturation - touching, 0.0);
  }
  double slope(double saturation) const {
    const double straight = ends_at(saturation) ? 0.0 : law.slope(unit, saturation);
    return straight - (saturation > touching ? bend : 0.0);
  }
  double saturation(double p) const {
    if (bend == 0.0 || p >= pressure(touching)) return law.saturation(unit, p);
    // Newton from above: the law is convex, so the iterates rise to the root.
    double s = touching;
    for (int iteration = 0; iteration < 100; ++iteration) {
      const double step = (p - pressure(s)) / (ends_at(s) ? -bend : law.slope(unit, s) - bend);
      s += step;
      if (std::abs(step) <= 4.0 * std::numeric_limits<double>::epsilon()) break;
    }
    return std::min(s, 1.0);  // rounding
  }
};

}  // namespace

double law_pressure(const AnyRetentionLaw& law, const CapillaryUnit& unit, double drop, double saturation) {
  return std::visit([&](const RetentionLaw auto& l) { return BentLaw(l, unit, drop).pressure(saturation); }, law);
}

double law_slope(const AnyRetentionLaw& law, const CapillaryUnit& unit, double drop, double saturation) {
  return std::visit([&](const RetentionLaw auto& l) { return BentLaw(l, unit, drop).slope(saturation); }, law);
}

double law_saturation(const AnyRetentionLaw& law, const CapillaryUnit& unit, double drop, double pressure) {
  return std::visit([&](const RetentionLaw auto& l) { return BentLaw(l, unit, drop).saturation(pressure); }, law);
}

}  // namespace puadem
