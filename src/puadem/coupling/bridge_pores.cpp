#include "puadem/coupling/bridge_pores.hpp"

#include <algorithm>
#include <cmath>

#include "puadem/base/compensated_sum.hpp"
#include "puadem/coupling/capillary_forces.hpp"
#include "puadem/dem/bridge_exchange.hpp"
#include "puadem/dem/bridge_pairs.hpp"
#include "puadem/flow/two_phase_system.hpp"

namespace puadem {

namespace {

/// Name of a vertex as an end of a bridge; -1: a face without a wall.
int end_of(const Vertex& vertex, const GrainSystem& grains) {
  if (!vertex.is_wall()) return vertex.index;
  for (int w = 0; w < size_of(grains.walls); ++w)
    if (grains.walls[to_size(w)].face == vertex.face()) return grains.owned + w;
  return -1;
}

/// Puts water of a bridge into a pore; what a full pore or one without room is given goes on to the reservoir.
void pour(double volume, int pore, const PoreNetwork& network, const TwoPhaseModel& model, TwoPhaseState& flow) {
  const std::size_t p = to_size(pore);
  const bool takes = model.is_counted(pore) && flow.nonwetting.holds[p];
  const double room = takes ? std::max(network.pore_volume[p] - flow.wetting_volume[p], 0.0) : 0.0;
  const double taken = std::min(volume, room);
  flow.wetting_volume[p] += taken;
  if (taken > 0.0) {
    flow.wetting.holds[p] = 1;
    // The gas that makes room is the reservoir's.
    flow.ledger.nonwetting_out.add(taken);
  }
  flow.ledger.wetting_out.add(volume - taken);
}

/// Bridges that have to go hand their water to the wet pores around them, or where there is none to the reservoir.
void give_back(const Bridges& old, const std::vector<char>& stays, const EdgePores& edges, const std::vector<char>& dry,
               const PoreNetwork& network, const TwoPhaseModel& model, TwoPhaseState& flow) {
  for (int k = 0; k < old.size(); ++k) {
    if (stays[to_size(k)]) continue;
    const auto& ends = old.pairs.ends[to_size(k)];
    const auto found = std::ranges::lower_bound(edges.ends, ends);
    double wet = 0.0, left = old.volume[to_size(k)];
    int last = -1;
    if (found != edges.ends.end() && *found == ends) {
      const auto row = static_cast<std::size_t>(found - edges.ends.begin());
      const auto begin = to_size(edges.pores.start[row]), end = to_size(edges.pores.start[row + 1]);
      for (std::size_t e = begin; e < end; ++e)
        if (!dry[to_size(edges.pores.index[e])]) wet += edges.share[e];
      for (std::size_t e = begin; e < end; ++e) {
        const int pore = edges.pores.index[e];
        if (dry[to_size(pore)]) continue;
        const double part = old.volume[to_size(k)] * edges.share[e] / wet;
        if (last >= 0) {
          pour(part, last, network, model, flow);
          left -= part;
        }
        last = pore;
      }
    }
    if (last >= 0)
      pour(left, last, network, model, flow);
    else
      flow.ledger.wetting_out.add(left);
  }
}

/// Saturation that a pore of the water's reservoir would have at its capillary pressure if gas had entered it; the air's
/// reservoir is at pressure 0 [-].
double reservoir_saturation(const TwoPhaseModel& model, const TwoPhaseState& flow, int pore) {
  const double pc = -flow.wetting_pressure[to_size(pore)];
  return pc > model.thresholds.unit[to_size(pore)].threshold ? local_saturation(model, flow.nonwetting, pore, pc) : 1.0;
}

/// Saturation from which a pore takes in the bridges around it.
double limit_of(const TwoPhaseModel& model, const TwoPhaseState& flow, int pore, double coalescence) {
  if (std::isfinite(coalescence)) return coalescence;
  return local_saturation(model, flow.nonwetting, pore, model.thresholds.unit[to_size(pore)].threshold);
}

/// Edges whose pores are all dry.
std::vector<std::array<int, 2>> dry_edges(const EdgePores& edges, const std::vector<char>& dry) {
  std::vector<std::array<int, 2>> ends;
  for (int row = 0; row < edges.pores.rows(); ++row)
    if (std::ranges::all_of(edges.pores[row], [&](int pore) { return dry[to_size(pore)]; }))
      ends.push_back(edges.ends[to_size(row)]);
  return ends;
}

}  // namespace

EdgePores edge_pores(const PoreNetwork& network, const GrainSystem& grains) {
  struct Piece {
    std::array<int, 2> ends;
    int pore;
    double space;
  };
  std::vector<Piece> pieces;
  for (int c = 0; c < network.triangulation.cells(); ++c) {
    const auto& vertices = network.triangulation.vertices[to_size(c)];
    for (std::size_t a = 0; a < 4; ++a)
      for (std::size_t b = a + 1; b < 4; ++b) {
        const int i = end_of(vertices[a], grains), j = end_of(vertices[b], grains);
        if (i < 0 || j < 0 || i == j || (i >= grains.owned && j >= grains.owned)) continue;
        pieces.push_back(
            {{std::min(i, j), std::max(i, j)}, network.tetrahedron_pore[to_size(c)], network.tetrahedron_void[to_size(c)]});
      }
  }
  std::ranges::stable_sort(pieces, {}, [](const Piece& p) { return std::pair{p.ends, p.pore}; });
  EdgePores edges;
  edges.pores.start = {0};
  for (std::size_t begin = 0; begin < pieces.size();) {
    std::size_t end = begin;
    double space = 0.0;
    for (; end < pieces.size() && pieces[end].ends == pieces[begin].ends; ++end) space += std::max(pieces[end].space, 0.0);
    for (std::size_t k = begin; k < end; ++k) {
      const double share = space > 0.0 ? std::max(pieces[k].space, 0.0) / space : 1.0 / static_cast<double>(end - begin);
      if (k > begin && pieces[k].pore == pieces[k - 1].pore) {
        edges.share.back() += share;
      } else {
        edges.pores.index.push_back(pieces[k].pore);
        edges.share.push_back(share);
      }
    }
    edges.ends.push_back(pieces[begin].ends);
    edges.pores.start.push_back(size_of(edges.pores.index));
    begin = end;
  }
  return edges;
}

std::vector<char> dry_pores(const PoreNetwork& network, const TwoPhaseModel& model, const TwoPhaseState& flow,
                            double coalescence) {
  std::vector<char> dry(to_size(network.pores()));
  for (int p = 0; p < network.pores(); ++p) {
    const std::size_t at = to_size(p);
    const double limit = limit_of(model, flow, p, coalescence);
    if (model.is_counted(p))
      dry[at] = flow.nonwetting.holds[at] && flow.wetting_volume[at] < limit * network.pore_volume[at];
    else
      dry[at] = flow.nonwetting.holds[at] || reservoir_saturation(model, flow, p) < limit;
  }
  return dry;
}

std::vector<double> pendular_pressures(const PoreNetwork& network, const TwoPhaseModel& model, const TwoPhaseState& flow,
                                       double coalescence) {
  const std::vector<char> dry = dry_pores(network, model, flow, coalescence);
  std::vector<double> pressure = effective_pressures(network, model, flow);
  for (std::size_t p = 0; p < dry.size(); ++p)
    if (dry[p]) pressure[p] = flow.nonwetting.holds[p] ? flow.nonwetting_pressure[p] : 0.0;
  return pressure;
}

TwoPhaseState start_dry(const PoreNetwork& network, const TwoPhaseModel& model, double capillary_pressure) {
  TwoPhaseState state = start_two_phase(network, model);
  for (int p = 0; p < network.pores(); ++p) {
    if (!model.is_counted(p)) continue;
    const std::size_t at = to_size(p);
    const bool keeps = model.thresholds.keeps_water[at];
    state.nonwetting.holds[at] = 1;
    state.nonwetting_pressure[at] = 0.0;
    state.wetting.holds[at] = keeps;
    state.wetting_pressure[at] = -capillary_pressure;
    state.wetting_volume[at] =
        keeps ? local_saturation(model, state.nonwetting, p, capillary_pressure) * network.pore_volume[at] : 0.0;
  }
  for (int t = 0; t < network.throats(); ++t) {
    const auto [i, j] = network.throat_pores[to_size(t)];
    const bool is_open =
        state.nonwetting.holds[to_size(i)] && state.nonwetting.holds[to_size(j)] &&
        (state.nonwetting.passes[to_size(t)] ||
         (model.thresholds.may_open[to_size(t)] && model.thresholds.entry_pressure[to_size(t)] < capillary_pressure));
    set_open(network, model, t, is_open, state.wetting, state.nonwetting);
  }
  connect_all(model.links, state.wetting);
  connect_all(model.links, state.nonwetting);
  return state;
}

double follow_pores(const PendularOptions& options, double capillary_pressure, const PoreNetwork& network,
                    const TwoPhaseModel& model, TwoPhaseState& flow, GrainSystem& grains) {
  const EdgePores edges = edge_pores(network, grains);
  const std::vector<char> dry = dry_pores(network, model, flow, options.coalescence);
  const Bridges old = grains.bridges ? grains.bridges->bridges : Bridges{};
  const bool everywhere =
      grains.bridges ? capillary_pressure > grains.bridges->suction : options.formation == BridgeFormation::at_any_distance;
  BridgePairs pairs = pairs_between(grains, dry_edges(edges, dry));
  std::vector<double> amount(pairs.ends.size());
  for (std::size_t n = 0; n < amount.size(); ++n) {
    const bool may_stand = everywhere || pairs.gap[n] <= 0.0 || std::ranges::binary_search(old.pairs.ends, pairs.ends[n]);
    // Below the table's suctions a bridge would be as large as the pores around it.
    const bool is_small =
        capillary_pressure * reduced_radius(pairs.radius[n]) >= options.model.table.least * options.model.surface_tension;
    amount[n] = may_stand && is_small ? capillary_pressure : 0.0;
  }
  place_bridges(grains, options.model, {.by_pores = true}, capillary_pressure, pairs, amount);
  const Bridges& now = grains.bridges->bridges;

  std::vector<char> stays(to_size(old.size()));
  std::vector<double> before(to_size(now.size()), 0.0);
  for (int k = 0; k < old.size(); ++k) {
    const auto found = std::ranges::lower_bound(now.pairs.ends, old.pairs.ends[to_size(k)]);
    stays[to_size(k)] = found != now.pairs.ends.end() && *found == old.pairs.ends[to_size(k)];
    if (stays[to_size(k)]) before[static_cast<std::size_t>(found - now.pairs.ends.begin())] = old.volume[to_size(k)];
  }
  give_back(old, stays, edges, dry, network, model, flow);
  CompensatedSum water;
  for (int k = 0; k < now.size(); ++k) {
    const double change = now.volume[to_size(k)] - before[to_size(k)];
    change > 0.0 ? flow.ledger.wetting_in.add(change) : flow.ledger.wetting_out.add(-change);
    water.add(now.volume[to_size(k)]);
  }
  return water.value();
}

}  // namespace puadem
