#include "puadem/flow/cooperative_filling.hpp"

#include <cmath>

#include "puadem/base/random.hpp"

namespace puadem {

namespace {

/// Turns of a weight from 0 to 1 and back while its ratio of radii changes by 1: many, so that the weights of neighbours have
/// nothing to do with one another, but few enough for rounding and for grains that move a little.
constexpr double turns = 1000.0;

double zigzag(double x) { return std::abs(2.0 * (x - std::floor(x)) - 1.0); }

}  // namespace

std::vector<double> filling_shares(const PoreNetwork& network, const PoreLinks& links, const Fluids& fluids, std::uint64_t seed) {
  std::vector<double> shares(links.link.size());
  const double rate = turns * Random(seed).uniform(1.0, 2.0);
  for (int i = 0; i < network.pores(); ++i) {
    const double radius = network.pore_radius[to_size(i)];
    for (int k = links.start[to_size(i)]; k < links.start[to_size(i) + 1]; ++k) {
      const auto [neighbour, throat] = links.link[to_size(k)];
      const double entry = network.throat_entry_radius[to_size(throat)];
      const double weight = zigzag(rate * (entry + network.pore_radius[to_size(neighbour)]) / radius);
      shares[to_size(k)] = weight * 2.0 * entry * std::cos(fluids.contact_angle) / radius;
    }
  }
  return shares;
}

double refill_pressure(std::span<const double> shares, const PoreLinks& links, const FluidClusters& gas, double body_pressure,
                       int pore) {
  if (shares.empty()) return body_pressure;
  int open = 0;
  double sum = 0.0;
  for (int k = links.start[to_size(pore)]; k < links.start[to_size(pore) + 1]; ++k) {
    if (!gas.passes[to_size(links.link[to_size(k)].throat)]) continue;
    ++open;
    sum += shares[to_size(k)];
  }
  return open < 2 ? body_pressure : body_pressure / (1.0 + (open - 1.0) / open * sum);
}

}  // namespace puadem
