#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "puadem/network/pore_network.hpp"

namespace puadem {

/// A network as one fluid sees it: pores with no resistance between them are one node, throats that pass
/// nothing are no links.
struct FlowGraph {
  using Shift = std::array<std::int8_t, 3>;

  std::vector<int> pore_node;         ///< of each pore
  std::vector<Shift> pore_shift;      ///< moved by this many periods a pore lies beside the rest of its node
  std::vector<int> node_pore;         ///< lowest pore of each node
  std::array<bool, 3> short_circuit;  ///< axes along which a node without resistance leads to its own image

  std::vector<std::array<int, 2>> link;  ///< nodes; equal where a link leads to a node's own image
  std::vector<Shift> link_shift;         ///< the second node is moved by this many periods
  std::vector<int> link_throat;

  int nodes() const { return size_of(node_pore); }
  int links() const { return size_of(link); }
};

/// @param conductance  per throat: 0 passes nothing, infinity has no resistance
/// @param joined_faces  bit f: all pores at face f of the box are one node
FlowGraph make_flow_graph(const PoreNetwork& network, std::span<const double> conductance, unsigned joined_faces);

}  // namespace puadem
