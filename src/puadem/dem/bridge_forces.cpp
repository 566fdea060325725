#include "puadem/dem/bridge_forces.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "puadem/dem/contact_kernel.hpp"

namespace puadem {

namespace {

constexpr int blocks_per_chunk = 64;
constexpr int blocks_worth_threads = 512;  // below, a second thread brings nothing
constexpr int blocks_ahead = 4;            // whose records are asked for while a block is worked on
constexpr int records_per_group = 128;

struct BridgeLoop {
  const GrainRecord* record;
  BridgeBlock* block;
  const BridgeSeries* series;
  ContactSlot* slot;  ///< of block 0
  Vec3 size;          ///< of the box along periodic axes, elsewhere 0 [m]
  double linear;      ///< B of theory 8.3
  bool by_series;     ///< else the forces stand in the blocks
};

/// The nearest whole number, for numbers below 2^51.
PUADEM_INLINE Lanes nearest(const Lanes& x) {
  constexpr double shift = 6755399441055744.0;  // 1.5 * 2^52: what is added to it is rounded to whole numbers
  return (x + shift) - shift;
}

PUADEM_INLINE Lanes to_nearest_image(const Lanes& d, double size) {
  return size > 0.0 ? d - size * nearest(d * (1.0 / size)) : d;
}

/// Force at gaps of which some are open. @param away  the gap, 0 in contact
PUADEM_INLINE Lanes force_apart(const BridgeBlock& block, const BridgeSeries& s, const Lanes& away, double linear) {
  const Lanes zero{};
  const LaneMask stands = away <= block.reach;
  const Lanes x = 2.0 * square_root(stands ? 1.0 - away / block.reach : zero) - 1.0;
  Lanes sum = s.term[bridge_terms - 1];
  for (int k = bridge_terms - 2; k >= 0; --k) sum = sum * x + s.term[static_cast<std::size_t>(k)];
  const Lanes force = sum * (1.0 - away / square_root(s.constant + linear * away * away));
  return stands ? force : zero;
}

PUADEM_CLONES void bridge_blocks(const BridgeLoop& loop, int begin, int end) {
  const GrainRecord* record = loop.record;
  const Lanes zero{};
  for (int b = begin; b < end; ++b) {
    if (b + blocks_ahead < end)
      for (const auto* four : {&loop.block[b + blocks_ahead].first, &loop.block[b + blocks_ahead].second})
        for (const int k : *four) __builtin_prefetch(record + k);
    BridgeBlock& block = loop.block[b];
    const Quad at_i = load<&GrainRecord::place>(record, block.first), at_j = load<&GrainRecord::place>(record, block.second);
    LaneVec3 branch = at_j.vector - at_i.vector;
    branch.x = to_nearest_image(branch.x, loop.size.x);
    branch.y = to_nearest_image(branch.y, loop.size.y);
    branch.z = to_nearest_image(branch.z, loop.size.z);
    const Lanes length = square_root(dot(branch, branch));
    block.gap = length - (at_i.scalar + at_j.scalar);
    if (loop.by_series) {
      const LaneMask is_apart = block.gap > zero;
      block.force = block.at_contact;
      if (any(is_apart)) {
        // To the last bit the same beside any neighbours in the block.
        const Lanes apart = force_apart(block, loop.series[b], is_apart ? block.gap : zero, loop.linear);
        block.force = is_apart ? apart : block.at_contact;
      }
    }
    // Empty lanes join the dummy to itself and pull with nothing.
    const Lanes pull = block.force / (length > zero ? length : broadcast(1.0));
    Lanes x = -pull * branch.x, y = -pull * branch.y, z = -pull * branch.z, normal = -block.force;
    transpose(x, y, z, normal);
    ContactSlot* slot = loop.slot + lane_count * b;
    slot[0].force = x;
    slot[1].force = y;
    slot[2].force = z;
    slot[3].force = normal;
  }
}

Vec3 periodic_size(const GrainSystem& s) {
  Vec3 size;
  for (int axis = 0; axis < 3; ++axis)
    if (s.domain.periodic[to_size(axis)]) size[axis] = s.domain.size()[axis];
  return size;
}

void run_blocks(GrainSystem& s, bool by_series) {
  BridgeList& list = s.bridges->list;
  const int blocks = size_of(list.block);
  const BridgeLoop loop{.record = s.record.data(),
                        .block = list.block.data(),
                        .series = list.series.data(),
                        .slot = s.slot.data() + lane_count * (s.grain_contacts.size() + s.wall_contacts.size()),
                        .size = periodic_size(s),
                        .linear = s.bridges->model.table.control == BridgeControl::volume ? 1.0 : 0.0,
                        .by_series = by_series};
  const int chunks = (blocks + blocks_per_chunk - 1) / blocks_per_chunk;
  parallel_for(
      chunks,
      [&](int chunk) {
        const int begin = chunk * blocks_per_chunk;
        bridge_blocks(loop, begin, std::min(begin + blocks_per_chunk, blocks));
      },
      blocks < blocks_worth_threads ? chunks : 2);
}

/// Gap and, by the table, force of the bridges to walls.
void update_wall_bridges(GrainSystem& s, bool by_series) {
  GrainBridges& g = *s.bridges;
  const int offset = lane_count * (s.grain_contacts.size() + s.wall_contacts.size() + size_of(g.list.block));
  for (int w = 0; w < size_of(g.list.at_wall); ++w) {
    const std::size_t k = to_size(g.list.at_wall[to_size(w)]);
    const GrainRecord& r = s.record[to_size(g.list.record_at_wall[to_size(w)])];
    const Wall& wall = s.walls[to_size(g.bridges.pairs.ends[k][1] - s.owned)];
    const double gap = dot(vec3(r.place) - wall.point, wall.normal) - radius_of(r);
    g.bridges.pairs.gap[k] = gap;
    const BridgeCurve& curve = g.bridges.curve[k];
    if (by_series)
      g.bridges.force[k] = gap > curve.reach ? 0.0 : 2.0 * std::numbers::pi * g.model.surface_tension * bridge_pull(curve, gap);
    const Vec3 force = -g.bridges.force[k] * wall.normal;
    s.slot[to_size(offset + w)].force = Lanes{force.x, force.y, force.z, -g.bridges.force[k]};
  }
}

void fill_block(const GrainBridges& g, std::span<const int> number, const std::vector<int>& record_of, int dummy,
                BridgeBlock& block, BridgeSeries& series) {
  block = BridgeBlock{};
  series = BridgeSeries{};
  series.constant = broadcast(1.0);
  block.first.fill(dummy);
  block.second.fill(dummy);
  block.bridge.fill(-1);
  block.reach = broadcast(1.0);
  for (std::size_t l = 0; l < number.size(); ++l) {
    const std::size_t k = to_size(number[l]);
    const BridgeCurve& curve = g.bridges.curve[k];
    block.first[l] = record_of[to_size(g.bridges.pairs.ends[k][0])];
    block.second[l] = record_of[to_size(g.bridges.pairs.ends[k][1])];
    block.bridge[l] = number[l];
    block.reach[l] = curve.reach;
    block.gap[l] = g.bridges.pairs.gap[k];
    block.force[l] = g.bridges.force[k];
    series.constant[l] = curve.small.constant;
    const double factor = 2.0 * std::numbers::pi * g.model.surface_tension * curve.small.pull;
    for (std::size_t t = 0; t < bridge_terms; ++t) {
      series.term[t][l] = factor * curve.pull[t];
      block.at_contact[l] += series.term[t][l];  // the polynomial at 1
    }
  }
}

}  // namespace

int bridge_slots(const BridgeList& list) { return lane_count * size_of(list.block) + size_of(list.at_wall); }

void list_bridges(GrainSystem& s) {
  GrainBridges& g = *s.bridges;
  BridgeList& list = g.list;
  std::vector<int> record_of(to_size(s.owned));
  for (int k = 0; k < s.owned; ++k) record_of[to_size(s.identity[to_size(k)])] = k;
  const auto& ends = g.bridges.pairs.ends;
  list.at_wall.clear();
  list.record_at_wall.clear();
  list.start.assign(to_size(s.owned) + 1, 0);
  // Bridges that touch stand together, so that most blocks need no series; groups of records keep the memory near.
  const int groups = s.owned / records_per_group + 1;
  std::vector<std::vector<int>> touching(to_size(groups)), apart(to_size(groups));
  for (int k = 0; k < g.bridges.size(); ++k) {
    ++list.start[to_size(ends[to_size(k)][0]) + 1];
    const int record = record_of[to_size(ends[to_size(k)][0])];
    if (ends[to_size(k)][1] >= s.owned) {
      list.at_wall.push_back(k);
      list.record_at_wall.push_back(record);
    } else {
      (g.bridges.pairs.gap[to_size(k)] > 0.0 ? apart : touching)[to_size(record / records_per_group)].push_back(k);
    }
  }
  std::partial_sum(list.start.begin(), list.start.end(), list.start.begin());
  const int dummy = s.owned + size_of(s.image_owner);
  list.block.clear();
  list.series.clear();
  for (std::size_t group = 0; group < to_size(groups); ++group)
    for (const auto* numbers : {&touching[group], &apart[group]})
      for (std::size_t n = 0; n < numbers->size(); n += lane_count)
        fill_block(g, std::span(*numbers).subspan(n, std::min<std::size_t>(lane_count, numbers->size() - n)), record_of, dummy,
                   list.block.emplace_back(), list.series.emplace_back());
  list.met_grains.assign(to_size(s.grain_contacts.size()), 0);
  list.met_walls.assign(to_size(s.wall_contacts.size()), 0);
}

std::array<double, 3> nearest_image(const GrainSystem& s, int first, int second) {
  const Lanes d = s.record[to_size(second)].place - s.record[to_size(first)].place;
  const Vec3 size = periodic_size(s);
  std::array<double, 3> shift{};
  for (int axis = 0; axis < 3; ++axis)
    if (size[axis] > 0.0) shift[to_size(axis)] = -std::nearbyint(d[axis] / size[axis]);
  return shift;
}

void update_bridge_forces(GrainSystem& s) {
  GrainBridges& g = *s.bridges;
  const bool by_series = g.model.law == BridgeModel::Law::table;
  run_blocks(s, by_series);
  update_wall_bridges(s, by_series);
  if (by_series) return;
  collect_bridges(g);
  update_forces(g.model, g.bridges);
  for (BridgeBlock& block : g.list.block)
    for (int l = 0; l < lane_count; ++l)
      if (const int k = block.bridge[to_size(l)]; k >= 0) block.force[l] = g.bridges.force[to_size(k)];
  run_blocks(s, false);
  update_wall_bridges(s, false);
}

void add_wall_bridges(GrainSystem& s) {
  const GrainBridges& g = *s.bridges;
  for (const int k : g.list.at_wall) {
    Wall& wall = s.walls[to_size(g.bridges.pairs.ends[to_size(k)][1] - s.owned)];
    wall.force += g.bridges.force[to_size(k)] * wall.normal;
  }
}

void collect_bridges(GrainBridges& g) {
  for (const BridgeBlock& block : g.list.block)
    for (int l = 0; l < lane_count; ++l)
      if (const int k = block.bridge[to_size(l)]; k >= 0) {
        g.bridges.pairs.gap[to_size(k)] = block.gap[l];
        g.bridges.force[to_size(k)] = block.force[l];
      }
}

}  // namespace puadem
