#pragma once

#include <span>
#include <string>
#include <vector>

#include "puadem/coupling/state.hpp"

namespace puadem {

/// One bar of a histogram.
struct Bin {
  double low, high;  ///< of R / <r> [-]
  double density;    ///< probability density by number [-]; density times width sums to 1
  bool operator==(const Bin&) const = default;
};

/// Pore and throat radii over the mean grain radius, by number.
struct RadiusDistributions {
  std::vector<Bin> pore;    ///< R_i / <r>
  std::vector<Bin> throat;  ///< R_ij / <r>, inscribed circle; throats without a gap are left out
  bool operator==(const RadiusDistributions&) const = default;
};

/// Histogram with a fixed number of bins per unit of the values, one edge at 0, so that two runs can be
/// laid over each other.
std::vector<Bin> histogram(std::span<const double> values, int bins_per_unit);

/// Distributions of a network; empty where there is none.
RadiusDistributions radius_distributions(const State& state);

/// Mean grain radius by number <r> [m]; 0 for no grains.
double mean_radius(const Particles& particles);

}  // namespace puadem
