#include "puadem/flow/pressure_system.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <optional>

#include "puadem/base/error.hpp"
#include "puadem/flow/cholesky_factor.hpp"
#include "puadem/flow/incomplete_factor.hpp"
#include "puadem/flow/multigrid.hpp"
#include "puadem/flow/network_matrix.hpp"

namespace puadem {

namespace {

double inner(std::span<const double> a, std::span<const double> b) {
  return parallel_sum<double>(size_of(a), [&](int i) { return a[to_size(i)] * b[to_size(i)]; });
}

/// More iterations with an incomplete factor than this cost more than the full one.
constexpr int iterations_worth_while = 200;
/// More iterations with the full factor of earlier numbers than this cost more than one of the present ones.
constexpr int iterations_by_old_factor = 20;

bool chooses_cholesky(const PressureSolverOptions& options, int unknowns) {
  using enum PressureSolverOptions::Method;
  return options.method == cholesky || (options.method == automatic && unknowns <= options.cholesky_limit);
}

}  // namespace

struct PressureSystem::Parts {
  PressureSolverOptions options;
  NetworkMatrix matrix;
  std::optional<CholeskyFactor> factor;
  std::optional<Multigrid> multigrid;
  std::optional<IncompleteFactor> incomplete;
  bool factor_is_old = false;  ///< with an incomplete factor: the full one is of other numbers
  bool factor_serves = false;  ///< it was made since the last `forget`: solves begin with it
  std::vector<double> residual, correction, direction, product;

  Parts(int unknowns, std::span<const std::array<int, 2>> links, const PressureSolverOptions& o)
      : options(o), matrix(unknowns, links), residual(to_size(unknowns)), correction(to_size(unknowns)) {
    if (unknowns == 0) return;
    if (o.method == PressureSolverOptions::Method::incomplete) {
      incomplete.emplace(matrix);
    } else if (chooses_cholesky(o, unknowns)) {
      factor.emplace(matrix);
      return;
    } else {
      multigrid.emplace(matrix);
    }
    direction.resize(to_size(unknowns));
    product.resize(to_size(unknowns));
  }

  /// residual = b - A p; returns its norm.
  double find_residual(std::span<const double> b, std::span<const double> p) {
    parallel_for(matrix.rows(), [&](int r) { residual[to_size(r)] = b[to_size(r)] - matrix.row_times(r, p); });
    return std::sqrt(inner(residual, residual));
  }

  /// Norm of a residual that the rounding of the pressures alone can leave.
  double rounding(std::span<const double> b, std::span<const double> p) const {
    const double squares = parallel_sum<double>(matrix.rows(), [&](int r) {
      const double terms = matrix.row_magnitude(r, p) + std::abs(b[to_size(r)]);
      return terms * terms;
    });
    return 4.0 * std::numeric_limits<double>::epsilon() * std::sqrt(squares);
  }

  void factorise_if_old() {
    if (!factor_is_old) return;
    if (!factor) factor.emplace(matrix);
    factor->factorise(matrix);
    factor_is_old = false;
    factor_serves = true;
  }

  /// Norm of the residual of a solution.
  double allowed(std::span<const double> b, std::span<const double> p) const {
    return std::max(options.tolerance * std::sqrt(inner(b, b)), rounding(b, p));
  }

  /// p = A^-1 b by the factor, corrected while rounding in the factor leaves more than rounding of the pressures does.
  void solve_by_factor(std::span<const double> b, std::span<double> p) {
    factor->solve(b, p);
    double norm = find_residual(b, p);
    for (double last = std::numeric_limits<double>::infinity(); norm < 0.5 * last && norm > rounding(b, p);) {
      last = norm;
      factor->solve(residual, correction);
      parallel_for(matrix.rows(), [&](int i) { p[to_size(i)] += correction[to_size(i)]; });
      norm = find_residual(b, p);
    }
  }

  void precondition(std::span<const double> r, std::span<double> z) {
    if (multigrid)
      multigrid->apply(r, z);
    else
      factor->solve(r, z);
  }

  /// p = A^-1 b by iterations that start from p; returns their number, or the limit.
  int iterate(std::span<const double> b, std::span<double> p, double tolerance, int most) {
    int iterations = 0;
    double norm = find_residual(b, p);
    // Ends where the residual made anew needs no iteration, or is as large as rounding makes it again and again.
    for (double last = std::numeric_limits<double>::infinity(); norm < 0.5 * last && norm > 0.0;) {
      last = norm;
      const int more = conjugate_gradients(b, inner(b, p), tolerance, most - iterations);
      parallel_for(matrix.rows(), [&](int i) { p[to_size(i)] += correction[to_size(i)]; });
      if (more == 0) break;
      iterations += more;
      norm = find_residual(b, p);
    }
    return iterations;
  }

  /// correction = A^-1 residual, to the tolerance; uses the residual up. A step of conjugate gradients takes
  /// step * (residual * M^-1 residual) from the square of the error in the norm of A, whose scale is p * b, the square of
  /// the solution itself (Hestenes and Stiefel 1952); it ends when the last two steps took next to nothing.
  /// @param start  p * b before the correction
  /// @return the iterations that were needed; 0 if the first step already takes next to nothing
  int conjugate_gradients(std::span<const double> b, double start, double tolerance, int limit) {
    std::ranges::fill(correction, 0.0);
    const int n = matrix.rows();
    double before = 1.0, taken_before = 0.0;
    for (int iteration = 0; iteration < limit; ++iteration) {
      precondition(residual, product);
      const double now = inner(residual, product);
      const double share = iteration == 0 ? 0.0 : now / before;
      before = now;
      parallel_for(n, [&](int i) { direction[to_size(i)] = product[to_size(i)] + share * direction[to_size(i)]; });
      parallel_for(n, [&](int r) { product[to_size(r)] = matrix.row_times(r, direction); });
      const double step = now / inner(direction, product);
      parallel_for(n, [&](int i) {
        correction[to_size(i)] += step * direction[to_size(i)];
        residual[to_size(i)] -= step * product[to_size(i)];
      });
      const double taken = step * now, scale = start + inner(b, correction);
      if (taken + taken_before <= tolerance * tolerance * scale) return iteration;
      taken_before = taken;
    }
    return limit;
  }
};

PressureSystem::PressureSystem(int unknowns, std::span<const std::array<int, 2>> links, const PressureSolverOptions& options)
    : parts_(std::make_unique<Parts>(unknowns, links, options)) {}
PressureSystem::~PressureSystem() = default;
PressureSystem::PressureSystem(PressureSystem&&) noexcept = default;
PressureSystem& PressureSystem::operator=(PressureSystem&&) noexcept = default;

void PressureSystem::set(std::span<const double> conductance, std::span<const double> diagonal) {
  parts_->matrix.set(conductance, diagonal);
  if (parts_->incomplete) {
    parts_->incomplete->set_up(parts_->matrix);
    parts_->factor_is_old = true;
    return;
  }
  if (parts_->factor) parts_->factor->factorise(parts_->matrix);
  if (parts_->multigrid) parts_->multigrid->set_up(parts_->matrix);
}

PressureSolveReport PressureSystem::solve(std::span<const double> right_hand_side, std::span<double> pressure, double tolerance) {
  Parts& s = *parts_;
  assert(size_of(right_hand_side) == s.matrix.rows() && pressure.size() == right_hand_side.size());
  PressureSolveReport report;
  const double scale = std::sqrt(inner(right_hand_side, right_hand_side));
  if (scale == 0.0) {
    std::ranges::fill(pressure, 0.0);
    return report;
  }
  if (s.incomplete) {
    const double asked = tolerance > 0.0 ? tolerance : s.options.tolerance;
    const int limit = s.factor_serves ? iterations_by_old_factor : iterations_worth_while;
    report.iterations = s.factor_serves ? s.iterate(right_hand_side, pressure, asked, limit)
                                        : s.incomplete->solve(right_hand_side, pressure, asked, limit);
    // Less than the usual tolerance was asked for, or the usual one is kept by the equations, too.
    if (report.iterations < limit) {
      if (asked > s.options.tolerance) return report;
      const double norm = s.find_residual(right_hand_side, pressure);
      report.residual = norm / scale;
      if (norm <= s.allowed(right_hand_side, pressure)) return report;
    }
    s.factorise_if_old();
  }
  if (s.factor)
    s.solve_by_factor(right_hand_side, pressure);
  else
    report.iterations = s.iterate(right_hand_side, pressure, s.options.tolerance, s.options.iteration_limit);
  const double norm = s.find_residual(right_hand_side, pressure);
  report.residual = norm / scale;
  ensure(s.factor ? norm <= s.allowed(right_hand_side, pressure)
                  : std::isfinite(norm) && report.iterations < s.options.iteration_limit,
         "the pressures of {} pores could not be found: residual {:.2e} of the right-hand side after {} iterations, tolerance "
         "{:.0e}",
         s.matrix.rows(), report.residual, report.iterations, s.options.tolerance);
  return report;
}

void PressureSystem::forget() { parts_->factor_serves = false; }

int PressureSystem::unknowns() const { return parts_->matrix.rows(); }
bool PressureSystem::is_factorised() const { return parts_->factor.has_value(); }
double PressureSystem::bytes() const {
  const double matrix = 12.0 * parts_->matrix.entries() + 8.0 * size_of(parts_->matrix.link_entry);
  return matrix + (parts_->factor ? parts_->factor->bytes() : 0.0);
}

}  // namespace puadem
