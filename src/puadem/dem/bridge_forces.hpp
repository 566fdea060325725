#pragma once

#include "puadem/dem/grain_system.hpp"

namespace puadem {

// The forces of liquid bridges on grains and walls. All functions want a system that has bridges.

/// Sorts the bridges by place, for the records as they are; the slots must be listed anew.
void list_bridges(GrainSystem& system);

/// Slots that bridges take behind those of contacts.
int bridge_slots(const BridgeList& list);

/// Calls `visit(slot, first, second, bridge)` for all bridges: records, or the wall and a record where `second` names a grain
/// at a wall; in the order of the slots.
template <class Grains, class Walls>
void for_each_bridge(const GrainSystem& s, const Grains& visit_grains, const Walls& visit_wall) {
  const BridgeList& list = s.bridges->list;
  const int offset = lane_count * (s.grain_contacts.size() + s.wall_contacts.size());
  for (int b = 0; b < size_of(list.block); ++b)
    for (int l = 0; l < lane_count; ++l) {
      const BridgeBlock& block = list.block[to_size(b)];
      if (block.bridge[to_size(l)] < 0) continue;
      visit_grains(block.first[to_size(l)], block.second[to_size(l)], block.bridge[to_size(l)], offset + lane_count * b + l);
    }
  for (int w = 0; w < size_of(list.at_wall); ++w) {
    const int bridge = list.at_wall[to_size(w)];
    visit_wall(s.bridges->bridges.pairs.ends[to_size(bridge)][1] - s.owned, list.record_at_wall[to_size(w)], bridge,
               offset + lane_count * size_of(list.block) + w);
  }
}

/// In box lengths, the image of the second grain that is nearest to the first.
std::array<double, 3> nearest_image(const GrainSystem& system, int first, int second);

/// Forces at the present places, written to the slots behind those of the contacts.
void update_bridge_forces(GrainSystem& system);

/// Adds the forces of the bridges to those on the walls.
void add_wall_bridges(GrainSystem& system);

/// Gaps and forces as they were evaluated last, into `bridges`.
void collect_bridges(GrainBridges& g);

}  // namespace puadem
