#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "puadem/geometry/domain.hpp"
#include "puadem/network/pore_network.hpp"

namespace puadem {

/// A network from a file: no grains, no tetrahedra. `flow` needs no more.
struct NetworkFile {
  PoreNetwork network;
  Domain box;                         ///< lower corner at 0
  std::vector<std::string> warnings;  ///< what was left out, and why
  int reservoir_pores = 0;            ///< last pores, which stand for inlet and outlet and are no pores of the rock
  double contact_angle = 0.0;         ///< at which the entry and snap-off radii hold [rad]
  bool knows_walls = false;           ///< tells which throats lie along walls
};

/// Reads a network of either kind: a table where the name ends in `.csv`, else four files of Statoil's format, by their prefix
/// or one of their names. @throws InputError
NetworkFile read_network(const std::filesystem::path& path);

/// Whether a path names a network rather than a packing: four files of Statoil's format, or a table with columns of pores.
bool is_network(const std::filesystem::path& path);

/// Common beginning of the four files of Statoil's format, from it or from the name of one of them.
std::filesystem::path statoil_prefix(const std::filesystem::path& path);

/// Names of the faces that have pores, such as "left, right".
std::string faces_with_pores(const PoreNetwork& network);

/// Reads the four text files `<prefix>_node1.dat`, `_node2.dat`, `_link1.dat` and `_link2.dat` of the format of
/// Statoil, which network extraction from images writes (pnextract) and pnflow and OpenPNM read. Flow runs from
/// left to right. Each reservoir becomes a pore of its own at that face. Pores and throats are tubes of triangular,
/// square or round section after their shape factor G (theory 3.10); throats hold no volume of their own, it goes to
/// their pores by halves. Entry radii are those of a fluid that wets perfectly. Parts of the network that reach
/// neither reservoir are left out, with a warning.
/// @throws InputError naming file, line and what is allowed
NetworkFile read_statoil_network(const std::filesystem::path& prefix);

/// Writes a network as `read_statoil_network` reads it, between two opposite faces of the box; their axis becomes x.
/// Throat lengths are such that the tubes have the conductances of the network. Closed throats are left out.
/// @throws InputError  for a network with periodic throats, which the format does not know
void write_statoil_network(const std::filesystem::path& prefix, const PoreNetwork& network, const Domain& box, int inlet_face);

/// Reads a table with named columns as OpenPNM writes it: `pore.coords[0]` to `[2]`, `pore.volume`,
/// `throat.conns[0]`, `[1]` are needed. Known besides: `pore.diameter` (inscribed), `pore.faces`, the labels
/// `pore.left` to `pore.top`, `throat.diameter` (inscribed), `throat.length`, `throat.cross_sectional_area`,
/// `throat.conductance` [m3] (times viscosity), `throat.entry_radius`, `throat.snap_off_radius`,
/// `throat.shift[0]` to `[2]`, `throat.facet_area`, `throat.normal[0]` to `[2]`, the label `throat.at_wall`, `param.box[0]` to
/// `[2]`, `param.periodic[0]` to `[2]`, `param.contact_angle` [rad]. A throat that gives only diameter and
/// length is a round tube; a box that is not given bounds the pores. Other columns are not read, with a warning.
/// @throws InputError naming line and column and what is allowed
NetworkFile read_csv_network(const std::filesystem::path& path);

/// Writes all of these columns; reading them gives the same numbers, bit for bit.
/// @param contact_angle  at which the entry and snap-off radii hold [rad]
void write_csv_network(const std::filesystem::path& path, const PoreNetwork& network, const Domain& box,
                       double contact_angle = 0.0);

}  // namespace puadem
