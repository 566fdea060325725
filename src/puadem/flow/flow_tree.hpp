#pragma once

#include <span>
#include <vector>

#include "puadem/flow/flow_graph.hpp"

namespace puadem {

/// Spanning forest of a flow graph along its best conductors: each part hangs on the nodes of given pressure in it.
struct FlowTree {
  std::vector<int> node;    ///< nodes that hang on another, each before the one it hangs on
  std::vector<int> link;    ///< the link by which
  std::vector<int> parent;  ///< the other end of it
};

/// @param conductance  per throat
/// @param is_root      per node; parts without any root are left out
FlowTree make_flow_tree(const FlowGraph& graph, std::span<const double> conductance, std::span<const char> is_root);

/// Makes flows conserve volume to rounding: what leaves a node in excess is carried along the tree to its root,
/// which gives or takes any amount (theory 3.9). A solve for pressures leaves such excess, the more the shorter
/// a throat: the flow of a throat that conducts a million times better than its neighbours is the difference of
/// two pressures that agree in all but their last digits.
///
/// @param excess       per node: flow out less flow in [m3/s]; afterwards 0 but at roots
/// @param throat_flow  per throat, from the first node of its link to the second [m3/s]
void carry_excess(const FlowGraph& graph, const FlowTree& tree, std::span<double> excess, std::span<double> throat_flow);

}  // namespace puadem
