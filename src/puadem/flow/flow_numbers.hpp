#pragma once

#include <span>

#include "puadem/flow/fluids.hpp"
#include "puadem/network/pore_network.hpp"

namespace puadem {

// Dimensionless numbers of a displacement (theory 5.6).

/// Ca = mu_w v / gamma [-].
/// @param velocity  volume of displaced wetting fluid per time and area of the region's initial boundary [m/s]
double capillary_number(const Fluids& fluids, double velocity);

/// M = mu_n / mu_w [-]: below 1 the non-wetting fluid is the thinner one.
double viscosity_ratio(const Fluids& fluids);

/// Bo = (rho_w - rho_n) g <r>^2 / gamma [-]. @param radius  mean radius of grains [m]
double bond_number(const Fluids& fluids, double gravity, double radius);

/// Flow of one fluid of viscosity 1 Pa s between two groups of pores at a pressure difference of 1 Pa [m3].
/// 0 where no way leads from one to the other.
/// @throws InputError  for an empty group, a pore in both
double conductance_between(const PoreNetwork& network, std::span<const int> from, std::span<const int> to);

/// Lowest capillary pressure at which the non-wetting fluid can get from one group of pores to the other [Pa]: over
/// all ways, the least of the greatest threshold on them. Infinite where no way leads there.
/// @param entry_pressure  per throat [Pa]
/// @param body_pressure   per pore [Pa]; pores of the two groups do not resist
double breakthrough_pressure(const PoreNetwork& network, std::span<const double> entry_pressure,
                             std::span<const double> body_pressure, std::span<const int> from, std::span<const int> to);

}  // namespace puadem
