#pragma once

#include <memory>
#include <span>
#include <string>

#include "puadem/flow/network_matrix.hpp"

namespace puadem {

/// One cycle of algebraic multigrid: an approximate inverse, symmetric and positive definite.
class Multigrid {
 public:
  explicit Multigrid(const NetworkMatrix& matrix);
  ~Multigrid();

  /// @throws NumericalError  where no hierarchy can be made
  void set_up(const NetworkMatrix& matrix);
  void apply(std::span<const double> b, std::span<double> x);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// Version of hypre in use.
std::string multigrid_version();

}  // namespace puadem
