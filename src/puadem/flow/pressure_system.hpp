#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace puadem {

/// How pressure systems are solved.
struct PressureSolverOptions {
  enum class Method : std::uint8_t {
    automatic,   ///< cholesky up to `cholesky_limit` unknowns, multigrid above
    cholesky,    ///< factorised once (CHOLMOD), each further right-hand side is cheap
    multigrid,   ///< conjugate gradients preconditioned by algebraic multigrid (hypre's BoomerAMG)
    incomplete,  ///< the same by an incomplete factor, for numbers that change with each solve; the full one where it is slow
  };
  Method method = Method::automatic;
  int cholesky_limit = 30000;
  /// Of the error of the pressures, in the norm of the power they dissipate, as a share of it [-]. It does not
  /// depend on units, on how the flow is driven, or on how much better a few throats conduct than the rest.
  double tolerance = 1e-10;
  int iteration_limit = 200;  ///< of conjugate gradients
};

/// What a solve took.
struct PressureSolveReport {
  double residual = 0.0;  ///< |b - A p| / |b| [-]
  int iterations = 0;     ///< of conjugate gradients; 0 with a factor
};

/// Symmetric positive definite system of a network,
///     d_i p_i + sum_k g_k (p_i - p_j) = b_i,
/// over its links k = {i, j}; a prescribed pressure beside i counts in d_i and b_i. The pattern stands for
/// the life of the object: the order of elimination is found once.
/// The same bits on any number of threads.
class PressureSystem {
 public:
  /// @param links  pairs of different unknowns, parallel ones allowed
  PressureSystem(int unknowns, std::span<const std::array<int, 2>> links, const PressureSolverOptions& options);
  ~PressureSystem();
  PressureSystem(PressureSystem&&) noexcept;
  PressureSystem& operator=(PressureSystem&&) noexcept;

  /// Numbers of the system; factorises it, or sets multigrid up.
  /// @param conductance  g_k >= 0 per link
  /// @param diagonal     d_i >= 0 per unknown; in every connected part one of them is positive
  /// @throws NumericalError  where the matrix is not positive definite
  void set(std::span<const double> conductance, std::span<const double> diagonal);

  /// Solves for one right-hand side.
  /// @param pressure   in: where iterations start, such as the last solution; out: the solution
  /// @param tolerance  instead of that of the options, where less will do
  /// @throws NumericalError  where the residual stays above the tolerance and above what rounding leaves
  PressureSolveReport solve(std::span<const double> right_hand_side, std::span<double> pressure, double tolerance = 0.0);

  /// With `incomplete`: what follows does not hang on earlier solves. Else, once the full factor was needed, later solves
  /// begin with it as it was.
  void forget();

  int unknowns() const;
  bool is_factorised() const;  ///< solved by Cholesky factors
  double bytes() const;        ///< memory of matrix and factor; 0 for what multigrid keeps to itself [B]

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace puadem
