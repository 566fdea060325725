#include "puadem/dem/contact_history.hpp"

#include <numeric>
#include <utility>

namespace puadem {

namespace {

void copy_lane(const LaneVec3& from, int lane, LaneVec3& to, int to_lane) {
  to.x[to_lane] = from.x[lane];
  to.y[to_lane] = from.y[lane];
  to.z[to_lane] = from.z[lane];
}

bool is_zero(const LaneVec3& v, int lane) { return v.x[lane] == 0.0 && v.y[lane] == 0.0 && v.z[lane] == 0.0; }

}  // namespace

ContactHistory keep_history(ContactBlocks&& blocks, const std::vector<int>& identity, int grains, bool with_walls) {
  ContactHistory history;
  history.blocks = std::move(blocks);
  const ContactBlocks& old = history.blocks;
  const auto for_each = [&](const auto& visit) {
    for (int b = 0; b < old.size(); ++b) {
      if (old.live[to_size(b)] == 0) continue;
      for (int l = 0; l < lane_count; ++l) {
        const bool rolled = !old.roll.empty() && !(is_zero(old.roll[to_size(b)].bend, l) && old.roll[to_size(b)].twist[l] == 0.0);
        const bool slowed = !old.viscous.empty() && old.viscous[to_size(b)].pace[l] != 0.0;
        if (is_zero(old.shear[to_size(b)], l) && !rolled && !slowed) continue;
        const int first = old.first[to_size(b)][to_size(l)], second = identity[to_size(old.second[to_size(b)][to_size(l)])];
        if (with_walls)
          visit(second, first, b, l);
        else
          visit(identity[to_size(first)], second, b, l);
      }
    }
  };
  history.start.assign(to_size(grains) + 1, 0);
  for_each([&](int owner, int, int, int) { ++history.start[to_size(owner) + 1]; });
  std::partial_sum(history.start.begin(), history.start.end(), history.start.begin());
  history.entry.resize(to_size(history.start.back()));
  std::vector<int> next(history.start.begin(), history.start.end() - 1);
  for_each([&](int owner, int partner, int b, int l) { history.entry[to_size(next[to_size(owner)]++)] = {partner, b, l}; });
  return history;
}

void restore_history(const ContactHistory& history, int owner, int partner, ContactBlocks& blocks, int block, int lane) {
  for (int e = history.start[to_size(owner)]; e < history.start[to_size(owner) + 1]; ++e) {
    const ContactHistory::Entry& entry = history.entry[to_size(e)];
    if (entry.partner != partner) continue;
    copy_lane(history.blocks.shear[to_size(entry.block)], entry.lane, blocks.shear[to_size(block)], lane);
    if (!blocks.viscous.empty())
      blocks.viscous[to_size(block)].pace[lane] = history.blocks.viscous[to_size(entry.block)].pace[entry.lane];
    if (!blocks.roll.empty()) {
      const RollHistory& old = history.blocks.roll[to_size(entry.block)];
      copy_lane(old.bend, entry.lane, blocks.roll[to_size(block)].bend, lane);
      blocks.roll[to_size(block)].twist[lane] = old.twist[entry.lane];
    }
    return;
  }
}

}  // namespace puadem
