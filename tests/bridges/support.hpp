#pragma once

#include <array>
#include <cmath>
#include <numbers>

#include "puadem/bridges/bridge_shape.hpp"

namespace puadem::test {

constexpr double degrees = std::numbers::pi / 180.0;

inline std::array<BridgeEnd, 2> bridge_ends(double first, double second, double angle) {
  return {BridgeEnd{first, angle}, BridgeEnd{second, angle}};
}

/// What the Young-Laplace equation itself gives: the meridian y(z) integrated by Runge and Kutta from one contact line until it
/// meets a second sphere at its contact angle. Nothing here knows the closed form of theory 8.1.
struct Integrated {
  double gap = 0.0, volume = 0.0, meniscus_area = 0.0;
  std::array<double, 2> pull{};  // y cos(phi) + p y^2 / 2 at both contact lines
};

/// @param filling  filling angle at the first end [rad]
inline Integrated integrate_meridian(const std::array<BridgeEnd, 2>& ends, double suction, double filling, double step) {
  struct Point {
    double y, z, phi, volume, area;
  };
  const auto rate = [&](const Point& m) {
    return Point{std::sin(m.phi), std::cos(m.phi), std::cos(m.phi) / m.y + suction,
                 std::numbers::pi * m.y * m.y * std::cos(m.phi), 2.0 * std::numbers::pi * m.y};
  };
  const auto moved = [](const Point& m, const Point& r, double h) {
    return Point{m.y + h * r.y, m.z + h * r.z, m.phi + h * r.phi, m.volume + h * r.volume, m.area + h * r.area};
  };
  const auto advanced = [&](const Point& m, double h) {
    const Point a = rate(m), b = rate(moved(m, a, 0.5 * h)), c = rate(moved(m, b, 0.5 * h)), d = rate(moved(m, c, h));
    return moved(moved(moved(moved(m, a, h / 6), b, h / 3), c, h / 3), d, h / 6);
  };
  // A sphere of the second end's radius through the point, centre on the axis, makes the contact angle where this vanishes.
  const auto misfit = [&](const Point& m) { return m.y - ends[1].radius * std::cos(m.phi + ends[1].contact_angle); };
  const double pi = std::numbers::pi, first = ends[0].radius;
  Point m{first * std::sin(filling), 0.0, -(0.5 * pi - filling - ends[0].contact_angle), 0.0, 0.0};
  Integrated result;
  result.pull[0] = m.y * std::cos(m.phi) + 0.5 * suction * m.y * m.y;
  while (misfit(advanced(m, step)) < 0.0) m = advanced(m, step);
  double low = 0.0, high = step;
  for (int k = 0; k < 60; ++k) (misfit(advanced(m, 0.5 * (low + high))) < 0.0 ? low : high) = 0.5 * (low + high);
  m = advanced(m, low);
  result.pull[1] = m.y * std::cos(m.phi) + 0.5 * suction * m.y * m.y;
  const auto cap = [pi](double radius, double y) {  // height and volume
    const double h = radius - std::sqrt(radius * radius - y * y);
    return std::array{h, pi * h * h * (radius - h / 3.0)};
  };
  const auto here = cap(first, first * std::sin(filling)), there = cap(ends[1].radius, m.y);
  result.gap = m.z - here[0] - there[0];
  result.volume = m.volume - here[1] - there[1];
  result.meniscus_area = m.area;
  return result;
}

}  // namespace puadem::test
