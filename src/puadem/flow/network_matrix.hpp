#pragma once

#include <array>
#include <span>
#include <vector>

#include "puadem/base/csr.hpp"

namespace puadem {

/// Symmetric matrix of a network, d_i on the diagonal and, for every link {i, j} of conductance g,
/// g (e_i - e_j)(e_i - e_j)^T. All entries are kept, rows ascending in columns.
struct NetworkMatrix {
  Csr pattern;                                 ///< columns of each row
  std::vector<double> value;                   ///< of each entry
  std::vector<int> diagonal_entry;             ///< of each row
  std::vector<std::array<int, 2>> link_entry;  ///< entries (i, j) and (j, i) of each link

  NetworkMatrix(int rows, std::span<const std::array<int, 2>> links);

  int rows() const { return pattern.rows(); }
  int entries() const { return size_of(value); }

  /// @param conductance  g per link; @param diagonal  d per row
  void set(std::span<const double> conductance, std::span<const double> diagonal);

  /// Row r times x, and the sum of the magnitudes of its terms: what rounding works on.
  double row_times(int r, std::span<const double> x) const;
  double row_magnitude(int r, std::span<const double> x) const;
};

}  // namespace puadem
