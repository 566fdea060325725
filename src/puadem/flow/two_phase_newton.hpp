#pragma once

#include <chrono>
#include <span>
#include <vector>

#include "puadem/flow/two_phase_step.hpp"
#include "puadem/flow/two_phase_system.hpp"

namespace puadem {

struct Clock {
  std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
  double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(); }
};

/// One step's equations (theory 6.3) and where their solution stands.
struct Newton {
  const PoreNetwork& network;
  const TwoPhaseModel& model;
  const TwoPhaseState& state;
  TwoPhaseModel::Solver& solver;
  const double step;
  const bool to_rest;  ///< pressures are to settle, whatever moves
  const std::span<const double> old_volume, volume;
  const std::span<const double> uptake;
  const BoundaryValues& boundary;
  TwoPhaseConductances throat;
  TwoPhaseTrial& trial;
  std::vector<double> law_pressure;  ///< of a mixed pore; of a full or emptied one the difference it has
  std::vector<double> capacitance;   ///< [m3/Pa]
  std::vector<double> predicted;     ///< wetting volume after a solve [m3]
  bool is_rough = false;             ///< gas still looks for pores to enter
  double gas_misfit = 0.0;           ///< largest error of a pore's gas volume by its law made linear, over the pore's [-]

  double height(int i) const {  // turns a difference of potentials into one of pressures
    return hydrostatic(model, FluidPhase::nonwetting, network.pore_centre[to_size(i)]) -
           hydrostatic(model, FluidPhase::wetting, network.pore_centre[to_size(i)]);
  }
  double taken(int i) const { return uptake.empty() || !model.is_counted(i) ? 0.0 : uptake[to_size(i)]; }
  double difference(int i) const { return trial.nonwetting[to_size(i)] - trial.wetting[to_size(i)] + height(i); }
  double threshold(int i) const { return model.thresholds.unit[to_size(i)].threshold; }
  double law(int i, double saturation) const { return local_pressure(model, trial.nonwetting_clusters, i, saturation); }
  double law_slope(int i, double saturation) const { return local_slope(model, trial.nonwetting_clusters, i, saturation); }
  bool has_capacitor(int i) const {
    const PoreFilling f = trial.filling[to_size(i)];
    return f == PoreFilling::mixed || f == PoreFilling::full || f == PoreFilling::emptied;
  }
};

/// Values at which the iteration starts: those of the state, prescribed potentials of the step's end.
void start_newton(Newton& n);

/// Law and capacitor of a pore at its present volume.
void set_capacitor(Newton& n, int pore);

/// New potentials from the equations made linear at the present point, and the volumes these predict.
/// @param tolerance  of the linear solver; 0: its own
void solve_newton(Newton& n, double tolerance);

/// By how much the cut-off ideal gas of a pore has grown against the start, at its pressure so far [m3].
double gas_expansion(const Newton& n, int pore);

}  // namespace puadem
