#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "puadem/coupling/pore_space_record.hpp"
#include "puadem/geometry/domain.hpp"
#include "puadem/network/network_geometry.hpp"

// The box in blocks that move with it, equal fractions of its sides (theory 7.10). A block's number is that of x plus that of y
// times those along x, and so on.

namespace puadem {

/// Blocks along each axis, near to cubes of 24 grains or more where the box has as many.
std::array<int, 3> block_counts(const Domain& domain, int grains);

/// Void share of each block: one minus the parts of the grains in it; overlaps of grains count twice [-].
std::vector<double> block_porosities(std::span<const Vec3> centre, std::span<const double> radius, const Domain& domain,
                                     const std::array<int, 3>& blocks);

/// Water over void of each block; a cell is of the block its centroid is in, and as full as its pore [-].
/// @param saturation  of the pores
/// @param is_counted  0: a pore of a reservoir, which counts in blocks without others only
std::vector<double> block_saturations(const PoreNetwork& network, const CellGeometry& cells, std::span<const double> saturation,
                                      std::span<const std::uint8_t> is_counted, const Domain& domain,
                                      const std::array<int, 3>& blocks);

/// How far grains have gone since they stood at `before` [m]; along periodic axes the shortest way in fractions of the box.
struct Displacements {
  std::vector<Vec3> total;       ///< with the box
  std::vector<Vec3> beyond_box;  ///< without what an even deformation of the box would have moved them
};
Displacements displacements(std::span<const Vec3> before, const Domain& domain_before, std::span<const Vec3> now,
                            const Domain& domain_now);

/// Adds grains and their mean displacement beyond the box to blocks.
void add_grains(std::span<const Vec3> centre, std::span<const Vec3> beyond_box, const Domain& domain,
                const std::array<int, 3>& counts, std::span<LocalBlock> blocks);

/// Spearman's rank correlation, ties with their mean rank; none where either does not vary.
std::optional<double> rank_correlation(std::span<const double> a, std::span<const double> b);

}  // namespace puadem
