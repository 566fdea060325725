#include "puadem/flow/retention_curve.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "puadem/base/parallel.hpp"

namespace puadem {

namespace {

// [1 + (alpha p)^n]^-(1 - 1/n) without overflow of the power.
double effective_saturation(double alpha, double n, double pressure) {
  if (pressure <= 0.0) return 1.0;
  const double power = n * std::log(alpha * pressure);
  return std::exp(-(1.0 - 1.0 / n) * (std::max(power, 0.0) + std::log1p(std::exp(-std::abs(power)))));
}

double squared_distance(const VanGenuchten& curve, std::span<const RetentionRow> rows) {
  double sum = 0.0;
  for (const RetentionRow& row : rows) {
    const double distance = curve.saturation(row.capillary_pressure) - row.saturation;
    sum += distance * distance;
  }
  return sum;
}

// S is linear in S_r and S_s: their best values for given alpha and n, within 0 <= S_r <= S_s <= 1. The
// squares form a convex bowl, so the best place is its bottom or the best of the three sides.
VanGenuchten with_best_ends(double alpha, double n, std::span<const RetentionRow> rows) {
  double ff = 0, fg = 0, gg = 0, fs = 0, gs = 0;  // f: part of S_s, g = 1 - f: part of S_r, s: data
  for (const RetentionRow& row : rows) {
    const double f = effective_saturation(alpha, n, row.capillary_pressure), g = 1.0 - f, s = row.saturation;
    ff += f * f, fg += f * g, gg += g * g, fs += f * s, gs += g * s;
  }
  const auto curve = [&](double residual, double maximal) { return VanGenuchten{alpha, n, residual, maximal, 0.0}; };
  const double determinant = ff * gg - fg * fg;
  const double residual = (gs * ff - fs * fg) / determinant, maximal = (fs * gg - gs * fg) / determinant;
  if (residual >= 0.0 && residual <= maximal && maximal <= 1.0) return curve(residual, maximal);

  const double mean = (fs + gs) / static_cast<double>(rows.size());
  const std::array sides{curve(0.0, ff > 0.0 ? std::clamp(fs / ff, 0.0, 1.0) : 1.0),
                         curve(gg > 0.0 ? std::clamp((gs - fg) / gg, 0.0, 1.0) : 0.0, 1.0), curve(mean, mean)};
  return *std::ranges::min_element(sides, {}, [&](const VanGenuchten& side) { return squared_distance(side, rows); });
}

// What is searched: x = ln alpha, y = ln (n - 1), within a box about the pressures of the data.
struct Search {
  std::span<const RetentionRow> rows;
  double low_x, high_x, low_y = std::log(0.01), high_y = std::log(1000.0);

  VanGenuchten curve(double x, double y) const { return with_best_ends(std::exp(x), 1.0 + std::exp(y), rows); }
  bool contains(double x, double y) const { return x >= low_x && x <= high_x && y >= low_y && y <= high_y; }
};

std::array<double, 2> best_of_grid(const Search& search) {
  constexpr int steps = 32;
  std::array<double, 2> best{};
  double least = std::numeric_limits<double>::infinity();
  for (int a = 0; a <= steps; ++a)
    for (const double n : {1.2, 1.5, 2.0, 3.0, 5.0, 8.0, 12.0, 20.0, 40.0}) {
      const double x = std::lerp(search.low_x, search.high_x, a / static_cast<double>(steps)), y = std::log(n - 1.0);
      const double sum = squared_distance(search.curve(x, y), search.rows);
      if (sum < least) least = sum, best = {x, y};
    }
  return best;
}

// One damped Gauss-Newton step in (x, y), the slopes by central differences.
std::array<double, 2> damped_step(const Search& search, std::array<double, 2> at, double damping) {
  constexpr double h = 1e-5;
  const VanGenuchten here = search.curve(at[0], at[1]);
  const VanGenuchten east = search.curve(at[0] + h, at[1]), west = search.curve(at[0] - h, at[1]);
  const VanGenuchten north = search.curve(at[0], at[1] + h), south = search.curve(at[0], at[1] - h);
  double xx = 0, xy = 0, yy = 0, xr = 0, yr = 0;
  for (const RetentionRow& row : search.rows) {
    const double p = row.capillary_pressure, distance = here.saturation(p) - row.saturation;
    const double dx = (east.saturation(p) - west.saturation(p)) / (2.0 * h);
    const double dy = (north.saturation(p) - south.saturation(p)) / (2.0 * h);
    xx += dx * dx, xy += dx * dy, yy += dy * dy, xr += dx * distance, yr += dy * distance;
  }
  xx *= 1.0 + damping, yy *= 1.0 + damping;
  const double determinant = xx * yy - xy * xy;
  if (!(determinant > 0.0)) return {0.0, 0.0};
  return {(xy * yr - yy * xr) / determinant, (xy * xr - xx * yr) / determinant};
}

// Signed area under the segment a-b, p over S, within [low, high] [Pa].
double clipped_area(const RetentionRow& a, const RetentionRow& b, double low, double high) {
  if (a.saturation > b.saturation) return -clipped_area(b, a, low, high);
  const double from = std::max(a.saturation, low), to = std::min(b.saturation, high);
  if (from >= to) return 0.0;
  const double slope = (b.capillary_pressure - a.capillary_pressure) / (b.saturation - a.saturation);
  return (to - from) * (a.capillary_pressure + slope * (0.5 * (from + to) - a.saturation));
}

double area_under(std::span<const RetentionRow> branch, double low, double high) {
  double area = 0.0;
  for (int k = 1; k < size_of(branch); ++k) area += clipped_area(branch[to_size(k - 1)], branch[to_size(k)], low, high);
  return branch.front().saturation <= branch.back().saturation ? area : -area;
}

}  // namespace

double VanGenuchten::saturation(double pressure) const {
  return std::lerp(residual_saturation, maximal_saturation, effective_saturation(alpha, n, pressure));
}

std::optional<VanGenuchten> fit_van_genuchten(std::span<const RetentionRow> branch) {
  constexpr double least_spread = 1e-6;  // in S, which is of order 1
  if (branch.size() < 5) return {};
  const auto [low_s, high_s] = std::ranges::minmax(branch, {}, &RetentionRow::saturation);
  if (high_s.saturation - low_s.saturation < least_spread) return {};
  double low = std::numeric_limits<double>::infinity(), high = 0.0;
  for (const RetentionRow& row : branch)
    if (row.capillary_pressure > 0.0) {
      low = std::min(low, row.capillary_pressure);
      high = std::max(high, row.capillary_pressure);
    }
  if (!(low < high)) return {};

  const Search search{branch, -std::log(10.0 * high), -std::log(0.1 * low)};
  std::array<double, 2> at = best_of_grid(search);
  double least = squared_distance(search.curve(at[0], at[1]), branch);
  double damping = 1e-3;
  for (int iteration = 0; iteration < 300 && damping < 1e12; ++iteration) {
    const auto step = damped_step(search, at, damping);
    const double x = at[0] + step[0], y = at[1] + step[1];
    const double sum = search.contains(x, y) ? squared_distance(search.curve(x, y), branch) : least;
    damping *= sum < least ? 0.2 : 5.0;
    if (sum < least) least = sum, at = {x, y};
  }
  VanGenuchten fit = search.curve(at[0], at[1]);
  fit.rms_error = std::sqrt(least / static_cast<double>(branch.size()));
  return fit;
}

double loop_area(std::span<const RetentionRow> upper, std::span<const RetentionRow> lower) {
  if (upper.empty() || lower.empty()) return 0.0;
  const auto [upper_low, upper_high] = std::ranges::minmax(upper, {}, &RetentionRow::saturation);
  const auto [lower_low, lower_high] = std::ranges::minmax(lower, {}, &RetentionRow::saturation);
  const double low = std::max(upper_low.saturation, lower_low.saturation);
  const double high = std::min(upper_high.saturation, lower_high.saturation);
  return low < high ? area_under(upper, low, high) - area_under(lower, low, high) : 0.0;
}

std::optional<double> capillary_pressure_at(std::span<const RetentionRow> branch, double saturation) {
  for (int k = 0; k < size_of(branch); ++k) {
    const RetentionRow& b = branch[to_size(k)];
    if (b.saturation == saturation) return b.capillary_pressure;
    if (k == 0) continue;
    const RetentionRow& a = branch[to_size(k - 1)];
    if ((a.saturation < saturation) == (b.saturation < saturation)) continue;
    return std::lerp(a.capillary_pressure, b.capillary_pressure, (saturation - a.saturation) / (b.saturation - a.saturation));
  }
  return {};
}

}  // namespace puadem
