#pragma once

#include <span>
#include <vector>

namespace puadem {

/// One normal distribution of a mixture.
struct NormalPart {
  double weight = 0.0;     ///< share of the samples [-]
  double mean = 0.0;       ///< as the samples
  double deviation = 0.0;  ///< standard deviation, as the samples
  bool operator==(const NormalPart&) const = default;
};

/// Parts that a mixture may have at most.
inline constexpr int most_normal_parts = 4;

/// A mixture of normal distributions that was fitted to samples (theory 7.10).
struct NormalMixture {
  std::vector<NormalPart> parts;  ///< by mean, ascending
  double log_likelihood = 0.0;    ///< of the samples, counted in the classes of the fit
  double bic = 0.0;               ///< Bayesian information criterion: less is better
  int iterations = 0;
  bool is_proper = false;  ///< settled, and no part is a spike or holds next to nothing; others are no candidates
};

/// Expectation and maximisation (Dempster, Laird and Rubin 1977, J. R. Stat. Soc. B 39, 1) for a given number of parts, from
/// equal shares of the sorted samples. The order of the samples does not matter.
/// @param parts            1 .. `most_normal_parts`
/// @param most_iterations  after which a mixture that has not settled is not proper
/// @pre there are samples; for more than one part two of them differ
NormalMixture fit_normal_parts(std::span<const double> samples, int parts, int most_iterations = 2000);

/// The proper mixture of least BIC among those of 1 to 4 parts; no parts without samples. One part is always proper.
NormalMixture fit_normal_mixture(std::span<const double> samples);

}  // namespace puadem
