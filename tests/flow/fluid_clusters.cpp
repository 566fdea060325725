#include "puadem/flow/fluid_clusters.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "flow/sample_networks.hpp"

namespace puadem::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::UnorderedElementsAre;

FluidClusters all_joined(const PoreNetwork& network, const PoreLinks& links) {
  FluidClusters clusters;
  clusters.holds.assign(to_size(network.pores()), 1);
  clusters.passes.assign(to_size(network.throats()), 1);
  clusters.reservoir.resize(to_size(network.pores()));
  for (int i = 0; i < network.pores(); ++i) clusters.reservoir[to_size(i)] = network.pore_walls[to_size(i)] & at_top;
  connect_all(links, clusters);
  return clusters;
}

std::vector<int> row(const Csr& csr, int r) { return {csr[r].begin(), csr[r].end()}; }

TEST(PoreLinks, LeaveOutThroatsThatPassNothing) {
  PoreNetwork network = chain({1.0, 1.0});
  add_throat(network, 1, 1, 1.0, 1.0);
  add_throat(network, 0, 2, 0.0, 0.0);
  add_throat(network, 0, 1, 2.0, 2.0);
  const PoreLinks links = pore_links(network);
  EXPECT_THAT(links[0], ElementsAre(PoreLinks::Link{1, 0}, PoreLinks::Link{1, 4}));
  EXPECT_THAT(links[1], ElementsAre(PoreLinks::Link{0, 0}, PoreLinks::Link{2, 1}, PoreLinks::Link{0, 4}));
  EXPECT_THAT(links[2], ElementsAre(PoreLinks::Link{1, 1}));
}

TEST(CutOff, FindsTheFarEndOfAChain) {
  const PoreNetwork network = chain({1, 1, 1, 1});
  const PoreLinks links = pore_links(network);
  FluidClusters clusters = all_joined(network, links);
  ClusterSearch search;
  clusters.passes[1] = 0;
  const Csr lost = cut_off(links, std::array{1, 2}, clusters, search);
  ASSERT_EQ(lost.rows(), 1);
  EXPECT_THAT(row(lost, 0), UnorderedElementsAre(2, 3, 4));
  EXPECT_THAT(clusters.connected, ElementsAre(1, 1, 0, 0, 0));
  EXPECT_THAT(cut_off(links, std::array{3, 4}, clusters, search).rows(), 0);  // what is lost is lost

  clusters.passes[1] = 1;
  EXPECT_THAT(reconnect(links, 2, clusters), UnorderedElementsAre(2, 3, 4));
  EXPECT_THAT(clusters.connected, ElementsAre(1, 1, 1, 1, 1));
}

TEST(CutOff, FindsEachPartOfAStar) {
  PoreNetwork network;
  for (int i = 0; i < 5; ++i) add_pore(network, 1.0, 6, i == 1 ? at_top : 0);
  for (int i = 1; i < 5; ++i) add_throat(network, 0, i, 1.0, 1.0);
  add_throat(network, 3, 4, 1.0, 1.0);
  const PoreLinks links = pore_links(network);
  FluidClusters clusters = all_joined(network, links);
  ClusterSearch search;
  clusters.holds[0] = clusters.connected[0] = 0;  // the hub loses the fluid
  const Csr lost = cut_off(links, std::array{1, 2, 3, 4, 2}, clusters, search);
  ASSERT_EQ(lost.rows(), 2);
  EXPECT_THAT(row(lost, 0), ElementsAre(2));
  EXPECT_THAT(row(lost, 1), UnorderedElementsAre(3, 4));
}

TEST(CutOff, NeverHappensWithoutTrapping) {
  const PoreNetwork network = chain({1, 1, 1});
  const PoreLinks links = pore_links(network);
  FluidClusters clusters = all_joined(network, links);
  clusters.traps = false;
  clusters.passes[0] = 0;
  connect_all(links, clusters);
  ClusterSearch search;
  EXPECT_EQ(cut_off(links, std::array{0, 1}, clusters, search).rows(), 0);
  EXPECT_THAT(clusters.connected, ElementsAre(1, 1, 1, 1));
}

// The work is that of the small part: three pores at the end of a very long chain.
TEST(CutOff, LooksAtTheSmallPartOnly) {
  const PoreNetwork network = chain(std::vector<double>(100000, 1.0));
  const PoreLinks links = pore_links(network);
  FluidClusters clusters = all_joined(network, links);
  ClusterSearch search;
  const int cut = network.throats() - 3;
  clusters.passes[to_size(cut)] = 0;
  EXPECT_EQ(cut_off(links, network.throat_pores[to_size(cut)], clusters, search).index.size(), 3u);
  std::size_t visited = 0;
  for (const auto& front : search.fronts) visited += front.visited.size();
  EXPECT_LT(visited, 10u);
}

// Throats and pores are taken away and given back at random; a flood is the judge.
TEST(Clusters, EqualAFloodAfterEachChange) {
  int changed = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const PoreNetwork network = random_network(80, seed, 2);
    const PoreLinks links = pore_links(network);
    FluidClusters clusters = all_joined(network, links);
    ClusterSearch search;
    Random random(seed);
    for (int event = 0; event < 400; ++event) {
      std::vector<int> around;
      if (random.uniform() < 0.5) {  // a few throats
        const bool passes = random.uniform() < 0.4;
        for (int k = 0; k < 3; ++k) {
          const std::size_t t = random.below(to_size(network.throats()));
          clusters.passes[t] = passes;
          around.insert(around.end(), {network.throat_pores[t][0], network.throat_pores[t][1]});
        }
      } else {
        const int pore = static_cast<int>(random.below(to_size(network.pores())));
        if (clusters.reservoir[to_size(pore)]) continue;
        clusters.holds[to_size(pore)] ^= 1;
        clusters.connected[to_size(pore)] = 0;
        for (const auto [neighbour, t] : links[pore])
          if (clusters.passes[to_size(t)]) around.push_back(neighbour);
        around.push_back(pore);
      }
      changed += size_of(cut_off(links, around, clusters, search).index);
      for (const int pore : around)  // gains: any lost pore beside a connected one
        if (clusters.holds[to_size(pore)] && !clusters.connected[to_size(pore)])
          for (const auto [neighbour, t] : links[pore])
            if (clusters.passes[to_size(t)] && clusters.connected[to_size(neighbour)] && !clusters.connected[to_size(pore)])
              changed += size_of(reconnect(links, pore, clusters));
      FluidClusters flooded = clusters;
      connect_all(links, flooded);
      ASSERT_EQ(clusters.connected, flooded.connected) << "seed " << seed << " event " << event;
    }
  }
  EXPECT_GT(changed, 1000);
}

}  // namespace
}  // namespace puadem::testing
