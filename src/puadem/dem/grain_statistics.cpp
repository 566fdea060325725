#include "puadem/dem/grain_statistics.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "puadem/dem/size_distribution.hpp"

namespace puadem {

namespace {

constexpr double volume_factor = 4.0 / 3.0 * std::numbers::pi;

GrainStatistics from_moments(const std::array<double, 4>& moment, double smallest, double largest) {
  return {moment[1] / moment[0], moment[3] / moment[2], volume_factor * moment[3] / moment[0], smallest, largest};
}

}  // namespace

GrainStatistics statistics_of(const Grading& grading) {
  std::array<double, 4> moment{};  // of r^k by number
  double smallest = std::numeric_limits<double>::infinity(), largest = 0.0;
  const std::vector<SizeClass> classes = size_classes(grading);
  const std::vector<double> share = number_shares(classes, grading.by);
  for (std::size_t i = 0; i < classes.size(); ++i) {
    const AnySizes& sizes = classes[i].sizes;
    for (int k = 0; k < 4; ++k) moment[static_cast<std::size_t>(k)] += share[i] * std::pow(0.5, k) * mean_power(sizes, k);
    smallest = std::min(smallest, 0.5 * quantile(sizes, 0.0));
    largest = std::max(largest, 0.5 * quantile(sizes, 1.0));
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
