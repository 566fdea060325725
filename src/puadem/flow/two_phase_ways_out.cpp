#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "puadem/base/disjoint_sets.hpp"
#include "puadem/base/error.hpp"
#include "puadem/flow/two_phase_step.hpp"
#include "puadem/flow/two_phase_system.hpp"

namespace puadem {

namespace {

/// Volume rates of a part sum to nothing up to this share of their magnitudes.
constexpr double rounding = 1e-12;

/// Parts within which volume can be passed on: fluids of neighbours through throats, and the two fluids of a pore. The wetting
/// fluid of pore i is i, the other n + i.
DisjointSets passing_parts(const PoreNetwork& network, const TwoPhaseModel& model, const TwoPhaseState& state) {
  const int n = network.pores();
  DisjointSets parts(2 * n);
  const TwoPhaseConductances k = two_phase_conductances(network, model, state);
  for (int t = 0; t < network.throats(); ++t) {
    const auto [i, j] = network.throat_pores[to_size(t)];
    if (k.wetting[to_size(t)] > 0.0) parts.join(i, j);
    if (k.nonwetting[to_size(t)] > 0.0) parts.join(n + i, n + j);
  }
  for (int i = 0; i < n; ++i)
    if (model.is_counted(i) && state.wetting.holds[to_size(i)] && state.nonwetting.holds[to_size(i)]) parts.join(i, n + i);
  for (const FlowBoundary& boundary : model.boundaries) {
    const int shift = boundary.fluid == FluidPhase::wetting ? 0 : n;
    for (const int i : boundary.pores) parts.join(shift + boundary.pores.front(), shift + i);
  }
  return parts;
}

}  // namespace

std::string closed_off_parts(const PoreNetwork& network, const TwoPhaseModel& model, const PoreRates& rates,
                             const TwoPhaseState& state) {
  const int n = network.pores();
  DisjointSets parts = passing_parts(network, model, state);
  std::vector<std::uint8_t> yields(to_size(2 * n));
  for (const FlowBoundary& boundary : model.boundaries)
    if (boundary.kind == FlowBoundary::Kind::pressure)
      yields[to_size(parts.find((boundary.fluid == FluidPhase::wetting ? 0 : n) + boundary.pores.front()))] = 1;
  const bool one_pressure = model.options.gas == GasKind::connected;
  for (int i = 0; i < n; ++i)
    if (state.nonwetting.holds[to_size(i)] && (one_pressure || state.gas_amount[to_size(i)] > 0.0))
      yields[to_size(parts.find(n + i))] = 1;
  std::vector<double> sum(to_size(2 * n)), magnitude(to_size(2 * n));
  const auto part = [&](int i) { return to_size(parts.find(state.wetting.holds[to_size(i)] ? i : n + i)); };
  for (int i = 0; i < n; ++i) {
    if (!model.is_counted(i)) continue;
    for (const auto given : {rates.volume, rates.uptake}) {
      if (given.empty()) continue;
      sum[part(i)] += given[to_size(i)];
      magnitude[part(i)] += std::abs(given[to_size(i)]);
    }
  }
  std::vector<int> stuck;
  for (int i = 0; i < n; ++i)
    if (model.is_counted(i) && !yields[part(i)] && std::abs(sum[part(i)]) > rounding * magnitude[part(i)]) stuck.push_back(i);
  if (stuck.empty()) return {};
  constexpr std::size_t named = 8;
  const auto first = std::span(stuck).first(std::min(stuck.size(), named));
  return fmt::format(
      "{} {}{} can pass no fluid to a boundary, and the fluids there do not yield, but the volume changes by {:.4g} m3/s in the "
      "part of pore {}",
      stuck.size() == 1 ? "pore" : "pores", fmt::join(first, ", "),
      stuck.size() > named ? fmt::format(" and {} more", stuck.size() - named) : "", sum[part(stuck.front())], stuck.front());
}

std::string unmet_rates(const PoreNetwork& network, const TwoPhaseModel& model, const BoundaryValues& values,
                        const TwoPhaseState& state) {
  const int n = network.pores();
  DisjointSets parts = passing_parts(network, model, state);
  std::vector<std::uint8_t> yields(to_size(2 * n));
  for (const FlowBoundary& boundary : model.boundaries)
    if (boundary.kind == FlowBoundary::Kind::pressure)
      yields[to_size(parts.find((boundary.fluid == FluidPhase::wetting ? 0 : n) + boundary.pores.front()))] = 1;
  std::string text;
  for (int b = 0; b < size_of(model.boundaries); ++b) {
    const FlowBoundary& boundary = model.boundaries[to_size(b)];
    if (boundary.kind == FlowBoundary::Kind::pressure || values[to_size(b)] == 0.0) continue;
    const bool wets = boundary.fluid == FluidPhase::wetting;
    const int part = parts.find((wets ? 0 : n) + boundary.pores.front());
    int pores = 0, both = 0;
    double void_volume = 0.0, water = 0.0;
    for (int i = 0; i < n; ++i) {
      if (!model.is_counted(i) || parts.find((wets ? 0 : n) + i) != part) continue;
      ++pores;
      if (!state.wetting.holds[to_size(i)] || !state.nonwetting.holds[to_size(i)]) continue;
      ++both;
      void_volume += network.pore_volume[to_size(i)];
      water += state.wetting_volume[to_size(i)];
    }
    text += fmt::format("{}boundary \"{}\" cannot pass {:.4g} m3/s of the {} fluid, which has the pressure {:.4g} Pa there: ",
                        text.empty() ? "" : "; ", boundary.name, values[to_size(b)], wets ? "wetting" : "non-wetting",
                        state.boundary_pressure[to_size(b)]);
    if (pores == 0)
      text += "none of it is within reach";
    else if (!yields[to_size(part)])
      text += fmt::format("the {} pores within reach are cut off from all boundaries with a pressure", pores);
    else if (both == 0)
      text += fmt::format("the {} pores within reach hold one fluid alone, and the other comes too slowly", pores);
    else
      text += fmt::format(
          "of the {} pores within reach {} hold both fluids, with a mean saturation of {:.3g}; the fluid there runs out, or its "
          "ways conduct too little",
          pores, both, water / void_volume);
  }
  return text;
}

}  // namespace puadem
