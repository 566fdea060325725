#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "puadem/geometry/cell_match.hpp"
#include "puadem/geometry/domain.hpp"
#include "puadem/network/network_options.hpp"
#include "puadem/network/pore_network.hpp"

namespace puadem {

/// Pore network of a packing: triangulation, throat sections, merging, pore units.
///
/// @param centre  grain centres [m]
/// @param radius  grain radii [m]
/// @throws InputError      as `triangulate`
/// @throws NumericalError  where overlapping grains leave no void
PoreNetwork build_pore_network(std::span<const Vec3> centre, std::span<const double> radius, const Domain& domain,
                               const NetworkOptions& options);

/// A network made anew for grains that have moved, and how its cells follow from the former ones.
struct RebuiltNetwork {
  PoreNetwork network;
  CellMatch match;
};

/// New triangulation; its units are the former ones as far as their cells stand (theory 3.11). They fall apart where they have
/// become too narrow, new cells join them, and whatever now qualifies merges. Without motion nothing changes.
///
/// @param kind  per pore of `before`, such as the fluids in it: units of different kinds stay apart. A new cell has the
///              highest kind among the cells whose place it takes. Empty: all are alike
/// @param wraps  per grain: periods by which it was moved back into the box since `before`; empty: none was
/// @param turned  per cell of `before`: 1 where it has turned inside out since; empty: none has
/// @throws as `build_pore_network`
RebuiltNetwork rebuild_pore_network(const PoreNetwork& before, std::span<const int> kind,
                                    std::span<const std::array<std::int8_t, 3>> wraps, std::span<const Vec3> centre,
                                    std::span<const double> radius, const Domain& domain, const NetworkOptions& options,
                                    std::span<const std::uint8_t> turned = {});

}  // namespace puadem
