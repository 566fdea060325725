#include "puadem/flow/incomplete_factor.hpp"

#include <algorithm>
#include <cstdint>
#include <numeric>

#include "puadem/base/parallel.hpp"

namespace puadem {

namespace {

/// Share of what an incomplete factor leaves out that goes to its diagonal: constant pressures are then nearly exact, and errors
/// that reach far fall faster (Gustafsson 1978); all of it would leave no reserve against a pivot of zero.
constexpr double kept = 0.97;

/// Unknowns in the order in which a flood from the first of each part reaches them.
std::vector<int> flood_order(const Csr& pattern) {
  const int n = pattern.rows();
  std::vector<int> order;
  order.reserve(to_size(n));
  std::vector<std::uint8_t> seen(to_size(n));
  for (int seed = 0; seed < n; ++seed) {
    if (seen[to_size(seed)]) continue;
    seen[to_size(seed)] = 1;
    order.push_back(seed);
    for (std::size_t next = order.size() - 1; next < order.size(); ++next)
      for (const int other : pattern[order[next]]) {
        if (seen[to_size(other)]) continue;
        seen[to_size(other)] = 1;
        order.push_back(other);
      }
  }
  return order;
}

double inner(std::span<const double> a, std::span<const double> b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

}  // namespace

IncompleteFactor::IncompleteFactor(const NetworkMatrix& matrix) {
  const int n = matrix.rows();
  const std::vector<int> order = flood_order(matrix.pattern);
  place_.resize(to_size(n));
  for (int r = 0; r < n; ++r) place_[to_size(order[to_size(r)])] = r;
  start_.push_back(0);
  for (const int unknown : order) {
    const int row = place_[to_size(unknown)];
    for (int e = matrix.pattern.start[to_size(unknown)]; e < matrix.pattern.start[to_size(unknown) + 1]; ++e) {
      const int column = place_[to_size(matrix.pattern.index[to_size(e)])];
      if (column >= row) continue;
      lower_.push_back({column, 0.0});
      source_.push_back(e);
    }
    diagonal_at_.push_back(matrix.diagonal_entry[to_size(unknown)]);
    start_.push_back(size_of(lower_));
  }
  for (auto* v : {&diagonal_, &pivot_, &inverse_, &residual_, &direction_, &solution_, &image_, &carried_}) v->resize(to_size(n));
}

void IncompleteFactor::set_up(const NetworkMatrix& matrix) {
  const std::size_t n = place_.size();
  for (std::size_t k = 0; k < lower_.size(); ++k) lower_[k].value = matrix.value[to_size(source_[k])];
  // Sums of the upper triangle of each row: what elimination of the row spreads over later rows.
  std::vector<double>& above = carried_;
  std::ranges::fill(above, 0.0);
  for (const Entry& entry : lower_) above[to_size(entry.column)] += entry.value;
  for (std::size_t r = 0; r < n; ++r) {
    diagonal_[r] = matrix.value[to_size(diagonal_at_[r])];
    double pivot = diagonal_[r];
    for (int k = start_[r]; k < start_[r + 1]; ++k) {
      const Entry& entry = lower_[to_size(k)];
      const std::size_t c = to_size(entry.column);
      pivot -= entry.value * inverse_[c] * ((1.0 - kept) * entry.value + kept * above[c]);
    }
    pivot_[r] = pivot;
    inverse_[r] = 1.0 / pivot;
  }
}

void IncompleteFactor::forward(std::span<double> x) const {
  for (std::size_t r = 0; r < x.size(); ++r) {
    double sum = x[r];
    for (int k = start_[r]; k < start_[r + 1]; ++k) sum -= lower_[to_size(k)].value * x[to_size(lower_[to_size(k)].column)];
    x[r] = sum * inverse_[r];
  }
}

void IncompleteFactor::backward(std::span<double> x) const {
  for (std::size_t r = x.size(); r-- > 0;) {
    const double value = x[r] *= inverse_[r];
    for (int k = start_[r]; k < start_[r + 1]; ++k) x[to_size(lower_[to_size(k)].column)] -= lower_[to_size(k)].value * value;
  }
}

int IncompleteFactor::solve(std::span<const double> b, std::span<double> x, double tolerance, int limit) {
  const std::size_t n = place_.size();
  for (std::size_t i = 0; i < n; ++i) {
    residual_[to_size(place_[i])] = b[i];
    solution_[to_size(place_[i])] = x[i];
  }
  // residual = b - A x, rows and columns of the lower triangle at once
  double start = inner(residual_, solution_);
  for (std::size_t r = 0; r < n; ++r) {
    double sum = diagonal_[r] * solution_[r];
    for (int k = start_[r]; k < start_[r + 1]; ++k) {
      const auto [column, value] = lower_[to_size(k)];
      sum += value * solution_[to_size(column)];
      residual_[to_size(column)] -= value * solution_[r];
    }
    residual_[r] -= sum;
  }
  forward(residual_);
  // From here on in the variables (D + L^T) x, where the preconditioner is D^-1.
  double before = 1.0, taken_before = 0.0, energy = start;
  std::ranges::fill(direction_, 0.0);
  int iteration = 0;
  for (; iteration < limit; ++iteration) {
    double now = 0.0;
    for (std::size_t r = 0; r < n; ++r) now += residual_[r] * residual_[r] * pivot_[r];
    if (now == 0.0) break;
    const double share = iteration == 0 ? 0.0 : now / before;
    before = now;
    for (std::size_t r = 0; r < n; ++r) image_[r] = direction_[r] = pivot_[r] * residual_[r] + share * direction_[r];
    backward(image_);
    for (std::size_t r = 0; r < n; ++r) carried_[r] = direction_[r] + (diagonal_[r] - 2.0 * pivot_[r]) * image_[r];
    forward(carried_);
    double curvature = 0.0;
    for (std::size_t r = 0; r < n; ++r) curvature += direction_[r] * (carried_[r] += image_[r]);
    const double step = now / curvature;
    for (std::size_t r = 0; r < n; ++r) {
      solution_[r] += step * image_[r];
      residual_[r] -= step * carried_[r];
    }
    const double taken = step * now;
    energy += taken;
    if (taken + taken_before <= tolerance * tolerance * energy) break;
    taken_before = taken;
  }
  for (std::size_t i = 0; i < n; ++i) x[i] = solution_[to_size(place_[i])];
  return iteration;
}

}  // namespace puadem
