#include "puadem/flow/flow_graph.hpp"

#include <algorithm>
#include <cmath>

namespace puadem {

namespace {

using Shift = FlowGraph::Shift;

Shift plus(const Shift& a, const Shift& b, int sign) {
  Shift sum;
  for (std::size_t k = 0; k < 3; ++k) sum[k] = static_cast<std::int8_t>(a[k] + sign * b[k]);
  return sum;
}

/// Shift of a throat's second pore; a network read from a file may not have any.
Shift throat_shift(const PoreNetwork& network, int t) {
  return network.throat_shift.empty() ? Shift{} : network.throat_shift[to_size(t)];
}

/// Gives `start`, and all pores that no resistance separates from them, the next node.
void flood(const PoreNetwork& network, std::span<const double> conductance, std::vector<int> start, FlowGraph& graph) {
  const int node = graph.nodes();
  graph.node_pore.push_back(start.front());
  for (const int p : start) graph.pore_node[to_size(p)] = node;
  for (std::vector<int>& front = start; !front.empty();) {
    const int p = front.back();
    front.pop_back();
    for (const int t : network.pore_throats[p]) {
      if (!std::isinf(conductance[to_size(t)])) continue;
      const auto [i, j] = network.throat_pores[to_size(t)];
      const int other = i == p ? j : i;
      const Shift shift = plus(graph.pore_shift[to_size(p)], throat_shift(network, t), i == p ? 1 : -1);
      if (graph.pore_node[to_size(other)] < 0) {
        graph.pore_node[to_size(other)] = node;
        graph.pore_shift[to_size(other)] = shift;
        front.push_back(other);
      } else {
        for (std::size_t k = 0; k < 3; ++k)
          graph.short_circuit[k] = graph.short_circuit[k] || shift[k] != graph.pore_shift[to_size(other)][k];
      }
    }
  }
}

}  // namespace

FlowGraph make_flow_graph(const PoreNetwork& network, std::span<const double> conductance, unsigned joined_faces) {
  FlowGraph graph;
  graph.pore_node.assign(to_size(network.pores()), -1);
  graph.pore_shift.assign(to_size(network.pores()), {});
  graph.short_circuit = {};
  for (unsigned face = 0; face < 6; ++face) {
    if (!(joined_faces >> face & 1u)) continue;
    std::vector<int> at_face;
    for (int p = 0; p < network.pores(); ++p)
      if (network.pore_walls[to_size(p)] >> face & 1u && graph.pore_node[to_size(p)] < 0) at_face.push_back(p);
    if (!at_face.empty()) flood(network, conductance, std::move(at_face), graph);
  }
  for (int p = 0; p < network.pores(); ++p)
    if (graph.pore_node[to_size(p)] < 0) flood(network, conductance, {p}, graph);

  const auto resists = [](double g) { return g > 0.0 && !std::isinf(g); };
  const auto links = to_size(static_cast<int>(std::ranges::count_if(conductance, resists)));
  graph.link.reserve(links);
  graph.link_shift.reserve(links);
  graph.link_throat.reserve(links);
  for (int t = 0; t < network.throats(); ++t) {
    if (!resists(conductance[to_size(t)])) continue;
    const auto [i, j] = network.throat_pores[to_size(t)];
    const int a = graph.pore_node[to_size(i)], b = graph.pore_node[to_size(j)];
    // Node frames: pore j stands beside pore i where it is moved by the throat's shift.
    const Shift shift = plus(plus(graph.pore_shift[to_size(i)], throat_shift(network, t), 1), graph.pore_shift[to_size(j)], -1);
    if (a == b && shift == Shift{}) continue;
    graph.link.push_back({a, b});
    graph.link_shift.push_back(shift);
    graph.link_throat.push_back(t);
  }
  return graph;
}

}  // namespace puadem
