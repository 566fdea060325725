#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace puadem {

/// One class of a grading; the cumulative curve rises linearly over its diameters.
struct GradingClass {
  double diameter_min = 0.0;  ///< [m]
  double diameter_max = 0.0;  ///< [m], equal to diameter_min for a single size
  double fraction = 1.0;      ///< share of the class [-]; the shares add to 1
};

/// A cumulative curve as sieves give it: from 0 at the smallest diameter to 1 at the largest.
struct GradingTable {
  enum class Interpolation { logarithmic, linear };  ///< straight over ln d, or over d
  std::vector<double> diameter;                      ///< ascending [m]
  std::vector<double> passing;                       ///< share of grains smaller than that [-]
  Interpolation interpolation = Interpolation::logarithmic;
};

/// Log-normal sizes between two cut-offs.
struct LogNormalGrading {
  double median = 0.0;             ///< diameter [m], before the cut
  double deviation = 0.0;          ///< geometric standard deviation > 1, d_84 / d_50 [-]
  std::optional<double> smallest;  ///< diameter [m]; none: median / deviation^2
  std::optional<double> largest;   ///< diameter [m]; none: median * deviation^2
};

/// A grading in one of three forms; exactly one is given.
struct Grading {
  enum class By { mass, number };
  By by = By::mass;  ///< what shares and cumulative curves are measured in
  std::vector<GradingClass> classes{};
  std::optional<GradingTable> table{};
  std::optional<LogNormalGrading> lognormal{};

  bool is_given() const { return !classes.empty() || table || lognormal; }
};

/// Radii [m] of `count` grains that follow the grading: every class (of a table: every interval) gets the whole
/// number of grains that comes nearest to its share, their sizes evenly spread over its part of the curve
/// and set so that its mass is met. In random order.
/// @throws InputError  see size_classes; a class left without a grain
std::vector<double> grain_radii(const Grading& grading, int count, std::uint64_t seed);

/// Largest relative error of the share of a class, an interval of a table or a quarter of a log-normal curve, by
/// the grading's own measure [-].
double grading_error(const Grading& grading, std::span<const double> radii);

}  // namespace puadem
