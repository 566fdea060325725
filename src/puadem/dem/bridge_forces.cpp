#include "puadem/dem/bridge_forces.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "puadem/dem/contact_kernel.hpp"

namespace puadem {

namespace {

constexpr int grains_per_chunk = 256;
constexpr int grains_worth_threads = 1024;  // below, a second thread brings nothing
constexpr int blocks_ahead = 4;             // whose records are asked for while a block is worked on

struct BridgeLoop {
  const GrainRecord* record;
  const int* start;
  const BridgeBlock* block;
  const BridgeSeries* series;
  const double* force;  ///< of every bridge; null: by the series
  BridgePull* pull;
  Vec3 size;      ///< of the box along periodic axes, elsewhere 0 [m]
  double linear;  ///< B of theory 8.3
};

/// The nearest whole number, for numbers below 2^51.
PUADEM_INLINE Lanes nearest(const Lanes& x) {
  constexpr double shift = 6755399441055744.0;  // 1.5 * 2^52: what is added to it is rounded to whole numbers
  return (x + shift) - shift;
}

PUADEM_INLINE Lanes to_nearest_image(const Lanes& d, double size) {
  return size > 0.0 ? d - size * nearest(d * (1.0 / size)) : d;
}

/// A force as a fraction, of which one division makes the pull along the branch.
struct Fraction {
  Lanes above, below;
};

/// Force at gaps, those that are open. @param away  the gap, 0 in contact
PUADEM_INLINE Fraction force_apart(const BridgeSeries& s, const Lanes& away, double linear) {
  const Lanes zero{};
  const Lanes left = s.reach - away;
  const LaneMask stands = left >= zero;
  const Lanes x = 2.0 * square_root(stands ? left * s.inverse_reach : zero) - 1.0;
  Lanes sum = s.term[bridge_terms - 1];
  for (int k = bridge_terms - 2; k >= 0; --k) sum = sum * x + s.term[static_cast<std::size_t>(k)];
  const Lanes zero_gap = square_root(s.constant + linear * away * away);
  return {stands ? sum * (zero_gap - away) : zero, zero_gap};
}

PUADEM_INLINE Lanes given_force(const double* force, const BridgeBlock& block) {
  Lanes given{};
  for (int l = 0; l < lane_count; ++l)
    if (block.bridge[static_cast<std::size_t>(l)] >= 0) given[l] = force[block.bridge[static_cast<std::size_t>(l)]];
  return given;
}

PUADEM_CLONES void pull_grains(const BridgeLoop& loop, int begin, int end) {
  const Lanes zero{};
  const int last = loop.start[end];
  for (int k = begin; k < end; ++k) {
    const Lanes own = loop.record[k].place;
    const LaneVec3 centre{broadcast(own[0]), broadcast(own[1]), broadcast(own[2])};
    LaneVec3 sum{zero, zero, zero};
    for (int b = loop.start[k]; b < loop.start[k + 1]; ++b) {
      if (b + blocks_ahead < last)
        for (const int j : loop.block[b + blocks_ahead].partner) __builtin_prefetch(loop.record + j);
      const BridgeBlock& block = loop.block[b];
      const Quad at = load<&GrainRecord::place>(loop.record, block.partner);
      LaneVec3 branch = at.vector - centre;
      branch.x = to_nearest_image(branch.x, loop.size.x);
      branch.y = to_nearest_image(branch.y, loop.size.y);
      branch.z = to_nearest_image(branch.z, loop.size.z);
      const Lanes length = square_root(dot(branch, branch)), gap = length - (own[3] + at.scalar);
      const LaneMask is_apart = gap > zero;
      // A grain is no distance from itself, and pulls itself with nothing.
      Fraction force{block.at_contact, length > zero ? length : broadcast(1.0)};
      if (loop.force != nullptr) {
        force.above = given_force(loop.force, block);
      } else if (any(is_apart)) {
        // To the last bit the same beside any neighbours in the block, so that both ends find the same.
        const Fraction apart = force_apart(loop.series[b], is_apart ? gap : zero, loop.linear);
        force.above = is_apart ? apart.above : force.above;
        force.below = is_apart ? apart.below * force.below : force.below;
      }
      sum = sum + (force.above / force.below) * branch;
    }
    Lanes x = sum.x, y = sum.y, z = sum.z, none = zero;
    transpose(x, y, z, none);
    loop.pull[k].force = (x + y) + (z + none);
  }
}

Vec3 periodic_size(const GrainSystem& s) {
  Vec3 size;
  for (int axis = 0; axis < 3; ++axis)
    if (s.domain.periodic[to_size(axis)]) size[axis] = s.domain.size()[axis];
  return size;
}

/// The blocks of every grain: bridges that touched at the last exchange first, each kind by number.
std::vector<std::vector<int>> bridges_of_records(const GrainSystem& s) {
  const GrainBridges& g = *s.bridges;
  std::vector<std::vector<int>> of(to_size(s.owned));
  for (const bool apart : {false, true})
    for (int k = 0; k < g.bridges.size(); ++k) {
      const auto [first, second] = g.list.record[to_size(k)];
      if (second < 0 || (g.bridges.pairs.gap[to_size(k)] > 0.0) != apart) continue;
      of[to_size(first)].push_back(k);
      of[to_size(second)].push_back(k);
    }
  return of;
}

void fill_lane(const GrainBridges& g, int record, int bridge, std::size_t lane, BridgeBlock& block, BridgeSeries& series) {
  const std::size_t k = to_size(bridge), l = lane;
  const auto [first, second] = g.list.record[k];
  const BridgeCurve& curve = g.bridges.curve[k];
  block.partner[l] = first == record ? second : first;
  block.bridge[l] = bridge;
  series.reach[l] = curve.reach;
  series.inverse_reach[l] = 1.0 / curve.reach;
  series.constant[l] = curve.small.constant;
  const double factor = 2.0 * std::numbers::pi * g.model.surface_tension * curve.small.pull;
  for (std::size_t t = 0; t < bridge_terms; ++t) {
    series.term[t][l] = factor * curve.pull[t];
    block.at_contact[l] += series.term[t][l];  // the polynomial at 1
  }
}

BridgeBlock empty_block(int record) {
  BridgeBlock block{};
  block.partner.fill(record);
  block.bridge.fill(-1);
  return block;
}

}  // namespace

void list_bridges(GrainSystem& s) {
  GrainBridges& g = *s.bridges;
  BridgeList& list = g.list;
  std::vector<int> record_of(to_size(s.owned));
  for (int k = 0; k < s.owned; ++k) record_of[to_size(s.identity[to_size(k)])] = k;
  list.record.clear();
  list.at_wall.clear();
  list.first.assign(to_size(s.owned) + 1, 0);
  for (int k = 0; k < g.bridges.size(); ++k) {
    const auto [first, second] = g.bridges.pairs.ends[to_size(k)];
    ++list.first[to_size(first) + 1];
    list.record.push_back({record_of[to_size(first)], second < s.owned ? record_of[to_size(second)] : -1 - (second - s.owned)});
    if (second >= s.owned) list.at_wall.push_back(k);
  }
  std::partial_sum(list.first.begin(), list.first.end(), list.first.begin());
  const auto of_records = bridges_of_records(s);
  list.start.assign(1, 0);
  for (const auto& numbers : of_records)
    list.start.push_back(list.start.back() + (size_of(numbers) + lane_count - 1) / lane_count);
  list.block.resize(to_size(list.start.back()));
  list.series.resize(list.block.size());
  list.pull.assign(to_size(s.owned), BridgePull{});
  parallel_for(s.owned, [&](int k) {
    const auto& numbers = of_records[to_size(k)];
    for (std::size_t n = 0; n < numbers.size(); ++n) {
      const std::size_t b = to_size(list.start[to_size(k)]) + n / lane_count;
      if (n % lane_count == 0) {
        list.block[b] = empty_block(k);
        list.series[b] = BridgeSeries{};
        list.series[b].constant = broadcast(1.0);
      }
      fill_lane(g, k, numbers[n], n % lane_count, list.block[b], list.series[b]);
    }
  });
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

Vec3 branch_between(const GrainSystem& s, int first, int second) {
  Vec3 branch = vec3(s.record[to_size(second)].place - s.record[to_size(first)].place);
  const auto image = nearest_image(s, first, second);
  const Vec3 size = s.domain.size();
  for (int axis = 0; axis < 3; ++axis) branch[axis] += image[to_size(axis)] * size[axis];
  return branch;
}

Vec3 height_over(const GrainSystem& s, int wall, int record) {
  const Wall& w = s.walls[to_size(wall)];
  return dot(vec3(s.record[to_size(record)].place) - w.point, w.normal) * w.normal;
}

PresentBridges present_bridges(const GrainSystem& s) {
  const GrainBridges& g = *s.bridges;
  PresentBridges now;
  now.gap.resize(to_size(g.bridges.size()));
  now.force.resize(now.gap.size());
  parallel_for(g.bridges.size(), [&](int k) {
    const auto [first, second] = g.list.record[to_size(k)];
    const double r = radius_of(s.record[to_size(first)]);
    now.gap[to_size(k)] = second < 0 ? dot(height_over(s, -1 - second, first), s.walls[to_size(-1 - second)].normal) - r
                                     : norm(branch_between(s, first, second)) - (r + radius_of(s.record[to_size(second)]));
  });
  if (g.model.law == BridgeModel::Law::table) {
    bridge_forces(g.model.surface_tension, g.bridges.curve, now.gap, now.force);
  } else {
    Bridges copy = g.bridges;
    copy.pairs.gap = now.gap;
    update_forces(g.model, copy);
    now.force = copy.force;
  }
  return now;
}

void collect_bridges(GrainSystem& s) {
  PresentBridges now = present_bridges(s);
  s.bridges->bridges.pairs.gap = std::move(now.gap);
  s.bridges->bridges.force = std::move(now.force);
}

void update_bridge_forces(GrainSystem& s) {
  GrainBridges& g = *s.bridges;
  const bool by_series = g.model.law == BridgeModel::Law::table;
  PresentBridges given;
  if (!by_series) given = present_bridges(s);
  const BridgeLoop loop{.record = s.record.data(),
                        .start = g.list.start.data(),
                        .block = g.list.block.data(),
                        .series = g.list.series.data(),
                        .force = by_series ? nullptr : given.force.data(),
                        .pull = g.list.pull.data(),
                        .size = periodic_size(s),
                        .linear = g.model.table.control == BridgeControl::volume ? 1.0 : 0.0};
  const int chunks = (s.owned + grains_per_chunk - 1) / grains_per_chunk;
  parallel_for(
      chunks,
      [&](int chunk) {
        const int begin = chunk * grains_per_chunk;
        pull_grains(loop, begin, std::min(begin + grains_per_chunk, s.owned));
      },
      s.owned < grains_worth_threads ? chunks : 1);
  for (const int k : g.list.at_wall) {
    const auto [record, wall] = g.list.record[to_size(k)];
    const Vec3& normal = s.walls[to_size(-1 - wall)].normal;
    const double gap = dot(height_over(s, -1 - wall, record), normal) - radius_of(s.record[to_size(record)]);
    const BridgeCurve& curve = g.bridges.curve[to_size(k)];
    double& force = g.bridges.force[to_size(k)];
    if (!by_series)
      force = given.force[to_size(k)];
    else
      force = gap > curve.reach ? 0.0 : 2.0 * std::numbers::pi * g.model.surface_tension * bridge_pull(curve, gap);
    const Vec3 f = -force * normal;
    g.list.pull[to_size(record)].force += Lanes{f.x, f.y, f.z, 0.0};
  }
}

void add_wall_bridges(GrainSystem& s) {
  const GrainBridges& g = *s.bridges;
  for (const int k : g.list.at_wall) {
    Wall& wall = s.walls[to_size(-1 - g.list.record[to_size(k)][1])];
    wall.force += g.bridges.force[to_size(k)] * wall.normal;
  }
}

}  // namespace puadem
