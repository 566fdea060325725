#pragma once

#include "puadem/flow/retention_law.hpp"

namespace puadem {

/// Area of the meniscus in a pore unit that holds both fluids [m2] (theory 5.5): a free bubble while it touches no
/// face, else edge menisci and corners of the regular polyhedron of section 4.1.
/// @param volume      void of the unit [m3]
/// @param saturation  wetting fluid in it [-], in [0, 1]
double interfacial_area(const CapillaryUnit& unit, double volume, double saturation, const AnyRetentionLaw& law);

}  // namespace puadem
