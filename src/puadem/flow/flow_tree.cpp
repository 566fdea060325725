#include "puadem/flow/flow_tree.hpp"

#include <algorithm>
#include <numeric>
#include <ranges>

#include "puadem/base/csr.hpp"
#include "puadem/base/disjoint_sets.hpp"

namespace puadem {

namespace {

/// Links of the forest, found from the best conductor down; all roots count as one node.
std::vector<int> forest_links(const FlowGraph& graph, std::span<const double> conductance, std::span<const char> is_root) {
  std::vector<int> by_conductance(to_size(graph.links()));
  std::iota(by_conductance.begin(), by_conductance.end(), 0);
  const auto of_link = [&](int k) { return conductance[to_size(graph.link_throat[to_size(k)])]; };
  std::ranges::stable_sort(by_conductance, std::greater{}, of_link);
  DisjointSets joined(graph.nodes());
  int root = -1;
  for (int n = 0; n < graph.nodes(); ++n) {
    if (!is_root[to_size(n)]) continue;
    if (root >= 0) joined.join(root, n);
    root = n;
  }
  std::erase_if(by_conductance, [&](int k) { return !joined.join(graph.link[to_size(k)][0], graph.link[to_size(k)][1]); });
  return by_conductance;
}

}  // namespace

FlowTree make_flow_tree(const FlowGraph& graph, std::span<const double> conductance, std::span<const char> is_root) {
  const std::vector<int> chosen = forest_links(graph, conductance, is_root);
  std::vector<std::array<int, 2>> ends;
  for (const int k : chosen) ends.push_back(graph.link[to_size(k)]);
  const Csr links_of = throats_of_pores(ends, graph.nodes());

  FlowTree tree;
  std::vector<char> reached(is_root.begin(), is_root.end());
  std::vector<int> front;
  for (int n = 0; n < graph.nodes(); ++n)
    if (is_root[to_size(n)]) front.push_back(n);
  for (std::size_t at = 0; at < front.size(); ++at)
    for (const int c : links_of[front[at]]) {
      const auto [a, b] = ends[to_size(c)];
      const int other = a == front[at] ? b : a;
      if (reached[to_size(other)]) continue;
      reached[to_size(other)] = 1;
      front.push_back(other);
      tree.node.push_back(other);
      tree.link.push_back(chosen[to_size(c)]);
      tree.parent.push_back(front[at]);
    }
  std::ranges::reverse(tree.node);
  std::ranges::reverse(tree.link);
  std::ranges::reverse(tree.parent);
  return tree;
}

void carry_excess(const FlowGraph& graph, const FlowTree& tree, std::span<double> excess, std::span<double> throat_flow) {
  for (std::size_t k = 0; k < tree.node.size(); ++k) {
    const int node = tree.node[k], link = tree.link[k];
    double& carried = excess[to_size(node)];
    double& flow = throat_flow[to_size(graph.link_throat[to_size(link)])];
    flow += graph.link[to_size(link)][0] == node ? -carried : carried;
    excess[to_size(tree.parent[k])] += carried;
    carried = 0.0;
  }
}

}  // namespace puadem
