#pragma once

#include <memory>
#include <span>
#include <string>

#include "puadem/flow/network_matrix.hpp"

namespace puadem {

/// Cholesky factor of a matrix whose pattern stands: the order of elimination is found once.
class CholeskyFactor {
 public:
  explicit CholeskyFactor(const NetworkMatrix& matrix);
  ~CholeskyFactor();

  /// @throws NumericalError  where the matrix is not positive definite, or memory does not suffice
  void factorise(const NetworkMatrix& matrix);
  void solve(std::span<const double> b, std::span<double> x);
  double bytes() const;  ///< of the factor [B]

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// Version of CHOLMOD in use.
std::string cholesky_version();

}  // namespace puadem
