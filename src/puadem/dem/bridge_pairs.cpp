#include "puadem/dem/bridge_pairs.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "puadem/base/error.hpp"
#include "puadem/bridges/bridge_formulas.hpp"
#include "puadem/dem/bridge_forces.hpp"
#include "puadem/dem/cell_grid.hpp"
#include "puadem/dem/contacts.hpp"

namespace puadem {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

double largest_radius(const GrainSystem& s) {
  double largest = 0.0;
  for (int k = 0; k < s.owned; ++k) largest = std::max(largest, radius_of(s.record[to_size(k)]));
  return largest;
}

/// Owned grains, then their images nearer than `reach` to the box, with the record of each.
std::vector<int> spheres_around(const GrainSystem& s, double reach, LargeArray<Lanes>& place) {
  std::vector<int> record;
  const Vec3 size = s.domain.size();
  const auto add = [&](int k, const std::array<int, 3>& shift) {
    Lanes x = s.record[to_size(k)].place;
    for (int axis = 0; axis < 3; ++axis) x[axis] += shift[to_size(axis)] * size[axis];
    for (int axis = 0; axis < 3; ++axis)
      if (shift[to_size(axis)] != 0 && (x[axis] < s.domain.lower[axis] - reach || x[axis] > s.domain.upper[axis] + reach)) return;
    place.push_back(x);
    record.push_back(k);
  };
  for (int k = 0; k < s.owned; ++k) add(k, {0, 0, 0});
  const auto most = [&](int axis) { return s.domain.periodic[to_size(axis)] ? 1 : 0; };
  for (int k = 0; k < s.owned; ++k)
    for (int a = -most(0); a <= most(0); ++a)
      for (int b = -most(1); b <= most(1); ++b)
        for (int c = -most(2); c <= most(2); ++c)
          if (a != 0 || b != 0 || c != 0) add(k, {a, b, c});
  return record;
}

void note(GrainSystem& s, const ContactBlocks& blocks, bool at_wall, std::vector<std::uint8_t>& met) {
  GrainBridges& g = *s.bridges;
  const auto& ends = g.bridges.pairs.ends;
  for (int b = 0; b < blocks.size(); ++b) {
    const auto fresh = static_cast<std::uint8_t>(blocks.live[to_size(b)] & ~met[to_size(b)]);
    if (fresh == 0) continue;
    met[to_size(b)] = static_cast<std::uint8_t>(met[to_size(b)] | fresh);
    for (unsigned l = 0; l < lane_count; ++l) {
      if ((fresh >> l & 1u) == 0) continue;
      const int first = blocks.first[to_size(b)][l], second = s.identity[to_size(blocks.second[to_size(b)][l])];
      const std::array<int, 2> pair =
          at_wall ? std::array{second, s.owned + first} : std::array{s.identity[to_size(first)], second};
      const auto from = ends.begin() + g.list.first[to_size(pair[0])], to = ends.begin() + g.list.first[to_size(pair[0]) + 1];
      if (std::find(from, to, pair) == to) g.touched.push_back(pair);
    }
  }
}

}  // namespace

std::vector<std::array<int, 2>> touching_ends(const GrainSystem& s) {
  std::vector<std::array<int, 2>> ends;
  for_each_grain_contact(s, [&](int first, int second, const Vec3&, int) {
    ends.push_back({s.identity[to_size(first)], s.identity[to_size(second)]});
  });
  for_each_wall_contact(s, [&](int wall, int record, const Vec3&, int) {
    ends.push_back({s.identity[to_size(record)], s.owned + wall});
  });
  std::ranges::sort(ends);
  return ends;
}

BridgePairs pairs_between(const GrainSystem& s, const std::vector<std::array<int, 2>>& ends) {
  std::vector<int> record_of(to_size(s.owned));
  for (int k = 0; k < s.owned; ++k) record_of[to_size(s.identity[to_size(k)])] = k;
  BridgePairs pairs;
  for (const auto& pair : ends) {
    const int first = record_of[to_size(pair[0])];
    const GrainRecord& a = s.record[to_size(first)];
    pairs.ends.push_back(pair);
    if (pair[1] >= s.owned) {
      const Wall& wall = s.walls[to_size(pair[1] - s.owned)];
      pairs.radius.push_back({radius_of(a), infinity});
      pairs.gap.push_back(dot(vec3(a.place) - wall.point, wall.normal) - radius_of(a));
      continue;
    }
    const int second = record_of[to_size(pair[1])];
    const GrainRecord& b = s.record[to_size(second)];
    pairs.radius.push_back({radius_of(a), radius_of(b)});
    pairs.gap.push_back(norm(branch_between(s, first, second)) - radius_of(a) - radius_of(b));
  }
  return pairs;
}

BridgePairs pairs_within(const GrainSystem& s, double reach) {
  LargeArray<Lanes> place;
  const std::vector<int> record = spheres_around(s, 2.0 * largest_radius(s) + reach, place);
  std::vector<std::array<int, 2>> ends;
  for_each_close_pair(make_sized_grids(place, reach), place, reach, [&](int a, int b) {
    const int i = s.identity[to_size(record[to_size(a)])], j = s.identity[to_size(record[to_size(b)])];
    if ((a < s.owned || b < s.owned) && i != j) ends.push_back({std::min(i, j), std::max(i, j)});
  });
  for (int w = 0; w < size_of(s.walls); ++w)
    for (int k = 0; k < s.owned; ++k) {
      const GrainRecord& r = s.record[to_size(k)];
      const Wall& wall = s.walls[to_size(w)];
      if (dot(vec3(r.place) - wall.point, wall.normal) - radius_of(r) < reach)
        ends.push_back({s.identity[to_size(k)], s.owned + w});
    }
  std::ranges::sort(ends);
  ends.erase(std::ranges::unique(ends).begin(), ends.end());  // a pair across a face is found from both sides
  return pairs_between(s, ends);
}

double farthest_bridge(const GrainSystem& s, const BridgeModel& model, const BridgeSupply& supply) {
  const double radius = largest_radius(s);
  const double at_wall = s.walls.empty() ? radius : infinity;
  if (model.table.control == BridgeControl::suction)
    return bridge_curve(model.table, {radius, at_wall}, supply.suction / model.surface_tension).reach;
  constexpr double over_lian = 1.5;  // the exact distance exceeds the rule by less
  const double most = volume_range(model, {radius, at_wall})[1];
  return over_lian * lian_reach(model.table.contact_angle, supply.total > 0.0 ? std::min(supply.total, most) : supply.each);
}

std::vector<double> shared_volume(const BridgeModel& model, const BridgePairs& pairs, double total) {
  const std::size_t count = pairs.ends.size();
  std::vector<double> volume(count);
  // Height at which small bridges of one suction end: all their volumes grow with it.
  const auto share = [&](double height) {
    double sum = 0.0;
    for (std::size_t n = 0; n < count; ++n) {
      const double reduced = reduced_radius(pairs.radius[n]), gap = std::max(pairs.gap[n], 0.0);
      const double v = gap < height ? 0.5 * std::numbers::pi * reduced * (height * height - gap * gap) : 0.0;
      volume[n] = gap <= lian_reach(model.table.contact_angle, v) ? v : 0.0;
      sum += volume[n];
    }
    return sum;
  };
  double low = 0.0, high = std::cbrt(total);
  while (share(high) < total) high *= 2.0;
  for (int k = 0; k < 60; ++k) {
    const double middle = 0.5 * (low + high);
    (share(middle) < total ? low : high) = middle;
  }
  const double sum = share(high);
  for (double& v : volume) v *= total / sum;
  return volume;
}

void note_touches(GrainSystem& s) {
  note(s, s.grain_contacts, false, s.bridges->list.met_grains);
  note(s, s.wall_contacts, true, s.bridges->list.met_walls);
}

void guard_images(const GrainSystem& s) {
  double reach = 0.0;
  for (int k = 0; k < s.bridges->bridges.size(); ++k)
    reach = std::max(reach, rupture_distance(s.bridges->model, s.bridges->bridges, k));
  const double needed = 2.0 * (2.0 * largest_radius(s) + reach);
  for (int axis = 0; axis < 3; ++axis)
    require(
        !s.domain.periodic[to_size(axis)] || s.domain.size()[axis] > needed,
        "liquid bridges: the periodic box is {:.4g} m wide along axis {}; bridges that reach {:.3g} m need more than {:.4g} m",
        s.domain.size()[axis], axis, reach, needed);
}

}  // namespace puadem
