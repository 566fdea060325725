#include <algorithm>
#include <cmath>
#include <numbers>

#include "puadem/base/error.hpp"
#include "puadem/base/random.hpp"
#include "puadem/dem/clump.hpp"
#include "puadem/dem/packing.hpp"
#include "puadem/dem/placed_grains.hpp"
#include "puadem/dem/sphere_in_box.hpp"

namespace puadem {

namespace {

// Solid fractions that random addition, largest first, fills at a few trials a grain, or a clump.
constexpr double uniform_fraction = 0.3;
constexpr double clumped_fraction = 0.08;
constexpr int most_trials = 20000;

Domain cloud_box(const PackingSource& source, const std::vector<double>& radius, double largest) {
  const double fraction = source.cloud == PackingSource::Cloud::uniform ? uniform_fraction : clumped_fraction;
  double solid = 0.0;
  for (const double r : radius) solid += 4.0 / 3.0 * std::numbers::pi * r * r * r;
  const Vec3& shape = source.shape;
  for (int axis = 0; axis < 3; ++axis)
    require(shape[axis] > 0.0, "domain.shape: proportion {} of axis {} must be positive", shape[axis], axis);
  const double scale = std::cbrt(solid / (fraction * shape.x * shape.y * shape.z));
  Domain box;
  box.upper = scale * shape;
  box.periodic = source.periodic;
  for (int axis = 0; axis < 3; ++axis)
    require(0.7 * box.upper[axis] > 5.0 * largest,
            "axis {} of the box would be narrower than 2.5 diameters of the largest grain: take more grains", axis);
  return box;
}

/// Grains that are placed together.
struct Clump {
  std::vector<int> grain;
  std::vector<Vec3> offset;  ///< of their centres [m]
  double radius = 0.0;       ///< of a sphere around all [m]
};

/// Clumps of consecutive grains, whose order is random; single grains for a uniform cloud. The largest first.
std::vector<Clump> make_clumps(const PackingSource& source, const std::vector<double>& radius, Random& random) {
  const bool is_uniform = source.cloud == PackingSource::Cloud::uniform;
  require(is_uniform || (source.clump_size >= 1.0 && std::isfinite(source.clump_size)),
          "grains.clump_size = {}: a clump has at least one grain", source.clump_size);
  const int count = size_of(radius);
  const int clumps = is_uniform ? count : std::max(1, static_cast<int>(std::lround(count / source.clump_size)));
  std::vector<Clump> all(to_size(clumps));
  for (int k = 0; k < count; ++k) all[to_size(static_cast<int>(static_cast<long>(k) * clumps / count))].grain.push_back(k);
  for (Clump& clump : all) {
    std::stable_sort(clump.grain.begin(), clump.grain.end(),
                     [&](int a, int b) { return radius[to_size(a)] > radius[to_size(b)]; });
    std::vector<double> sizes;
    for (const int k : clump.grain) sizes.push_back(radius[to_size(k)]);
    clump.offset = make_clump(sizes, random);
    for (std::size_t k = 0; k < sizes.size(); ++k) clump.radius = std::max(clump.radius, norm(clump.offset[k]) + sizes[k]);
  }
  std::stable_sort(all.begin(), all.end(), [](const Clump& a, const Clump& b) { return a.radius > b.radius; });
  return all;
}

/// At a random place where all its grains are free.
void place_clump(PlacedGrains& placed, const Clump& clump, Random& random) {
  const Domain& box = placed.box;
  const Vec3 size = box.size();
  for (int axis = 0; axis < 3; ++axis)
    require(2.0 * clump.radius < size[axis],
            "a clump of {} grains is {:.4g} m wide, axis {} of the cloud's box {:.4g} m: take more grains or a smaller "
            "grains.clump_size",
            clump.grain.size(), 2.0 * clump.radius, axis, size[axis]);
  std::vector<Vec3> at(clump.grain.size());
  const auto is_placed = [&] {
    Vec3 centre;
    for (int axis = 0; axis < 3; ++axis) {
      const double margin = box.periodic[to_size(axis)] ? 0.0 : clump.radius;
      centre[axis] = random.uniform(margin, size[axis] - margin);
    }
    for (std::size_t k = 0; k < at.size(); ++k) {
      at[k] = centre + clump.offset[k];
      for (int axis = 0; axis < 3; ++axis)
        if (box.periodic[to_size(axis)]) at[k][axis] -= size[axis] * std::floor(at[k][axis] / size[axis]);
      if (!is_free(placed, at[k], placed.radius[to_size(clump.grain[k])])) return false;
    }
    return true;
  };
  int trial = 1;
  while (!is_placed())
    ensure(++trial <= most_trials, "the random cloud finds no place for {} grain(s) within {:.4g} m in {} trials",
           clump.grain.size(), clump.radius, most_trials);
  for (std::size_t k = 0; k < at.size(); ++k) place(placed, clump.grain[k], at[k]);
}

/// Grains of their own size, before the cloud is scattered around them.
void place_added(PlacedGrains& placed, const PackingSource& source, Random& random) {
  int grain = source.count;
  for (const AddedGrains& added : source.added)
    for (int k = 0; k < added.count; ++k, ++grain) {
      if (!added.at) {
        place_clump(placed, {.grain = {grain}, .offset = {Vec3{}}, .radius = added.radius}, random);
        continue;
      }
      Vec3 centre = placed.box.lower;
      const Vec3 size = placed.box.size();
      for (int axis = 0; axis < 3; ++axis) centre[axis] += (*added.at)[axis] * size[axis];
      require(is_free(placed, centre, added.radius), "grains.added: another grain lies at {:g}, {:g}, {:g} of the box",
              added.at->x, added.at->y, added.at->z);
      place(placed, grain, centre);
    }
}

}  // namespace

Packing random_cloud(const PackingSource& source, std::span<const Material> materials) {
  for (const MaterialShare& share : source.materials)
    require(share.material >= 0 && share.material < size_of(materials), "grains of material {} of {} materials", share.material,
            materials.size());
  const std::vector<double> graded = grain_radii(source.grading, source.count, source.seed);
  std::vector<int> material = assign_materials(graded, source.materials);
  std::vector<double> radius = graded;
  for (const AddedGrains& added : source.added) {
    require(added.material >= 0 && added.material < size_of(materials), "grains of material {} of {} materials", added.material,
            materials.size());
    require(added.radius > 0.0 && added.count > 0, "{} added grains of radius {} m", added.count, added.radius);
    require(!added.at || added.count == 1, "{} added grains cannot all lie at one place", added.count);
    radius.insert(radius.end(), to_size(added.count), added.radius);
    material.insert(material.end(), to_size(added.count), added.material);
  }
  const double largest = *std::max_element(radius.begin(), radius.end());
  PlacedGrains placed = empty_box(cloud_box(source, radius, largest), radius);
  Random random(source.seed ^ 0x636c6f7564ULL);
  place_added(placed, source, random);
  for (const Clump& clump : make_clumps(source, graded, random)) place_clump(placed, clump, random);
  Packing cloud;
  cloud.domain = placed.box;
  cloud.particles = make_particles(placed.position, radius, materials, material);
  cloud.report.grading_error = grading_error(source.grading, graded);
  cloud.report.porosity_box = porosity_of(cloud.particles.position, radius, cloud.domain);
  return cloud;
}

}  // namespace puadem
