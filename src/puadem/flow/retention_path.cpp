#include "puadem/flow/retention_path.hpp"

#include <algorithm>
#include <cmath>

#include "puadem/base/error.hpp"

namespace puadem {

namespace {

void check(const RetentionPath& path) {
  require(!path.turning_points.empty(), "the retention path is empty: give at least one capillary pressure");
  for (const double step : path.step)
    require(std::isfinite(step) && step > 0.0, "the step of the retention path is {} Pa; it must be positive", step);
  require(path.step.size() == 1 || path.step.size() + 1 == path.turning_points.size(),
          "the retention path has {} steps for {} legs; give one for all or one for each", path.step.size(),
          path.turning_points.size() - 1);
  for (int k = 0; k < size_of(path.turning_points); ++k) {
    const double point = path.turning_points[to_size(k)];
    require(std::isfinite(point) && point >= 0.0, "value {} of the retention path is {} Pa; it must be finite and not negative",
            k + 1, point);
    require(k == 0 || point != path.turning_points[to_size(k - 1)],
            "values {} and {} of the retention path are both {} Pa; neighbours must differ", k, k + 1, point);
  }
}

/// Step of the leg that ends at turning point k.
double step_of(const RetentionPath& path, int k) { return path.step.size() == 1 ? path.step.front() : path.step[to_size(k - 1)]; }

void check_length(const RetentionPath& path) {
  constexpr double most_rows = 1e6;
  double rows = 0.0;
  for (int k = 1; k < size_of(path.turning_points); ++k)
    rows += std::abs(path.turning_points[to_size(k)] - path.turning_points[to_size(k - 1)]) / step_of(path, k);
  require(rows < most_rows, "the retention path has more than a million steps of {} Pa: take a larger step",
          std::ranges::min(path.step));
}

// Stops within a leg, the end included and the start left out.
void add_leg(double from, double to, double step, const std::string& branch, std::vector<RetentionStop>& stops) {
  constexpr double same = 1e-9;  // of a step: a last multiple that is the end but for rounding
  const double sign = to > from ? 1.0 : -1.0;
  for (long k = 1; static_cast<double>(k) * step < std::abs(to - from) - same * step; ++k)
    stops.push_back({from + sign * static_cast<double>(k) * step, branch});
  stops.push_back({to, branch});
}

}  // namespace

std::vector<RetentionStop> retention_stops(const RetentionPath& path, double start) {
  check(path);
  check_length(path);
  int drainages = 0, imbibitions = 0;
  bool drains = path.turning_points.front() >= start;
  const auto next_branch = [&] {
    return drains ? fmt::format("drainage-{}", ++drainages) : fmt::format("imbibition-{}", ++imbibitions);
  };
  std::string branch = next_branch();
  std::vector<RetentionStop> stops{{path.turning_points.front(), branch}};
  for (int k = 1; k < size_of(path.turning_points); ++k) {
    const double from = path.turning_points[to_size(k - 1)], to = path.turning_points[to_size(k)];
    if (drains != (to > from)) {
      drains = to > from;
      branch = next_branch();
    }
    add_leg(from, to, step_of(path, k), branch, stops);
  }
  return stops;
}

RetentionRow follow_to(const PoreNetwork& network, const Fluids& fluids, const RetentionPath& path, const RetentionStop& stop,
                       int number, InvasionState& state, const InvasionEventCallback& on_event) {
  advance_to(network, stop.capillary_pressure, state, on_event);
  const InvasionTotals sums = totals(network, state);
  const double pc_star = stop.capillary_pressure * path.mean_grain_radius / fluids.surface_tension;
  return {number, stop.branch, stop.capillary_pressure, pc_star, sums.saturation, sums.trapped_wetting, sums.trapped_nonwetting};
}

std::vector<RetentionRow> follow_path(const PoreNetwork& network, const Fluids& fluids, const RetentionPath& path,
                                      InvasionState& state, const std::function<bool(const RetentionRow&)>& on_row,
                                      const InvasionEventCallback& on_event) {
  std::vector<RetentionRow> rows;
  for (const RetentionStop& stop : retention_stops(path, state.capillary_pressure)) {
    rows.push_back(follow_to(network, fluids, path, stop, size_of(rows), state, on_event));
    if (on_row && !on_row(rows.back())) break;
  }
  return rows;
}

}  // namespace puadem
