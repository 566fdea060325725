#pragma once

#include <vector>

#include "puadem/geometry/packing_sites.hpp"
#include "puadem/network/pore_network.hpp"

namespace puadem {

/// What a throat carries once the non-wetting fluid is in it, as shares of its conductance full of one fluid
/// (theory 6.2): the corners pass the wetting fluid by
///     wetting_at_entry (p_e / p_c)^exponent,
/// the middle passes the other by nonwetting.
struct ThroatFilms {
  std::vector<double> wetting_at_entry;  ///< per throat [-]
  std::vector<double> exponent;          ///< per throat [-]
  std::vector<double> nonwetting;        ///< per throat [-]
  int without_menisci = 0;               ///< throats whose section has no menisci at entry: they get the usual numbers
};

/// The usual numbers, for a network that comes without its grains.
ThroatFilms usual_throat_films(const PoreNetwork& network);

/// From the menisci in the corners of each throat's section.
/// @param contact_angle  theta [rad]
ThroatFilms throat_films(const PoreNetwork& network, const PackingSites& sites_of, double contact_angle);

}  // namespace puadem
