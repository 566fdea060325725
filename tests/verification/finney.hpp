#pragma once

#include <array>
#include <filesystem>
#include <vector>

#include "puadem/flow/invasion.hpp"
#include "puadem/geometry/domain.hpp"
#include "puadem/network/network_options.hpp"

namespace puadem::verification {

/// The random close packing of 4,021 equal steel balls that Finney measured (Proc. R. Soc. A 319, 479, 1970). Lengths in
/// radii of a ball; the heap is a sphere of radius 18.5 about its middle.
struct FinneyPacking {
  std::vector<Vec3> centre;
  std::vector<double> radius;
  Domain box;  ///< half a ball wider than the heap
  Vec3 middle;
};

/// Reads finney_packing_4021.csv (id, x, y, z) of a folder; no balls where the file is not there.
FinneyPacking read_finney_packing(const std::filesystem::path& folder);

/// Radii of spheres inscribed in tetrahedra and of circles inscribed in their facets, for those with their mean vertex
/// within 14 radii of the middle.
struct FinneyRadii {
  std::vector<double> pores, throats;
};
FinneyRadii inscribed_radii(const FinneyPacking& packing);

/// The heap as a network: pores within 14 radii of the middle; what lies outside is gas where `gas_enters` says so, a
/// reservoir of water where `water_leaves` does, and closed elsewhere.
struct FinneyHeap {
  PoreNetwork network;
  std::vector<char> is_core;  ///< per pore: within 10 radii of the middle
};
enum class HeapReservoirs {
  gas_around,  ///< gas enters from all sides; water may always leave
  gas_on_top,  ///< gas enters at heights above 7 radii over the middle, water leaves below -7
};
FinneyHeap finney_heap(const FinneyPacking& packing, const NetworkOptions& options, HeapReservoirs reservoirs);

/// Saturation of the core at rising capillary pressures [gamma / radius of a ball].
std::vector<double> drain_heap(const FinneyHeap& heap, const InvasionOptions& options, const std::vector<double>& pressures);

/// Where no front is in balance with arcs in all corners, our own law takes half the widest gap. This puts in its place
/// the largest r at which a front is in balance with arcs in those corners alone that an arc of radius r fits in.
void enter_with_fitting_menisci(const FinneyPacking& packing, PoreNetwork& network);

/// Conventions of plain invasion percolation: no trapping, an entered unit is empty, its throat alone resists.
InvasionOptions plain_percolation();

/// What an independent computation finds on the same packing in the same regions; it shares no code with this one (a
/// Delaunay triangulation of the centres). A cross-check, not an experiment.
///
/// Drainage is plain invasion percolation. Haines: 2 / inscribed radius of a facet; Mayer-Stowe-Princen: arcs in the
/// plane of the three centres, where they fit.
struct FinneyDrainage {
  double pressure;                     ///< [gamma / radius of a ball]
  double haines, mayer_stowe_princen;  ///< saturation of the core [-]
};
std::vector<FinneyDrainage> finney_drainage_reference();

/// Probability densities of `FinneyRadii` in bins 0.02 wide [1 / radius of a ball].
struct FinneyDensities {
  double radius, throats, pores;
};
std::vector<FinneyDensities> finney_densities_reference();

inline constexpr std::array finney_percent{5, 10, 25, 50, 75, 90, 95};
inline constexpr std::array<double, 7> finney_throat_percentiles{0.157, 0.1631, 0.1939, 0.2792, 0.3801, 0.4483, 0.4902};
inline constexpr std::array<double, 7> finney_pore_percentiles{0.2544, 0.2746, 0.3226, 0.3818, 0.4389, 0.5019, 0.5364};

/// Value below which `percent` of them lie.
double percentile(std::vector<double> values, int percent);

}  // namespace puadem::verification
