#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "puadem/base/csr.hpp"
#include "puadem/base/vec3.hpp"
#include "puadem/geometry/facets.hpp"
#include "puadem/geometry/throat_entry.hpp"

namespace puadem {

/// Pores joined by throats. Plain arrays, one entry per pore or per throat, SI units. `flow` needs
/// nothing else; a network read from a file has no triangulation.
///
/// A pore is a pore unit: one or more tetrahedra of the regular triangulation. A throat is one facet
/// between two different pores; two pores may share several throats, and each stays a throat of its own.
struct PoreNetwork {
  // Per pore.
  std::vector<Vec3> pore_centre;         ///< centroid of the unit's tetrahedra [m]
  std::vector<double> pore_volume;       ///< void volume V_i [m3], > 0
  std::vector<double> pore_radius;       ///< R_i = chi_g(n_f) V_i^(1/3) [m] (theory 3.6)
  std::vector<int> pore_faces;           ///< n_f: throats and wall faces that bound the unit [-]
  std::vector<std::uint8_t> pore_walls;  ///< bit f is set where the unit touches wall face f of the box
  Csr pore_throats;                      ///< throats of each pore, ascending

  // Per throat. `throat_pores[t] = {i, j}`, i <= j; the normal points from i to j.
  std::vector<std::array<int, 2>> throat_pores;
  std::vector<std::array<std::int8_t, 3>> throat_shift;  ///< pore j is its image moved by this many periods
  std::vector<Vec3> throat_normal;                       ///< unit vector [-]
  std::vector<double> throat_area;                       ///< void cross-section A_ij [m2]
  std::vector<double> throat_facet_area;                 ///< whole facet, grains included [m2]
  std::vector<double> throat_length;                     ///< distance of the power centres L_ij [m]
  std::vector<double> throat_conductance;      ///< times viscosity [m3], infinite between halves of one pore (theory 3.8)
  std::vector<double> throat_radius;           ///< inscribed circle r_in [m]
  std::vector<double> throat_entry_radius;     ///< r*: entry pressure p_e = gamma / r* [m] (theory 3.4)
  std::vector<double> throat_snap_off_radius;  ///< r_so: snap-off pressure p_so = gamma / r_so [m] (theory 3.5)
  std::vector<EntryKind> throat_entry_kind;
  std::vector<std::uint8_t> throat_at_wall;  ///< 1 where a wall bounds the throat

  // From the triangulation; empty for a network read from a file.
  Triangulation triangulation;
  std::vector<double> tetrahedron_void;  ///< [m3]
  std::vector<int> tetrahedron_pore;
  std::vector<std::array<std::int8_t, 3>> tetrahedron_shift;  ///< moved by this many periods it lies beside the rest of its pore
  std::vector<Facet> throat_facet;
  Csr pore_tetrahedra;  ///< tetrahedra of each pore, ascending
  int windows = 0;      ///< flat windows whose throats share the radii of the whole (theory 3.4)

  int pores() const { return size_of(pore_volume); }
  int throats() const { return size_of(throat_pores); }
  /// Grains or walls around a throat.
  std::array<Vertex, 3> throat_vertices(int throat) const { return facet_vertices(triangulation, throat_facet[to_size(throat)]); }
};

/// Throats of each pore, ascending; a throat from a pore to its own image is listed once.
Csr throats_of_pores(std::span<const std::array<int, 2>> throat_pores, int pores);

}  // namespace puadem
