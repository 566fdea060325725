#include "puadem/coupling/run.hpp"

#include "puadem/base/parallel.hpp"
#include "puadem/coupling/stages.hpp"

namespace puadem {

namespace {

/// Does the next stage make the pore network? It then tells the observer of the packing.
bool is_followed_by_network(const Case& c, int index) {
  return index + 1 < size_of(c.stages) && std::holds_alternative<RetentionStage>(c.stages[to_size(index + 1)]);
}

}  // namespace

RunResults run(const Case& c, State& state, const Observer& observer) {
  RunResults results;
  try {
    for (int index = 0; index < size_of(c.stages); ++index) {
      const Stage& stage = c.stages[to_size(index)];
      if (const auto* retention = std::get_if<RetentionStage>(&stage)) {
        run_retention_stage(c, *retention, state, observer, results);
        continue;
      }
      if (const auto* compact = std::get_if<CompactStage>(&stage))
        run_compact_stage(c, *compact, state, observer, results);
      else
        run_loading_stage(c, index, state, observer, results);
      if (observer.packed && !is_followed_by_network(c, index)) observer.packed(state);
    }
  } catch (const Interrupted&) {
    results.interrupted = true;
  }
  if (state.particles.size() > 0) describe_packing(state, results);
  return results;
}

}  // namespace puadem
