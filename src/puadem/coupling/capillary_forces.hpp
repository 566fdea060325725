#pragma once

#include <span>
#include <vector>

#include "puadem/coupling/fluid_forces.hpp"
#include "puadem/dem/tensor.hpp"
#include "puadem/flow/two_phase_flow.hpp"

namespace puadem {

/// Share of a pore's walls that its water covers, from threshold over capillary pressure x = p_thr / p_c (theory 7.7); 1 where
/// the bubble does not touch the walls.
double wetted_fraction(double threshold_over_pressure);

/// Pressure with which the fluids of each pore push its walls: that of the water where there is no gas, else
/// p_n - f_w p_c with the wetted share of the walls (theory 7.7) [Pa].
std::vector<double> effective_pressures(const PoreNetwork& network, const TwoPhaseModel& model, const TwoPhaseState& state);

/// The part of the fluids' forces on grains that menisci make which hang in throats: what acts on the void of the throats [N].
/// @param pressure  see `effective_pressures`
std::vector<Vec3> tension_forces(const PoreNetwork& network, const PushedAreas& areas, std::span<const double> pressure,
                                 int grains);

/// What forces on grains and walls carry of the stress of the box: (1/V) sum F x, compression positive [Pa] (theory 7.8).
/// Where the box is periodic, forces must act on grains where they are listed; walls at their face.
Tensor fluid_stress(const FluidForces& forces, std::span<const Vec3> centre, const Domain& domain);

/// Directions of forces, weighted by their magnitude.
struct ForceFabric {
  double anisotropy = 0.0;  ///< a_c = sqrt(3/2 a:a), a = 15/2 (C - I/3), C the mean of n (outer) n by magnitude [-]
  double mean = 0.0;        ///< magnitude [N]
};
ForceFabric force_fabric(std::span<const Vec3> force);

}  // namespace puadem
