#include <algorithm>
#include <cmath>
#include <numeric>

#include "puadem/base/error.hpp"
#include "puadem/base/random.hpp"
#include "puadem/dem/packing.hpp"
#include "puadem/dem/sphere_in_box.hpp"

namespace puadem {

namespace {

constexpr double cloud_fraction = 0.3;  // random addition, largest first, fills this at a few trials a grain
constexpr int trials_per_grain = 20000;

/// Grains placed so far, in cells that a grain may overlap from the neighbouring cell at most.
struct PlacedGrains {
  Domain box;
  std::array<int, 3> cells{};
  std::vector<std::vector<int>> cell;
  const std::vector<double>& radius;
  std::vector<Vec3> position;

  PlacedGrains(const Domain& domain, const std::vector<double>& radii, double largest)
      : box(domain), radius(radii), position(radii.size()) {
    for (int axis = 0; axis < 3; ++axis)
      cells[static_cast<unsigned>(axis)] = std::max(1, static_cast<int>(box.size()[axis] / (2.0 * largest)));
    cell.resize(to_size(cells[0]) * to_size(cells[1]) * to_size(cells[2]));
  }
  int along(const Vec3& x, int axis) const {
    const int n = cells[static_cast<unsigned>(axis)];
    return std::clamp(static_cast<int>((x[axis] - box.lower[axis]) / box.size()[axis] * n), 0, n - 1);
  }
  int index(int i, int j, int k) const { return (k * cells[1] + j) * cells[0] + i; }
};

double nearest_image(double d, double size, bool periodic) { return periodic ? d - size * std::round(d / size) : d; }

bool is_free(const PlacedGrains& placed, const Vec3& x, double r) {
  const Vec3 size = placed.box.size();
  std::array<std::vector<int>, 3> range;  // a narrow periodic box meets a cell once only
  for (int axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<unsigned>(axis);
    const int n = placed.cells[a], c = placed.along(x, axis);
    for (int k = c - 1; k <= c + 1; ++k) {
      if (!placed.box.periodic[a] && (k < 0 || k >= n)) continue;
      const int wrapped = (k + n) % n;
      if (std::find(range[a].begin(), range[a].end(), wrapped) == range[a].end()) range[a].push_back(wrapped);
    }
  }
  for (const int k : range[2])
    for (const int j : range[1])
      for (const int i : range[0])
        for (const int other : placed.cell[to_size(placed.index(i, j, k))]) {
          Vec3 d = placed.position[to_size(other)] - x;
          for (int axis = 0; axis < 3; ++axis)
            d[axis] = nearest_image(d[axis], size[axis], placed.box.periodic[static_cast<unsigned>(axis)]);
          const double reach = r + placed.radius[to_size(other)];
          if (squared_norm(d) < reach * reach) return false;
        }
  return true;
}

Domain cloud_box(const PackingSource& source, const std::vector<double>& radius, double largest) {
  double solid = 0.0;
  for (const double r : radius) solid += 4.0 / 3.0 * std::numbers::pi * r * r * r;
  const Vec3& shape = source.shape;
  for (int axis = 0; axis < 3; ++axis)
    require(shape[axis] > 0.0, "domain.shape: proportion {} of axis {} must be positive", shape[axis], axis);
  const double scale = std::cbrt(solid / (cloud_fraction * shape.x * shape.y * shape.z));
  Domain box;
  box.upper = scale * shape;
  box.periodic = source.periodic;
  for (int axis = 0; axis < 3; ++axis)
    require(0.7 * box.upper[axis] > 5.0 * largest,
            "axis {} of the box would be narrower than 2.5 diameters of the largest grain: take more grains", axis);
  return box;
}

}  // namespace

Packing random_cloud(const PackingSource& source, std::span<const Material> materials) {
  for (const MaterialShare& share : source.materials)
    require(share.material >= 0 && share.material < size_of(materials), "grains of material {} of {} materials", share.material,
            materials.size());
  const std::vector<double> radius = grain_radii(source.grading, source.count, source.seed);
  const double largest = *std::max_element(radius.begin(), radius.end());
  PlacedGrains placed(cloud_box(source, radius, largest), radius, largest);

  std::vector<int> order(radius.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return radius[to_size(a)] > radius[to_size(b)]; });
  Random random(source.seed ^ 0x636c6f7564ULL);
  const Vec3& upper = placed.box.upper;
  for (const int grain : order) {
    const double r = radius[to_size(grain)];
    const auto within = [&](int axis) {
      const double margin = placed.box.periodic[static_cast<unsigned>(axis)] ? 0.0 : r;
      return random.uniform(margin, upper[axis] - margin);
    };
    Vec3 x;
    int trial = 0;
    do {
      ensure(++trial <= trials_per_grain, "the random cloud finds no place for grain {} of radius {:.4g} m in {} trials", grain,
             r, trials_per_grain);
      x.x = within(0);
      x.y = within(1);
      x.z = within(2);
    } while (!is_free(placed, x, r));
    placed.position[to_size(grain)] = x;
    placed.cell[to_size(placed.index(placed.along(x, 0), placed.along(x, 1), placed.along(x, 2)))].push_back(grain);
  }
  Packing cloud;
  cloud.domain = placed.box;
  cloud.particles = make_particles(placed.position, radius, materials, assign_materials(radius, source.materials));
  cloud.report.grading_error = grading_error(source.grading, radius);
  cloud.report.porosity_box = porosity_of(cloud.particles.position, radius, cloud.domain);
  return cloud;
}

}  // namespace puadem
