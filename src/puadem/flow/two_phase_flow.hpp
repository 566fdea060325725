#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "puadem/base/vec3.hpp"
#include "puadem/flow/flow_boundary.hpp"
#include "puadem/flow/fluid_clusters.hpp"
#include "puadem/flow/fluid_ledger.hpp"
#include "puadem/flow/fluids.hpp"
#include "puadem/flow/invasion.hpp"
#include "puadem/flow/pressure_system.hpp"
#include "puadem/flow/retention_law.hpp"
#include "puadem/flow/throat_films.hpp"
#include "puadem/network/pore_network.hpp"

// Dynamic two-phase flow in a pore network (theory 6):
//   make_two_phase_model -> start_two_phase -> advance_two_phase | equilibrate_two_phase, again and again.

namespace puadem {

enum class TwoPhaseScheme : std::uint8_t {
  impes,     ///< one linear solve a step, saturations after it; gas of one pressure only
  implicit,  ///< pressures and saturations of the step's end together, by Newton's method
};

enum class GasKind : std::uint8_t {
  connected,       ///< without viscosity and everywhere at the pressure of its reservoir, cut off or not
  incompressible,  ///< with viscosity and pressures of its own; gas cut off keeps its volume
  ideal,           ///< the same; gas cut off keeps pressure times volume
};

/// How long the steps are (theory 6.4).
struct TwoPhaseSteps {
  /// Volume that may change hands in a step over that of the front, the pores beside throats with gas on one side: steps
  /// aim at it, and one that exceeds twice of it is taken back [-].
  double front_change = 0.005;
  double growth = 2.0;                                       ///< most by which a step may exceed the last [-]
  double longest = std::numeric_limits<double>::infinity();  ///< [s]
  int newton_limit = 30;                                     ///< iterations of a step before it is halved
  double tolerance = 1e-6;  ///< of local saturation, or of capillary pressure over the body's own [-]
  long step_limit = 10'000'000;
};

struct TwoPhaseOptions {
  TwoPhaseScheme scheme = TwoPhaseScheme::implicit;
  GasKind gas = GasKind::incompressible;
  double reference_pressure = 101325.0;  ///< absolute pressure at which pressures here are 0, for ideal gas [Pa]
  bool snap_off = false;                 ///< see `InvasionOptions::snap_off`
  bool cooperative_filling = false;      ///< open throats of a pore delay its refilling
  std::uint64_t seed = 1;                ///< of the weights of cooperative filling
  bool corner_films = true;              ///< wetting fluid flows through the corners of open throats
  bool touching_first = false;           ///< gas leaves a pore only once it touches its walls, S_i <= S_thr
  bool wall_throats = true;              ///< throats along walls may be invaded
  Vec3 gravity{};                        ///< [m/s2]
  AnyRetentionLaw retention_law = ExponentialRetention{};
  TwoPhaseSteps steps;
  PressureSolverOptions solver;
};

/// What follows from network, fluids, options and boundaries and stays while they do: nothing of it needs saving.
struct TwoPhaseModel {
  Fluids fluids;
  TwoPhaseOptions options;
  std::vector<FlowBoundary> boundaries;
  std::vector<Vec3> boundary_place;        ///< per boundary: mean of its pores' centres, where its pressure holds [m]
  std::vector<int> pore_boundary;          ///< per pore: its boundary, or -1
  std::vector<std::uint8_t> is_reservoir;  ///< per pore: full of a reservoir's fluid, not counted
  double void_volume = 0.0;                ///< of the counted pores [m3]
  InvasionThresholds thresholds;
  PoreLinks links;
  ThroatFilms films;
  double time_scale = 0.0;     ///< in which the median pore drains through its throats [s]
  double shortest_time = 0.0;  ///< the same of the fastest pore [s]

  struct Solver;
  std::shared_ptr<Solver> solver;  ///< pattern and factors, kept between steps

  bool is_counted(int pore) const { return !is_reservoir[to_size(pore)]; }
};

/// Everything a restart needs. SI; nothing geometric.
struct TwoPhaseState {
  double time = 0.0;                        ///< [s]
  double time_step = 0.0;                   ///< that the next step tries; 0: not chosen yet [s]
  std::vector<double> wetting_volume;       ///< per pore [m3]
  std::vector<double> wetting_pressure;     ///< per pore [Pa]
  std::vector<double> nonwetting_pressure;  ///< per pore with gas [Pa]
  /// Where the fluids stand: gas in pores with `nonwetting.holds`, a throat is open where `nonwetting.passes`.
  FluidClusters wetting, nonwetting;
  std::vector<double> gas_amount;  ///< per pore of cut-off ideal gas: absolute pressure times volume [J]; else 0
  FluidLedger ledger;              ///< of the counted pores since the start
  std::vector<std::array<double, 2>> boundary_inflow;  ///< per boundary: wetting and non-wetting fluid since the start [m3]
  std::vector<double> boundary_pressure;               ///< per boundary: of the reservoir [Pa]
  long steps = 0;                                      ///< accepted since the start
  bool is_settling = false;                            ///< a call of `equilibrate_two_phase` was ended before rest
  int quiet_steps = 0;                                 ///< of that call, the last in a row that count as rest
};

/// Work of one call.
struct TwoPhaseReport {
  long steps = 0;             ///< accepted
  long retries = 0;           ///< taken back: too long a step, or no convergence
  long solves = 0;            ///< of linear systems
  long events = 0;            ///< moves of gas: invasions, fillings, openings and closings of throats
  double largest_change = 0;  ///< of a pore's saturation in the last step [-]
  double seconds_assemble = 0, seconds_solve = 0, seconds_events = 0;
  bool stopped = false;  ///< by `on_step`
};

/// An event of the flow; volumes and pressures are those of the step's end.
struct TwoPhaseEvent {
  InvasionEventKind kind;
  double time;                ///< [s]
  double capillary_pressure;  ///< that decided [Pa]
  int pore = -1;              ///< unit; of a cluster its lowest; -1 for a throat alone
  int throat = -1;            ///< throat, or -1
  int units = 0;              ///< size of the cluster cut off or reached again
};

struct TwoPhaseCallbacks {
  std::function<void(const TwoPhaseEvent&)> on_event;
  std::function<bool(const TwoPhaseState&)> on_step;  ///< after each accepted step; false ends the call there
};

/// @param films  of this network; the usual ones serve where its grains are not known
/// @throws InputError  for set-ups that cannot run: no reservoir, a pore in boundaries of both fluids, a contact angle of
///                     90 degrees or more, viscosity or sizes that are not positive, throats without resistance, a gas
///                     flow rate with gas of one pressure, an option the scheme does not know
TwoPhaseModel make_two_phase_model(const PoreNetwork& network, const Fluids& fluids, const TwoPhaseOptions& options,
                                   std::vector<FlowBoundary> boundaries, ThroatFilms films);

/// Wetting fluid everywhere but in the reservoirs of the other, at rest at the first wetting pressure.
TwoPhaseState start_two_phase(const PoreNetwork& network, const TwoPhaseModel& model);

/// What grains that move or swell do to each pore; empty: nothing.
struct PoreRates {
  std::span<const double> volume{};  ///< dV_i/dt, from the network's volumes at the start of the call [m3/s]
  std::span<const double> uptake{};  ///< wetting fluid that grains take out of the pore, >= 0 [m3/s]
};

/// Follows the flow for a duration [s].
///
/// Under such rates each pore must be able to pass on what it loses: its fluids reach a boundary with a pressure, directly or
/// through neighbours and through the other fluid of a pore, or there is gas of one pressure or cut-off ideal gas that yields,
/// or the rates of the part that is closed off sum to nothing. This is looked at before the first step and after events.
/// @throws InputError      for volume rates of closed-off parts at the start, with their pores
/// @throws NumericalError  for a part that an event has closed off; for a step that fails however short it is, with the pores
///                         that hold it up
TwoPhaseReport advance_two_phase(const PoreNetwork& network, const TwoPhaseModel& model, double duration, const PoreRates& rates,
                                 TwoPhaseState& state, const TwoPhaseCallbacks& callbacks = {});

/// The same up to a time [s]: the sum of several durations rounds, a time does not.
TwoPhaseReport advance_two_phase_to(const PoreNetwork& network, const TwoPhaseModel& model, double time, const PoreRates& rates,
                                    TwoPhaseState& state, const TwoPhaseCallbacks& callbacks = {});

/// When two fluids count as being at rest.
struct RestCriterion {
  double saturation_change = 1e-7;  ///< largest of a pore in a step of `duration` without events [-]
  /// In units of `TwoPhaseModel::time_scale`, where the rounding of flows in the fastest pore lets steps be as long [-].
  double duration = 1e6;
};

/// Follows the flow under the boundary conditions of the present time, in steps as long as events and Newton's
/// method allow, until it rests. The state's time goes on. A call that `on_step` has ended is taken up by the next one.
/// @throws NumericalError  as `advance_two_phase`, and where rest is not reached within the limit of steps
TwoPhaseReport equilibrate_two_phase(const PoreNetwork& network, const TwoPhaseModel& model, const RestCriterion& rest,
                                     TwoPhaseState& state, const TwoPhaseCallbacks& callbacks = {});

/// Pressure difference of the fluids in a pore that holds both [Pa].
double capillary_pressure(const PoreNetwork& network, const TwoPhaseModel& model, int pore, const TwoPhaseState& state);

/// Saturation with wetting fluid of each pore, reservoirs included [-].
std::vector<double> saturation(const PoreNetwork& network, const TwoPhaseState& state);

/// Sums over the counted pores; fluids are trapped where they do not reach a boundary of theirs.
InvasionTotals totals(const PoreNetwork& network, const TwoPhaseModel& model, const TwoPhaseState& state);

/// Flow of both fluids through each throat, from its first pore to its second [m3/s].
struct ThroatFlows {
  std::vector<double> wetting, nonwetting;
};
ThroatFlows throat_flows(const PoreNetwork& network, const TwoPhaseModel& model, const TwoPhaseState& state);

}  // namespace puadem
