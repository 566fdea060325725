#pragma once

#include <cstdint>
#include <functional>
#include <string_view>
#include <vector>

#include "puadem/flow/cooperative_filling.hpp"
#include "puadem/flow/fluid_clusters.hpp"
#include "puadem/flow/fluid_ledger.hpp"
#include "puadem/flow/fluids.hpp"
#include "puadem/flow/retention_law.hpp"
#include "puadem/network/pore_network.hpp"

namespace puadem {

/// When it is looked at what is cut off from its reservoir.
enum class TrapCheck : std::uint8_t {
  event,  ///< after each event: the state does not depend on the stops of the path
  step,   ///< once per stop, after all events on the way to it, as some codes do: it then does
};

/// Rules of the quasi-static invasion (theory 4.4). Defaults follow the paper, but for snap-off. The last
/// three are conventions of other codes, for comparison (theory 4.7).
struct InvasionOptions {
  int nonwetting_face = 5;  ///< box face whose pores belong to the non-wetting reservoir (top)
  int wetting_face = 4;     ///< box face whose pores belong to the wetting reservoir (bottom)
  /// Throats may close by their corner menisci in imbibition. Off by default: the criterion is that of a long
  /// tube and closes nearly all throats of a bead pack before any body refills, so that most of the gas is trapped.
  bool snap_off = false;
  bool trap_wetting = true;     ///< wetting fluid cut off from its reservoir keeps its volume
  bool trap_nonwetting = true;  ///< the same for the non-wetting fluid
  bool corner_films = false;    ///< corner water connects through open throats
  bool corner_water = true;     ///< an invaded unit keeps the water of the local retention law; else none
  bool wall_throats = true;     ///< throats along walls may be invaded
  bool body_entry = true;       ///< false: the body does not resist entry; only with corner_water = false
  /// false: pores at walls that are no reservoir are not counted, and gas enters them from inner pores only:
  /// no throat between two pores at walls opens. Water passes through them.
  bool side_pores = true;
  TrapCheck trap_check = TrapCheck::event;
  bool cooperative_filling = false;  ///< open throats of a pore delay its refilling
  std::uint64_t seed = 1;            ///< of the weights of cooperative filling
  AnyRetentionLaw retention_law = ExponentialRetention{};
};

enum class InvasionEventKind : std::uint8_t {
  drain,         ///< the non-wetting fluid enters a saturated unit
  open_throat,   ///< the non-wetting fluid joins two units it already holds
  fill,          ///< the wetting fluid refills a unit
  snap_off,      ///< an open throat closes
  trap_wetting,  ///< a cluster of wetting fluid loses its reservoir
  trap_nonwetting,
  free_wetting,  ///< a trapped cluster is reached again
  free_nonwetting,
};

inline constexpr int invasion_event_kinds = 8;

/// The name of an event in files: "drain", "open_throat", ...
std::string_view event_name(InvasionEventKind kind);

struct InvasionEvent {
  InvasionEventKind kind;
  double capillary_pressure;  ///< [Pa]
  int pore = -1;              ///< unit; of a cluster its lowest; -1 for a throat alone
  int throat = -1;            ///< throat, or -1
  int units = 0;              ///< size of the cluster trapped or freed
  double wetting_volume = 0;  ///< change of wetting volume in the counted pores [m3]
};

/// Pressures at which things happen, fixed by network, fluids and options (theory 4.4).
struct InvasionThresholds {
  std::vector<CapillaryUnit> unit;        ///< per pore, for the local law
  std::vector<std::uint8_t> keeps_water;  ///< per pore: corner water stays in it when it is invaded
  std::vector<double> body_pressure;      ///< per pore: not entered below; refilled below, or later if pores cooperate [Pa]
  std::vector<double> entry_pressure;     ///< per throat: p_e [Pa]; infinite without a gap
  std::vector<double> snap_off_pressure;  ///< per throat: p_so <= p_e [Pa]; 0: never
  std::vector<std::uint8_t> may_open;     ///< per throat
  std::vector<double> filling_shares;     ///< see `filling_shares`; empty without cooperative filling
  bool all_keep_water = true;
};

/// A throat or pore that may change at a pressure; checked again when its turn comes.
struct InvasionCandidate {
  enum class Kind : std::uint8_t { enter_first, enter_second, join, fill, snap_off };
  double pressure;  ///< [Pa]
  double entry;     ///< entry pressure of the throat, or 0; decides between equal pressures [Pa]
  int index;        ///< pore of `fill`, else throat
  Kind kind;
};

/// Candidates as a heap, and marks that keep one from standing in it twice.
struct InvasionQueue {
  std::vector<InvasionCandidate> heap;
  std::vector<std::uint8_t> pore_marks, throat_marks;  ///< bit of each kind that is queued
};

/// Two fluids at rest in a network. Reservoir pores are full of their fluid. They, and side pores if the
/// options say so, are not counted in saturations and ledger.
struct InvasionState {
  InvasionOptions options;
  double capillary_pressure = 0.0;     ///< p_c of the reservoirs [Pa]
  FluidClusters wetting, nonwetting;   ///< a throat is open where `nonwetting.passes`
  std::vector<double> wetting_volume;  ///< per pore [m3]; 0 in the non-wetting reservoir, V_i in the wetting one
  std::vector<std::uint8_t> counted;   ///< per pore: part of saturations and ledger
  double void_volume = 0.0;            ///< of the counted pores [m3]
  FluidLedger ledger;                  ///< volumes since the start

  PoreLinks links;  ///< the rest follows from the start or from the above
  InvasionThresholds thresholds;
  InvasionQueue drainage, imbibition;  ///< lowest pressure first; highest first
  ClusterSearch search;

  bool is_counted(int pore) const { return counted[to_size(pore)] != 0; }
  bool is_reservoir(int pore) const { return wetting.reservoir[to_size(pore)] || nonwetting.reservoir[to_size(pore)]; }
  /// Pressure below which a pore refills now [Pa].
  double refill_pressure(int pore) const {
    return puadem::refill_pressure(thresholds.filling_shares, links, nonwetting, thresholds.body_pressure[to_size(pore)], pore);
  }
  /// Both fluids reach their reservoirs: the unit follows its local law.
  bool is_in_equilibrium(int pore) const {
    return nonwetting.connected[to_size(pore)] && wetting.connected[to_size(pore)] && !is_reservoir(pore);
  }
};

using InvasionEventCallback = std::function<void(const InvasionEvent&)>;

/// Water everywhere but in the non-wetting reservoir, at p_c = 0.
/// @throws InputError  for a face without pores, a pore at both faces, no pore between, an angle of 90 degrees
///                     or more, sizes that are not positive, options that exclude one another
InvasionState start_invasion(const PoreNetwork& network, const Fluids& fluids, const InvasionOptions& options);

/// Moves the reservoirs to a capillary pressure through all events on the way, each at its own
/// pressure (theory 4.5): the state reached does not depend on the stops between, unless trapping is
/// looked at once per stop.
///
/// @param target    [Pa], >= 0
/// @param on_event  called after each event; may be empty
/// @throws InputError      for a target that is negative or not finite
/// @throws NumericalError  if events follow one another without end at one pressure
void advance_to(const PoreNetwork& network, double target, InvasionState& state, const InvasionEventCallback& on_event = {});

/// Saturation with wetting fluid of each pore, reservoirs included [-].
std::vector<double> saturation(const PoreNetwork& network, const InvasionState& state);

/// Sums over the counted pores, as fractions of their void.
struct InvasionTotals {
  double saturation = 1.0;          ///< [-]
  double trapped_wetting = 0.0;     ///< wetting fluid out of reach of its reservoir [-]
  double trapped_nonwetting = 0.0;  ///< [-]
};
InvasionTotals totals(const PoreNetwork& network, const InvasionState& state);

}  // namespace puadem
