#include "puadem/dem/grading.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "puadem/base/error.hpp"
#include "puadem/base/random.hpp"
#include "puadem/dem/size_distribution.hpp"

namespace puadem {

namespace {

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
void spread(const AnySizes& sizes, int n, std::vector<double>& radii) {
  const double target = n * mean_power(sizes, 3);
  const auto excess = [&](double offset) {
    double cubes = 0.0;
    for (int k = 0; k < n; ++k) {
      const double d = quantile(sizes, (k + offset) / n);
      cubes += d * d * d;
    }
    return cubes - target;
  };
  // Regula falsi with the Illinois rule: the excess rises from below zero to above it, nearly straight.
  double low = 0.0, high = 1.0, offset = 0.5;
  double at_low = excess(low), at_high = excess(high);
  for (int step = 0; step < 60 && at_low < 0.0 && at_high > 0.0; ++step) {
    offset = (low * at_high - high * at_low) / (at_high - at_low);
    const double here = excess(offset);
    if (std::abs(here) <= 1e-13 * target) break;
    if (here < 0.0) {
      low = offset;
      at_low = here;
      at_high *= 0.5;
    } else {
      high = offset;
      at_high = here;
      at_low *= 0.5;
    }
  }
  for (int k = 0; k < n; ++k) radii.push_back(0.5 * quantile(sizes, (k + offset) / n));
}

/// A part of the curve whose share is looked at.
struct Bin {
  double lower, upper;  ///< diameters [m]
  double share;
};

std::vector<Bin> bins_of(const Grading& grading) {
  constexpr int quarters = 4;
  std::vector<Bin> bins;
  for (const SizeClass& c : size_classes(grading)) {
    if (const auto* power = std::get_if<PowerLawSizes>(&c.sizes)) {
      bins.push_back({power->lower, power->upper, c.share});
      continue;
    }
    LogNormalSizes measured = std::get<LogNormalSizes>(c.sizes);  // by the measure of the grading
    if (grading.by == Grading::By::mass) measured.median *= std::exp(3.0 * measured.log_width * measured.log_width);
    for (int q = 0; q < quarters; ++q)
      bins.push_back({quantile(measured, 1.0 * q / quarters), quantile(measured, (q + 1.0) / quarters), c.share / quarters});
  }
  return bins;
}

}  // namespace

std::vector<double> grain_radii(const Grading& grading, int count, std::uint64_t seed) {
  require(count >= 1, "grains.count = {} must be at least 1", count);
  const std::vector<SizeClass> classes = size_classes(grading);
  const std::vector<double> share = number_shares(classes, grading.by);
  const std::vector<int> counts = round_counts(share, count);
  std::vector<double> radii;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    require(counts[i] > 0, "grading class {} ({:.6g} to {:.6g} m) gets no grain out of {}: it would need at least {}", i + 1,
            quantile(classes[i].sizes, 0.0), quantile(classes[i].sizes, 1.0), count,
            static_cast<long>(std::ceil(1.0 / share[i])));
    spread(classes[i].sizes, counts[i], radii);
  }
  Random random(seed);
  for (std::size_t k = radii.size() - 1; k > 0; --k) std::swap(radii[k], radii[random.below(k + 1)]);
  return radii;
}

double grading_error(const Grading& grading, std::span<const double> radii) {
  const std::vector<Bin> bins = bins_of(grading);
  std::vector<double> amount(bins.size(), 0.0);
  double total = 0.0;
  for (const double r : radii) {
    const double weight = grading.by == Grading::By::mass ? r * r * r : 1.0;
    total += weight;
    // The nearest bin: rounding must not lose a grain of a single size.
    std::size_t best = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < bins.size(); ++i) {
      const double outside = std::max({bins[i].lower - 2.0 * r, 2.0 * r - bins[i].upper, 0.0});
      if (outside < least) {
        least = outside;
        best = i;
      }
    }
    amount[best] += weight;
  }
  double error = 0.0;
  for (std::size_t i = 0; i < bins.size(); ++i) error = std::max(error, std::abs(amount[i] / total / bins[i].share - 1.0));
  return error;
}

}  // namespace puadem
