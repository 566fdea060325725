#include "puadem/flow/network_matrix.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace puadem {

NetworkMatrix::NetworkMatrix(int rows, std::span<const std::array<int, 2>> links) {
  std::vector<int> count(to_size(rows) + 1, 0);
  for (const auto& [i, j] : links) {
    assert(i != j);
    ++count[to_size(i) + 1];
    ++count[to_size(j) + 1];
  }
  for (int r = 0; r < rows; ++r) count[to_size(r) + 1] += count[to_size(r)];
  std::vector<int> neighbour(to_size(count.back()));
  std::vector<int> next(count.begin(), count.end() - 1);
  for (const auto& [i, j] : links) {
    neighbour[to_size(next[to_size(i)]++)] = j;
    neighbour[to_size(next[to_size(j)]++)] = i;
  }
  pattern.start.reserve(to_size(rows) + 1);
  pattern.index.reserve(neighbour.size() + to_size(rows));
  diagonal_entry.reserve(to_size(rows));
  for (int r = 0; r < rows; ++r) {
    const auto begin = neighbour.begin() + count[to_size(r)], end = neighbour.begin() + count[to_size(r) + 1];
    std::sort(begin, end);
    const auto last = std::unique(begin, end);
    const auto middle = std::lower_bound(begin, last, r);
    pattern.index.insert(pattern.index.end(), begin, middle);
    diagonal_entry.push_back(size_of(pattern.index));
    pattern.index.push_back(r);
    pattern.index.insert(pattern.index.end(), middle, last);
    pattern.start.push_back(size_of(pattern.index));
  }
  value.resize(pattern.index.size());
  link_entry.reserve(links.size());
  const auto entry = [&](int row, int column) {
    const auto columns = pattern[row];
    return pattern.start[to_size(row)] + static_cast<int>(std::ranges::lower_bound(columns, column) - columns.begin());
  };
  for (const auto& [i, j] : links) link_entry.push_back({entry(i, j), entry(j, i)});
}

void NetworkMatrix::set(std::span<const double> conductance, std::span<const double> diagonal) {
  std::ranges::fill(value, 0.0);
  for (std::size_t k = 0; k < link_entry.size(); ++k) {
    value[to_size(link_entry[k][0])] -= conductance[k];
    value[to_size(link_entry[k][1])] -= conductance[k];
  }
  for (int r = 0; r < rows(); ++r) {
    double sum = diagonal[to_size(r)];
    for (int e = pattern.start[to_size(r)]; e < pattern.start[to_size(r) + 1]; ++e) sum -= value[to_size(e)];
    value[to_size(diagonal_entry[to_size(r)])] = sum;
  }
}

double NetworkMatrix::row_times(int r, std::span<const double> x) const {
  double sum = 0.0;
  for (int e = pattern.start[to_size(r)]; e < pattern.start[to_size(r) + 1]; ++e)
    sum += value[to_size(e)] * x[to_size(pattern.index[to_size(e)])];
  return sum;
}
double NetworkMatrix::row_magnitude(int r, std::span<const double> x) const {
  double sum = 0.0;
  for (int e = pattern.start[to_size(r)]; e < pattern.start[to_size(r) + 1]; ++e)
    sum += std::abs(value[to_size(e)] * x[to_size(pattern.index[to_size(e)])]);
  return sum;
}

}  // namespace puadem
