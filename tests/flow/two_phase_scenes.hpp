#pragma once

#include <vector>

// Chains of pores with known answers. Each scene runs the flow and returns what was found; tests judge it, and the program
// verify_two_phase writes it down. Lengths, surface tension and volumes are of order 1.

namespace puadem::testing {

/// Reservoir - pore 1 - pore 2 - reservoir, the throat between the pores the tightest. Suction goes to just below the
/// pressure at which gas enters pore 2, then to just above it.
struct HainesJumpScene {
  double threshold = 0.0;  ///< of pore 2: the larger of its throat's and its body's
  bool enters_below = false, enters_above = false;
  double lost_below = 0.0;      ///< water of pore 2 lost before, over its volume
  double rise = 0.0;            ///< most by which the water pressure in pore 2 exceeds the reservoir's, over the suction
  double regain = 0.0;          ///< most that pore 2 takes up in a step, over its volume
  double imbalance = 0.0;       ///< largest of change of water less inflow, over the volume of a pore
  double law_difference = 0.0;  ///< at rest: largest of |S_i - S(p_c)|
  struct Row {
    double time;               ///< since the suction was raised, in drainage times
    double invaded, invading;  ///< capillary pressure of pores 2 and 1, over the suction
  };
  std::vector<Row> rows;
};
HainesJumpScene haines_jump_scene();

/// Water drawn into a chain of 60 pores full of gas by the pores' own suction (Washburn). Pore n fills through n - 1 full
/// throats: its time is mu V / g sum_k k int dS / p_c.
struct WashburnScene {
  std::vector<double> time;    ///< at which pore n = 1, 2, ... is full, over the unit of time mu V / g int dS / p_c
  std::vector<double> by_sum;  ///< the same by the sum of throats, n (n + 1) / 2
  double exponent = 0.0;       ///< of n over time, from pore 20 to 60
};
WashburnScene washburn_scene();

/// Gas behind a front, water ahead of it: one flow, by what the front's capillary pressure leaves of the suction.
struct SeriesScene {
  int checked = 0;             ///< steps that were looked at
  double wetting_error = 0.0;  ///< largest relative difference of the water's flow
  double nonwetting_error = 0.0;
  double conserved = 0.0;  ///< gas that came in over water that left, less 1
};
SeriesScene series_scene(double gas_viscosity);

/// A column in gravity, drained from full and wetted from dry. Heights in pores.
struct RiseScene {
  double drained = 0.0, drained_by_formula = 0.0;  ///< p_e / ((rho_w - rho_n) g), with the weight of the gas
  double wetted = 0.0, wetted_by_formula = 0.0;    ///< the same with the pressure at which a body refills
  double hydrostatic_error = 0.0;                  ///< largest of p_w + rho g h below the front, over rho g times a pore
  double start_error = 0.0;                        ///< the same at the start, between two pores
};
RiseScene rise_scene();

}  // namespace puadem::testing
