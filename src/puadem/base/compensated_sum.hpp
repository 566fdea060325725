#pragma once

#include <cmath>
#include <span>

namespace puadem {

/// A sum that keeps what rounding drops (Neumaier 1974, ZAMM 54, 39).
struct CompensatedSum {
  double sum = 0.0, rest = 0.0;

  void add(double term) {
    const double next = sum + term;
    rest += std::abs(sum) >= std::abs(term) ? (sum - next) + term : (term - next) + sum;
    sum = next;
  }
  double value() const { return sum + rest; }
};

inline double compensated_sum(std::span<const double> values) {
  CompensatedSum sum;
  for (const double v : values) sum.add(v);
  return sum.value();
}

}  // namespace puadem
