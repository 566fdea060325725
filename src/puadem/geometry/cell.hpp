#pragma once

#include <array>
#include <optional>

#include "puadem/geometry/site.hpp"

namespace puadem {

/// Volume and area of a cell or facet whose vertices are grains and walls (theory 3.2): the polyhedron
/// of the grain centres and their feet on the walls. At least one site is a grain; walls of one cell
/// meet at right angles. A cell of four grains is a plain tetrahedron.
double cell_volume(const std::array<Site, 4>& sites);
double facet_area(const std::array<Site, 3>& sites);

/// Solid angle [sr] that the cell takes of each of its grains; 0 for walls.
std::array<double, 4> grain_solid_angles(const std::array<Site, 4>& sites);

/// Void volume of a cell [m3]: its volume less the corners of its grains (theory 3.3). Exact as long as
/// no grain pokes through the opposite facet; overlaps of grains count twice, so it may be negative.
double cell_void_volume(const std::array<Site, 4>& sites);

/// Point of equal power to all grains of the cell, on its walls (theory 3.1); none for a flat cell.
std::optional<Vec3> power_centre(const std::array<Site, 4>& sites);

/// Centroid of the cell's polyhedron [m].
Vec3 cell_centroid(const std::array<Site, 4>& sites);

/// Sphere that touches the four sites from outside (theory 3.6); none where no such sphere exists, radius 0
/// where grains leave no room.
struct InscribedSphere {
  Vec3 centre;          ///< [m]
  double radius = 0.0;  ///< [m]
};
std::optional<InscribedSphere> inscribed_sphere(const std::array<Site, 4>& sites);

/// Unit normal of a facet; its sign is that of the order of the sites [-].
Vec3 facet_normal(const std::array<Site, 3>& sites);

}  // namespace puadem
