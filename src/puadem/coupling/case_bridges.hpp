#pragma once

#include <optional>

#include "puadem/dem/grain_bridges.hpp"

namespace puadem {

/// The table [bridges]: liquid between grains in the stages that load them. Surface tension and contact angle are those of
/// the fluids.
struct BridgeCase : BridgeRules {
  BridgeControl control = BridgeControl::volume;
  std::optional<double> capillary_pressure;  ///< at given suction [Pa]
  // At given volume one of these.
  std::optional<double> water_content;           ///< mass of water over mass of grains [-]
  std::optional<double> saturation;              ///< volume of water over that of the void [-]
  std::optional<double> volume;                  ///< of every bridge [m3]
  std::optional<double> coalescence_saturation;  ///< of a pore beside a bridge that takes it in; none: 0.3 [-]
  BridgeModel::Law law = BridgeModel::Law::table;
};

struct Case;
struct GrainSystem;
struct Observer;

/// Liquid and table of a case with bridges.
/// @throws InputError  as `bridge_model` of the module bridges
BridgeModel bridge_model(const Case& c);

/// The first bridges, where the case wants some and the grains have none.
/// @throws InputError  as `wet_grains`
void ready_bridges(const Case& c, GrainSystem& grains, const Observer& observer);

}  // namespace puadem
