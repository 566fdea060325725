#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "puadem/base/csr.hpp"
#include "puadem/network/pore_network.hpp"

namespace puadem {

/// The throats around each pore, with the pore behind each of them.
struct PoreLinks {
  struct Link {
    int pore, throat;
    bool operator==(const Link&) const = default;
  };
  std::vector<int> start{0};
  std::vector<Link> link;

  std::span<const Link> operator[](int pore) const {
    return std::span(link).subspan(to_size(start[to_size(pore)]), to_size(start[to_size(pore) + 1] - start[to_size(pore)]));
  }
  bool operator==(const PoreLinks&) const = default;
};

/// Links of a network. Left out: throats that join a pore to its own periodic image, and throats
/// without a gap (entry radius 0), which no fluid passes.
PoreLinks pore_links(const PoreNetwork& network);

/// Where one fluid stands and which of it still reaches its reservoir: pores that hold the fluid,
/// joined by throats that pass it. The two fluids use the same code.
struct FluidClusters {
  bool traps = true;                    ///< false: the fluid counts as connected wherever it stands
  std::vector<std::uint8_t> holds;      ///< per pore
  std::vector<std::uint8_t> passes;     ///< per throat
  std::vector<std::uint8_t> reservoir;  ///< per pore: belongs to the reservoir of this fluid
  std::vector<std::uint8_t> connected;  ///< per pore: holds the fluid and reaches the reservoir

  bool operator==(const FluidClusters&) const = default;
};

/// Sets `connected` from the other arrays by one flood from the reservoir.
void connect_all(const PoreLinks& links, FluidClusters& clusters);

/// Searches of `cut_off`, kept between calls to spare allocations.
struct ClusterSearch {
  struct Front {
    std::vector<int> visited;  ///< pores in the order they were reached
    std::size_t next = 0;      ///< first of them not looked at
    int group = 0;             ///< fronts that met share the group of the lowest
    int running = 1;           ///< of a group: its fronts that have not come to an end
    enum class Fate : std::uint8_t { open, safe, lost } fate = Fate::open;  ///< of a group
  };
  std::vector<Front> fronts;
  std::vector<int> front_of;  ///< per pore, -1: not visited
};

/// Decides what a removal cuts off. Call it after throats were closed to the fluid or a pore lost it.
///
/// One search starts from each pore beside the removal; they take turns, searches that meet go on as
/// one, and a search that reaches the reservoir is safe. A search that ends without either has found a
/// cluster cut off: `connected` is cleared on it. The work is that of the smaller parts, not of the network.
///
/// @param around  ends of all removed throats, and the neighbours of a removed pore, that hold the fluid
///                still; those not connected before are passed over. Repetitions do no harm.
/// @return the clusters cut off, a row each
Csr cut_off(const PoreLinks& links, std::span<const int> around, FluidClusters& clusters, ClusterSearch& search);

/// Finds by one flood from the reservoir all that is cut off and still marked as connected, and clears the
/// mark: for removals whose ends were not noted. @return the clusters cut off, a row each
Csr cut_off_anywhere(const PoreLinks& links, FluidClusters& clusters);

/// Connects the cluster of `pore`, which holds the fluid, has not been connected and now touches a
/// connected pore. @return its pores
std::vector<int> reconnect(const PoreLinks& links, int pore, FluidClusters& clusters);

}  // namespace puadem
