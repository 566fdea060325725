#pragma once

#include <span>
#include <vector>

#include "puadem/flow/two_phase_flow.hpp"

namespace puadem {

/// Room that a pore about to vanish between its grains borrows from a neighbour until a new network is made (theory 7.6).
struct BorrowedRoom {
  int pore, from;
  double volume;  ///< [m3]
};

/// Gives every pore at least a small share of the volume it has, at the cost of a neighbour that holds the same fluids where
/// there is one, so that the flow has volumes it can follow.
///
/// @param volume  per pore that is asked for, may be negative; changed [m3]
/// @return what was borrowed; -1 for `from` where no neighbour has room
std::vector<BorrowedRoom> borrow_room(const PoreNetwork& network, const TwoPhaseModel& model, const TwoPhaseState& state,
                                      std::vector<double>& volume);

/// The volumes are as they were asked for again; both pores hold water in the same share of them.
void give_back_room(std::span<const BorrowedRoom> borrowed, std::vector<double>& volume, TwoPhaseState& state);

}  // namespace puadem
