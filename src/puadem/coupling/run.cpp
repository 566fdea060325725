#include "puadem/coupling/run.hpp"

#include "puadem/base/parallel.hpp"
#include "puadem/coupling/stages.hpp"

namespace puadem {

namespace {

/// Does the next stage make the pore network? It then tells the observer of the packing.
bool is_followed_by_network(const Case& c, int index) {
  return index + 1 < size_of(c.stages) && puts_fluid(c.stages[to_size(index + 1)]);
}

/// What the pores held is of no meaning once grains have moved.
void forget_pores(State& state) {
  state.network = {};
  state.invasion.reset();
  state.flow.reset();
  state.saturated.reset();
  state.saturation.clear();
}

}  // namespace

RunResults run(const Case& c, State& state, const Observer& observer) {
  RunResults results;
  Observer has_seen = observer;  // one that knows how the grains lie
  has_seen.packed = nullptr;
  bool is_seen = false;
  try {
    for (int index = 0; index < size_of(c.stages); ++index) {
      const Stage& stage = c.stages[to_size(index)];
      if (puts_fluid(stage)) {
        const Observer& watching = is_seen ? has_seen : observer;
        is_seen = true;
        if (const auto* retention = std::get_if<RetentionStage>(&stage))
          run_retention_stage(c, *retention, state, watching, results);
        else if (std::holds_alternative<TwoPhaseStage>(stage))
          run_two_phase_stage(c, index, state, watching, results);
        else
          run_permeability_stage(c, index, state, watching, results);
        continue;
      }
      forget_pores(state);
      if (const auto* compact = std::get_if<CompactStage>(&stage))
        run_compact_stage(c, *compact, state, observer, results);
      else if (std::holds_alternative<SaturatedStage>(stage))
        run_saturated_stage(c, index, state, observer, results);
      else
        run_loading_stage(c, index, state, observer, results);
      is_seen = !is_followed_by_network(c, index);
      if (observer.packed && is_seen) observer.packed(state);
    }
  } catch (const Interrupted&) {
    results.interrupted = true;
  }
  if (state.particles.size() > 0) describe_packing(state, results);
  return results;
}

}  // namespace puadem
