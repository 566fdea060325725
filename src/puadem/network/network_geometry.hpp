#pragma once

#include <span>
#include <vector>

#include "puadem/geometry/facets.hpp"
#include "puadem/geometry/packing_sites.hpp"
#include "puadem/network/network_options.hpp"
#include "puadem/network/pore_network.hpp"

namespace puadem {

/// What geometry says of every cell of a triangulation.
struct CellGeometry {
  std::vector<double> volume, void_volume;   ///< [m3]
  std::vector<Vec3> centroid, power_centre;  ///< [m]; a flat cell, which always merges, has its centroid for both
};
CellGeometry measure_cells(const Triangulation& triangulation, const PackingSites& sites_of);

/// Gives flat cells the power centre of a cell beside them in their pore unit, so that the throats on their far side
/// keep their whole length (theory 3.8). The cells' units are known. @return whether there are any
bool centre_flat_cells(const PoreNetwork& network, const PackingSites& sites_of, CellGeometry& cells);

/// What geometry says of facets: theory 3.4 and 3.8.
struct FacetGeometry {
  std::vector<Vec3> normal;                                             ///< out of the facet's first cell [-]
  std::vector<double> area, void_area;                                  ///< [m2]
  std::vector<double> length;                                           ///< distance of the power centres [m]
  std::vector<double> conductance;                                      ///< times viscosity [m3]
  std::vector<double> inscribed_radius, entry_radius, snap_off_radius;  ///< [m]
  std::vector<EntryKind> kind;

  explicit FacetGeometry(std::size_t facets);
};
FacetGeometry measure_facets(const Triangulation& triangulation, std::span<const Facet> facets, const CellGeometry& cells,
                             const PackingSites& sites_of, const NetworkOptions& options);

/// Volumes, centres and radii of the pores from their cells; the pores' cells and faces are known.
/// @throws NumericalError  for a pore without void
void set_pore_geometry(PoreNetwork& network, const CellGeometry& cells, const PackingSites& sites_of, PoreShape shape);

/// Takes over the geometry of `network.throat_facet`, in its order; throats of one window get its radii where
/// the options ask for windows.
void set_throat_geometry(PoreNetwork& network, FacetGeometry geometry, const PackingSites& sites_of,
                         const NetworkOptions& options);

/// Geometry of a network whose grains have moved or grown, on the same topology: the numbers a new build would
/// find as long as its triangulation and pore units were the same.
///
/// @throws NumericalError  for a pore without void
void update_network_geometry(PoreNetwork& network, std::span<const Vec3> centre, std::span<const double> radius,
                             const Domain& domain, const NetworkOptions& options);

}  // namespace puadem
