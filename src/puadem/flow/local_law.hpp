#pragma once

#include "puadem/flow/retention_law.hpp"

namespace puadem {

/// Local law of a unit down to the pressure at which it refills (theory 4.4, 6.1): a law of `capillary_laws` above the
/// saturation S_thr where the bubble leaves the faces, continued at its last pressure where it ends there; from S_thr on it is
/// bent, linearly in S, so that it ends lower at S = 1.
///
/// @param drop  by which the pressure at S = 1 lies below `saturated_pressure` of the law, >= 0 [Pa]
double law_pressure(const AnyRetentionLaw& law, const CapillaryUnit& unit, double drop, double saturation);

/// dp_c/dS of it [Pa], <= 0.
double law_slope(const AnyRetentionLaw& law, const CapillaryUnit& unit, double drop, double saturation);

/// The saturation at a pressure, which is not below that at S = 1 [-].
double law_saturation(const AnyRetentionLaw& law, const CapillaryUnit& unit, double drop, double pressure);

}  // namespace puadem
