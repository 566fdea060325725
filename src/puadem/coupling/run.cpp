#include "puadem/coupling/run.hpp"

#include "puadem/base/error.hpp"
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
  state.unsaturated.reset();
  state.saturation.clear();
}

void run_stage_with_fluid(const Case& c, State& state, const Observer& observer, RunResults& results) {
  const int index = state.position.stage;
  Observer watching = observer;
  // A stage that goes on has shown the packing, whatever came before it.
  if (state.position.is_packing_shown) watching.packed = nullptr;
  state.position.is_packing_shown = true;
  const Stage& stage = c.stages[to_size(index)];
  if (const auto* retention = std::get_if<RetentionStage>(&stage))
    run_retention_stage(c, *retention, state, watching, results);
  else if (std::holds_alternative<TwoPhaseStage>(stage))
    run_two_phase_stage(c, index, state, watching, results);
  else
    run_permeability_stage(c, index, state, watching, results);
}

void run_stage_with_grains(const Case& c, State& state, const Observer& observer, RunResults& results) {
  const int index = state.position.stage;
  if (!has_begun(state)) forget_pores(state);
  if (const auto* compact = std::get_if<CompactStage>(&c.stages[to_size(index)]))
    run_compact_stage(c, *compact, state, observer, results);
  else if (std::holds_alternative<SaturatedStage>(c.stages[to_size(index)]))
    run_saturated_stage(c, index, state, observer, results);
  else if (std::holds_alternative<UnsaturatedStage>(c.stages[to_size(index)]))
    run_unsaturated_stage(c, index, state, observer, results);
  else
    run_loading_stage(c, index, state, observer, results);
  state.position.is_packing_shown = !is_followed_by_network(c, index);
  if (observer.packed && state.position.is_packing_shown) observer.packed(state);
}

}  // namespace

void tell_at_safe_place(const Observer& observer, const Progress& progress, const State& state, const RunResults& results) {
  const bool goes_on = !observer.progress || observer.progress(progress);
  if (observer.safe_place) observer.safe_place(state, results, !goes_on);
  if (!goes_on) throw Interrupted{};
}

RunResults run(const Case& c, State& state, const Observer& observer, RunResults results) {
  results.interrupted = false;
  int& stage = state.position.stage;
  try {
    while (stage < size_of(c.stages)) {
      if (puts_fluid(c.stages[to_size(stage)]))
        run_stage_with_fluid(c, state, observer, results);
      else
        run_stage_with_grains(c, state, observer, results);
      state.position.progress = {};
      ++stage;
      if (observer.safe_place) observer.safe_place(state, results, false);
    }
    state.position = {};  // another case may go on from here
  } catch (const Interrupted&) {
    results.interrupted = true;
  } catch (const NumericalError& error) {
    if (!couples(c.stages[to_size(stage)])) throw;
    throw NumericalError(fmt::format("stage {} at {:.6g} s: {}", stage_name(c, stage), state.time, error.what()));
  }
  if (state.particles.size() > 0) describe_packing(state, results);
  return results;
}

}  // namespace puadem
