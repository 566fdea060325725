#include "puadem/dem/neighbour_list.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "puadem/base/csr.hpp"
#include "puadem/base/error.hpp"
#include "puadem/dem/bridge_forces.hpp"
#include "puadem/dem/cell_grid.hpp"
#include "puadem/dem/contact_forces.hpp"
#include "puadem/dem/contact_history.hpp"

namespace puadem {

namespace {

constexpr int grains_per_group = 128;

std::uint64_t spread_bits(std::uint64_t v) {
  v &= 0x1fffff;
  v = (v | v << 32) & 0x1f00000000ffffULL;
  v = (v | v << 16) & 0x1f0000ff0000ffULL;
  v = (v | v << 8) & 0x100f00f00f00f00fULL;
  v = (v | v << 4) & 0x10c30c30c30c30c3ULL;
  return (v | v << 2) & 0x1249249249249249ULL;
}

/// Moves grains that have crossed a periodic face to the other side, with the velocity of the box there.
void wrap(GrainSystem& s) {
  const Vec3 size = s.domain.size();
  for (int axis = 0; axis < 3; ++axis) {
    if (!s.domain.periodic[static_cast<unsigned>(axis)]) continue;
    for (int k = 0; k < s.owned; ++k) {
      GrainRecord& r = s.record[to_size(k)];
      const double boxes = std::floor((r.place[axis] - s.domain.lower[axis]) / size[axis]);
      if (boxes == 0.0) continue;
      r.place[axis] -= boxes * size[axis];
      r.drift[axis] -= boxes * s.box_rate[axis];
    }
  }
}

/// Sorts the owned records along a Morton curve of cells about one grain wide.
void sort_records(GrainSystem& s) {
  const Vec3 size = s.domain.size();
  const double width = std::cbrt(size.x * size.y * size.z / s.owned);
  LargeArray<std::pair<std::uint64_t, int>> key(to_size(s.owned));
  for (int k = 0; k < s.owned; ++k) {
    const GrainRecord& r = s.record[to_size(k)];
    std::uint64_t code = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const double cell = std::max((r.place[axis] - s.domain.lower[axis]) / width, 0.0);
      code |= spread_bits(static_cast<std::uint64_t>(cell)) << axis;
    }
    key[to_size(k)] = {code, k};
  }
  std::sort(key.begin(), key.end(), [&](const auto& a, const auto& b) {
    return a.first != b.first ? a.first < b.first : s.identity[to_size(a.second)] < s.identity[to_size(b.second)];
  });
  LargeArray<GrainRecord> record(to_size(s.owned));
  std::vector<int> identity(to_size(s.owned));
  for (int k = 0; k < s.owned; ++k) {
    record[to_size(k)] = s.record[to_size(key[to_size(k)].second)];
    identity[to_size(k)] = s.identity[to_size(key[to_size(k)].second)];
  }
  s.record = std::move(record);
  s.identity = std::move(identity);
}

/// Images of all grains that may touch something across a periodic face; then the dummy.
void make_images(GrainSystem& s, double largest_radius) {
  s.image_owner.clear();
  s.image_shift.clear();
  s.record.resize(to_size(s.owned));
  s.identity.resize(to_size(s.owned));
  for (int k = 0; k < s.owned; ++k) {
    const Lanes place = s.record[to_size(k)].place;
    const double reach = place[3] + largest_radius + s.skin;
    std::array<std::array<int, 2>, 3> range{};
    for (int axis = 0; axis < 3; ++axis) {
      if (!s.domain.periodic[static_cast<unsigned>(axis)]) continue;
      if (place[axis] > s.domain.upper[axis] - reach) range[static_cast<unsigned>(axis)][0] = -1;
      if (place[axis] < s.domain.lower[axis] + reach) range[static_cast<unsigned>(axis)][1] = 1;
    }
    for (int a = range[0][0]; a <= range[0][1]; ++a)
      for (int b = range[1][0]; b <= range[1][1]; ++b)
        for (int c = range[2][0]; c <= range[2][1]; ++c) {
          if (a == 0 && b == 0 && c == 0) continue;
          s.image_owner.push_back(k);
          s.image_shift.push_back({a, b, c});
          s.identity.push_back(s.identity[to_size(k)]);
        }
  }
  s.record.resize(to_size(s.owned) + s.image_owner.size() + 1);
  GrainRecord& dummy = s.record.back();
  const Vec3 middle = 0.5 * (s.domain.lower + s.domain.upper);
  dummy = {Lanes{middle.x, middle.y, middle.z, 0.0}, Lanes{0, 0, 0, 1.0}, Lanes{}, Lanes{0, 0, 0, 1.0}};
  update_images(s);
}

struct Candidate {
  int first, second;  ///< records; for walls the wall first
};

/// Candidates of neighbouring grains. Pairs that touch stand together, so that blocks without a contact leave
/// the kernel early.
struct Group {
  std::vector<Candidate> touching, near;
};

int blocks_for(const std::vector<Candidate>& candidates) { return (size_of(candidates) + lane_count - 1) / lane_count; }

/// First block of every group, and their number.
std::vector<int> block_starts(const std::vector<Group>& groups) {
  std::vector<int> start{0};
  for (const Group& g : groups) start.push_back(start.back() + blocks_for(g.touching) + blocks_for(g.near));
  return start;
}

/// Lists the groups in blocks of four with the history kept for them.
/// @param dummy_first  in group g the first of a lane without a candidate
/// @param owner, partner  names of a candidate in the history
template <class DummyFirst, class Owner, class Partner>
ContactBlocks fill_blocks(const GrainSystem& s, const std::vector<Group>& groups, const std::vector<int>& start,
                          const ContactHistory& history, const DummyFirst& dummy_first, const Owner& owner,
                          const Partner& partner) {
  const int dummy = s.owned + size_of(s.image_owner);
  const std::size_t count = to_size(start.back());
  ContactBlocks blocks;
  blocks.first.resize(count);
  blocks.second.resize(count, {dummy, dummy, dummy, dummy});
  blocks.shear.resize(count);
  if (resists_rolling(s.contact)) blocks.roll.resize(count);
  if (has_dashpots(s)) blocks.viscous.resize(count);
  blocks.live.resize(count, 1);
  const auto fill = [&](int block, const std::vector<Candidate>& candidates, int empty) {
    for (int c = 0; c < lane_count * blocks_for(candidates); ++c) {
      const int b = block + c / lane_count, lane = c % lane_count;
      blocks.first[to_size(b)][to_size(lane)] = empty;
      if (c >= size_of(candidates)) continue;
      const Candidate& candidate = candidates[to_size(c)];
      blocks.first[to_size(b)][to_size(lane)] = candidate.first;
      blocks.second[to_size(b)][to_size(lane)] = candidate.second;
      restore_history(history, owner(candidate), partner(candidate), blocks, b, lane);
    }
  };
  parallel_for(
      size_of(groups),
      [&](int g) {
        const Group& group = groups[to_size(g)];
        fill(start[to_size(g)], group.touching, dummy_first(g));
        fill(start[to_size(g)] + blocks_for(group.touching), group.near, dummy_first(g));
      },
      4);
  return blocks;
}

/// A pair across a periodic face is listed by the grain of lower identity and the image of the other.
std::vector<Group> find_groups(const GrainSystem& s) {
  const int spheres = s.owned + size_of(s.image_owner);
  LargeArray<Lanes> place(to_size(spheres));
  for (int k = 0; k < spheres; ++k) place[to_size(k)] = s.record[to_size(k)].place;
  const SizedGrids grids = make_sized_grids(place, s.skin);
  const int* identity = s.identity.data();
  std::vector<Group> groups(to_size((spheres + grains_per_group - 1) / grains_per_group));
  const auto search = [&](int g) {
    Group& group = groups[to_size(g)];
    for (int a = g * grains_per_group; a < std::min((g + 1) * grains_per_group, spheres); ++a)
      for_each_later_partner(grids, place, s.skin, a, [&](int b) {
        if (a >= s.owned && b >= s.owned) return;
        const Candidate pair = identity[a] < identity[b] ? Candidate{a, b} : Candidate{b, a};
        if (pair.first >= s.owned || identity[a] == identity[b]) return;
        const Lanes d = place[to_size(a)] - place[to_size(b)];
        const double reach = place[to_size(a)][3] + place[to_size(b)][3];
        (d[0] * d[0] + d[1] * d[1] + d[2] * d[2] < reach * reach ? group.touching : group.near).push_back(pair);
      });
  };
  parallel_for(size_of(groups), search, 4);
  return groups;
}

void list_grain_contacts(GrainSystem& s, const ContactHistory& history) {
  const std::vector<Group> groups = find_groups(s);
  const int dummy = s.owned + size_of(s.image_owner);
  const int* identity = s.identity.data();
  s.grain_contacts = fill_blocks(
      s, groups, block_starts(groups), history, [&](int) { return dummy; }, [&](const Candidate& c) { return identity[c.first]; },
      [&](const Candidate& c) { return identity[c.second]; });
}

/// One group a wall, its grains by identity.
void list_wall_contacts(GrainSystem& s, const ContactHistory& history) {
  std::vector<int> record_of(to_size(s.owned));
  for (int k = 0; k < s.owned; ++k) record_of[to_size(s.identity[to_size(k)])] = k;
  std::vector<Group> groups(s.walls.size());
  const auto search = [&](int w) {
    const Wall& wall = s.walls[to_size(w)];
    for (const int k : record_of) {
      const GrainRecord& r = s.record[to_size(k)];
      if (dot(vec3(r.place) - wall.point, wall.normal) < radius_of(r) + s.skin) groups[to_size(w)].near.push_back({w, k});
    }
  };
  parallel_for(size_of(groups), search, 1);
  s.wall_start = block_starts(groups);
  s.wall_contacts = fill_blocks(
      s, groups, s.wall_start, history, [](int w) { return w; },
      [&](const Candidate& c) { return s.identity[to_size(c.second)]; }, [](const Candidate& c) { return c.first; });
}

/// For every grain its slots by identity of the partner, walls last.
void make_rows(GrainSystem& s) {
  struct Entry {
    int partner, place;
  };
  const int dummy = s.owned + size_of(s.image_owner);
  const auto owner = [&](int record) { return record < s.owned ? record : s.image_owner[to_size(record - s.owned)]; };
  auto& start = s.row_start;
  start.assign(to_size(s.owned) + 1, 0);
  const auto for_each_end = [&](const auto& visit) {
    const ContactBlocks& g = s.grain_contacts;
    for (int b = 0; b < g.size(); ++b)
      for (int l = 0; l < lane_count; ++l) {
        const int first = g.first[to_size(b)][to_size(l)], second = g.second[to_size(b)][to_size(l)];
        if (second == dummy) continue;
        const int slot = lane_count * b + l;
        visit(owner(first), s.identity[to_size(second)], 2 * slot);
        visit(owner(second), s.identity[to_size(first)], 2 * slot + 1);
      }
    const ContactBlocks& w = s.wall_contacts;
    for (int b = 0; b < w.size(); ++b)
      for (int l = 0; l < lane_count; ++l) {
        const int second = w.second[to_size(b)][to_size(l)];
        if (second != dummy) visit(second, s.owned + w.first[to_size(b)][to_size(l)], 2 * (lane_count * (g.size() + b) + l) + 1);
      }
  };
  for_each_end([&](int record, int, int) { ++start[to_size(record) + 1]; });
  std::partial_sum(start.begin(), start.end(), start.begin());
  LargeArray<Entry> entry(to_size(start.back()));
  std::vector<int> next(start.begin(), start.end() - 1);
  for_each_end([&](int record, int partner, int place) { entry[to_size(next[to_size(record)]++)] = {partner, place}; });
  s.row.assign(entry.size() + to_size(rows_ahead), 0);
  parallel_for(s.owned, [&](int k) {
    const auto begin = entry.begin() + start[to_size(k)], end = entry.begin() + start[to_size(k) + 1];
    std::sort(begin, end,
              [](const Entry& a, const Entry& b) { return a.partner != b.partner ? a.partner < b.partner : a.place < b.place; });
    for (auto e = begin; e != end; ++e) s.row[to_size(static_cast<int>(e - entry.begin()))] = e->place;
  });
}

void remember_places(GrainSystem& s) {
  s.listed_at.resize(to_size(s.owned));
  for (int k = 0; k < s.owned; ++k) s.listed_at[to_size(k)] = vec3(s.record[to_size(k)].place);
  s.listed_in = s.domain;
  s.walls_listed_at.clear();
  for (const Wall& wall : s.walls) s.walls_listed_at.push_back(wall.point);
  s.slack = s.grown = 0.0;
  s.listed_step = s.steps;
  ++s.list_builds;
}

/// The skin balances the cost of a build against that of pairs that do not touch: a build is worth about
/// as much as twenty steps. A skin wider than the smallest grains would give them too many neighbours.
void adapt_skin(GrainSystem& s, double smallest_radius, double largest_radius) {
  const long lived = s.steps - s.listed_step;
  if (s.list_builds == 0)
    s.skin = 0.2 * smallest_radius;
  else if (lived < 40)
    s.skin = std::min({1.25 * s.skin, 0.5 * largest_radius, smallest_radius});
  else if (lived > 400)
    s.skin = std::max(0.8 * s.skin, 0.05 * smallest_radius);
}

/// Largest approach of two surfaces of grains, or of a grain and a wall, since the list was made; what the box strained
/// brings two listed grains closer by at most its largest shortening times their reach.
double approach_since(const GrainSystem& s, double largest_radius) {
  const Vec3 size = s.domain.size(), old_size = s.listed_in.size();
  Vec3 stretch{1, 1, 1};
  if (s.motion.strain_with_box || s.domain.periodic != std::array<bool, 3>{})
    stretch = {size.x / old_size.x, size.y / old_size.y, size.z / old_size.z};
  double squared = 0.0;
  for (int k = 0; k < s.owned; ++k) {
    const Vec3 from = s.listed_at[to_size(k)] - s.listed_in.lower;
    const Vec3 moved =
        vec3(s.record[to_size(k)].place) - s.domain.lower - Vec3{from.x * stretch.x, from.y * stretch.y, from.z * stretch.z};
    squared = std::max(squared, squared_norm(moved));
  }
  const double grains = std::sqrt(squared);
  const double strain = std::max({1.0 - stretch.x, 1.0 - stretch.y, 1.0 - stretch.z, 0.0});
  double walls = 0.0;
  for (int w = 0; w < size_of(s.walls); ++w) {
    const Vec3 old = s.walls_listed_at[to_size(w)] - s.listed_in.lower;
    const Vec3 carried = s.domain.lower + Vec3{old.x * stretch.x, old.y * stretch.y, old.z * stretch.z};
    walls = std::max(walls, std::abs(dot(s.walls[to_size(w)].point - carried, s.walls[to_size(w)].normal)));
  }
  return grains + std::max(grains, walls) + strain * (2.0 * largest_radius + s.skin) + 2.0 * s.grown;
}

std::array<double, 2> radius_range(const GrainSystem& s) {
  std::array<double, 2> range{radius_of(s.record[0]), radius_of(s.record[0])};
  for (int k = 0; k < s.owned; ++k) {
    range[0] = std::min(range[0], radius_of(s.record[to_size(k)]));
    range[1] = std::max(range[1], radius_of(s.record[to_size(k)]));
  }
  return range;
}

}  // namespace

void update_images(GrainSystem& s) {
  const Vec3 size = s.domain.size();
  parallel_for(size_of(s.image_owner), [&](int k) {
    const GrainRecord& owner = s.record[to_size(s.image_owner[to_size(k)])];
    const auto& shift = s.image_shift[to_size(k)];
    GrainRecord& image = s.record[to_size(s.owned + k)];
    image = owner;
    for (int axis = 0; axis < 3; ++axis) {
      image.place[axis] += shift[static_cast<unsigned>(axis)] * size[axis];
      image.drift[axis] += shift[static_cast<unsigned>(axis)] * s.box_rate[axis];
    }
  });
}

void build_neighbour_list(GrainSystem& s) {
  const auto [smallest, largest] = radius_range(s);
  LargeArray<ContactSlot>().swap(s.slot);  // gives its memory to the list in the making
  LargeArray<RollSlot>().swap(s.roll_slot);
  {
    const ContactHistory grain_history = keep_history(std::move(s.grain_contacts), s.identity, s.owned, false);
    const ContactHistory wall_history = keep_history(std::move(s.wall_contacts), s.identity, s.owned, true);
    adapt_skin(s, smallest, largest);
    wrap(s);
    sort_records(s);
    make_images(s, largest);
    list_grain_contacts(s, grain_history);
    list_wall_contacts(s, wall_history);
  }
  make_rows(s);
  const std::size_t slots = to_size(lane_count * (s.grain_contacts.size() + s.wall_contacts.size()));
  s.slot.assign(slots, ContactSlot{});
  s.roll_slot.assign(resists_rolling(s.contact) ? slots : 0, RollSlot{});
  if (s.bridges) list_bridges(s);
  remember_places(s);
}

void renew_neighbour_list(GrainSystem& s) {
  if (s.list_builds == 0) return build_neighbour_list(s);
  if (s.slack < s.skin) return;
  const double largest = radius_range(s)[1];
  s.slack = approach_since(s, largest);
  if (s.slack > 0.9 * s.skin) build_neighbour_list(s);
}

}  // namespace puadem
