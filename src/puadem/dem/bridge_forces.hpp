#pragma once

#include "puadem/dem/grain_system.hpp"

namespace puadem {

// The forces of liquid bridges on grains and walls. All functions want a system that has bridges.

/// Lists the bridges for the records as they are.
void list_bridges(GrainSystem& system);

/// Forces at the present places on grains, in the list, and of the bridges to walls.
void update_bridge_forces(GrainSystem& system);

/// Adds the forces of the bridges to those on the walls.
void add_wall_bridges(GrainSystem& system);

/// What all bridges of a record pull it with [N]; nothing on dry grains.
inline Vec3 bridge_pull_on(const GrainSystem& s, int record) {
  return s.bridges ? vec3(s.bridges->list.pull[to_size(record)].force) : Vec3{};
}

/// Calls `visit(first, second, bridge)` for the bridges between grains, by records, and `visit_wall(wall, record, bridge)` for
/// those to walls, in their order.
template <class Visit, class VisitWall>
void for_each_bridge(const GrainSystem& s, const Visit& visit, const VisitWall& visit_wall) {
  const auto& record = s.bridges->list.record;
  for (int k = 0; k < size_of(record); ++k) {
    const auto [first, second] = record[to_size(k)];
    if (second < 0)
      visit_wall(-1 - second, first, k);
    else
      visit(first, second, k);
  }
}

/// In box lengths, the image of the second grain that is nearest to the first.
std::array<double, 3> nearest_image(const GrainSystem& system, int first, int second);

/// Line from the centre of the first grain to that of the second, its nearest image [m].
Vec3 branch_between(const GrainSystem& system, int first, int second);

/// Line from the foot on a wall to the centre of a grain [m].
Vec3 height_over(const GrainSystem& system, int wall, int record);

/// Gaps and forces of all bridges at the present places.
struct PresentBridges {
  std::vector<double> gap, force;  ///< [m], [N]
};
PresentBridges present_bridges(const GrainSystem& system);

/// The same into `bridges`.
void collect_bridges(GrainSystem& system);

}  // namespace puadem
