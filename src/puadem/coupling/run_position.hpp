#pragma once

#include <array>
#include <optional>
#include <variant>
#include <vector>

#include "puadem/coupling/flow_record.hpp"
#include "puadem/coupling/history.hpp"
#include "puadem/flow/invasion.hpp"
#include "puadem/geometry/domain.hpp"

namespace puadem {

/// What the rates of a loading program are judged by.
struct LoadingScale {
  double diameter = 0.0;        ///< mean of the grains [m]
  double density = 0.0;         ///< of the solid [kg/m3]
  double youngs_modulus = 0.0;  ///< [Pa]
  Vec3 size;                    ///< of the box [m]
  Vec3 stress;                  ///< along the axes at the start [Pa]
  double bridge_stress = 0.0;   ///< mean tension that liquid bridges add to the contacts' stress then [Pa]
};

/// How far a stage that loads the grains has come.
struct LoadingProgress {
  LoadingScale scale;
  HistoryStart start;
  double longest_step = 0.0;    ///< [s]
  long first_step = 0;          ///< of the grain engine
  int first_row = 0;            ///< of the stage in the history
  long last_row_step = -1;      ///< of the grain engine
  int leg = 0;                  ///< of the program
  long leg_step = 0;            ///< steps of that leg
  double leg_began = 0.0;       ///< [s]
  Vec3 leg_strain, leg_stress;  ///< at its start
  int leg_rows = 0;             ///< rows of the leg that are due no more
  BoxServo servo;
};

/// How far a retention stage has come; the equilibria reached stand in `State::retention`.
struct RetentionProgress {
  std::array<int, invasion_event_kinds> events{};
  double wetting_start = 0.0;  ///< [m3]
};

/// How far a stage "two-phase-flow" has come.
struct TwoPhaseProgress {
  FlowVolumes start;
  double done = 0.0;            ///< share of the stage, as well as it is known
  double saturation = 1.0;      ///< after the last step
  std::vector<double> awaited;  ///< saturations of the pictures still to come
  long last_picture = -1;       ///< step of it
  bool breaks_through = false;
  bool ends = false;
  std::optional<TwoPhaseState> before_jump;  ///< while one is awaited
  int stop = 0;                              ///< of the path of pressures
  std::optional<double> stop_end;            ///< time until which its pressure is held, once it is [s]
};

/// How far a stage "saturated-flow" has come.
struct SaturatedProgress {
  HistoryStart start;
  double diameter = 0.0;       ///< mean of the grains at the start [m]
  double height = 0.0;         ///< of the box along the record's axis then [m]
  double began = 0.0;          ///< [s]
  double duration = 0.0;       ///< [s]
  double interval = 0.0;       ///< over which the fluid's forces stay frozen [s]
  double longest_step = 0.0;   ///< of the grains [s]
  long step = 0;               ///< coupled steps done
  int rows = 0, profiles = 0;  ///< due no more
};

/// How far a stage "unsaturated-flow" has come.
struct UnsaturatedProgress {
  double began = 0.0;                                   ///< [s]
  double mean_radius = 0.0;                             ///< of the grains [m]
  double first_force = 0.0;                             ///< mean of the contacts in the first row [N]
  Vec3 start_size;                                      ///< of the box, from which strains are counted [m]
  int stop = 0;                                         ///< of the path of pressures
  int round = 0;                                        ///< at that stop
  double strain_rate = 0.0;                             ///< of the box after the path [1/s]
  int strain_rows = 0;                                  ///< due no more
  std::optional<double> motion_began;                   ///< time of the grains at which motion in time did [s]
  double interval = 0.0;                                ///< longest of that motion [s]
  int time_rows = 0;                                    ///< due no more
  double saturation_before = 2.0, strain_before = 0.0;  ///< a round ago
  std::vector<Vec3> first_centre;                       ///< of the grains, at the first row [m]
  Domain first_domain;                                  ///< then
};

/// Where a run stands in its stages: with the rest of the state, all that it needs to go on.
struct RunPosition {
  int stage = 0;                  ///< that is under way or comes next
  bool is_packing_shown = false;  ///< the observer knows how the grains lie
  // None: the stage has not begun.
  std::variant<std::monostate, LoadingProgress, RetentionProgress, TwoPhaseProgress, SaturatedProgress, UnsaturatedProgress>
      progress;
};

}  // namespace puadem
