#include "puadem/base/gaussian_mixture.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>

#include "puadem/base/compensated_sum.hpp"
#include "puadem/base/parallel.hpp"

namespace puadem {

namespace {

constexpr double class_width = 0.02;   // of the samples' deviation: changes the variance of no part by more than 1 %
constexpr double narrowest = 0.06;     // part, over the samples' deviation
constexpr double fewest = 5.0;         // samples of a part
constexpr double settled_gain = 1e-8;  // of the log-likelihood of a sample in one iteration
constexpr int most_iterations = 2000;
constexpr double rounding = 1e-9;  // of the largest sample: values that differ by less are one

/// Samples that lie close together count as one value: the cost does not grow with their number.
struct Classes {
  std::vector<double> value, count;  ///< mean of the samples in a class, and how many
  double samples = 0.0, mean = 0.0, deviation = 0.0;
};

Classes classes_of(std::span<const double> samples) {
  std::vector<double> sorted(samples.begin(), samples.end());
  std::ranges::sort(sorted);
  Classes classes;
  classes.samples = static_cast<double>(sorted.size());
  CompensatedSum sum, squares;
  for (const double x : sorted) sum.add(x);
  classes.mean = sum.value() / classes.samples;
  for (const double x : sorted) squares.add((x - classes.mean) * (x - classes.mean));
  classes.deviation = std::sqrt(squares.value() / classes.samples);
  const double width = class_width * classes.deviation;
  for (std::size_t first = 0, end = 0; first < sorted.size(); first = end) {
    CompensatedSum inside;
    for (; end < sorted.size() && sorted[end] - sorted[first] <= width; ++end) inside.add(sorted[end]);
    classes.count.push_back(static_cast<double>(end - first));
    classes.value.push_back(inside.value() / classes.count.back());
  }
  return classes;
}

/// Mean and deviation of each of equal shares of the samples, in order.
std::vector<NormalPart> start_of(const Classes& classes, int parts) {
  std::vector<double> weight(to_size(parts)), sum(to_size(parts)), squares(to_size(parts));
  double before = 0.0;
  for (std::size_t c = 0; c < classes.value.size(); ++c) {
    const double middle = (before + 0.5 * classes.count[c]) / classes.samples, x = classes.value[c] - classes.mean;
    const auto k = std::min(static_cast<std::size_t>(middle * parts), to_size(parts) - 1);
    weight[k] += classes.count[c];
    sum[k] += classes.count[c] * x;
    squares[k] += classes.count[c] * x * x;
    before += classes.count[c];
  }
  std::vector<NormalPart> start;
  for (std::size_t k = 0; k < weight.size(); ++k) {
    if (!(weight[k] > 0.0)) continue;
    const double mean = sum[k] / weight[k], variance = squares[k] / weight[k] - mean * mean;
    // A share of equal values begins as narrow as the classes are.
    const double deviation = std::max(std::sqrt(std::max(variance, 0.0)), class_width * classes.deviation);
    start.push_back({weight[k] / classes.samples, classes.mean + mean, deviation});
  }
  return start;
}

/// One iteration: what each part has of each class by the parts as they are, then the parts that fit that best.
/// @return log-likelihood of the samples with the parts as they were
double iterate(const Classes& classes, std::vector<NormalPart>& parts) {
  const std::size_t n = parts.size();
  std::vector<double> weight(n), sum(n), squares(n), scale(n), exponent(n), share(n);
  for (std::size_t k = 0; k < n; ++k) scale[k] = parts[k].weight / (parts[k].deviation * std::sqrt(2.0 * std::numbers::pi));
  double log_likelihood = 0.0;
  for (std::size_t c = 0; c < classes.value.size(); ++c) {
    for (std::size_t k = 0; k < n; ++k) {
      const double z = (classes.value[c] - parts[k].mean) / parts[k].deviation;
      exponent[k] = -0.5 * z * z;
    }
    const double largest = std::ranges::max(exponent);  // far from all parts every density would underflow
    double density = 0.0;
    for (std::size_t k = 0; k < n; ++k) density += share[k] = scale[k] * std::exp(exponent[k] - largest);
    log_likelihood += classes.count[c] * (largest + std::log(density));
    for (std::size_t k = 0; k < n; ++k) {
      const double part = classes.count[c] * share[k] / density, x = classes.value[c] - parts[k].mean;
      weight[k] += part;
      sum[k] += part * x;
      squares[k] += part * x * x;
    }
  }
  for (std::size_t k = 0; k < n; ++k) {
    const double shift = sum[k] / weight[k];
    parts[k] = {weight[k] / classes.samples, parts[k].mean + shift, std::sqrt(squares[k] / weight[k] - shift * shift)};
  }
  return log_likelihood;
}

/// A spike has a likelihood without bound, and a few samples tell no deviation: neither can be compared by BIC.
bool is_sound(const Classes& classes, const std::vector<NormalPart>& parts) {
  return std::ranges::all_of(parts, [&](const NormalPart& p) {
    return p.deviation >= narrowest * classes.deviation && p.weight * classes.samples >= fewest;
  });
}

NormalMixture fit(const Classes& classes, int parts, int limit) {
  NormalMixture mixture;
  std::vector<NormalPart> next = start_of(classes, parts);
  if (size_of(next) < parts) return mixture;  // fewer values than parts
  for (double before = -std::numeric_limits<double>::infinity(); mixture.iterations < limit && !mixture.is_proper;) {
    mixture.parts = next;
    mixture.log_likelihood = iterate(classes, next);
    ++mixture.iterations;
    if (parts > 1 && !is_sound(classes, next)) return mixture;
    mixture.is_proper = parts == 1 || mixture.log_likelihood - before < settled_gain * classes.samples;
    before = mixture.log_likelihood;
  }
  mixture.bic = -2.0 * mixture.log_likelihood + (3 * parts - 1) * std::log(classes.samples);
  std::ranges::sort(mixture.parts, {}, &NormalPart::mean);
  return mixture;
}

}  // namespace

NormalMixture fit_normal_parts(std::span<const double> samples, int parts, int limit) {
  assert(!samples.empty() && parts >= 1 && parts <= most_normal_parts);
  const Classes classes = classes_of(samples);
  assert(parts == 1 || classes.deviation > 0.0);
  return fit(classes, parts, limit);
}

NormalMixture fit_normal_mixture(std::span<const double> samples) {
  if (samples.empty()) return {};
  const Classes classes = classes_of(samples);
  const double largest = std::max(std::abs(classes.value.front()), std::abs(classes.value.back()));
  if (!(classes.deviation > rounding * largest)) {  // one value: its likelihood has no bound
    NormalMixture one;
    one.parts = {{1.0, classes.mean, 0.0}};
    one.is_proper = true;
    return one;
  }
  NormalMixture best = fit(classes, 1, most_iterations);
  for (int parts = 2; parts <= most_normal_parts; ++parts) {
    NormalMixture other = fit(classes, parts, most_iterations);
    if (other.is_proper && other.bic < best.bic) best = std::move(other);
  }
  return best;
}

}  // namespace puadem
