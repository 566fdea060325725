#include "puadem/bridges/bridge_shape.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace puadem {

namespace {

using std::numbers::pi;

constexpr int points = 12;          // of Gauss and Legendre on each side: 1e-13 of gap and volume
constexpr double rounding = 1e-13;  // of the square root in which both circles are one

struct GaussLegendre {
  std::array<double, points> place, weight;  // on (0, 1)
};

/// Nodes by Newton's method on the Legendre polynomial.
GaussLegendre gauss_legendre() {
  GaussLegendre rule{};
  for (int i = 0; i < points; ++i) {
    double x = std::cos(pi * (i + 0.75) / (points + 0.5)), slope = 1.0;
    for (int iteration = 0; iteration < 8; ++iteration) {
      double before = 1.0, value = x;
      for (int k = 2; k <= points; ++k) {
        const double next = ((2 * k - 1) * x * value - (k - 1) * before) / k;
        before = value;
        value = next;
      }
      slope = points * (x * value - before) / (x * x - 1.0);
      x -= value / slope;
    }
    const auto at = static_cast<std::size_t>(i);
    rule.place[at] = 0.5 * (1.0 - x);
    rule.weight[at] = 1.0 / ((1.0 - x * x) * slope * slope);
  }
  return rule;
}

/// The meridian y^2 = y_0^2 + 4 C (sin(p s / 2) / p)^2 around its neck.
struct Meridian {
  double suction, pull, opening, neck;  // p, f, C = sqrt(1 + 2 p f), y_0

  double half_chord(double s) const { return suction == 0.0 ? 0.5 * s : std::sin(0.5 * suction * s) / suction; }
};

struct ContactLine {
  double radius, sine, cosine;  // of the filling angle
};

/// The circle on which a meniscus of this suction and pull meets the end at its contact angle.
std::optional<ContactLine> contact_line(const BridgeEnd& end, double suction, double pull, bool is_wide) {
  const double curvature = 1.0 / end.radius, sine = std::sin(end.contact_angle);
  const double plus = curvature * std::cos(end.contact_angle), minus = curvature * curvature * pull;
  const double square = sine * sine + 4.0 * pull * (plus + 0.5 * suction - minus);
  const double scale = sine * sine + 4.0 * pull * (plus + 0.5 * std::abs(suction) + minus);
  if (!(square >= -rounding * scale)) return std::nullopt;
  const double root = std::sqrt(std::max(square, 0.0));
  const double across = is_wide ? sine - root : sine + root, along = 2.0 * pull * curvature;
  const double length = std::hypot(along, across);
  if (curvature == 0.0 && across <= 0.0) return std::nullopt;
  return ContactLine{2.0 * pull / length, along / length, across / length};
}

/// Integrals along the meridian from the neck to the contact line. The substitution s = y_0 / sqrt(C) sinh(t) moves the
/// branch points, where y = 0, away from the real axis however thin the neck is.
std::optional<BridgeSide> bridge_side(const BridgeEnd& end, const Meridian& m, bool is_wide) {
  static const GaussLegendre rule = gauss_legendre();
  const auto line = contact_line(end, m.suction, m.pull, is_wide);
  if (!line) return std::nullopt;
  const double curvature = 1.0 / end.radius, y = line->radius;
  const double slope = line->cosine * std::cos(end.contact_angle) - line->sine * std::sin(end.contact_angle);
  const double along = line->sine * std::cos(end.contact_angle) + line->cosine * std::sin(end.contact_angle);
  const double rise = y * slope, phase = 1.0 + m.suction * y * along;
  BridgeSide side;
  side.arc = m.suction == 0.0 ? rise : std::atan2(m.suction * rise, phase) / m.suction;
  side.contact_radius = y;
  side.filling_angle = std::atan2(line->sine, line->cosine);

  const double width = m.neck / std::sqrt(m.opening), end_t = std::asinh(side.arc / width);
  for (std::size_t i = 0; i < points; ++i) {
    const double grown = std::exp(end_t * rule.place[i]);
    const double chord = m.half_chord(0.5 * width * (grown - 1.0 / grown));
    const double ds = rule.weight[i] * end_t * 0.5 * width * (grown + 1.0 / grown);
    const double growth = 4.0 * m.opening * chord * chord, radius = std::sqrt(m.neck * m.neck + growth);
    const double across = m.neck - 0.5 * m.suction * growth;  // y dz/ds
    side.reach += ds * across / radius;
    side.volume += ds * pi * across * radius;
    side.meniscus_area += ds * 2.0 * pi * radius;
  }
  const double over = 1.0 / (1.0 + line->cosine), height = curvature * y * y * over;  // of the wetted cap
  side.reach -= height;
  side.volume -= pi * (curvature * y * y * y * y * over * over - height * height * height / 3.0);
  side.wetted_area = 2.0 * pi * y * y * over;
  return side;
}

}  // namespace

std::optional<BridgeShape> bridge_shape(const std::array<BridgeEnd, 2>& ends, double suction, double pull,
                                        std::optional<int> wide_end) {
  assert(pull > 0.0);
  const double square = 1.0 + 2.0 * suction * pull;
  if (!(square > 0.0)) return std::nullopt;  // no neck: the cylinder and beyond
  const double opening = std::sqrt(square);
  const Meridian meridian{suction, pull, opening, 2.0 * pull / (1.0 + opening)};
  const auto first = bridge_side(ends[0], meridian, wide_end == 0);
  if (!first) return std::nullopt;
  const bool is_symmetric = !wide_end && ends[0].radius == ends[1].radius && ends[0].contact_angle == ends[1].contact_angle;
  const auto second = is_symmetric ? first : bridge_side(ends[1], meridian, wide_end == 1);
  if (!second || first->arc + second->arc <= 0.0) return std::nullopt;
  return BridgeShape{.suction = suction,
                     .pull = pull,
                     .gap = first->reach + second->reach,
                     .volume = first->volume + second->volume,
                     .neck_radius = meridian.neck,
                     .sides = {*first, *second}};
}

double greatest_pull(const BridgeEnd& end, double suction) {
  const double curvature = 1.0 / end.radius, sine = std::sin(end.contact_angle);
  const double linear = curvature * std::cos(end.contact_angle) + 0.5 * suction;
  const double length = std::hypot(linear, curvature * sine);
  if (linear <= 0.0) return 0.5 * sine * sine / (length - linear);
  return 0.5 * (linear + length) / (curvature * curvature);
}

double least_suction(const BridgeEnd& end, double pull) {
  const double curvature = 1.0 / end.radius, sine = std::sin(end.contact_angle);
  return 2.0 * curvature * (curvature * pull - std::cos(end.contact_angle)) - 0.5 * sine * sine / pull;
}

double surface_energy(const std::array<BridgeEnd, 2>& ends, const BridgeShape& shape) {
  double energy = 0.0;
  for (std::size_t k = 0; k < 2; ++k)
    energy += shape.sides[k].meniscus_area - std::cos(ends[k].contact_angle) * shape.sides[k].wetted_area;
  return energy;
}

double reduced_radius(const std::array<BridgeEnd, 2>& ends) { return 2.0 / (1.0 / ends[0].radius + 1.0 / ends[1].radius); }

}  // namespace puadem
