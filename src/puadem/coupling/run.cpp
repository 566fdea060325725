#include "puadem/coupling/run.hpp"

#include "puadem/coupling/stages.hpp"

namespace puadem {

RunResults run(const Case& c, State& state, const Observer& observer) {
  RunResults results;
  try {
    for (const Stage& stage : c.stages)
      std::visit(
          [&](const auto& s) {
            if constexpr (std::is_same_v<std::decay_t<decltype(s)>, CompactStage>)
              run_compact_stage(c, s, state, observer, results);
            else
              run_retention_stage(c, s, state, observer, results);
          },
          stage);
  } catch (const Interrupted&) {
    results.interrupted = true;
  }
  if (state.particles.size() > 0) describe_packing(state, results);
  return results;
}

}  // namespace puadem
