#include "puadem/flow/invasion_pattern.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "puadem/base/error.hpp"

namespace puadem {

namespace {

/// Boxes of `side` pixels with an invaded pixel, the grid moved back by (dx, dy) pixels.
int boxes_hit(const PatternImage& image, int side, int dx, int dy) {
  const int across = (image.columns + dx + side - 1) / side, along = (image.rows + dy + side - 1) / side;
  std::vector<std::uint8_t> hit(to_size(across * along));
  for (int y = 0; y < image.rows; ++y)
    for (int x = 0; x < image.columns; ++x)
      if (image.at(x, y)) hit[to_size((y + dy) / side * across + (x + dx) / side)] = 1;
  return static_cast<int>(std::ranges::count(hit, std::uint8_t{1}));
}

double slope_of(std::span<const double> x, std::span<const double> y) {
  const double n = static_cast<double>(x.size());
  double sx = 0.0, sy = 0.0, sxx = 0.0, sxy = 0.0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    sx += x[k];
    sy += y[k];
    sxx += x[k] * x[k];
    sxy += x[k] * y[k];
  }
  return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

/// Changes between invaded and not, from each pixel to the one (dx, dy) further.
long changes(const PatternImage& image, int dx, int dy) {
  long found = 0;
  for (int y = 0; y + dy < image.rows; ++y)
    for (int x = std::max(0, -dx); x < image.columns - std::max(0, dx); ++x)
      found += image.at(x, y) != image.at(x + dx, y + dy) ? 1 : 0;
  return found;
}

}  // namespace

double pore_spacing(const PoreNetwork& network, const Domain& domain) {
  return std::cbrt(domain.volume() / std::max(network.pores(), 1));
}

PatternImage project_pattern(const PoreNetwork& network, const Domain& domain, int axis, std::span<const std::uint8_t> invaded,
                             double pixel, double share) {
  require(std::isfinite(pixel) && pixel > 0.0, "a pixel of {} m; it must be positive", pixel);
  const int across = (axis + 1) % 3, along = (axis + 2) % 3;
  const Vec3 size = domain.size();
  PatternImage image;
  image.columns = std::max(1, static_cast<int>(std::lround(size[across] / pixel)));
  image.pixel = size[across] / image.columns;
  image.rows = std::max(1, static_cast<int>(std::ceil(size[along] / image.pixel * (1.0 - 1e-12))));
  std::vector<double> total(to_size(image.columns * image.rows)), gas(total.size());
  const auto place = [&](double x, int count) { return std::clamp(static_cast<int>(std::floor(x / image.pixel)), 0, count - 1); };
  for (int i = 0; i < network.pores(); ++i) {
    const Vec3 at = network.pore_centre[to_size(i)] - domain.lower;
    const std::size_t k = to_size(place(at[along], image.rows) * image.columns + place(at[across], image.columns));
    total[k] += network.pore_volume[to_size(i)];
    if (invaded[to_size(i)]) gas[k] += network.pore_volume[to_size(i)];
  }
  image.invaded.resize(total.size());
  for (std::size_t k = 0; k < total.size(); ++k) image.invaded[k] = gas[k] > share * total[k];
  return image;
}

BoxCount count_boxes(const PatternImage& image) {
  constexpr int most_shifts = 8;  // in each direction
  BoxCount count;
  std::vector<double> log_size, log_boxes;
  for (int side = 1; side <= std::max(1, std::min(image.columns, image.rows) / 4); side *= 2) {
    int least = std::numeric_limits<int>::max();
    const int stride = std::max(1, side / most_shifts);
    for (int dy = 0; dy < side; dy += stride)
      for (int dx = 0; dx < side; dx += stride) least = std::min(least, boxes_hit(image, side, dx, dy));
    if (least == 0) return count;
    count.size.push_back(side * image.pixel);
    count.boxes.push_back(least);
    log_size.push_back(std::log(count.size.back()));
    log_boxes.push_back(std::log(count.boxes.back()));
  }
  if (log_size.size() > 1) count.dimension = -slope_of(log_size, log_boxes);
  return count;
}

double finger_width(const PatternImage& image) {
  const auto area = static_cast<double>(std::ranges::count_if(image.invaded, [](std::uint8_t p) { return p != 0; }));
  // Crofton: the perimeter is pi/2 times the mean over directions of crossings times the distance of the lines.
  const double crossings = static_cast<double>(changes(image, 1, 0) + changes(image, 0, 1)) +
                           static_cast<double>(changes(image, 1, 1) + changes(image, -1, 1)) / std::numbers::sqrt2;
  const double perimeter = 0.5 * std::numbers::pi * crossings / 4.0;
  return perimeter > 0.0 ? 2.0 * area / perimeter * image.pixel : 0.0;
}

}  // namespace puadem
