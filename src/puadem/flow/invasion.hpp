#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "puadem/flow/fluids.hpp"
#include "puadem/network/pore_network.hpp"

namespace puadem {

/// Rules of the quasi-static invasion (docs/theory.md 4). Defaults follow the paper.
struct InvasionOptions {
  int nonwetting_face = 5;      ///< box face whose pores belong to the non-wetting reservoir (top)
  int wetting_face = 4;         ///< box face whose pores belong to the wetting reservoir (bottom)
  bool snap_off = true;         ///< throats may close by their corner menisci in imbibition
  bool trap_wetting = true;     ///< wetting fluid cut off from its reservoir keeps its volume
  bool trap_nonwetting = true;  ///< the same for the non-wetting fluid
  bool corner_films = false;    ///< corner water connects through open throats
  bool corner_water = true;     ///< an invaded unit keeps the water of the local retention law; else none
  bool wall_throats = true;     ///< throats along walls may be invaded
};

enum class InvasionEventKind : std::uint8_t {
  drain,          ///< the non-wetting fluid enters a saturated unit
  open_throat,    ///< the non-wetting fluid joins two units it already holds
  fill,           ///< the wetting fluid refills a unit
  snap_off,       ///< an open throat closes
  trap_wetting,   ///< a cluster of wetting fluid loses its reservoir
  trap_nonwetting,
  free_wetting,   ///< a trapped cluster is reached again
  free_nonwetting,
};

struct InvasionEvent {
  InvasionEventKind kind;
  double capillary_pressure;  ///< [Pa]
  int pore = -1;              ///< unit, or -1
  int throat = -1;            ///< throat, or -1
  int units = 0;              ///< size of the cluster trapped or freed
  double wetting_volume = 0;  ///< change of wetting volume in the counted pores [m3]
};

}  // namespace puadem
