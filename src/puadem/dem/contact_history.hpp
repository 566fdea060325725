#pragma once

#include <vector>

#include "puadem/dem/grain_system.hpp"

namespace puadem {

/// The contacts in force of a list that is about to be replaced, to be found again by name.
struct ContactHistory {
  struct Entry {
    int partner;      ///< identity of the second grain; of a wall contact the wall
    int block, lane;  ///< where its history stands in `blocks`
  };
  ContactBlocks blocks;    ///< the old list
  std::vector<int> start;  ///< entries of the lower identity, or of the grain at a wall
  LargeArray<Entry> entry;
};

/// Takes the old list over; `identity` still belongs to it.
ContactHistory keep_history(ContactBlocks&& blocks, const std::vector<int>& identity, int grains, bool with_walls);

/// Copies the history that `owner` and `partner` had, if any, to a lane of a block.
void restore_history(const ContactHistory& history, int owner, int partner, ContactBlocks& blocks, int block, int lane);

}  // namespace puadem
