#pragma once

#include <vector>

#include "puadem/base/histogram.hpp"
#include "puadem/coupling/state.hpp"

namespace puadem {

/// Pore and throat radii over the mean grain radius, by number.
struct RadiusDistributions {
  std::vector<Bin> pore;    ///< R_i / <r>
  std::vector<Bin> throat;  ///< R_ij / <r>, inscribed circle; throats without a gap are left out
  bool operator==(const RadiusDistributions&) const = default;
};

/// Distributions of a network; empty where there is none.
RadiusDistributions radius_distributions(const State& state);

/// Mean grain radius by number <r> [m]; 0 for no grains.
double mean_radius(const Particles& particles);

}  // namespace puadem
