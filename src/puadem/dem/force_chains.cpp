#include "puadem/dem/force_chains.hpp"

#include <algorithm>
#include <cstdint>
#include <vector>

#include "puadem/dem/contacts.hpp"

namespace puadem {

namespace {

using Periods = std::array<int, 3>;

/// A strong contact seen from one of its grains.
struct Link {
  int grain;
  Periods shift;  ///< of that grain's image, in box lengths
};

Periods shift_of(const GrainSystem& s, int record) {
  return record < s.owned ? Periods{} : s.image_shift[to_size(record - s.owned)];
}

/// Strong contacts of every grain, by record.
std::vector<std::vector<Link>> strong_links(const GrainSystem& s, double mean, ForceChains& chains) {
  std::vector<std::vector<Link>> links(to_size(s.owned));
  long strong = 0, all = 0;
  for_each_grain_contact(s, [&](int i, int j, const Vec3&, int slot) {
    ++all;
    if (!(s.slot[to_size(slot)].force[3] > mean)) return;
    ++strong;
    const Periods a = shift_of(s, i), b = shift_of(s, j);
    const Periods there{b[0] - a[0], b[1] - a[1], b[2] - a[2]}, back{-there[0], -there[1], -there[2]};
    links[to_size(owner_of(s, i))].push_back({owner_of(s, j), there});
    links[to_size(owner_of(s, j))].push_back({owner_of(s, i), back});
  });
  if (all > 0) chains.strong_share = static_cast<double>(strong) / static_cast<double>(all);
  return links;
}

/// Faces whose wall a grain leans on with more than the mean force, one bit each.
std::vector<unsigned> leaned_on(const GrainSystem& s, double mean) {
  std::vector<unsigned> faces(to_size(s.owned), 0U);
  for_each_wall_contact(s, [&](int w, int k, const Vec3&, int slot) {
    const int face = s.walls[to_size(w)].face;
    if (face >= 0 && s.slot[to_size(slot)].force[3] > mean) faces[to_size(k)] |= 1U << static_cast<unsigned>(face);
  });
  return faces;
}

}  // namespace

ForceChains find_force_chains(const GrainSystem& s) {
  ForceChains chains;
  double sum = 0.0;
  long contacts = 0;
  for_each_grain_contact(s, [&](int, int, const Vec3&, int slot) {
    sum += s.slot[to_size(slot)].force[3];
    ++contacts;
  });
  if (contacts == 0) return chains;
  chains.mean_force = sum / static_cast<double>(contacts);
  const auto links = strong_links(s, chains.mean_force, chains);
  const std::vector<unsigned> faces = leaned_on(s, chains.mean_force);

  std::vector<std::uint8_t> is_seen(to_size(s.owned), 0);
  std::vector<Periods> period(to_size(s.owned));
  std::vector<int> waiting;
  int largest = 0;
  for (int first = 0; first < s.owned; ++first) {
    if (is_seen[to_size(first)] || links[to_size(first)].empty()) continue;
    is_seen[to_size(first)] = 1;
    waiting.assign(1, first);
    unsigned touched = 0U;
    int size = 0;
    while (!waiting.empty()) {
      const int k = waiting.back();
      waiting.pop_back();
      ++size;
      touched |= faces[to_size(k)];
      for (const Link& link : links[to_size(k)]) {
        const auto g = to_size(link.grain);
        Periods there = period[to_size(k)];
        for (unsigned a = 0; a < 3; ++a) there[a] += link.shift[a];
        if (!is_seen[g]) {
          is_seen[g] = 1;
          period[g] = there;
          waiting.push_back(link.grain);
        } else {
          for (unsigned a = 0; a < 3; ++a) chains.spans[a] = chains.spans[a] || there[a] != period[g][a];
        }
      }
    }
    largest = std::max(largest, size);
    for (unsigned a = 0; a < 3; ++a) chains.spans[a] = chains.spans[a] || ((touched >> (2U * a)) & 3U) == 3U;
  }
  chains.largest_share = static_cast<double>(largest) / s.owned;
  return chains;
}

}  // namespace puadem
