#include "puadem/dem/sphere_in_box.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numbers>

#include "puadem/base/error.hpp"
#include "puadem/base/parallel.hpp"

namespace puadem {

namespace {

using std::numbers::pi;

/// Part of the unit circle of radius rho with y > b, z > c, where b, c >= 0 and b^2 + c^2 < rho^2: angle of
/// its arc, and area.
struct CircleCorner {
  double angle, area;
};
CircleCorner circle_corner(double rho, double b, double c) {
  const double y = std::sqrt(rho * rho - c * c), z = std::sqrt(rho * rho - b * b);
  const double angle = std::atan2(z, b) - std::atan2(c, y);
  return {angle, 0.5 * (rho * rho * angle - c * (y - b) - b * (z - c))};
}

/// Unit sphere beyond three planes at right angles, x > a, y > b, z > c >= 0, whose common point lies inside:
/// divergence theorem over the three flat faces and the spherical one, whose area follows from the
/// theorem of Gauss and Bonnet.
double beyond_corner(double a, double b, double c) {
  const auto tilt = [](double p, double q) { return std::acos(-p * q / std::sqrt((1.0 - p * p) * (1.0 - q * q))); };
  const CircleCorner on_a = circle_corner(std::sqrt(1.0 - a * a), b, c);
  const CircleCorner on_b = circle_corner(std::sqrt(1.0 - b * b), c, a);
  const CircleCorner on_c = circle_corner(std::sqrt(1.0 - c * c), a, b);
  const double cap = 2.0 * pi - tilt(a, b) - tilt(b, c) - tilt(c, a) - a * on_a.angle - b * on_b.angle - c * on_c.angle;
  return (cap - a * on_a.area - b * on_b.area - c * on_c.area) / 3.0;
}

/// Volume of the unit sphere beyond the first `count` of three perpendicular planes at distances h from
/// the centre. A plane behind the centre is the complement of its mirror image.
double beyond(std::array<double, 3> h, int count) {
  if (count == 0) return 4.0 * pi / 3.0;
  double squared = 0.0;
  for (int p = 0; p < count; ++p) {
    const auto plane = static_cast<unsigned>(p);
    if (h[plane] >= 1.0) return 0.0;
    if (h[plane] < 0.0) {
      std::array<double, 3> mirrored = h, rest = h;
      mirrored[plane] = -h[plane];
      std::swap(rest[plane], rest[static_cast<unsigned>(count - 1)]);
      return beyond(rest, count - 1) - beyond(mirrored, count);
    }
    squared += h[plane] * h[plane];
  }
  if (squared >= 1.0) return 0.0;
  if (count == 1) return pi / 3.0 * (1.0 - h[0]) * (1.0 - h[0]) * (2.0 + h[0]);
  if (count == 2) return 2.0 * beyond_corner(h[0], h[1], 0.0);
  return beyond_corner(h[0], h[1], h[2]);
}

}  // namespace

double sphere_volume_in_box(const Vec3& centre, double radius, const Domain& box) {
  // Signed distance of the faces in radii; two faces of an axis never cut together outside the box.
  std::array<std::array<double, 2>, 3> h{};
  bool inside = true;
  for (int axis = 0; axis < 3; ++axis) {
    auto& faces = h[static_cast<unsigned>(axis)];
    if (box.periodic[static_cast<unsigned>(axis)])
      faces = {1.0, 1.0};
    else
      faces = {(centre[axis] - box.lower[axis]) / radius, (box.upper[axis] - centre[axis]) / radius};
    if (faces[0] <= -1.0 || faces[1] <= -1.0) return 0.0;
    inside = inside && faces[0] >= 1.0 && faces[1] >= 1.0;
  }
  double volume = 4.0 * pi / 3.0;
  if (!inside) {
    for (unsigned a = 0; a < 3; ++a)
      for (const double x : h[a]) {
        if (x >= 1.0) continue;
        volume -= beyond({x, 0, 0}, 1);
        for (unsigned b = a + 1; b < 3; ++b)
          for (const double y : h[b]) {
            if (y >= 1.0) continue;
            volume += beyond({x, y, 0}, 2);
            for (unsigned c = b + 1; c < 3; ++c)
              for (const double z : h[c])
                if (z < 1.0) volume -= beyond({x, y, z}, 3);
          }
      }
  }
  return volume * radius * radius * radius;
}

double porosity_of(std::span<const Vec3> centre, std::span<const double> radius, const Domain& box) {
  assert(centre.size() == radius.size());
  const double solid = parallel_sum<double>(
      static_cast<int>(centre.size()), [&](int k) { return sphere_volume_in_box(centre[to_size(k)], radius[to_size(k)], box); });
  return 1.0 - solid / box.volume();
}

Domain core_of(const Domain& box, double margin) {
  Domain core = box;
  for (int axis = 0; axis < 3; ++axis) {
    if (box.periodic[static_cast<unsigned>(axis)]) continue;
    core.lower[axis] += margin;
    core.upper[axis] -= margin;
    require(core.upper[axis] > core.lower[axis],
            "the box is {:.4g} m wide along axis {}: no core is left farther than {:.4g} m from the walls; take more grains, or "
            "the porosity of the box",
            box.size()[axis], axis, margin);
  }
  return core;
}

}  // namespace puadem
