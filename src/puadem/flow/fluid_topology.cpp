#include "puadem/flow/fluid_topology.hpp"

#include <algorithm>
#include <cassert>

#include "puadem/base/disjoint_sets.hpp"

namespace puadem {

namespace {

bool is_link(const PoreNetwork& network, std::span<const std::uint8_t> holds, std::span<const std::uint8_t> passes, int t) {
  const auto [i, j] = network.throat_pores[to_size(t)];
  return passes[to_size(t)] && holds[to_size(i)] && holds[to_size(j)];
}

DisjointSets clusters_of(const PoreNetwork& network, std::span<const std::uint8_t> holds, std::span<const std::uint8_t> passes) {
  assert(size_of(holds) == network.pores() && size_of(passes) == network.throats());
  DisjointSets sets(network.pores());
  for (int t = 0; t < network.throats(); ++t)
    if (is_link(network, holds, passes, t)) sets.join(network.throat_pores[to_size(t)][0], network.throat_pores[to_size(t)][1]);
  return sets;
}

}  // namespace

FluidTopology fluid_topology(const PoreNetwork& network, std::span<const std::uint8_t> holds,
                             std::span<const std::uint8_t> passes) {
  DisjointSets sets = clusters_of(network, holds, passes);
  FluidTopology topology;
  for (int i = 0; i < network.pores(); ++i)
    if (holds[to_size(i)]) {
      ++topology.pores;
      topology.clusters += sets.find(i) == i ? 1 : 0;
    }
  for (int t = 0; t < network.throats(); ++t) topology.throats += is_link(network, holds, passes, t) ? 1 : 0;
  return topology;
}

std::vector<FluidCluster> fluid_cluster_sizes(const PoreNetwork& network, std::span<const std::uint8_t> holds,
                                              std::span<const std::uint8_t> passes, std::span<const double> volume) {
  DisjointSets sets = clusters_of(network, holds, passes);
  std::vector<FluidCluster> clusters;
  std::vector<int> number(to_size(network.pores()), -1);
  for (int i = 0; i < network.pores(); ++i) {
    if (!holds[to_size(i)]) continue;
    const int root = sets.find(i);  // the lowest of its pores, so that it comes first
    if (root == i) {
      number[to_size(i)] = size_of(clusters);
      clusters.push_back({i, 0, 0.0});
    }
    FluidCluster& cluster = clusters[to_size(number[to_size(root)])];
    ++cluster.pores;
    cluster.volume += volume[to_size(i)];
  }
  std::ranges::stable_sort(clusters, std::greater{}, &FluidCluster::volume);
  return clusters;
}

std::vector<int> fluid_cluster_numbers(const PoreNetwork& network, std::span<const std::uint8_t> holds,
                                       std::span<const std::uint8_t> passes, std::span<const double> volume) {
  const auto clusters = fluid_cluster_sizes(network, holds, passes, volume);
  DisjointSets sets = clusters_of(network, holds, passes);
  std::vector<int> number(to_size(network.pores()), -1);
  for (int c = 0; c < size_of(clusters); ++c) number[to_size(clusters[to_size(c)].first)] = c;
  for (int i = 0; i < network.pores(); ++i)
    if (holds[to_size(i)]) number[to_size(i)] = number[to_size(sets.find(i))];
  return number;
}

}  // namespace puadem
