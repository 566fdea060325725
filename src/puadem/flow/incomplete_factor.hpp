#pragma once

#include <span>
#include <vector>

#include "puadem/flow/network_matrix.hpp"

namespace puadem {

/// Conjugate gradients for a matrix whose numbers change with each solve, preconditioned by (D + L) D^-1 (D + L^T) with L the
/// lower triangle of the matrix: an incomplete factor of which only the diagonal D is new (theory 6.3). Setting up costs one
/// pass over the matrix, and so does an iteration (Eisenstat 1981). Serial: the same bits on any number of threads.
class IncompleteFactor {
 public:
  explicit IncompleteFactor(const NetworkMatrix& matrix);

  /// Takes the numbers of a matrix with the pattern of the constructor's.
  void set_up(const NetworkMatrix& matrix);

  /// x = A^-1 b, from the x given. Ends when two steps took no more than `tolerance` of the solution, in the norm of A.
  /// @return iterations; `limit` where they were not enough
  int solve(std::span<const double> b, std::span<double> x, double tolerance, int limit);

 private:
  struct Entry {
    int column;
    double value;
  };
  void forward(std::span<double> x) const;   ///< x = (D + L)^-1 x
  void backward(std::span<double> x) const;  ///< x = (D + L^T)^-1 x

  std::vector<int> place_;        ///< per unknown: its row here; neighbours in the network are near
  std::vector<int> start_;        ///< of each row
  std::vector<Entry> lower_;      ///< left of the diagonal
  std::vector<int> source_;       ///< per entry of `lower_`: its place in the matrix
  std::vector<int> diagonal_at_;  ///< per row: the same of its diagonal
  std::vector<double> diagonal_, pivot_, inverse_;
  std::vector<double> residual_, direction_, solution_, image_, carried_;
};

}  // namespace puadem
