#include "puadem/dem/tensor.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace puadem {

Tensor deviator(const Tensor& t) {
  Tensor s;
  for (unsigned a = 0; a < 3; ++a)
    for (unsigned b = 0; b < 3; ++b) s[a][static_cast<int>(b)] = 0.5 * (t[a][static_cast<int>(b)] + t[b][static_cast<int>(a)]);
  const double third = trace(t) / 3.0;
  for (unsigned a = 0; a < 3; ++a) s[a][static_cast<int>(a)] -= third;
  return s;
}

double deviatoric_invariant(const Tensor& t) {
  double squares = 0.0;
  for (const Vec3& row : deviator(t)) squares += squared_norm(row);
  return std::sqrt(1.5 * squares);
}

// Jacobi's rotations: each sets one pair of elements off the diagonal to zero; three sweeps or four suffice.
Vec3 principal_values(const Tensor& t) {
  Tensor s = deviator(t);
  const double third = trace(t) / 3.0, size = deviatoric_invariant(t);
  const auto at = [&s](unsigned a, unsigned b) -> double& { return s[a][static_cast<int>(b)]; };
  const auto off_diagonal = [&] { return std::abs(at(0, 1)) + std::abs(at(0, 2)) + std::abs(at(1, 2)); };
  for (int sweep = 0; sweep < 20 && off_diagonal() > 1e-16 * size; ++sweep)
    for (const auto& [p, q] : {std::pair{0U, 1U}, std::pair{0U, 2U}, std::pair{1U, 2U}}) {
      if (at(p, q) == 0.0) continue;
      const double slope = (at(q, q) - at(p, p)) / (2.0 * at(p, q));
      const double tangent = (slope >= 0.0 ? 1.0 : -1.0) / (std::abs(slope) + std::sqrt(1.0 + slope * slope));
      const double cosine = 1.0 / std::sqrt(1.0 + tangent * tangent), sine = tangent * cosine;
      const unsigned r = 3 - p - q;
      const double pq = at(p, q), pr = at(p, r), qr = at(q, r);
      at(p, p) -= tangent * pq;
      at(q, q) += tangent * pq;
      at(p, q) = at(q, p) = 0.0;
      at(p, r) = at(r, p) = cosine * pr - sine * qr;
      at(q, r) = at(r, q) = sine * pr + cosine * qr;
    }
  std::array<double, 3> values{at(0, 0) + third, at(1, 1) + third, at(2, 2) + third};
  std::sort(values.begin(), values.end(), std::greater<>());
  return {values[0], values[1], values[2]};
}

}  // namespace puadem
