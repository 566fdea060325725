#include "puadem/flow/fluid_clusters.hpp"

#include <cassert>

namespace puadem {

PoreLinks pore_links(const PoreNetwork& network) {
  const auto joins = [&](int t) {
    const auto [i, j] = network.throat_pores[to_size(t)];
    return i != j && network.throat_entry_radius[to_size(t)] > 0.0;
  };
  PoreLinks links;
  links.start.assign(to_size(network.pores()) + 1, 0);
  for (int t = 0; t < network.throats(); ++t)
    if (joins(t))
      for (const int pore : network.throat_pores[to_size(t)]) ++links.start[to_size(pore) + 1];
  for (int i = 0; i < network.pores(); ++i) links.start[to_size(i) + 1] += links.start[to_size(i)];
  links.link.resize(to_size(links.start.back()));
  std::vector<int> next(links.start.begin(), links.start.end() - 1);
  for (int t = 0; t < network.throats(); ++t) {
    if (!joins(t)) continue;
    const auto [i, j] = network.throat_pores[to_size(t)];
    links.link[to_size(next[to_size(i)]++)] = {j, t};
    links.link[to_size(next[to_size(j)]++)] = {i, t};
  }
  return links;
}

void connect_all(const PoreLinks& links, FluidClusters& clusters) {
  if (!clusters.traps) {
    clusters.connected = clusters.holds;
    return;
  }
  clusters.connected.assign(clusters.holds.size(), 0);
  for (int pore = 0; pore < size_of(clusters.holds); ++pore)
    if (clusters.reservoir[to_size(pore)] && !clusters.connected[to_size(pore)]) reconnect(links, pore, clusters);
}

Csr cut_off_anywhere(const PoreLinks& links, FluidClusters& clusters) {
  const std::vector<std::uint8_t> before = clusters.connected;
  connect_all(links, clusters);
  Csr lost;
  for (int pore = 0; pore < size_of(before); ++pore) {
    if (!before[to_size(pore)] || !clusters.holds[to_size(pore)] || clusters.connected[to_size(pore)]) continue;
    const std::vector<int> cluster = reconnect(links, pore, clusters);
    lost.index.insert(lost.index.end(), cluster.begin(), cluster.end());
    lost.start.push_back(size_of(lost.index));
  }
  for (const int pore : lost.index) clusters.connected[to_size(pore)] = 0;
  return lost;
}

std::vector<int> reconnect(const PoreLinks& links, int pore, FluidClusters& clusters) {
  assert(clusters.holds[to_size(pore)] && !clusters.connected[to_size(pore)]);
  std::vector<int> gained{pore};
  clusters.connected[to_size(pore)] = 1;
  for (std::size_t next = 0; next < gained.size(); ++next)
    for (const auto [neighbour, throat] : links[gained[next]]) {
      const std::size_t v = to_size(neighbour);
      if (!clusters.passes[to_size(throat)] || !clusters.holds[v] || clusters.connected[v]) continue;
      clusters.connected[v] = 1;
      gained.push_back(neighbour);
    }
  return gained;
}

namespace {

using Front = ClusterSearch::Front;
using Fate = ClusterSearch::Front::Fate;

int group_of(const ClusterSearch& search, int front) {
  while (search.fronts[to_size(front)].group != front) front = search.fronts[to_size(front)].group;
  return front;
}

struct Race {
  int fronts = 0;
  int undecided = 0;      // groups that may still be cut off
  bool any_safe = false;  // a group has reached the reservoir
};

Race start_fronts(std::span<const int> around, const FluidClusters& clusters, ClusterSearch& search) {
  search.front_of.resize(clusters.holds.size(), -1);
  Race race;
  for (const int pore : around) {
    if (!clusters.connected[to_size(pore)] || search.front_of[to_size(pore)] >= 0) continue;
    if (race.fronts == size_of(search.fronts)) search.fronts.emplace_back();
    Front& front = search.fronts[to_size(race.fronts)];
    front.visited.assign(1, pore);
    front.next = 0;
    front.group = race.fronts;
    front.running = 1;
    front.fate = clusters.reservoir[to_size(pore)] ? Fate::safe : Fate::open;
    search.front_of[to_size(pore)] = race.fronts++;
    if (front.fate == Fate::safe)
      race.any_safe = true;
    else
      ++race.undecided;
  }
  return race;
}

// Two groups met. Both cannot be safe: a safe group is not searched on, and neither can be lost.
int merge(int a, int b, Race& race, ClusterSearch& search) {
  if (b < a) std::swap(a, b);
  Front &low = search.fronts[to_size(a)], &high = search.fronts[to_size(b)];
  high.group = a;
  low.running += high.running;
  if (high.fate == Fate::safe) low.fate = Fate::safe;
  --race.undecided;
  return a;
}

// Looks at the links of one pore of a front.
void advance_front(int f, const PoreLinks& links, const FluidClusters& clusters, Race& race, ClusterSearch& search) {
  Front& front = search.fronts[to_size(f)];
  int group = group_of(search, f);
  for (const auto [neighbour, throat] : links[front.visited[front.next++]]) {
    const std::size_t v = to_size(neighbour);
    if (!clusters.passes[to_size(throat)] || !clusters.holds[v]) continue;
    if (clusters.reservoir[v]) {
      search.fronts[to_size(group)].fate = Fate::safe;
      race.any_safe = true;
      --race.undecided;
      return;
    }
    if (search.front_of[v] < 0) {
      search.front_of[v] = f;
      front.visited.push_back(neighbour);
    } else if (const int other = group_of(search, search.front_of[v]); other != group) {
      group = merge(group, other, race, search);
      if (search.fronts[to_size(group)].fate == Fate::safe) return;
    }
  }
  if (front.next < front.visited.size()) return;
  Front& whole = search.fronts[to_size(group)];
  if (--whole.running == 0) {
    whole.fate = Fate::lost;
    --race.undecided;
  }
}

}  // namespace

Csr cut_off(const PoreLinks& links, std::span<const int> around, FluidClusters& clusters, ClusterSearch& search) {
  Csr lost;
  if (!clusters.traps) return lost;
  Race race = start_fronts(around, clusters, search);
  // What was one cluster with the reservoir cannot be lost altogether: the last group is safe if no other is.
  for (int f = 0; race.undecided > (race.any_safe ? 0 : 1); f = (f + 1) % race.fronts) {
    const Front& front = search.fronts[to_size(f)];
    if (front.next < front.visited.size() && search.fronts[to_size(group_of(search, f))].fate == Fate::open)
      advance_front(f, links, clusters, race, search);
  }

  for (int group = 0; group < race.fronts; ++group) {
    if (search.fronts[to_size(group)].group != group || search.fronts[to_size(group)].fate != Fate::lost) continue;
    for (int f = group; f < race.fronts; ++f)
      if (group_of(search, f) == group)
        for (const int pore : search.fronts[to_size(f)].visited) {
          clusters.connected[to_size(pore)] = 0;
          lost.index.push_back(pore);
        }
    lost.start.push_back(size_of(lost.index));
  }
  for (int f = 0; f < race.fronts; ++f)
    for (const int pore : search.fronts[to_size(f)].visited) search.front_of[to_size(pore)] = -1;
  return lost;
}

}  // namespace puadem
