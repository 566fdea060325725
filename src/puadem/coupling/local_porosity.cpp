#include "puadem/coupling/local_porosity.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "puadem/dem/sphere_in_box.hpp"

namespace puadem {

namespace {

constexpr double grains_of_block = 24.0;  // at least

/// Place as fractions of the box.
Vec3 fraction_of(const Vec3& x, const Domain& domain) {
  const Vec3 from = x - domain.lower, size = domain.size();
  return {from.x / size.x, from.y / size.y, from.z / size.z};
}

int number(const std::array<int, 3>& block, const std::array<int, 3>& counts) {
  return (block[2] * counts[1] + block[1]) * counts[0] + block[0];
}

/// Block that a point lies in; one on the far side of a wall, by rounding, is of the block beside it.
int block_of(const Vec3& x, const Domain& domain, const std::array<int, 3>& counts) {
  const Vec3 fraction = fraction_of(x, domain);
  std::array<int, 3> block{};
  for (int a = 0; a < 3; ++a) {
    const int n = counts[to_size(a)];
    const double f = domain.periodic[to_size(a)] ? fraction[a] - std::floor(fraction[a]) : fraction[a];
    block[to_size(a)] = std::clamp(static_cast<int>(f * n), 0, n - 1);
  }
  return number(block, counts);
}

/// Blocks along one axis that a grain reaches; beyond the ends where the axis is periodic.
std::array<int, 2> reach(double centre, double radius, const Domain& domain, int axis, int n) {
  const double side = domain.size()[axis] / n, from = centre - domain.lower[axis];
  const int first = static_cast<int>(std::floor((from - radius) / side)),
            last = static_cast<int>(std::floor((from + radius) / side));
  if (domain.periodic[to_size(axis)]) return {first, last};
  return {std::max(first, 0), std::min(last, n - 1)};
}

/// Ranks from 0, those of equal values their mean.
std::vector<double> ranks_of(std::span<const double> values) {
  std::vector<int> order(values.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, {}, [&](int k) { return values[to_size(k)]; });
  std::vector<double> rank(values.size());
  for (std::size_t first = 0, end = 0; first < order.size(); first = end) {
    while (end < order.size() && values[to_size(order[end])] == values[to_size(order[first])]) ++end;
    for (std::size_t k = first; k < end; ++k) rank[to_size(order[k])] = 0.5 * static_cast<double>(first + end - 1);
  }
  return rank;
}

}  // namespace

std::array<int, 3> block_counts(const Domain& domain, int grains) {
  const double side = std::cbrt(domain.volume() * grains_of_block / grains);
  std::array<int, 3> counts{};
  for (int a = 0; a < 3; ++a) counts[to_size(a)] = std::max(1, static_cast<int>(domain.size()[a] / side));
  return counts;
}

std::vector<double> block_porosities(std::span<const Vec3> centre, std::span<const double> radius, const Domain& domain,
                                     const std::array<int, 3>& blocks) {
  const Vec3 size = domain.size();
  const Vec3 side{size.x / blocks[0], size.y / blocks[1], size.z / blocks[2]};
  std::vector<double> solid(to_size(blocks[0] * blocks[1] * blocks[2]), 0.0);
  for (std::size_t k = 0; k < centre.size(); ++k) {
    std::array<std::array<int, 2>, 3> range{};
    for (int a = 0; a < 3; ++a) range[to_size(a)] = reach(centre[k][a], radius[k], domain, a, blocks[to_size(a)]);
    for (int z = range[2][0]; z <= range[2][1]; ++z)
      for (int y = range[1][0]; y <= range[1][1]; ++y)
        for (int x = range[0][0]; x <= range[0][1]; ++x) {
          Domain block;
          block.lower = domain.lower + Vec3{x * side.x, y * side.y, z * side.z};
          block.upper = block.lower + side;
          const auto wrapped = [](int i, int n) { return (i % n + n) % n; };
          const int into = number({wrapped(x, blocks[0]), wrapped(y, blocks[1]), wrapped(z, blocks[2])}, blocks);
          solid[to_size(into)] += sphere_volume_in_box(centre[k], radius[k], block);
        }
  }
  for (double& s : solid) s = 1.0 - s / (side.x * side.y * side.z);
  return solid;
}

std::vector<double> block_saturations(const PoreNetwork& network, const CellGeometry& cells, std::span<const double> saturation,
                                      std::span<const std::uint8_t> is_counted, const Domain& domain,
                                      const std::array<int, 3>& blocks) {
  struct Held {
    double water = 0.0, space = 0.0;  // [m3]
    double saturation() const { return water / space; }
  };
  std::vector<Held> counted(to_size(blocks[0] * blocks[1] * blocks[2])), all = counted;
  for (std::size_t c = 0; c < cells.centroid.size(); ++c) {
    const auto block = to_size(block_of(cells.centroid[c], domain, blocks)), pore = to_size(network.tetrahedron_pore[c]);
    const auto add_to = [&](Held& held) {
      held.space += cells.void_volume[c];
      held.water += cells.void_volume[c] * saturation[pore];
    };
    add_to(all[block]);
    if (is_counted[pore]) add_to(counted[block]);
  }
  std::vector<double> local(all.size());
  for (std::size_t b = 0; b < all.size(); ++b) local[b] = counted[b].space > 0.0 ? counted[b].saturation() : all[b].saturation();
  return local;
}

Displacements displacements(std::span<const Vec3> before, const Domain& domain_before, std::span<const Vec3> now,
                            const Domain& domain_now) {
  const Vec3 size = domain_now.size();
  Displacements moved{std::vector<Vec3>(now.size()), std::vector<Vec3>(now.size())};
  for (std::size_t k = 0; k < now.size(); ++k) {
    const Vec3 from = fraction_of(before[k], domain_before), to = fraction_of(now[k], domain_now);
    for (int a = 0; a < 3; ++a) {
      double way = to[a] - from[a];
      if (domain_now.periodic[to_size(a)]) way -= std::nearbyint(way);
      moved.beyond_box[k][a] = way * size[a];
      moved.total[k][a] = domain_now.lower[a] + (from[a] + way) * size[a] - before[k][a];
    }
  }
  return moved;
}

void add_grains(std::span<const Vec3> centre, std::span<const Vec3> beyond_box, const Domain& domain,
                const std::array<int, 3>& counts, std::span<LocalBlock> blocks) {
  for (std::size_t k = 0; k < centre.size(); ++k) {
    LocalBlock& block = blocks[to_size(block_of(centre[k], domain, counts))];
    ++block.grains;
    block.displacement += beyond_box[k];
  }
  for (LocalBlock& block : blocks)
    if (block.grains > 0) block.displacement = block.displacement / block.grains;
}

std::optional<double> rank_correlation(std::span<const double> a, std::span<const double> b) {
  const std::vector<double> x = ranks_of(a), y = ranks_of(b);
  const double mean = 0.5 * (static_cast<double>(x.size()) - 1.0);
  double xx = 0.0, yy = 0.0, xy = 0.0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    xx += (x[k] - mean) * (x[k] - mean);
    yy += (y[k] - mean) * (y[k] - mean);
    xy += (x[k] - mean) * (y[k] - mean);
  }
  if (!(xx > 0.0 && yy > 0.0)) return std::nullopt;
  return xy / std::sqrt(xx * yy);
}

}  // namespace puadem
