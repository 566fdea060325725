#pragma once

#include <array>
#include <span>
#include <vector>

#include "puadem/base/csr.hpp"
#include "puadem/dem/grain_system.hpp"
#include "puadem/flow/two_phase_flow.hpp"
#include "puadem/network/pore_network.hpp"

namespace puadem {

// Liquid bridges on the edges of the triangulation whose pore units are all dry (theory 8.8).

inline constexpr double default_coalescence = 0.3;  ///< of a pore, near the saturation at which one of beads fills [-]

/// How pores and bridges hand water to each other.
struct PendularOptions {
  BridgeModel model;                                        ///< at given suction
  BridgeFormation formation = BridgeFormation::at_contact;  ///< of the first bridges
  /// Saturation from which a pore's water takes its bridges in; infinite: that at which the gas touches its walls no more [-].
  double coalescence = default_coalescence;
};

/// Edges of the triangulation with the pore units around them. Ends as in GrainBridges: grains, or a grain and a wall.
struct EdgePores {
  std::vector<std::array<int, 2>> ends;  ///< ascending
  Csr pores;                             ///< around each edge, ascending
  std::vector<double> share;             ///< of the edge's void in each of them, like `pores.index` [-]
};
EdgePores edge_pores(const PoreNetwork& network, const GrainSystem& grains);

/// Which pores are dry: they hold gas, and less water than coalescence takes. Pores of the water's reservoirs are dry where one
/// at their capillary pressure would be that gas has entered: the reservoir reaches no farther than its face.
std::vector<char> dry_pores(const PoreNetwork& network, const TwoPhaseModel& model, const TwoPhaseState& flow,
                            double coalescence);

/// The pressures with which fluids push the walls of pores where bridges stand in dry ones: there it is the gas alone, the
/// water pulls as bridges (theory 8.8) [Pa].
std::vector<double> pendular_pressures(const PoreNetwork& network, const TwoPhaseModel& model, const TwoPhaseState& flow,
                                       double coalescence);

/// Both fluids as after a drainage to this capillary pressure that left gas in all pores and nothing cut off: water at the
/// faces' reservoirs and, by the local law, in the corners of pores.
TwoPhaseState start_dry(const PoreNetwork& network, const TwoPhaseModel& model, double capillary_pressure);

/// Bridges follow pores and capillary pressure: those beside a pore that has become wet give it their water, new ones form
/// between dry pores at contact, or wherever one can stand while the pressure rises; the water of all follows the suction, in
/// exchange with the reservoir. Everything is booked in the ledger of the flow.
/// @pre the forces of the grains are those of the present places; the forces of the bridges then are again
/// @return water in bridges [m3]
double follow_pores(const PendularOptions& options, double capillary_pressure, const PoreNetwork& network,
                    const TwoPhaseModel& model, TwoPhaseState& flow, GrainSystem& grains);

}  // namespace puadem
