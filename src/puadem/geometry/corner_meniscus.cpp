#include "puadem/geometry/corner_meniscus.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>

namespace puadem {

namespace {

struct Wetting {
  double r, cosine, sine, angle;
};

/// Arc cosine of a ratio that rounding may push past 1.
double safe_acos(double c) { return std::acos(std::clamp(c, -1.0, 1.0)); }

CornerMeniscus between_grains(double ra, double rb, double e, const Wetting& w) {
  const double da = std::sqrt(ra * ra + w.r * w.r + 2.0 * ra * w.r * w.cosine);
  const double db = std::sqrt(rb * rb + w.r * w.r + 2.0 * rb * w.r * w.cosine);
  const double at_a = safe_acos((e * e + da * da - db * db) / (2.0 * e * da));
  const double at_b = safe_acos((e * e + db * db - da * da) / (2.0 * e * db));
  const double at_centre = std::numbers::pi - at_a - at_b;
  double wetted_a = at_a, wetted_b = at_b, opening = at_centre;
  double area = 0.5 * e * da * std::sin(at_a);  // triangle of the two grains and the meniscus centre
  if (w.angle > 0.0) {
    wetted_a -= std::asin(w.r * w.sine / da);
    wetted_b -= std::asin(w.r * w.sine / db);
    opening -= std::asin(ra * w.sine / da) + std::asin(rb * w.sine / db);
    area -= 0.5 * (ra + rb) * w.r * w.sine;
  }
  area -= 0.5 * (ra * ra * wetted_a + rb * rb * wetted_b + w.r * w.r * opening);
  return {area, opening, ra * wetted_a, rb * wetted_b};
}

/// Limit of the former for a grain of infinite radius: the meniscus centre stands r cos(theta) off the wall.
CornerMeniscus at_wall(double ra, double distance, const Wetting& w) {
  const double da = std::sqrt(ra * ra + w.r * w.r + 2.0 * ra * w.r * w.cosine);
  const double height = w.r * w.cosine;
  const double at_a = safe_acos((distance - height) / da);
  const double along = da * std::sin(at_a);
  double wetted_a = at_a, wetted_wall = along, opening = std::numbers::pi - at_a;
  double area = 0.5 * (distance + height) * along;
  if (w.angle > 0.0) {
    wetted_a -= std::asin(w.r * w.sine / da);
    wetted_wall -= w.r * w.sine;
    opening -= std::asin(ra * w.sine / da) + w.angle;
    area -= 0.5 * ra * w.r * w.sine + 0.5 * w.r * w.sine * height;
  }
  area -= 0.5 * (ra * ra * wetted_a + w.r * w.r * opening);
  return {area, opening, ra * wetted_a, wetted_wall};
}

CornerMeniscus between_walls(double half_angle, const Wetting& w) {
  const double opening = std::numbers::pi - 2.0 * (half_angle + w.angle);
  if (opening <= 0.0) return {};  // the corner is too open to hold this fluid
  const double wetted = w.r * std::cos(w.angle + half_angle) / std::sin(half_angle);
  return {w.r * (wetted * w.cosine - 0.5 * w.r * opening), opening, wetted, wetted};
}

}  // namespace

CornerMeniscus corner_meniscus(const ThroatSection& section, int k, double r, double contact_angle) {
  assert(r > 0.0);
  const auto& crevice = section.crevice[static_cast<unsigned>(k)];
  const auto& first = section.side[static_cast<unsigned>(k)];
  const auto& next = section.side[static_cast<unsigned>((k + 1) % section.sides)];
  const Wetting w{r, std::cos(contact_angle), std::sin(contact_angle), contact_angle};
  if (first.is_wall && next.is_wall) return between_walls(crevice.half_angle, w);
  if (next.is_wall) return at_wall(first.radius, crevice.distance, w);
  if (first.is_wall) {
    const CornerMeniscus m = at_wall(next.radius, crevice.distance, w);
    return {m.area, m.angle, m.wetted_next, m.wetted_first};
  }
  return between_grains(first.radius, next.radius, crevice.distance, w);
}

SectionMenisci section_menisci(const ThroatSection& section, double r, double contact_angle) {
  SectionMenisci all;
  all.dry_length = section.solid_perimeter();
  all.least_area = std::numeric_limits<double>::infinity();
  for (int k = 0; k < section.sides; ++k) {
    const CornerMeniscus m = corner_meniscus(section, k, r, contact_angle);
    all.wetting_area += m.area;
    all.meniscus_length += r * m.angle;
    all.dry_length -= m.wetted_first + m.wetted_next;
    all.least_area = std::min(all.least_area, m.area);
  }
  return all;
}

}  // namespace puadem
