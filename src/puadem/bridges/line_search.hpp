#pragma once

#include <cmath>
#include <utility>

#include "puadem/base/error.hpp"

namespace puadem {

/// Root of a continuous `f` between `a` and `b`, where it has opposite signs, to `tolerance` of the greater of both.
/// Inverse quadratic interpolation where it is safe, bisection elsewhere (Chandrupatla 1997, Adv. Eng. Softw. 28, 145).
template <class Function>
double find_root(const Function& f, double a, double fa, double b, double fb, double tolerance) {
  double c = a, fc = fa, share = 0.5;
  for (int evaluations = 0; evaluations < 200; ++evaluations) {
    const double x = a + share * (b - a), fx = f(x);
    if ((fx > 0.0) == (fa > 0.0)) {
      c = a, fc = fa;
    } else {
      c = b, fc = fb;
      b = a, fb = fa;
    }
    a = x, fa = fx;
    const double best = std::abs(fa) < std::abs(fb) ? a : b;
    const double least = tolerance * std::fmax(std::abs(a), std::abs(b)) / std::abs(b - a);
    if (fa == 0.0 || fb == 0.0 || least >= 0.5) return best;
    const double xi = (a - b) / (c - b), phi = (fa - fb) / (fc - fb);
    share = 0.5;
    if (phi * phi < xi && (1.0 - phi) * (1.0 - phi) < 1.0 - xi)
      share = fa / (fb - fa) * fc / (fb - fc) + (c - a) / (b - a) * fa / (fc - fa) * fb / (fc - fb);
    share = std::fmin(std::fmax(share, least), 1.0 - least);
  }
  throw NumericalError("liquid bridge: the search for a root does not end");
}

/// Place of the maximum of an `f` with a single one between `a` and `b`, to about `tolerance` absolute.
/// Golden section with parabolas (Brent 1973, Algorithms for Minimization without Derivatives, chapter 5).
template <class Function>
double find_maximum(const Function& f, double a, double b, double tolerance) {
  const double golden = 0.5 * (3.0 - std::sqrt(5.0));
  double x = a + golden * (b - a), w = x, v = x, fx = f(x), fw = fx, fv = fx, step = 0.0, before = 0.0;
  for (int evaluations = 0; evaluations < 200; ++evaluations) {
    const double middle = 0.5 * (a + b);
    if (std::abs(x - middle) + 0.5 * (b - a) <= 2.0 * tolerance) return x;
    double p = (x - v) * (x - v) * (fx - fw) - (x - w) * (x - w) * (fx - fv);
    double q = 2.0 * ((x - v) * (fx - fw) - (x - w) * (fx - fv));
    if (q > 0.0) p = -p;
    q = std::abs(q);
    const bool is_safe =
        std::abs(before) > tolerance && std::abs(p) < std::abs(0.5 * q * before) && p > q * (a - x) && p < q * (b - x);
    before = is_safe ? step : (x < middle ? b : a) - x;
    step = is_safe ? p / q : golden * before;
    if (is_safe && (x + step - a < 2.0 * tolerance || b - x - step < 2.0 * tolerance))
      step = std::copysign(tolerance, middle - x);
    const double u = x + (std::abs(step) >= tolerance ? step : std::copysign(tolerance, step)), fu = f(u);
    if (fu >= fx) {
      (u < x ? b : a) = x;
      v = std::exchange(w, std::exchange(x, u));
      fv = std::exchange(fw, std::exchange(fx, fu));
    } else {
      (u < x ? a : b) = u;
      if (fu >= fw || w == x) {
        v = std::exchange(w, u), fv = std::exchange(fw, fu);
      } else if (fu >= fv || v == x || v == w) {
        v = u, fv = fu;
      }
    }
  }
  throw NumericalError("liquid bridge: the search for a maximum does not end");
}

}  // namespace puadem
