#include "puadem/geometry/cell.hpp"

#include <cassert>
#include <cmath>

#include "puadem/geometry/solid_angle.hpp"

namespace puadem {

namespace {

/// Grains and walls of a cell or facet apart. With p + 1 grains and q walls the polyhedron is a simplex
/// of dimension p times a cube of dimension q: its corners are the feet of a grain on a set of walls.
template <std::size_t N>
struct Staircase {
  std::array<const Site*, N> grains{}, walls{};
  int grain_count = 0, wall_count = 0;

  explicit Staircase(const std::array<Site, N>& sites) {
    for (const Site& site : sites)
      if (site.is_wall)
        walls[static_cast<unsigned>(wall_count++)] = &site;
      else
        grains[static_cast<unsigned>(grain_count++)] = &site;
    assert(grain_count > 0);
  }

  /// Calls `visit` with the corners of each simplex of the staircase decomposition: every path from the
  /// first grain on no wall to the last grain on all walls, a step being the next grain or one more wall.
  template <class Visit>
  void for_each_simplex(const Visit& visit) const {
    std::array<Vec3, N> corner;
    step(0, 0, 0, grains[0]->centre, corner, visit);
  }

 private:
  template <class Visit>
  void step(int depth, int grain, unsigned on_walls, const Vec3& at, std::array<Vec3, N>& corner, const Visit& visit) const {
    corner[static_cast<unsigned>(depth)] = at;
    if (depth + 1 == static_cast<int>(N)) {
      visit(corner);
      return;
    }
    if (grain + 1 < grain_count) {
      Vec3 next = grains[static_cast<unsigned>(grain + 1)]->centre;
      for (int w = 0; w < wall_count; ++w)
        if (on_walls >> w & 1u) next = foot(next, *walls[static_cast<unsigned>(w)]);
      step(depth + 1, grain + 1, on_walls, next, corner, visit);
    }
    for (int w = 0; w < wall_count; ++w)
      if (!(on_walls >> w & 1u))
        step(depth + 1, grain, on_walls | 1u << w, foot(at, *walls[static_cast<unsigned>(w)]), corner, visit);
  }

  static Vec3 foot(const Vec3& x, const Site& wall) { return x + (wall.offset - dot(wall.normal, x)) * wall.normal; }
};

double tetrahedron_volume(const std::array<Vec3, 4>& p) { return std::abs(triple(p[1] - p[0], p[2] - p[0], p[3] - p[0])) / 6.0; }

/// The three tangencies of the first grain with the other sites.
std::array<Tangency, 3> tangencies(const std::array<Site, 4>& sites, std::size_t first) {
  std::array<Tangency, 3> rows;
  for (std::size_t k = 0, row = 0; k < 4; ++k)
    if (k != first) rows[row++] = tangency(sites[first], sites[k]);
  return rows;
}

/// Solves the 3 x 3 system with rows a by Cramer's rule; none where the rows are flat to 1e-13 of their size.
std::optional<Vec3> solve(const std::array<Vec3, 3>& a, const std::array<double, 3>& b) {
  const double determinant = triple(a[0], a[1], a[2]);
  if (std::abs(determinant) <= 1e-13 * norm(a[0]) * norm(a[1]) * norm(a[2])) return std::nullopt;
  return (b[0] * cross(a[1], a[2]) + b[1] * cross(a[2], a[0]) + b[2] * cross(a[0], a[1])) / determinant;
}

}  // namespace

double cell_volume(const std::array<Site, 4>& sites) {
  double volume = 0.0;
  Staircase<4>(sites).for_each_simplex([&](const std::array<Vec3, 4>& p) { volume += tetrahedron_volume(p); });
  return volume;
}

Vec3 cell_centroid(const std::array<Site, 4>& sites) {
  double volume = 0.0;
  Vec3 moment, mean;
  int corners = 0;
  Staircase<4>(sites).for_each_simplex([&](const std::array<Vec3, 4>& p) {
    const double v = tetrahedron_volume(p);
    const Vec3 sum = p[0] + p[1] + p[2] + p[3];
    volume += v;
    moment += v / 4.0 * sum;
    mean += sum;
    corners += 4;
  });
  return volume > 0.0 ? moment / volume : mean / corners;  // a flat cell has no volume to weigh by
}

double facet_area(const std::array<Site, 3>& sites) {
  double area = 0.0;
  Staircase<3>(sites).for_each_simplex(
      [&](const std::array<Vec3, 3>& p) { area += 0.5 * norm(cross(p[1] - p[0], p[2] - p[0])); });
  return area;
}

std::array<double, 4> grain_solid_angles(const std::array<Site, 4>& sites) {
  std::array<double, 4> omega{};
  for (unsigned k = 0; k < 4; ++k)
    if (!sites[k].is_wall)
      omega[k] = solid_angle(edge_from(sites[k], sites[(k + 1) % 4]), edge_from(sites[k], sites[(k + 2) % 4]),
                             edge_from(sites[k], sites[(k + 3) % 4]));
  return omega;
}

double cell_void_volume(const std::array<Site, 4>& sites) {
  const auto omega = grain_solid_angles(sites);
  double volume = cell_volume(sites);
  for (unsigned k = 0; k < 4; ++k) volume -= sites[k].radius * sites[k].radius * sites[k].radius * omega[k] / 3.0;
  return volume;
}

std::optional<Vec3> power_centre(const std::array<Site, 4>& sites) {
  const std::size_t first = first_grain(sites);
  const auto [p, q, r] = tangencies(sites, first);
  const auto offset = solve({p.edge, q.edge, r.edge}, {p.constant, q.constant, r.constant});
  if (!offset) return std::nullopt;
  return sites[first].centre + *offset;
}

std::optional<InscribedSphere> inscribed_sphere(const std::array<Site, 4>& sites) {
  const std::size_t first = first_grain(sites);
  const auto [p, q, r] = tangencies(sites, first);
  const std::array<Vec3, 3> edges{p.edge, q.edge, r.edge};
  const auto u = solve(edges, {p.constant, q.constant, r.constant}), v = solve(edges, {p.linear, q.linear, r.linear});
  if (!u || !v) return std::nullopt;
  const auto radius = tangent_radius(*u, *v, sites[first].radius);
  if (!radius) return std::nullopt;
  return InscribedSphere{sites[first].centre + *u + *radius * *v, *radius};
}

Vec3 facet_normal(const std::array<Site, 3>& sites) {
  const std::size_t k = first_grain(sites);
  return normalized(cross(edge_from(sites[k], sites[(k + 1) % 3]), edge_from(sites[k], sites[(k + 2) % 3])));
}

}  // namespace puadem
