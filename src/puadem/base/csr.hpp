#pragma once

#include <span>
#include <vector>

#include "puadem/base/parallel.hpp"

namespace puadem {

/// Compressed rows of indices: row r is `index[start[r] .. start[r + 1])`.
struct Csr {
  std::vector<int> start{0};
  std::vector<int> index;

  int rows() const { return static_cast<int>(start.size()) - 1; }
  std::span<const int> operator[](int row) const {
    return std::span(index).subspan(to_size(start[to_size(row)]), to_size(start[to_size(row) + 1] - start[to_size(row)]));
  }
  bool operator==(const Csr&) const = default;
};

/// Rows from the row of each entry: row r lists, ascending, every entry e with `row_of[e] == r`.
/// Entries with a negative row are left out.
inline Csr rows_from(std::span<const int> row_of, int rows) {
  Csr csr;
  csr.start.assign(to_size(rows) + 1, 0);
  for (const int row : row_of)
    if (row >= 0) ++csr.start[to_size(row) + 1];
  for (int r = 0; r < rows; ++r) csr.start[to_size(r) + 1] += csr.start[to_size(r)];
  csr.index.resize(to_size(csr.start.back()));
  std::vector<int> next(csr.start.begin(), csr.start.end() - 1);
  for (int e = 0; e < static_cast<int>(row_of.size()); ++e)
    if (row_of[to_size(e)] >= 0) csr.index[to_size(next[to_size(row_of[to_size(e)])]++)] = e;
  return csr;
}

}  // namespace puadem
