#include "puadem/io/section_map.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "puadem/base/csr.hpp"

namespace puadem {
namespace {

/// Pores in cubic bins, to find the one of least power without looking at all.
struct PoreBins {
  Vec3 lower;
  double side = 0.0, largest = 0.0;  ///< side of a bin, largest pore radius [m]
  std::array<int, 3> count{};
  Csr pores;

  std::array<int, 3> bin_of(const Vec3& x) const {
    std::array<int, 3> bin{};
    for (int a = 0; a < 3; ++a)
      bin[to_size(a)] = std::clamp(static_cast<int>(std::floor((x[a] - lower[a]) / side)), 0, count[to_size(a)] - 1);
    return bin;
  }
  int number(int x, int y, int z) const { return (z * count[1] + y) * count[0] + x; }
};

PoreBins make_bins(const PoreNetwork& network, const Domain& domain) {
  PoreBins bins;
  bins.lower = domain.lower;
  bins.side = 2.0 * std::cbrt(domain.volume() / std::max(network.pores(), 1));
  for (const double r : network.pore_radius) bins.largest = std::max(bins.largest, r);
  for (int a = 0; a < 3; ++a) bins.count[to_size(a)] = std::max(1, static_cast<int>(std::ceil(domain.size()[a] / bins.side)));
  std::vector<int> bin(to_size(network.pores()));
  for (int i = 0; i < network.pores(); ++i) {
    const auto [x, y, z] = bins.bin_of(network.pore_centre[to_size(i)]);
    bin[to_size(i)] = bins.number(x, y, z);
  }
  bins.pores = rows_from(bin, bins.count[0] * bins.count[1] * bins.count[2]);
  return bins;
}

/// The pore of least power: bins in growing shells, until none further out can hold it.
int least_power(const PoreNetwork& network, const PoreBins& bins, const Vec3& at) {
  const auto [bx, by, bz] = bins.bin_of(at);
  double best = std::numeric_limits<double>::infinity();
  int found = -1;
  for (int shell = 0; shell <= std::max({bins.count[0], bins.count[1], bins.count[2]}); ++shell) {
    const double reach = std::max(0, shell - 1) * bins.side;
    if (found >= 0 && reach * reach - bins.largest * bins.largest > best) break;
    for (int z = std::max(0, bz - shell); z <= std::min(bins.count[2] - 1, bz + shell); ++z)
      for (int y = std::max(0, by - shell); y <= std::min(bins.count[1] - 1, by + shell); ++y)
        for (int x = std::max(0, bx - shell); x <= std::min(bins.count[0] - 1, bx + shell); ++x) {
          if (std::max({std::abs(x - bx), std::abs(y - by), std::abs(z - bz)}) != shell) continue;
          for (const int i : bins.pores[bins.number(x, y, z)]) {
            const double radius = network.pore_radius[to_size(i)];
            const double power = squared_norm(at - network.pore_centre[to_size(i)]) - radius * radius;
            if (power < best) {
              best = power;
              found = i;
            }
          }
        }
  }
  return found;
}

constexpr int planes_of_thin_box = 8;

/// Place of a plane along the axis [m].
double plane_place(const SectionMap& map, const Domain& domain, int plane) {
  return domain.lower[map.axis] + (plane + 0.5) / map.planes * domain.size()[map.axis];
}

/// Calls `visit(pixel)` for all pixels whose centres a grain covers in the plane.
template <class Visit>
void cover(const SectionMap& map, const Domain& domain, double plane, const Vec3& centre, double radius, const Visit& visit) {
  const double off = centre[map.axis] - plane, disc = radius * radius - off * off;
  if (disc <= 0.0) return;
  const double x = centre[(map.axis + 1) % 3] - domain.lower[(map.axis + 1) % 3];
  const double y = centre[(map.axis + 2) % 3] - domain.lower[(map.axis + 2) % 3];
  const double reach = std::sqrt(disc) / map.pixel;
  const auto from = [&](double v) { return std::max(0, static_cast<int>(std::floor(v / map.pixel - reach))); };
  const auto to = [&](double v, int n) { return std::min(n - 1, static_cast<int>(std::ceil(v / map.pixel + reach))); };
  for (int row = from(y); row <= to(y, map.rows); ++row)
    for (int column = from(x); column <= to(x, map.columns); ++column) {
      const double dx = (column + 0.5) * map.pixel - x, dy = (row + 0.5) * map.pixel - y;
      if (dx * dx + dy * dy < disc) visit(to_size(row * map.columns + column));
    }
}

}  // namespace

SectionMap cut_section(const State& state, int columns) {
  const Domain& domain = state.domain;
  const Vec3 size = domain.size();
  SectionMap map;
  for (int a = 0; a < 3; ++a)
    if (size[a] < size[map.axis]) map.axis = a;
  map.planes = planes_of_thin_box;
  if (!is_thin(domain)) {  // the upright plane shows more
    map.axis = 0;
    map.planes = 1;
  }
  const int across = (map.axis + 1) % 3, along = (map.axis + 2) % 3;
  map.pixel = std::max(size[across], size[along]) / columns;
  map.columns = std::max(1, static_cast<int>(std::lround(size[across] / map.pixel)));
  map.rows = std::max(1, static_cast<int>(std::lround(size[along] / map.pixel)));
  const int pixels = map.columns * map.rows;
  map.pore.assign(to_size(pixels * map.planes), 0);
  const Particles& grains = state.particles;
  for (int plane = 0; plane < map.planes; ++plane)
    for (int k = 0; k < grains.size(); ++k)
      cover(map, domain, plane_place(map, domain, plane), grains.position[to_size(k)], grains.radius[to_size(k)],
            [&](std::size_t pixel) { map.pore[to_size(plane * pixels) + pixel] = -1; });
  const PoreBins bins = make_bins(state.network, domain);
  parallel_for(size_of(map.pore), [&](int k) {
    if (map.pore[to_size(k)] < 0) return;
    const int pixel = k % pixels;
    Vec3 at;
    at[map.axis] = plane_place(map, domain, k / pixels);
    at[across] = domain.lower[across] + (pixel % map.columns + 0.5) * map.pixel;
    at[along] = domain.lower[along] + (pixel / map.columns + 0.5) * map.pixel;
    map.pore[to_size(k)] = least_power(state.network, bins, at);
  });
  return map;
}

std::string section_picture(const SectionMap& map, const std::vector<double>& saturation) {
  constexpr const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const std::size_t pixels = map.pore.size() / to_size(map.planes);
  const auto byte = [&](std::size_t pixel) -> unsigned {
    double sum = 0.0;
    int in_void = 0;
    for (std::size_t k = pixel; k < map.pore.size(); k += pixels) {
      if (map.pore[k] < 0) continue;
      sum += saturation[to_size(map.pore[k])];
      ++in_void;
    }
    return in_void == 0 ? 255u : static_cast<unsigned>(std::lround(254.0 * sum / in_void));
  };
  std::string text;
  for (std::size_t k = 0; k < pixels; k += 3) {
    const std::size_t left = std::min<std::size_t>(3, pixels - k);
    const unsigned word = byte(k) << 16 | (left > 1 ? byte(k + 1) << 8 : 0u) | (left > 2 ? byte(k + 2) : 0u);
    text += digits[word >> 18];
    text += digits[word >> 12 & 63];
    text += left > 1 ? digits[word >> 6 & 63] : '=';
    text += left > 2 ? digits[word & 63] : '=';
  }
  return text;
}

std::vector<CutGrain> cut_grains(const State& state, const SectionMap& map, const std::vector<Vec3>& force,
                                 const std::vector<Vec3>& displacement) {
  const int across = (map.axis + 1) % 3, up = (map.axis + 2) % 3;
  const Vec3 lower = state.domain.lower;
  const double plane = 0.5 * (lower[map.axis] + state.domain.upper[map.axis]);
  std::vector<CutGrain> cut;
  for (std::size_t k = 0; k < force.size(); ++k) {
    const Vec3 place = state.particles.position[k] - lower;
    const double off = place[map.axis] + lower[map.axis] - plane, r = state.particles.radius[k];
    if (std::abs(off) < r)
      cut.push_back({place[across], place[up], std::sqrt(r * r - off * off), force[k][across], force[k][up],
                     displacement[k][across], displacement[k][up]});
  }
  return cut;
}

}  // namespace puadem
