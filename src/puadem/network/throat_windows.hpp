#pragma once

#include "puadem/geometry/packing_sites.hpp"
#include "puadem/network/network_options.hpp"
#include "puadem/network/pore_network.hpp"

namespace puadem {

/// Entry, snap-off and inscribed radii of throats that lie side by side between the same two pores and form
/// one flat window, such as the two halves of the square window of a simple cubic packing: all its throats get
/// the radii of the whole (theory 3.4); they are counted in `network.windows`. A window is a ring of 4 to 8 grains and walls with
/// none inside, its facets within 25 degrees of each other; throats of other outlines keep their own.
void set_window_radii(PoreNetwork& network, const PackingSites& sites_of, const NetworkOptions& options);

}  // namespace puadem
