#include "puadem/bridges/bridge_formulas.hpp"

#include <algorithm>
#include <cmath>

namespace puadem {

namespace {

double reduced(const std::array<double, 2>& radius) { return 2.0 * radius[0] * radius[1] / (radius[0] + radius[1]); }

/// a + b t + c t^2.
struct Quadratic {
  double a, b, c;
  double at(double t) const { return a + (b + c * t) * t; }
};

/// Coefficients of f_1 to f_4: a power of ln V* each, a quadratic in the contact angle.
constexpr std::array<std::array<Quadratic, 4>, 4> willett{
    {{{{-0.44507, 0.050832, -1.1466},
       {-0.1119, -0.000411, -0.1490},
       {-0.012101, -0.0036456, -0.01255},
       {-0.0005, -0.0003505, -0.00029076}}},
     {{{1.9222, -0.57473, -1.2918}, {-0.0668, -0.1201, -0.22574}, {-0.0013375, -0.0068988, -0.01137}, {0.0, 0.0, 0.0}}},
     {{{1.268, -0.01396, -0.23566}, {0.198, 0.092, -0.06418}, {0.02232, 0.02238, -0.009853}, {0.0008585, 0.001318, -0.00053}}},
     {{{-0.010703, 0.073776, -0.34742}, {0.03345, 0.04543, -0.09056}, {0.0018574, 0.004456, -0.006257}, {0.0, 0.0, 0.0}}}}};

}  // namespace

double willett_pull(const std::array<double, 2>& radius, double contact_angle, double volume, double gap) {
  const double length = reduced(radius), log_volume = std::log(volume / (length * length * length));
  std::array<double, 4> f{};
  for (std::size_t i = 0; i < f.size(); ++i)
    for (std::size_t power = 4; power-- > 0;) f[i] = f[i] * log_volume + willett[i][power].at(contact_angle);
  if (gap <= 0.0) return length * std::exp(f[0]);
  const double log_gap = std::log(0.5 * gap / std::sqrt(volume / length));
  return length * std::exp(f[0] - f[1] * std::exp(f[2] * log_gap + f[3] * log_gap * log_gap));
}

double willett_reach(const std::array<double, 2>& radius, double contact_angle, double volume) {
  const double length = reduced(radius), ratio = std::min(radius[0], radius[1]) / std::max(radius[0], radius[1]);
  const double edge = std::cbrt(volume) / length;
  return length * (1.0 + 0.25 * contact_angle * (1.0 + ratio)) * edge * (1.0 + (0.5 * ratio - 0.4) * edge);
}

double soulie_pull(const std::array<double, 2>& radius, double contact_angle, double volume, double gap) {
  const double larger = std::max(radius[0], radius[1]), scaled = volume / (larger * larger * larger),
               log_volume = std::log(scaled);
  const double a = -1.1 * std::pow(scaled, -0.53), c = 0.0018 * log_volume + 0.078;
  const double b = (-0.148 * log_volume - 0.96) * contact_angle * contact_angle - 0.0082 * log_volume + 0.48;
  return 0.5 * std::sqrt(radius[0] * radius[1]) * (c + std::exp(a * std::max(gap, 0.0) / larger + b));
}

double lian_reach(double contact_angle, double volume) { return (1.0 + 0.5 * contact_angle) * std::cbrt(volume); }

}  // namespace puadem
