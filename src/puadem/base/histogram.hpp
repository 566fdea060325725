#pragma once

#include <span>
#include <vector>

namespace puadem {

/// One bar of a histogram.
struct Bin {
  double low, high;  ///< as the values
  double density;    ///< probability density by number; density times width sums to 1
  bool operator==(const Bin&) const = default;
};

/// Histogram with a fixed number of bins per unit of the values, one edge at 0, so that two runs can be
/// laid over each other.
std::vector<Bin> histogram(std::span<const double> values, int bins_per_unit);

}  // namespace puadem
