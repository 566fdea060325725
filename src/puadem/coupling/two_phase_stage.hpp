#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "puadem/flow/two_phase_flow.hpp"

namespace puadem {

/// Stage "two-phase-flow": pressures and saturations evolve in time, grains fixed. It begins with water everywhere.
struct TwoPhaseStage {
  static constexpr std::string_view kind = "two-phase-flow";
  static constexpr int disc = 6;  ///< place of the air in the middle of the box, beside the six faces

  int air = 5;                                                         ///< face, or `disc`
  std::optional<double> disc_radius;                                   ///< of the upright disc about the middle of the box [m]
  std::array<bool, 6> water{false, false, false, false, true, false};  ///< faces
  std::optional<double> initial_air_fraction;  ///< of the pores at the air's face; none: they belong to its reservoir [-]
  double air_pressure = 0.0;                   ///< [Pa]

  // One of the four drives the flow.
  std::vector<double> path;                ///< turning points of the capillary pressure of the reservoirs [Pa]
  std::vector<double> water_pressure;      ///< one, or one for each of `water_times` with straight lines between [Pa]
  std::optional<double> withdrawal;        ///< of water [m3/s]
  std::optional<double> capillary_number;  ///< the same as a capillary number, theory 5.6 [-]

  double step = 100.0;                ///< along the path [Pa]
  std::optional<double> hold;         ///< time each pressure of the path is held; none: until at rest [s]
  std::vector<double> water_times;    ///< [s]
  std::optional<double> duration;     ///< after which the stage ends, where no path ends it [s]
  double until_saturation = 0.0;      ///< it ends earlier at this saturation [-]
  bool until_breakthrough = false;    ///< or where air reaches the water's faces
  std::optional<double> record_jump;  ///< below this saturation the next invasion is recorded in fine steps [-]
  TwoPhaseOptions options = [] {
    TwoPhaseOptions o;
    o.touching_first = true;
    return o;
  }();
};

}  // namespace puadem
