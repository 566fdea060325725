#pragma once

#include <optional>
#include <span>
#include <vector>

#include "puadem/flow/pressure_system.hpp"
#include "puadem/flow/two_phase_flow.hpp"

namespace puadem {

/// Unknowns of the two-phase pressures and the links between them: the pore network twice, once for each fluid,
/// and in each pore a capacitor from one to the other (theory 6.3). All throats and capacitors have their place
/// in the pattern, whether a fluid is there at the time or not.
struct TwoPhaseModel::Solver {
  std::vector<int> wetting, nonwetting;            ///< per pore: unknown, or -1 where there is none
  std::vector<int> wetting_link, nonwetting_link;  ///< per throat: link, or -1
  std::vector<int> capacitor;                      ///< per pore: link, or -1
  std::vector<std::array<int, 2>> link;
  std::vector<double> conductance, diagonal, residual, increment;  ///< numbers of one solve
  int unknowns = 0;
  /// The same system for steps in time and for steps to rest, made when first needed. In time its numbers change with every
  /// solve and the pores' capacitors dominate, which suits conjugate gradients; steps to rest leave nothing but the throats, over
  /// many orders of magnitude, and take the method of the one-fluid solver.
  std::optional<PressureSystem> in_time, to_rest;
};

/// The system for steps to rest or in time.
PressureSystem& pressure_system(const TwoPhaseModel& model, bool to_rest);

/// Sets the pattern up for a model whose boundaries and reservoirs are known.
std::shared_ptr<TwoPhaseModel::Solver> make_two_phase_solver(const PoreNetwork& network, const TwoPhaseModel& model);

/// Conductances of all throats for both fluids, by where gas is and at what capillary pressure (theory 6.2).
struct TwoPhaseConductances {
  std::vector<double> wetting, nonwetting;  ///< per throat [m3/(Pa s)]
};
TwoPhaseConductances two_phase_conductances(const PoreNetwork& network, const TwoPhaseModel& model, const TwoPhaseState& state);

/// The same of one throat, after it has opened or closed.
/// @param pressure  mean capillary pressure of the two pores, where both hold gas [Pa]
void set_conductance(const PoreNetwork& network, const TwoPhaseModel& model, const FluidClusters& wetting,
                     const FluidClusters& nonwetting, double pressure, int throat, TwoPhaseConductances& conductances);

/// Lets gas pass a throat, or no longer. Corners of an open throat pass the wetting fluid where both pores keep some.
void set_open(const PoreNetwork& network, const TwoPhaseModel& model, int throat, bool open, FluidClusters& wetting,
              FluidClusters& nonwetting);

/// Pressure of gas in one pore over that of the wetting fluid in another, at the throat between them [Pa]. Potentials
/// are pressures less their hydrostatic part.
double pressure_across(const PoreNetwork& network, const TwoPhaseModel& model, int throat, double gas_potential,
                       double wetting_potential);

/// Net flow of a fluid out of each pore, from potentials (pressures less their hydrostatic part) [m3/s].
void net_outflow(const PoreNetwork& network, std::span<const double> conductance, std::span<const double> potential,
                 std::span<double> outflow);

/// Pressure below which a pore refills, with gas where it is [Pa].
double refill_pressure(const TwoPhaseModel& model, const FluidClusters& gas, int pore);

/// Local law of a pore: capillary pressure [Pa] at a saturation in [0, 1], continued through the part where the law has
/// none (theory 6.1), and its slope dp_c/dS [Pa], below 0. With cooperative filling it depends on where gas is.
double local_pressure(const TwoPhaseModel& model, const FluidClusters& gas, int pore, double saturation);
double local_slope(const TwoPhaseModel& model, const FluidClusters& gas, int pore, double saturation);

/// The law the other way: saturation at a pressure above that of S = 1 [-].
double local_saturation(const TwoPhaseModel& model, const FluidClusters& gas, int pore, double pressure);

/// Hydrostatic part of a pressure, rho g . x [Pa].
inline double hydrostatic(const TwoPhaseModel& model, FluidPhase fluid, const Vec3& place) {
  const Fluid& f = fluid == FluidPhase::wetting ? model.fluids.wetting : model.fluids.nonwetting;
  return f.density * dot(model.options.gravity, place);
}

}  // namespace puadem
