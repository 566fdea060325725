#include "puadem/bridges/stable_bridge.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "puadem/base/error.hpp"
#include "puadem/bridges/line_search.hpp"

namespace puadem {

namespace {

using std::numbers::pi;

// Lengths in units of R* from here on.
constexpr double least_volume = 1e-30;      // stands for no bridge at all
constexpr double beyond_contact = -1.0;     // gap where no bridge exists for so great a pull
constexpr double root_tolerance = 1e-13;    // of the suction of a given volume
constexpr double pull_tolerance = 1e-12;    // of the pull at a given gap
constexpr double maximum_tolerance = 1e-6;  // of the pull at rupture: mostly its gap is exact to the square

double mean_cosine(const std::array<BridgeEnd, 2>& ends) {
  return 0.5 * (std::cos(ends[0].contact_angle) + std::cos(ends[1].contact_angle));
}

BridgeShape scaled(BridgeShape s, double length) {
  const double area = length * length, volume = area * length;
  s.suction /= length;
  s.pull *= length;
  s.gap *= length;
  s.volume *= volume;
  s.neck_radius *= length;
  for (BridgeSide& side : s.sides) {
    side.reach *= length;
    side.volume *= volume;
    side.meniscus_area *= area;
    side.wetted_area *= area;
    side.contact_radius *= length;
    side.arc *= length;
  }
  return s;
}

/// At one pull the volume falls as the suction rises, nearly as its inverse square; where a bridge at the least suction
/// is too small, one end takes it on its wider circle and the suction rises again (theory 8.2).
/// @param start  a suction not far below that of the bridge: too low a one may belong to ends that overlap
std::optional<BridgeShape> bridge_of_volume(const std::array<BridgeEnd, 2>& ends, double volume, double pull,
                                            std::optional<double> start) {
  const std::array<double, 2> least{least_suction(ends[0], pull), least_suction(ends[1], pull)};
  const double lowest = std::max(least[0], least[1]), target = 1.0 / std::sqrt(volume);
  std::optional<BridgeShape> shape;
  std::optional<int> wide_end;
  const auto excess = [&](double suction) {
    shape = bridge_shape(ends, suction, pull, wide_end);
    return (shape && shape->volume > 0.0 ? 1.0 / std::sqrt(shape->volume) : 1.0 / least_volume) - target;
  };
  const auto between = [&](double a, double at_a, double b, double at_b) {
    const bool is_found = std::abs(excess(find_root(excess, a, at_a, b, at_b, root_tolerance))) < 1e-6 * target;
    return is_found ? shape : std::nullopt;
  };
  const double share = std::min(pull / mean_cosine(ends), 1.0);
  const double factor = 2.0 * mean_cosine(ends) * std::sqrt(0.5 * pi * share * (2.0 - share));  // p sqrt(V), theory 8.3
  double high = std::max(start ? *start : std::max(factor * target, 1.0), lowest), above = excess(high);
  for (double step = factor * std::abs(above); above < 0.0; step *= 2.0) {
    const double low = high, below = above;
    high += step;
    above = excess(high);
    if (above >= 0.0) return between(low, below, high, above);
  }
  // Down to the first crossing: beyond it lie bridges between ends that overlap.
  while (high > lowest) {
    const double size = std::max(std::abs(high), 0.3);
    const double low = std::max(high - std::clamp(1.1 * factor * above, 1e-3 * size, 0.1 * size), lowest), below = excess(low);
    if (below <= 0.0) return between(low, below, high, above);
    if (below > above) return std::nullopt;
    high = low, above = below;
  }
  wide_end = least[0] > least[1] ? 0 : 1;
  const double size = 1.0 + std::abs(lowest);
  for (double step = 1e-4 * size; step < size; step *= 2.0) {
    const double low = lowest + step, below = excess(low);
    if (below <= 0.0) return between(high, above, low, below);
    if (below > above) return std::nullopt;
    high = low, above = below;
  }
  return std::nullopt;
}

/// The bridges of one branch, in units of R*.
struct BridgeFamily {
  std::array<BridgeEnd, 2> ends;
  BridgeControl control;
  double amount;
  std::vector<std::array<double, 2>> found{};  // pull and suction
};

/// At one volume the suction rises with the pull: that of the next greater pull found so far is where the search begins.
std::optional<BridgeShape> bridge_with_pull(BridgeFamily& family, double pull) {
  if (family.control == BridgeControl::suction) return bridge_shape(family.ends, family.amount, pull);
  const std::array<double, 2>* next = nullptr;
  for (const auto& f : family.found)
    if (f[0] >= pull && (!next || f[0] < (*next)[0])) next = &f;
  const auto shape = bridge_of_volume(family.ends, family.amount, pull, next ? std::optional((*next)[1]) : std::nullopt);
  if (shape) family.found.push_back({pull, shape->suction});
  return shape;
}

std::string described(const BridgeFamily& family) {
  return fmt::format("{} {:g}", family.control == BridgeControl::suction ? "p_c R*/gamma =" : "V/R*^3 =", family.amount);
}

BridgeFamily family_of(const std::array<BridgeEnd, 2>& ends, BridgeControl control, double amount) {
  const double length = reduced_radius(ends);
  BridgeFamily f{ends, control, control == BridgeControl::suction ? amount * length : amount / (length * length * length)};
  for (BridgeEnd& end : f.ends) end.radius /= length;
  return f;
}

}  // namespace

StableBranch stable_branch(const std::array<BridgeEnd, 2>& ends, BridgeControl control, double amount) {
  for (const BridgeEnd& end : ends) {
    require(end.radius > 0.0, "liquid bridge: radius {} m must be positive", end.radius);
    require(end.contact_angle >= 0.0 && end.contact_angle < 0.5 * pi, "liquid bridge: contact angle {} deg must lie in [0, 90)",
            end.contact_angle * 180.0 / pi);
  }
  require(std::isfinite(reduced_radius(ends)), "liquid bridge: one of the ends must be a sphere");
  require(amount > 0.0 && std::isfinite(amount), "liquid bridge: {} {} must be positive",
          control == BridgeControl::suction ? "suction over surface tension" : "volume", amount);
  BridgeFamily unit = family_of(ends, control, amount);
  const auto gap = [&](double log_pull) {
    const auto shape = bridge_with_pull(unit, std::exp(log_pull));
    return shape ? shape->gap : beyond_contact;
  };
  const double greatest = mean_cosine(ends);
  const double least =
      0.05 * greatest * std::min(control == BridgeControl::suction ? std::cbrt(1.0 / unit.amount) : std::cbrt(unit.amount), 1.0);
  const double at = find_maximum(gap, std::log(least), std::log(greatest), maximum_tolerance);
  const auto rupture = bridge_with_pull(unit, std::exp(at));
  require(rupture && rupture->gap > 0.0, "liquid bridge: {} is too much for contact angles of {:g} and {:g} deg", described(unit),
          ends[0].contact_angle * 180.0 / pi, ends[1].contact_angle * 180.0 / pi);
  return {ends, control, amount, scaled(*rupture, reduced_radius(ends))};
}

std::optional<BridgeShape> bridge_on(const StableBranch& branch, double gap) {
  const double length = reduced_radius(branch.ends), target = std::max(gap, 0.0);
  if (target > branch.rupture.gap) return std::nullopt;
  BridgeFamily unit = family_of(branch.ends, branch.control, branch.amount);
  std::optional<BridgeShape> shape;
  const auto excess = [&](double pull) {
    shape = bridge_with_pull(unit, pull);
    return (shape ? shape->gap : beyond_contact) - target / length;
  };
  double limit = mean_cosine(branch.ends);
  if (branch.control == BridgeControl::suction)
    for (const BridgeEnd& end : unit.ends) limit = std::min(limit, greatest_pull(end, unit.amount));
  double low = branch.rupture.pull / length, below = excess(low);
  if (below <= 0.0) return branch.rupture;
  const SmallBridge small = small_bridge(unit.ends, unit.control, unit.amount);
  double high = std::min(std::max(small.pull_at(target / length), 1.1 * low), limit), above = excess(high);
  while (above >= 0.0 && high < limit) {
    low = high, below = above;
    high = std::min(1.2 * high, limit);
    above = excess(high);
  }
  if (above < 0.0) excess(find_root(excess, low, below, high, above, pull_tolerance));
  ensure(shape && std::abs(shape->gap - target / length) < 1e-6 * branch.rupture.gap / length,
         "liquid bridge: {} at a gap of {:g} R* is too much liquid for a bridge of these contact angles", described(unit),
         target / length);
  return scaled(*shape, length);
}

double free_energy(const StableBranch& branch, const BridgeShape& shape) {
  return surface_energy(branch.ends, shape) + (branch.control == BridgeControl::suction ? shape.suction * shape.volume : 0.0);
}

double SmallBridge::zero_gap(double gap) const { return std::sqrt(constant + linear * gap * gap); }
double SmallBridge::pull_at(double gap) const { return pull * (1.0 - gap / zero_gap(gap)); }

SmallBridge small_bridge(const std::array<BridgeEnd, 2>& ends, BridgeControl control, double amount) {
  const double radius = reduced_radius(ends), cosine = mean_cosine(ends);
  if (control == BridgeControl::suction) return {radius * cosine, 4.0 * cosine * cosine / (amount * amount), 0.0, cosine};
  return {radius * cosine, 2.0 * amount / (pi * radius), 1.0, cosine};
}

}  // namespace puadem
