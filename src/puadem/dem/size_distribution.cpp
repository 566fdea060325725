#include "puadem/dem/size_distribution.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "puadem/base/error.hpp"

namespace puadem {

namespace {

/// Integral of exp(p x) over 0 .. length.
double span_of(double p, double length) { return p == 0.0 ? length : std::expm1(p * length) / p; }

/// ln(upper / lower), right for bounds that are nearly one.
double log_ratio(double lower, double upper) { return std::log1p((upper - lower) / lower); }

double quantile_of(const PowerLawSizes& s, double u) {
  const double length = log_ratio(s.lower, s.upper), p = 1.0 - s.exponent;
  const double x = p == 0.0 ? u * length : std::log1p(u * std::expm1(p * length)) / p;
  return std::min(s.lower * std::exp(x), s.upper);
}

double mean_power_of(const PowerLawSizes& s, int k) {
  const double length = log_ratio(s.lower, s.upper), p = 1.0 - s.exponent;
  const double ratio = length > 0.0 ? span_of(p + k, length) / span_of(p, length) : 1.0;
  return std::pow(s.lower, k) * ratio;
}

/// Share of a normal curve above z. Exact far out, where most of the numbers lie of a curve given by mass.
double upper_tail(double z) { return 0.5 * std::erfc(z / std::numbers::sqrt2); }

struct Cut {
  double low, high;              ///< bounds in standard deviations of ln d
  double above_low, above_high;  ///< share of the uncut curve above them
};

Cut cut_of(const LogNormalSizes& s, double shift = 0.0) {
  const double low = std::log(s.lower / s.median) / s.log_width - shift,
               high = std::log(s.upper / s.median) / s.log_width - shift;
  return {low, high, upper_tail(low), upper_tail(high)};
}

/// Newton's method on the logarithm of the tail, which is smooth far out, kept between the cuts by bisection.
double quantile_of(const LogNormalSizes& s, double u) {
  const Cut cut = cut_of(s);
  const double target = (1.0 - u) * cut.above_low + u * cut.above_high;
  double low = cut.low, high = cut.high, z = 0.5 * (low + high);
  for (int step = 0; step < 80 && high - low > 1e-14 * (1.0 + std::abs(z)); ++step) {
    const double tail = upper_tail(z);
    (tail > target ? low : high) = z;
    const double density = std::exp(-0.5 * z * z) / std::sqrt(2.0 * std::numbers::pi);
    const double next = z + std::log(tail / target) * tail / density;
    if (std::abs(next - z) <= 1e-14 * (1.0 + std::abs(z))) break;
    z = next > low && next < high ? next : 0.5 * (low + high);
  }
  return std::clamp(s.median * std::exp(s.log_width * z), s.lower, s.upper);
}

double mean_power_of(const LogNormalSizes& s, int k) {
  const double shift = k * s.log_width;
  const Cut cut = cut_of(s), shifted = cut_of(s, shift);
  return std::pow(s.median, k) * std::exp(0.5 * shift * shift) * (shifted.above_low - shifted.above_high) /
         (cut.above_low - cut.above_high);
}

bool is_diameter(double d) { return std::isfinite(d) && d > 0.0; }

/// Mass is d^3 by number: a curve straight over d has d^0 by its measure, one straight over ln d has d^-1.
double exponent_of(Grading::By by, bool over_logarithm) {
  return (by == Grading::By::mass ? 3.0 : 0.0) + (over_logarithm ? 1.0 : 0.0);
}

std::vector<SizeClass> from_classes(const Grading& grading) {
  std::vector<SizeClass> out;
  double sum = 0.0;
  for (std::size_t i = 0; i < grading.classes.size(); ++i) {
    const GradingClass& c = grading.classes[i];
    require(is_diameter(c.diameter_min) && is_diameter(c.diameter_max) && c.diameter_max >= c.diameter_min,
            "grading class {}: diameters {} to {} m must be positive and ascending", i + 1, c.diameter_min, c.diameter_max);
    require(c.fraction > 0.0 && c.fraction <= 1.0, "grading class {}: its fraction {} must lie in (0, 1]", i + 1, c.fraction);
    sum += c.fraction;
    out.push_back({PowerLawSizes{c.diameter_min, c.diameter_max, exponent_of(grading.by, false)}, c.fraction});
  }
  // Fractions are written with few digits; thirds must pass.
  require(std::abs(sum - 1.0) <= 1e-3, "the fractions of grains.grading.classes add to {:.6g}; they must add to 1", sum);
  for (SizeClass& c : out) c.share /= sum;
  return out;
}

std::vector<SizeClass> from_table(const GradingTable& table, Grading::By by) {
  const auto &d = table.diameter, &passing = table.passing;
  require(d.size() == passing.size(), "grains.grading.table: {} diameters but {} values of passing; each diameter needs one",
          d.size(), passing.size());
  require(d.size() >= 2, "grains.grading.table: at least two diameters are needed, where the curve begins and where it ends");
  require(passing.front() == 0.0,
          "grains.grading.table: passing begins with {:.4g} %; it must begin with 0 %, at the diameter of the smallest grain",
          100.0 * passing.front());
  require(std::abs(passing.back() - 1.0) <= 1e-12,
          "grains.grading.table: passing ends with {:.6g} %; it must end with 100 %, at the diameter of the largest grain",
          100.0 * passing.back());
  const double exponent = exponent_of(by, table.interpolation == GradingTable::Interpolation::logarithmic);
  std::vector<SizeClass> out;
  for (std::size_t i = 0; i < d.size(); ++i) {
    require(is_diameter(d[i]), "grains.grading.table: diameter {} of value {} m must be positive", i + 1, d[i]);
    if (i == 0) continue;
    require(d[i] > d[i - 1], "grains.grading.table: the diameters must ascend, but {:.6g} m follows {:.6g} m", d[i], d[i - 1]);
    require(passing[i] >= passing[i - 1], "grains.grading.table: passing must not fall, but {:.6g} % follows {:.6g} %",
            100.0 * passing[i], 100.0 * passing[i - 1]);
    if (passing[i] > passing[i - 1]) out.push_back({PowerLawSizes{d[i - 1], d[i], exponent}, passing[i] - passing[i - 1]});
  }
  return out;
}

std::vector<SizeClass> from_lognormal(const LogNormalGrading& g, Grading::By by) {
  require(is_diameter(g.median), "grains.grading.lognormal: median {} m must be positive", g.median);
  require(std::isfinite(g.deviation) && g.deviation > 1.0,
          "grains.grading.lognormal: deviation {} must exceed 1; it is d_84 / d_50, for a single size use classes", g.deviation);
  const double tail = g.deviation * g.deviation;
  const double smallest = g.smallest.value_or(g.median / tail), largest = g.largest.value_or(g.median * tail);
  require(is_diameter(smallest) && std::isfinite(largest) && largest > smallest,
          "grains.grading.lognormal: cut-offs {:.6g} and {:.6g} m must be positive and ascending", smallest, largest);
  // A curve that is log-normal by mass is so by number, about a smaller median (Hatch and Choate 1929,
  // J. Franklin Inst. 207, 369).
  const double width = std::log(g.deviation);
  const double median = by == Grading::By::mass ? g.median * std::exp(-3.0 * width * width) : g.median;
  const LogNormalSizes sizes{smallest, largest, median, width};
  const Cut cut = cut_of(sizes);
  require(
      cut.above_low - cut.above_high > 1e-12,
      "grains.grading.lognormal: the cut-offs {:.6g} and {:.6g} m leave nothing of a curve of median {:.6g} m and deviation {}",
      smallest, largest, g.median, g.deviation);
  return {{sizes, 1.0}};
}

}  // namespace

double quantile(const AnySizes& sizes, double u) {
  return std::visit([u](const auto& s) { return u <= 0.0 ? s.lower : u >= 1.0 ? s.upper : quantile_of(s, u); }, sizes);
}

double mean_power(const AnySizes& sizes, int k) {
  return std::visit([k](const auto& s) { return mean_power_of(s, k); }, sizes);
}

std::vector<SizeClass> size_classes(const Grading& grading) {
  const int forms = (grading.classes.empty() ? 0 : 1) + (grading.table ? 1 : 0) + (grading.lognormal ? 1 : 0);
  require(forms > 0, "grains.grading has no class; give classes, a table or lognormal");
  require(forms == 1, "grains.grading: classes, table and lognormal exclude each other; give one of them");
  if (grading.table) return from_table(*grading.table, grading.by);
  if (grading.lognormal) return from_lognormal(*grading.lognormal, grading.by);
  return from_classes(grading);
}

std::vector<double> number_shares(const std::vector<SizeClass>& classes, Grading::By by) {
  std::vector<double> share;
  double sum = 0.0;
  for (const SizeClass& c : classes) {
    share.push_back(by == Grading::By::number ? c.share : c.share / mean_power(c.sizes, 3));
    sum += share.back();
  }
  for (double& s : share) s /= sum;
  return share;
}

}  // namespace puadem
