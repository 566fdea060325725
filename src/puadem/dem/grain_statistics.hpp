#pragma once

#include <span>

#include "puadem/dem/grading.hpp"

namespace puadem {

/// Means over the grains of a grading, or of a packing, by number.
struct GrainStatistics {
  double mean_radius = 0.0;    ///< <r> [m]
  double sauter_radius = 0.0;  ///< <r^3> / <r^2> [m]
  double mean_volume = 0.0;    ///< of one grain [m3]
  double smallest = 0.0;       ///< radius [m]
  double largest = 0.0;        ///< radius [m]
};

/// Closed form for an endless number of grains.
/// @throws InputError  see size_classes
GrainStatistics statistics_of(const Grading& grading);
GrainStatistics statistics_of(std::span<const double> radius);

}  // namespace puadem
