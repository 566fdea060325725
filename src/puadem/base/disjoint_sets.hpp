#pragma once

#include <numeric>
#include <vector>

#include "puadem/base/parallel.hpp"

namespace puadem {

/// Union-find. The root of a set is always its smallest member, so that labels do not depend on the
/// order in which sets were joined.
class DisjointSets {
 public:
  explicit DisjointSets(int count) : parent_(to_size(count)) { std::iota(parent_.begin(), parent_.end(), 0); }

  int find(int i) {
    while (parent_[to_size(i)] != i) i = parent_[to_size(i)] = parent_[to_size(parent_[to_size(i)])];
    return i;
  }

  /// Joins the sets of a and b; false if they were one already.
  bool join(int a, int b) {
    a = find(a);
    b = find(b);
    if (a == b) return false;
    if (b < a) std::swap(a, b);
    parent_[to_size(b)] = a;
    return true;
  }

 private:
  std::vector<int> parent_;
};

}  // namespace puadem
