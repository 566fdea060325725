#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "puadem/flow/fluid_clusters.hpp"
#include "puadem/flow/fluids.hpp"

namespace puadem {

/// Cooperative filling (theory 4.4): the more open throats a pore has, the flatter the meniscus that refills it, and the
/// lower the capillary pressure at which it does.
///
/// @param seed  of the weights b, uniform in [0, 1]; they follow from the radii around a throat, not from numbers, and
///              change steadily with them
/// @return per link of `links`: b times the radius of the throat, 2 r* cos(theta), over that of the pore [-]
std::vector<double> filling_shares(const PoreNetwork& network, const PoreLinks& links, const Fluids& fluids, std::uint64_t seed);

/// Pressure at which a pore with gas refills: its body's, lowered by its open throats [Pa].
///
/// @param shares  of `filling_shares`, or empty: the body's pressure as it is
/// @param gas     where gas stands: open throats
double refill_pressure(std::span<const double> shares, const PoreLinks& links, const FluidClusters& gas, double body_pressure,
                       int pore);

}  // namespace puadem
