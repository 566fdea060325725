#include "puadem/network/pore_network.hpp"

namespace puadem {

Csr throats_of_pores(std::span<const std::array<int, 2>> throat_pores, int pores) {
  Csr csr;
  csr.start.assign(to_size(pores) + 1, 0);
  for (const auto& [i, j] : throat_pores) {
    ++csr.start[to_size(i) + 1];
    if (j != i) ++csr.start[to_size(j) + 1];
  }
  for (int p = 0; p < pores; ++p) csr.start[to_size(p) + 1] += csr.start[to_size(p)];
  csr.index.resize(to_size(csr.start.back()));
  std::vector<int> next(csr.start.begin(), csr.start.end() - 1);
  for (int t = 0; t < size_of(throat_pores); ++t) {
    const auto [i, j] = throat_pores[to_size(t)];
    csr.index[to_size(next[to_size(i)]++)] = t;
    if (j != i) csr.index[to_size(next[to_size(j)]++)] = t;
  }
  return csr;
}

}  // namespace puadem
