#include "puadem/io/grading_statistics.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace puadem {

namespace {

constexpr double volume_factor = 4.0 / 3.0 * std::numbers::pi;

/// Mean of r^k over radii uniform between a and b.
double mean_power(double a, double b, int k) {
  if (b - a <= 1e-9 * b) return std::pow(0.5 * (a + b), k);
  if (k == -1) return std::log(b / a) / (b - a);
  return (std::pow(b, k + 1) - std::pow(a, k + 1)) / ((k + 1) * (b - a));
}

GrainStatistics from_moments(const std::array<double, 4>& moment, double smallest, double largest) {
  return {moment[1] / moment[0], moment[3] / moment[2], volume_factor * moment[3] / moment[0], smallest, largest};
}

}  // namespace

GrainStatistics statistics_of(const Grading& grading) {
  std::array<double, 4> moment{};  // of r^k by number, up to a common factor
  double smallest = std::numeric_limits<double>::infinity(), largest = 0.0;
  // Mass is r^3 by number: uniform by mass, the number in dr goes as r^-3.
  const int weight = grading.by == Grading::By::mass ? -3 : 0;
  for (const GradingClass& g : grading.classes) {
    const double a = 0.5 * g.diameter_min, b = 0.5 * g.diameter_max;
    for (int k = 0; k < 4; ++k) moment[static_cast<std::size_t>(k)] += g.fraction * mean_power(a, b, k + weight);
    smallest = std::min(smallest, a);
    largest = std::max(largest, b);
  }
  return from_moments(moment, smallest, largest);
}

GrainStatistics statistics_of(std::span<const double> radius) {
  std::array<double, 4> moment{};
  for (const double r : radius) {
    double power = 1.0;
    for (double& m : moment) {
      m += power;
      power *= r;
    }
  }
  const auto [low, high] = std::ranges::minmax(radius);
  return from_moments(moment, low, high);
}

}  // namespace puadem
