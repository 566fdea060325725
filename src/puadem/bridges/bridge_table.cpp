#include "puadem/bridges/bridge_table.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <utility>

#include "puadem/base/error.hpp"
#include "puadem/base/parallel.hpp"

namespace puadem {

namespace {

using std::numbers::pi;

constexpr int ratios = 9;   // nodes of the ratio of radii
constexpr int stencil = 4;  // amounts that an interpolation uses
constexpr int values = 2 + 3 * bridge_terms;
constexpr double least_suction_of_table = 1.0, most_suction = 1e5, least_volume_of_table = 1e-12;
constexpr double most_volume = 0.16;            // larger ones engulf a sphere that touches a plane
constexpr double suction_of_most_volume = 0.2;  // of equal spheres that touch: where the liquid wets poorly, less 10 %

using Terms = std::array<double, bridge_terms>;

/// Place of node k of n, from 0 to 1, denser at both ends (Chebyshev, Gauss and Lobatto).
double lobatto(int k, int n) {
  const double s = std::sin(0.5 * pi * k / (n - 1));
  return s * s;
}

/// The ratio of radii as (|R_1 - R_2| / (R_1 + R_2))^(2/3): 0 for equal spheres, 1 for a plane. Rupture by a loss of
/// symmetry depends on the radii like this (theory 8.2).
double unlikeness(const std::array<double, 2>& radius) {
  const double ratio = std::min(radius[0], radius[1]) / std::max(radius[0], radius[1]);
  return std::pow((1.0 - ratio) / (1.0 + ratio), 2.0 / 3.0);
}

/// Ends of that unlikeness with R* = 1.
std::array<BridgeEnd, 2> ends_of(double unlike, double contact_angle) {
  const double difference = std::pow(unlike, 1.5);
  return {BridgeEnd{1.0 / (1.0 + difference), contact_angle},
          BridgeEnd{difference < 1.0 ? 1.0 / (1.0 - difference) : std::numeric_limits<double>::infinity(), contact_angle}};
}

/// Nodes are evenly spaced in the logarithm of the volume, or of a suction to which a few are added: below, bridges change
/// with the suction itself.
double offset(BridgeControl control) { return control == BridgeControl::suction ? 2.0 : 0.0; }

double natural_reach(const SmallBridge& small, BridgeControl control, double amount) {
  return control == BridgeControl::suction ? small.zero_gap(0.0) : std::cbrt(amount);
}

double natural_content(const SmallBridge& small, BridgeControl control, double radius, double gap) {
  const double zero = small.zero_gap(gap);
  return control == BridgeControl::suction ? 0.5 * pi * radius * (zero - gap) * (zero + gap) : 2.0 * small.cosine / zero;
}

/// Work of the small bridge from `gap` to `reach` over gamma.
double natural_work(const SmallBridge& small, double gap, double reach) {
  const double span = reach - gap;
  if (small.linear == 0.0) return 2.0 * pi * small.pull * span * (1.0 - 0.5 * (reach + gap) / small.zero_gap(0.0));
  return 2.0 * pi * small.pull * span * (1.0 - (reach + gap) / (small.zero_gap(reach) + small.zero_gap(gap)));
}

/// The polynomial in 2 zeta - 1 through values at the Lobatto nodes: by Chebyshev's series, then in powers, which two short
/// chains of products evaluate.
Terms powers(const Terms& value) {
  constexpr int last = bridge_terms - 1;
  Terms result{}, before{}, chebyshev{};  // T_(k-1) and T_k in powers
  for (int k = 0; k <= last; ++k) {
    Terms next{};
    if (k == 0) next[0] = 1.0;
    if (k == 1) next[1] = 1.0;
    for (int power = 0; k > 1 && power < last; ++power) next[to_size(power + 1)] = 2.0 * chebyshev[to_size(power)];
    for (int power = 0; k > 1 && power <= last; ++power) next[to_size(power)] -= before[to_size(power)];
    before = std::exchange(chebyshev, next);
    double sum = 0.0;
    for (int j = 0; j <= last; ++j)
      sum += (j == 0 || j == last ? 0.5 : 1.0) * value[to_size(j)] * std::cos(pi * k * (last - j) / last);
    sum *= (k == 0 || k == last ? 1.0 : 2.0) / last;
    for (int power = 0; power <= k; ++power) result[to_size(power)] += sum * chebyshev[to_size(power)];
  }
  return result;
}

double series(const Terms& terms, double zeta) {
  static_assert(bridge_terms % 2 == 0);
  const double z = 2.0 * zeta - 1.0, square = z * z;
  double even = 0.0, odd = 0.0;
  for (std::size_t k = bridge_terms; k > 0; k -= 2) {
    odd = odd * square + terms[k - 1];
    even = even * square + terms[k - 2];
  }
  return even + z * odd;
}

double series_slope(const Terms& terms, double zeta) {  // over zeta
  double slope = 0.0;
  for (int k = bridge_terms - 1; k > 0; --k) slope = slope * (2.0 * zeta - 1.0) + k * terms[to_size(k)];
  return 2.0 * slope;
}

struct AmountWeights {
  int start;
  std::array<double, stencil> weight;
};

/// Lagrange's weights of the nodes around an amount.
AmountWeights amount_weights(const BridgeTable& table, double amount) {
  const double add = offset(table.control), span = std::log((table.most + add) / (table.least + add));
  const double place = (table.amounts - 1) / span * std::log((amount + add) / (table.least + add));
  AmountWeights w{std::clamp(static_cast<int>(place) - 1, 0, table.amounts - stencil), {}};
  for (int a = 0; a < stencil; ++a) {
    w.weight[to_size(a)] = 1.0;
    for (int b = 0; b < stencil; ++b)
      if (b != a) w.weight[to_size(a)] *= (place - w.start - b) / (a - b);
  }
  return w;
}

/// Barycentric weights of the Lobatto nodes.
std::array<double, ratios> ratio_weights(double unlike) {
  static const auto place = [] {
    std::array<double, ratios> p{};
    for (int k = 0; k < ratios; ++k) p[to_size(k)] = lobatto(k, ratios);
    return p;
  }();
  std::array<double, ratios> weight{};
  double sum = 0.0;
  for (int k = 0; k < ratios; ++k) {
    const double distance = unlike - place[to_size(k)];
    if (distance == 0.0) {
      weight.fill(0.0);
      weight[to_size(k)] = 1.0;
      return weight;
    }
    weight[to_size(k)] = (k % 2 ? -1.0 : 1.0) * (k == 0 || k == ratios - 1 ? 0.5 : 1.0) / distance;
    sum += weight[to_size(k)];
  }
  for (double& w : weight) w /= sum;
  return weight;
}

/// Solves one node and writes its values.
void solve_node(const std::array<BridgeEnd, 2>& ends, BridgeControl control, double amount, double* out) {
  const StableBranch branch = stable_branch(ends, control, amount);
  const SmallBridge small = small_bridge(ends, control, amount);
  const double reach = branch.rupture.gap;
  const double last = free_energy(branch, branch.rupture);
  Terms pull{}, content{}, work{};
  for (int k = 0; k < bridge_terms; ++k) {
    const double zeta = lobatto(k, bridge_terms), gap = k == bridge_terms - 1 ? 0.0 : reach * (1.0 - zeta * zeta);
    const BridgeShape shape = k == 0 ? branch.rupture : *bridge_on(branch, gap);
    const auto at = to_size(k);
    pull[at] = shape.pull / small.pull_at(gap);
    content[at] = (control == BridgeControl::suction ? shape.volume : shape.suction) / natural_content(small, control, 1.0, gap);
    work[at] = k == 0 ? pull[at] : (last - free_energy(branch, shape)) / natural_work(small, gap, reach);
  }
  *out++ = reach / natural_reach(small, control, amount);
  *out++ = branch.rupture.sides[0].volume / branch.rupture.volume;
  for (const Terms& terms : {powers(pull), powers(content), powers(work)}) out = std::ranges::copy(terms, out).out;
}

double zeta_of(const BridgeCurve& curve, double gap) {
  assert(gap <= curve.reach);
  return gap <= 0.0 ? 1.0 : std::sqrt((curve.reach - gap) / curve.reach);
}

}  // namespace

BridgeTable make_bridge_table(BridgeControl control, double contact_angle) {
  const double most_angle = 80.0;
  require(contact_angle >= 0.0 && contact_angle <= most_angle * pi / 180.0,
          "liquid bridges: contact angle {:g} deg must lie in [0, {:g}]", contact_angle * 180.0 / pi, most_angle);
  BridgeTable table{control, contact_angle, least_suction_of_table, most_suction, 48, {}};
  if (control == BridgeControl::volume) {
    table.least = least_volume_of_table;
    table.amounts = 25;
    const StableBranch poor = stable_branch(ends_of(0.0, contact_angle), BridgeControl::suction, suction_of_most_volume);
    table.most = std::min(most_volume, 0.9 * bridge_on(poor, 0.0)->volume);
  }
  const double add = offset(control), span = std::log((table.most + add) / (table.least + add));
  table.node.resize(to_size(ratios * table.amounts * values));
  parallel_for(
      ratios * table.amounts,
      [&](int n) {
        const double share = static_cast<double>(n % table.amounts) / (table.amounts - 1);
        solve_node(ends_of(lobatto(n / table.amounts, ratios), contact_angle), control,
                   (table.least + add) * std::exp(share * span) - add, &table.node[to_size(n * values)]);
      },
      1);
  return table;
}

BridgeCurve bridge_curve(const BridgeTable& table, const std::array<double, 2>& radius, double amount) {
  const std::array<BridgeEnd, 2> ends{BridgeEnd{radius[0], table.contact_angle}, BridgeEnd{radius[1], table.contact_angle}};
  const double length = reduced_radius(ends), cube = length * length * length;
  const double scaled = table.control == BridgeControl::suction ? amount * length : amount / cube;
  require(scaled >= table.least && scaled <= table.most,
          "liquid bridge between radii of {:g} and {:g} m: {} {:g} must lie in [{:g}, {:g}]", radius[0], radius[1],
          table.control == BridgeControl::suction ? "p_c R*/gamma =" : "V/R*^3 =", scaled, table.least, table.most);

  const auto [start, along] = amount_weights(table, scaled);
  const auto across = ratio_weights(unlikeness(radius));
  std::array<double, values> mean{};
  for (int k = 0; k < ratios; ++k)
    for (int a = 0; a < stencil; ++a) {
      const double weight = across[to_size(k)] * along[to_size(a)];
      const double* node = &table.node[to_size((k * table.amounts + start + a) * values)];
      for (int v = 0; v < values; ++v) mean[to_size(v)] += weight * node[v];
    }

  BridgeCurve curve{0.0, small_bridge(ends, table.control, amount), {}, {}, {}, 0.0, table.control};
  curve.reach = mean[0] * natural_reach(curve.small, table.control, amount);
  curve.share = radius[0] <= radius[1] ? mean[1] : 1.0 - mean[1];
  const double* from = &mean[2];
  for (Terms* terms : {&curve.pull, &curve.content, &curve.work}) {
    std::copy(from, from + bridge_terms, terms->begin());
    from += bridge_terms;
  }
  return curve;
}

double bridge_pull(const BridgeCurve& curve, double gap) {
  return curve.small.pull_at(std::max(gap, 0.0)) * series(curve.pull, zeta_of(curve, gap));
}

void bridge_forces(double surface_tension, std::span<const BridgeCurve> curve, std::span<const double> gap,
                   std::span<double> force) {
  const double factor = 2.0 * pi * surface_tension;
  parallel_for(size_of(curve), [&](int k) {
    const BridgeCurve& c = curve[to_size(k)];
    const double d = std::max(gap[to_size(k)], 0.0);
    if (d > c.reach) {
      force[to_size(k)] = 0.0;
      return;
    }
    const double zero = c.small.linear == 0.0 ? std::sqrt(c.small.constant) : std::sqrt(c.small.constant + d * d);
    force[to_size(k)] = factor * c.small.pull * (1.0 - d / zero) * series(c.pull, std::sqrt((c.reach - d) / c.reach));
  });
}

double bridge_pull_slope(const BridgeCurve& curve, double gap) {
  const double d = std::max(gap, 0.0), zeta = zeta_of(curve, gap), zero = curve.small.zero_gap(d);
  const double small_slope = -curve.small.pull * curve.small.constant / (zero * zero * zero);
  return small_slope * series(curve.pull, zeta) -
         curve.small.pull_at(d) * series_slope(curve.pull, zeta) / (2.0 * zeta * curve.reach);
}

double bridge_content(const BridgeCurve& curve, double gap) {
  const double radius = curve.small.pull / curve.small.cosine;
  return natural_content(curve.small, curve.control, radius, std::max(gap, 0.0)) * series(curve.content, zeta_of(curve, gap));
}

double bridge_work(const BridgeCurve& curve, double gap) {
  return natural_work(curve.small, std::max(gap, 0.0), curve.reach) * series(curve.work, zeta_of(curve, gap));
}

}  // namespace puadem
