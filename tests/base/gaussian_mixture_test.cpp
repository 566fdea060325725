#include "puadem/base/gaussian_mixture.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "puadem/base/random.hpp"

namespace puadem {
namespace {

/// Normal numbers by the polar formula of Box and Muller.
std::vector<double> normal_samples(int count, double mean, double deviation, std::uint64_t seed) {
  Random random(seed);
  std::vector<double> samples;
  for (int k = 0; k < count; ++k) {
    const double size = std::sqrt(-2.0 * std::log(1.0 - random.uniform()));
    samples.push_back(mean + deviation * size * std::cos(2.0 * std::numbers::pi * random.uniform()));
  }
  return samples;
}

std::vector<double> joined(std::vector<double> a, const std::vector<double>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

/// Log-likelihood of the samples themselves, by the definition.
double log_likelihood(const std::vector<double>& samples, const std::vector<NormalPart>& parts) {
  double sum = 0.0;
  for (const double x : samples) {
    double density = 0.0;
    for (const NormalPart& p : parts)
      density +=
          p.weight * std::exp(-0.5 * std::pow((x - p.mean) / p.deviation, 2)) / (p.deviation * std::sqrt(2.0 * std::numbers::pi));
    sum += std::log(density);
  }
  return sum;
}

TEST(GaussianMixture, FindsTwoNormalsThatLieApart) {
  const int first = 3000, second = 1000;
  const NormalMixture m = fit_normal_mixture(joined(normal_samples(first, 0.4, 0.03, 1), normal_samples(second, 0.7, 0.05, 2)));
  ASSERT_EQ(m.parts.size(), 2u);
  const auto expect_part = [](const NormalPart& part, double weight, double mean, double deviation, int count) {
    EXPECT_NEAR(part.weight, weight, 0.005);
    EXPECT_NEAR(part.mean, mean, 3.0 * deviation / std::sqrt(count));
    EXPECT_NEAR(part.deviation, deviation, 3.0 * deviation / std::sqrt(2.0 * count));
  };
  expect_part(m.parts[0], 0.75, 0.4, 0.03, first);
  expect_part(m.parts[1], 0.25, 0.7, 0.05, second);
}

TEST(GaussianMixture, OneNormalIsOnePart) {
  for (const std::uint64_t seed : {3u, 4u, 5u}) {
    const std::vector<double> samples = normal_samples(2000, -2.0, 0.3, seed);
    const NormalMixture m = fit_normal_mixture(samples);
    ASSERT_EQ(m.parts.size(), 1u);
    double mean = 0.0, variance = 0.0;
    for (const double x : samples) mean += x / 2000.0;
    for (const double x : samples) variance += (x - mean) * (x - mean) / 2000.0;
    EXPECT_NEAR(m.parts[0].mean, mean, 1e-12);
    EXPECT_NEAR(m.parts[0].deviation, std::sqrt(variance), 1e-3 * std::sqrt(variance));
    EXPECT_EQ(m.parts[0].weight, 1.0);
  }
}

TEST(GaussianMixture, LikelihoodNeverFalls) {
  const std::vector<double> samples = joined(normal_samples(600, 0.0, 1.0, 6), normal_samples(300, 2.5, 0.5, 7));
  for (int parts = 2; parts <= most_normal_parts; ++parts) {
    double before = -1e300;
    for (int iterations = 1; iterations <= 200; ++iterations) {
      const NormalMixture m = fit_normal_parts(samples, parts, iterations);
      EXPECT_GE(m.log_likelihood, before - 1e-9 * std::abs(before)) << parts << " parts, iteration " << iterations;
      before = m.log_likelihood;
    }
  }
}

TEST(GaussianMixture, StandsAtAMaximumOfTheLikelihoodOfItsSamples) {
  const std::vector<double> samples = joined(normal_samples(1500, 0.0, 1.0, 8), normal_samples(500, 3.0, 0.6, 9));
  const NormalMixture m = fit_normal_parts(samples, 2);
  ASSERT_TRUE(m.is_proper);
  const double best = log_likelihood(samples, m.parts);
  EXPECT_NEAR(m.log_likelihood, best, 1e-3 * std::abs(best));
  EXPECT_NEAR(m.bic, -2.0 * best + 5.0 * std::log(2000.0), 1e-3 * std::abs(best));
  for (std::size_t k = 0; k < 2; ++k)
    for (const double step : {-0.02, 0.02}) {
      std::vector<NormalPart> off = m.parts;
      off[k].mean += step;
      EXPECT_LT(log_likelihood(samples, off), best);
      off = m.parts;
      off[k].deviation += step;
      EXPECT_LT(log_likelihood(samples, off), best);
      off = m.parts;
      off[k].weight += step;
      off[1 - k].weight -= step;
      EXPECT_LT(log_likelihood(samples, off), best);
    }
}

TEST(GaussianMixture, DoesNotDependOnTheOrderOfTheSamples) {
  std::vector<double> samples = joined(normal_samples(400, 0.0, 1.0, 10), normal_samples(300, 4.0, 0.5, 11));
  const NormalMixture before = fit_normal_mixture(samples);
  Random random(12);
  for (std::size_t k = samples.size() - 1; k > 0; --k) std::swap(samples[k], samples[random.below(k + 1)]);
  const NormalMixture after = fit_normal_mixture(samples);
  EXPECT_EQ(before.parts, after.parts);
  EXPECT_EQ(before.bic, after.bic);
}

TEST(GaussianMixture, ScalesWithTheUnitOfTheSamples) {
  std::vector<double> samples = joined(normal_samples(400, 1.0, 0.2, 13), normal_samples(200, 3.0, 0.3, 14));
  const NormalMixture metres = fit_normal_mixture(samples);
  for (double& x : samples) x *= 1e-6;
  const NormalMixture small = fit_normal_mixture(samples);
  ASSERT_EQ(metres.parts.size(), small.parts.size());
  for (std::size_t k = 0; k < metres.parts.size(); ++k) {
    EXPECT_NEAR(small.parts[k].mean, 1e-6 * metres.parts[k].mean, 1e-14);
    EXPECT_NEAR(small.parts[k].deviation, 1e-6 * metres.parts[k].deviation, 1e-14);
  }
}

// What lies close together would win by a spike without bound.
TEST(GaussianMixture, ASpikeIsNoPart) {
  const std::vector<double> samples = joined(normal_samples(1000, 0.5, 0.1, 15), normal_samples(1000, 0.45, 0.001, 16));
  for (const NormalPart& part : fit_normal_mixture(samples).parts) EXPECT_GE(part.deviation, 0.06 * 0.08);
  EXPECT_FALSE(fit_normal_parts(joined(std::vector<double>(500, 1.0), std::vector<double>(500, 2.0)), 2).is_proper);
}

TEST(GaussianMixture, TakesFewOrEqualSamples) {
  EXPECT_TRUE(fit_normal_mixture({}).parts.empty());
  const std::vector<double> one{0.3}, equal(40, 0.1 + 0.2), two{0.0, 1.0};
  EXPECT_EQ(fit_normal_mixture(one).parts, (std::vector<NormalPart>{{1.0, 0.3, 0.0}}));
  EXPECT_EQ(fit_normal_mixture(equal).parts.size(), 1u);
  ASSERT_EQ(fit_normal_mixture(two).parts.size(), 1u);
  EXPECT_EQ(fit_normal_mixture(two).parts[0], (NormalPart{1.0, 0.5, 0.5}));
}

}  // namespace
}  // namespace puadem
