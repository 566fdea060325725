#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "puadem/network/pore_network.hpp"

namespace puadem {

enum class FluidPhase : std::uint8_t { wetting, nonwetting };

/// A quantity over time: straight lines between points, constant before the first and after the last. Two points
/// at one time are a jump; from that time on the later one holds.
struct Schedule {
  std::vector<double> time;   ///< [s], ascending
  std::vector<double> value;  ///< as many

  double at(double t) const;
  double just_before(double t) const;  ///< the same but at jumps
  /// First time after `t` at which the line bends or jumps; infinite where none is left.
  double next_corner(double t) const;

  static Schedule constant(double value) { return {{0.0}, {value}}; }
};

/// Pores through which one fluid enters and leaves the network.
///
/// They belong to a reservoir: full of its fluid for good, and not counted in saturations and ledger. Only a
/// boundary of gas with `initial_gas_fraction` is different: there the gas of the reservoir merely touches pores
/// that are counted, and they drain like any other.
struct FlowBoundary {
  enum class Kind : std::uint8_t {
    pressure,  ///< of the fluid, at the mean height of the pores [Pa]
    flow_rate  ///< into the network, negative to withdraw; its pores share one pressure, which the solve finds [m3/s]
  };
  std::string name;  ///< for messages: "top", "central disc"
  std::vector<int> pores;
  FluidPhase fluid = FluidPhase::wetting;
  Kind kind = Kind::pressure;
  Schedule schedule;
  /// Only for the non-wetting fluid: its share of the boundary's pores at the start [-], in (0, 1).
  std::optional<double> initial_gas_fraction;
};

/// Pores that touch a face of the box, ascending.
std::vector<int> face_pores(const PoreNetwork& network, int face);

/// Pores whose centre lies within an upright cylinder about (x, y), ascending: a central disc [m].
std::vector<int> cylinder_pores(const PoreNetwork& network, double x, double y, double radius);

}  // namespace puadem
