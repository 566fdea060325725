#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "puadem/base/error.hpp"
#include "puadem/base/random.hpp"
#include "puadem/dem/packing.hpp"

namespace puadem {

namespace {

/// Diameter below which the share u of the grains of a class lies, by number. Mass spread evenly over
/// diameter means a number density that falls as d^-3.
double quantile(const GradingClass& c, Grading::By by, double u) {
  const double a = c.diameter_min, b = c.diameter_max;
  if (by == Grading::By::number) return a + u * (b - a);
  return 1.0 / std::sqrt((1.0 - u) / (a * a) + u / (b * b));
}

double mean_cubed_diameter(const GradingClass& c, Grading::By by) {
  const double a = c.diameter_min, b = c.diameter_max;
  if (by == Grading::By::number) return (a + b) * (a * a + b * b) / 4.0;
  return 2.0 * a * a * b * b / (a + b);
}

void check(const Grading& grading, int count) {
  require(count >= 1, "grains.count = {} must be at least 1", count);
  require(!grading.classes.empty(), "the grading has no class");
  double sum = 0.0;
  for (std::size_t i = 0; i < grading.classes.size(); ++i) {
    const GradingClass& c = grading.classes[i];
    require(std::isfinite(c.diameter_min) && c.diameter_min > 0.0 && std::isfinite(c.diameter_max) &&
                c.diameter_max >= c.diameter_min,
            "grading class {}: diameters {} to {} m must be positive and ascending", i + 1, c.diameter_min, c.diameter_max);
    require(c.fraction > 0.0 && c.fraction <= 1.0, "grading class {}: its fraction {} must lie in (0, 1]", i + 1, c.fraction);
    sum += c.fraction;
  }
  require(std::abs(sum - 1.0) < 1e-6, "the fractions of the grading add to {:.6g}: they must add to 1", sum);
}

/// Share of the grains by number that falls to each class, before rounding.
std::vector<double> number_shares(const Grading& grading) {
  std::vector<double> share;
  double sum = 0.0;
  for (const GradingClass& c : grading.classes) {
    share.push_back(grading.by == Grading::By::number ? c.fraction : c.fraction / mean_cubed_diameter(c, grading.by));
    sum += share.back();
  }
  for (double& s : share) s /= sum;
  return share;
}

/// Whole numbers with the given sum: largest remainders, measured relative to the class so that a class
/// of few large grains, where one grain weighs most, is rounded first.
std::vector<int> round_counts(const std::vector<double>& share, int count) {
  std::vector<int> counts;
  int missing = count;
  for (const double s : share) {
    counts.push_back(static_cast<int>(std::floor(s * count)));
    missing -= counts.back();
  }
  for (; missing > 0; --missing) {
    std::size_t best = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < share.size(); ++i) {
      const double exact = share[i] * count;
      const double change = (std::abs(counts[i] + 1 - exact) - std::abs(counts[i] - exact)) / exact;
      if (change < least) {
        least = change;
        best = i;
      }
    }
    ++counts[best];
  }
  return counts;
}

/// Diameters at the quantiles (k + offset) / n, the offset set so that the mean of d^3 is the class's own.
void spread(const GradingClass& c, Grading::By by, int n, std::vector<double>& radii) {
  const double target = n * mean_cubed_diameter(c, by);
  const auto sum = [&](double offset) {
    double cubes = 0.0;
    for (int k = 0; k < n; ++k) cubes += std::pow(quantile(c, by, (k + offset) / n), 3);
    return cubes;
  };
  double low = 0.0, high = 1.0;  // the sum rises from below the target to above it
  for (int bisection = 0; bisection < 60; ++bisection) {
    const double middle = 0.5 * (low + high);
    (sum(middle) < target ? low : high) = middle;
  }
  for (int k = 0; k < n; ++k) radii.push_back(0.5 * quantile(c, by, (k + 0.5 * (low + high)) / n));
}

}  // namespace

std::vector<double> grain_radii(const Grading& grading, int count, std::uint64_t seed) {
  check(grading, count);
  const std::vector<double> share = number_shares(grading);
  const std::vector<int> counts = round_counts(share, count);
  std::vector<double> radii;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    require(counts[i] > 0, "grading class {} ({} to {} m) gets no grain out of {}: it would need at least {}", i + 1,
            grading.classes[i].diameter_min, grading.classes[i].diameter_max, count,
            static_cast<long>(std::ceil(1.0 / share[i])));
    spread(grading.classes[i], grading.by, counts[i], radii);
  }
  Random random(seed);
  for (std::size_t k = radii.size() - 1; k > 0; --k) std::swap(radii[k], radii[random.below(k + 1)]);
  return radii;
}

double grading_error(const Grading& grading, std::span<const double> radii) {
  std::vector<double> amount(grading.classes.size(), 0.0);
  double total = 0.0;
  for (const double r : radii) {
    const double weight = grading.by == Grading::By::mass ? r * r * r : 1.0;
    total += weight;
    // The nearest class: rounding must not lose a grain of a single size.
    std::size_t best = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < amount.size(); ++i) {
      const GradingClass& c = grading.classes[i];
      const double outside = std::max({c.diameter_min - 2.0 * r, 2.0 * r - c.diameter_max, 0.0});
      if (outside < least) {
        least = outside;
        best = i;
      }
    }
    amount[best] += weight;
  }
  double error = 0.0;
  for (std::size_t i = 0; i < amount.size(); ++i)
    error = std::max(error, std::abs(amount[i] / total / grading.classes[i].fraction - 1.0));
  return error;
}

}  // namespace puadem
