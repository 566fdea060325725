#include "puadem/geometry/throat_section.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "puadem/geometry/cell.hpp"
#include "puadem/geometry/solid_angle.hpp"

namespace puadem {

namespace {

/// Distance of the feet of two sites on a wall: the length of wall between them.
double length_on_wall(const Site& wall, const Site& a, const Site& b) {
  if (a.is_wall) return distance_to_wall(b, a);  // b's foot to the corner of the two walls
  if (b.is_wall) return distance_to_wall(a, b);
  const Vec3 d = b.centre - a.centre;
  return norm(d - dot(wall.normal, d) * wall.normal);
}

ThroatSection::Crevice crevice_between(const Site& a, const Site& b) {
  if (a.is_wall && b.is_wall) return {0.0, std::numbers::pi / 4.0, 0.0};
  const Site& grain = a.is_wall ? b : a;
  const Site& other = a.is_wall ? a : b;
  const double distance = other.is_wall ? distance_to_wall(grain, other) : norm(other.centre - grain.centre);
  return {distance, 0.0, distance - (grain.radius + other.radius)};  // the same bits from either end
}

void subtract_grains(ThroatSection& section) {
  section.void_area = section.facet_area;
  for (int k = 0; k < section.sides; ++k) {
    const auto& side = section.side[static_cast<unsigned>(k)];
    if (!side.is_wall) section.void_area -= 0.5 * side.radius * side.radius * side.extent;
  }
}

}  // namespace

double ThroatSection::solid_perimeter() const {
  double length = 0.0;
  for (int k = 0; k < sides; ++k) length += solid_length(k);
  return length;
}

double inscribed_circle_radius(const std::array<Site, 3>& sites) {
  const std::size_t first = first_grain(sites);
  const Site& origin = sites[first];
  // The centre lies in the plane of the two edges.
  const Tangency p = tangency(origin, sites[first == 0 ? 1 : 0]), q = tangency(origin, sites[first == 2 ? 1 : 2]);
  const double g00 = squared_norm(p.edge), g01 = dot(p.edge, q.edge), g11 = squared_norm(q.edge);
  const double determinant = g00 * g11 - g01 * g01;
  if (determinant <= 1e-26 * g00 * g11) return 0.0;  // three centres on a line enclose nothing
  const auto in_plane = [&](double b0, double b1) {
    return ((g11 * b0 - g01 * b1) * p.edge + (g00 * b1 - g01 * b0) * q.edge) / determinant;
  };
  return tangent_radius(in_plane(p.constant, q.constant), in_plane(p.linear, q.linear), origin.radius).value_or(0.0);
}

ThroatSection throat_section(const std::array<Site, 3>& sites) {
  ThroatSection section;
  section.sides = 3;
  for (unsigned k = 0; k < 3; ++k) {
    const Site &site = sites[k], &next = sites[(k + 1) % 3], &last = sites[(k + 2) % 3];
    section.side[k] = {
        site.is_wall, site.radius,
        site.is_wall ? length_on_wall(site, next, last) : angle_between(edge_from(site, next), edge_from(site, last))};
    section.crevice[k] = crevice_between(site, next);
  }
  section.facet_area = facet_area(sites);
  subtract_grains(section);
  section.inscribed_radius = inscribed_circle_radius(sites);
  return section;
}

ThroatSection grain_window_section(std::span<const Site> grains) {
  const auto n = grains.size();
  assert(n >= 3 && n <= static_cast<unsigned>(ThroatSection::max_sides));
  ThroatSection section;
  section.sides = static_cast<int>(n);
  Vec3 twice_area;
  for (unsigned k = 0; k < n; ++k) {
    const Site &before = grains[(k + n - 1) % n], &here = grains[k], &next = grains[(k + 1) % n];
    section.side[k] = {false, here.radius, angle_between(before.centre - here.centre, next.centre - here.centre)};
    section.crevice[k] = crevice_between(here, next);
    twice_area += cross(here.centre - grains[0].centre, next.centre - grains[0].centre);
  }
  section.facet_area = 0.5 * norm(twice_area);
  subtract_grains(section);
  // The largest circle is the tightest of those between three grains that meets no fourth; for a ring of
  // grains around one void that is the smallest of all triples.
  section.inscribed_radius = std::numeric_limits<double>::infinity();
  for (unsigned i = 0; i < n; ++i)
    for (unsigned j = i + 1; j < n; ++j)
      for (unsigned k = j + 1; k < n; ++k)
        section.inscribed_radius = std::min(section.inscribed_radius, inscribed_circle_radius({grains[i], grains[j], grains[k]}));
  return section;
}

ThroatSection polygon_section(std::span<const std::array<double, 2>> corners) {
  const auto n = corners.size();
  assert(n >= 3 && n <= static_cast<unsigned>(ThroatSection::max_sides));
  const auto at = [&](std::size_t k) { return Vec3{corners[k % n][0], corners[k % n][1], 0.0}; };
  ThroatSection section;
  section.sides = static_cast<int>(n);
  std::array<Vec3, ThroatSection::max_sides> inward;
  for (unsigned k = 0; k < n; ++k) {  // side k runs from corner k to corner k + 1, where crevice k lies
    const Vec3 along = at(k + 1) - at(k);
    section.side[k] = {true, 0.0, norm(along)};
    section.crevice[k] = {0.0, 0.5 * angle_between(at(k) - at(k + 1), at(k + 2) - at(k + 1)), 0.0};
    section.facet_area += 0.5 * cross(at(k), at(k + 1)).z;
    inward[k] = normalized(Vec3{-along.y, along.x, 0.0});
  }
  section.void_area = section.facet_area;
  // Largest inscribed circle: touches three sides and stays inside all others.
  for (unsigned i = 0; i < n; ++i)
    for (unsigned j = i + 1; j < n; ++j)
      for (unsigned k = j + 1; k < n; ++k) {
        // inward . (y - corner) = r for the three sides: linear in (y, r).
        const std::array<unsigned, 3> sides{i, j, k};
        std::array<Vec3, 3> row;
        std::array<double, 3> b{};
        for (unsigned s = 0; s < 3; ++s) {
          row[s] = {inward[sides[s]].x, inward[sides[s]].y, -1.0};
          b[s] = dot(inward[sides[s]], at(sides[s]));
        }
        const double determinant = triple(row[0], row[1], row[2]);
        if (std::abs(determinant) < 1e-12) continue;  // parallel sides
        const Vec3 y = (b[0] * cross(row[1], row[2]) + b[1] * cross(row[2], row[0]) + b[2] * cross(row[0], row[1])) / determinant;
        bool inside = true;
        for (unsigned s = 0; s < n; ++s) inside = inside && dot(inward[s], Vec3{y.x, y.y, 0.0} - at(s)) >= y.z * (1.0 - 1e-12);
        if (inside) section.inscribed_radius = std::max(section.inscribed_radius, y.z);
      }
  return section;
}

}  // namespace puadem
