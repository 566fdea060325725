#include "puadem/geometry/regular_triangulation.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Regular_triangulation_3.h>
#include <CGAL/Regular_triangulation_cell_base_3.h>
#include <CGAL/Regular_triangulation_vertex_base_3.h>
#include <CGAL/Triangulation_cell_base_with_info_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "puadem/base/error.hpp"
#include "puadem/base/parallel.hpp"
#include "puadem/geometry/cell.hpp"
#include "puadem/geometry/packing_sites.hpp"

namespace puadem {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_3<Vertex, Kernel, CGAL::Regular_triangulation_vertex_base_3<Kernel>>;
using CellBase = CGAL::Triangulation_cell_base_with_info_3<int, Kernel, CGAL::Regular_triangulation_cell_base_3<Kernel>>;
using Regular = CGAL::Regular_triangulation_3<Kernel, CGAL::Triangulation_data_structure_3<VertexBase, CellBase>>;
using Point = Regular::Bare_point;
using WeightedPoint = Regular::Weighted_point;
using Shift = std::array<std::int8_t, 3>;

constexpr int max_periods = 3;  // a halo wider than this means a box with too few grains to fill it

/// Spheres on a grid of 2^-40 of the box: a periodic image is then an exact translation, so that the
/// exact predicates, ties included, decide alike for a cell and for its image (theory 3.1).
struct SnappedSpheres {
  static constexpr std::array grids{0x1p40, 0x1p36, 0x1p32, 0x1p28};  ///< the first, and what to try where images differ
  static constexpr double wall_radius = 0x1p26;                       ///< in units of the box; keeps wall curvature near 1e-8

  std::vector<Vec3> centre;
  std::vector<double> weight;
  Vec3 period;
  std::vector<Vec3> place;  ///< the centres on the grid [m]

  SnappedSpheres(std::span<const Vec3> centres, std::span<const double> radii, const Domain& domain, double grid) {
    const Vec3 size = domain.size();
    const double scale = std::exp2(-std::ilogb(std::max({size.x, size.y, size.z})));
    const auto snap = [&](double x) { return std::nearbyint(x * scale * grid) / grid; };
    centre.reserve(centres.size());
    weight.reserve(radii.size());
    place.reserve(centres.size());
    for (const Vec3& c : centres) {
      centre.push_back({snap(c.x - domain.lower.x), snap(c.y - domain.lower.y), snap(c.z - domain.lower.z)});
      place.push_back(domain.lower + centre.back() / scale);
    }
    for (const double r : radii) weight.push_back(r * scale * (r * scale));
    period = {snap(size.x), snap(size.y), snap(size.z)};
  }

  WeightedPoint image(int i, const Shift& shift) const {
    const Vec3& c = centre[to_size(i)];
    return {Point(c.x + shift[0] * period.x, c.y + shift[1] * period.y, c.z + shift[2] * period.z), weight[to_size(i)]};
  }

  WeightedPoint wall(int face) const {
    Vec3 c = 0.5 * period;
    c[axis_of(face)] = is_upper(face) ? period[axis_of(face)] + wall_radius : -wall_radius;
    return {Point(c.x, c.y, c.z), wall_radius * wall_radius};
  }
};

Shift operator-(const Shift& a, const Shift& b) {
  return {static_cast<std::int8_t>(a[0] - b[0]), static_cast<std::int8_t>(a[1] - b[1]), static_cast<std::int8_t>(a[2] - b[2])};
}

using CellVertices = std::array<Vertex, 4>;

CellVertices vertices_of(Regular::Cell_handle cell) {
  return {cell->vertex(0)->info(), cell->vertex(1)->info(), cell->vertex(2)->info(), cell->vertex(3)->info()};
}

bool has_grain(const CellVertices& cell) {
  return std::any_of(cell.begin(), cell.end(), [](const Vertex& v) { return !v.is_wall(); });
}
bool has_owned_grain(const CellVertices& cell) {
  return std::any_of(cell.begin(), cell.end(), [](const Vertex& v) { return !v.is_wall() && v.shift == Shift{}; });
}

class Builder {
 public:
  Builder(std::span<const Vec3> centre, std::span<const double> radius, const Domain& domain, double grid)
      : centre_(centre),
        radius_(radius),
        domain_(domain),
        spheres_(centre, radius, domain, grid),
        sites_of_(spheres_.place, radius, domain) {
    largest_radius_ = *std::max_element(radius.begin(), radius.end());
    any_periodic_ = domain.periodic[0] || domain.periodic[1] || domain.periodic[2];
  }

  /// None where two images of the same grains were cut differently, near the grain of `differing`.
  std::optional<Triangulation> build() {
    if (!any_periodic_) {
      insert(0.0);
    } else {
      const Vec3 size = domain_.size();
      const double cell = std::cbrt(domain_.volume() / size_of(radius_));
      for (double halo = 2.0 * largest_radius_ + 1.5 * cell;;) {
        insert(halo);
        const double needed = needed_halo();
        if (needed <= halo) break;
        halo = std::max(1.05 * std::min(needed, 2.0 * halo), 1.3 * halo);
        for (int axis = 0; axis < 3; ++axis)
          require(!domain_.periodic[to_size(axis)] || halo <= max_periods * size[axis],
                  "the periodic box of {:g} x {:g} x {:g} m holds too few grains to triangulate ({}): use more grains or walls",
                  size.x, size.y, size.z, radius_.size());
      }
    }
    require_all_visible();
    return collect();
  }

  int differing = -1;

 private:
  void insert(double halo) {
    std::vector<std::pair<WeightedPoint, Vertex>> points;
    const Vec3 size = domain_.size();
    std::array<int, 3> reach{};
    for (int axis = 0; axis < 3; ++axis)
      if (domain_.periodic[to_size(axis)]) reach[to_size(axis)] = static_cast<int>(std::ceil(halo / size[axis]));
    for (int face = 0; face < 6; ++face)
      if (domain_.is_wall(face)) points.emplace_back(spheres_.wall(face), Vertex::wall(face));
    for (int i = 0; i < size_of(radius_); ++i) {
      const Vec3 x = centre_[to_size(i)] - domain_.lower;
      for (int a = -reach[0]; a <= reach[0]; ++a)
        for (int b = -reach[1]; b <= reach[1]; ++b)
          for (int c = -reach[2]; c <= reach[2]; ++c) {
            const std::array<int, 3> s{a, b, c};
            bool inside = true;
            for (int axis = 0; axis < 3; ++axis) {
              const double image = x[axis] + s[to_size(axis)] * size[axis];
              inside = inside && (s[to_size(axis)] == 0 || (image >= -halo && image <= size[axis] + halo));
            }
            if (!inside) continue;
            const Shift shift{static_cast<std::int8_t>(a), static_cast<std::int8_t>(b), static_cast<std::int8_t>(c)};
            points.emplace_back(spheres_.image(i, shift), Vertex{i, shift});
          }
    }
    regular_.clear();
    regular_.insert(points.begin(), points.end());
  }

  /// Halo at which no image left out could change a cell that touches an owned grain, or one beside it
  /// [m]: the orthosphere of every such cell, widened by the largest grain, must lie inside the images.
  double needed_halo() const {
    double needed = 0.0;
    for (auto cell = regular_.finite_cells_begin(); cell != regular_.finite_cells_end(); ++cell) {
      if (!has_owned_grain(vertices_of(cell))) continue;
      needed = std::max(needed, reach_beyond_box(cell));
      for (int k = 0; k < 4; ++k) {
        const auto other = cell->neighbor(k);
        if (regular_.is_infinite(other)) {
          const bool only_walls = [&] {
            for (int v = 0; v < 4; ++v)
              if (v != k && !cell->vertex(v)->info().is_wall()) return false;
            return true;
          }();
          if (!only_walls) return std::numeric_limits<double>::infinity();
        } else if (!has_owned_grain(vertices_of(other)) && has_grain(vertices_of(other))) {
          needed = std::max(needed, reach_beyond_box(other));
        }
      }
    }
    return needed;
  }

  /// How far the orthosphere of a cell, widened by the largest grain, leaves the box along periodic axes [m].
  double reach_beyond_box(Regular::Cell_handle cell) const {
    const std::array<Site, 4> sites = sites_of_(vertices_of(cell));
    const auto centre = power_centre(sites);
    if (!centre) return 0.0;  // flat: the orthospheres of its neighbours bound its own
    const Site& grain = sites[first_grain(sites)];
    const double power = squared_norm(*centre - grain.centre) - grain.radius * grain.radius;
    const double reach = std::sqrt(std::max(0.0, power + largest_radius_ * largest_radius_));
    double beyond = 0.0;
    for (int axis = 0; axis < 3; ++axis)
      if (domain_.periodic[to_size(axis)])
        beyond = std::max({beyond, domain_.lower[axis] - (*centre)[axis] + reach, (*centre)[axis] + reach - domain_.upper[axis]});
    return beyond;
  }

  void require_all_visible() {
    std::vector<char> seen(radius_.size(), 0);
    for (auto v = regular_.finite_vertices_begin(); v != regular_.finite_vertices_end(); ++v)
      if (!v->info().is_wall() && v->info().shift == Shift{}) seen[to_size(v->info().index)] = 1;
    for (int i = 0; i < size_of(radius_); ++i) {
      const Vec3& c = centre_[to_size(i)];
      require(seen[to_size(i)],
              "grain {} at ({:g}, {:g}, {:g}) m is hidden: a neighbour at the same place or swallowing it leaves it no space of "
              "its own; "
              "remove it or reduce the overlap",
              i, c.x, c.y, c.z);
    }
  }

  std::optional<Triangulation> collect() {
    struct Kept {
      CellVertices vertices;
      Regular::Cell_handle handle;
    };
    std::vector<Kept> kept;
    kept.reserve(6 * radius_.size() + 64);
    for (auto cell = regular_.finite_cells_begin(); cell != regular_.finite_cells_end(); ++cell) {
      cell->info() = -1;
      CellVertices vertices = vertices_of(cell);
      if (!has_grain(vertices)) continue;
      std::sort(vertices.begin(), vertices.end());
      if (any_periodic_ && !(has_owned_grain(vertices) && canonical(vertices).vertices == vertices)) continue;
      kept.push_back({vertices, cell});
    }
    std::sort(kept.begin(), kept.end(), [](const Kept& a, const Kept& b) { return a.vertices < b.vertices; });
    for (int t = 0; t < size_of(kept); ++t) kept[to_size(t)].handle->info() = t;

    Triangulation result;
    result.vertices.resize(kept.size());
    result.neighbours.resize(kept.size());
    for (int t = 0; t < size_of(kept); ++t) {
      const auto& [vertices, handle] = kept[to_size(t)];
      result.vertices[to_size(t)] = vertices;
      for (int k = 0; k < 4; ++k) {
        const auto place = std::find(vertices.begin(), vertices.end(), handle->vertex(k)->info()) - vertices.begin();
        const auto other = handle->neighbor(k);
        auto& neighbour = result.neighbours[to_size(t)][static_cast<unsigned>(place)];
        if (regular_.is_infinite(other)) continue;
        const CellVertices across = vertices_of(other);
        if (!has_grain(across)) continue;
        if (other->info() >= 0) {
          neighbour.cell = other->info();
          continue;
        }
        const CanonicalCell image = canonical(across);
        const auto found = std::lower_bound(kept.begin(), kept.end(), image.vertices,
                                            [](const Kept& a, const CellVertices& key) { return a.vertices < key; });
        if (found == kept.end() || found->vertices != image.vertices) {
          differing = vertices[3].index;
          return std::nullopt;
        }
        neighbour = {static_cast<int>(found - kept.begin()), image.shift};
      }
    }
    return result;
  }

  std::span<const Vec3> centre_;
  std::span<const double> radius_;
  Domain domain_;
  SnappedSpheres spheres_;
  PackingSites sites_of_;  // as the predicates see them
  double largest_radius_ = 0.0;
  bool any_periodic_ = false;
  Regular regular_;
};

}  // namespace

CanonicalCell canonical(const std::array<Vertex, 4>& cell) {
  int first = -1;
  for (const Vertex& v : cell)
    if (!v.is_wall() && (first < 0 || v.index < first)) first = v.index;
  CanonicalCell best;
  bool found = false;
  for (const Vertex& origin : cell) {
    if (origin.index != first) continue;
    CanonicalCell candidate{cell, origin.shift};
    for (Vertex& v : candidate.vertices)
      if (!v.is_wall()) v.shift = v.shift - origin.shift;
    std::sort(candidate.vertices.begin(), candidate.vertices.end());
    if (!found || candidate.vertices < best.vertices) best = candidate;
    found = true;
  }
  return best;
}

Triangulation triangulate(std::span<const Vec3> centre, std::span<const double> radius, const Domain& domain) {
  assert(centre.size() == radius.size());
  require(!centre.empty(), "a packing without grains has no pores to triangulate: give at least one grain");
  for (int i = 0; i < size_of(radius); ++i) {
    const Vec3& c = centre[to_size(i)];
    require(radius[to_size(i)] > 0.0 && std::isfinite(radius[to_size(i)]), "grain {} has radius {} m: it must be positive", i,
            radius[to_size(i)]);
    for (int axis = 0; axis < 3; ++axis) {
      const bool inside = domain.periodic[to_size(axis)] ? c[axis] >= domain.lower[axis] && c[axis] < domain.upper[axis]
                                                         : c[axis] > domain.lower[axis] && c[axis] < domain.upper[axis];
      require(inside, "grain {} at ({:g}, {:g}, {:g}) m has its centre outside the box [{:g}, {:g}] m along {}", i, c.x, c.y, c.z,
              domain.lower[axis], domain.upper[axis], "xyz"[axis]);
    }
  }
  // A wall is very slightly curved. Where images of a nearly regular packing tie but for that, it decides, for each
  // image in its own way; on a coarser grid they tie exactly.
  int differing = -1;
  for (const double grid : SnappedSpheres::grids) {
    Builder builder(centre, radius, domain, grid);
    if (auto triangulation = builder.build()) return std::move(*triangulation);
    differing = builder.differing;
  }
  throw NumericalError(fmt::format(
      "the triangulation is not periodic near grain {}: two images of the same grains were cut differently", differing));
}

}  // namespace puadem
