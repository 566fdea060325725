// Cost of grains and one fluid that move each other: a consolidation under way, on one thread. Its coupled steps beside the
// same steps of the grains alone and the same number of flow solves in a network that stands, in turns. Prints milliseconds
// of processor time per coupled step and the ratio.
// Usage: bench_coupled [largest number of grains]

#include <cstdio>
#include <cstdlib>
#include <limits>

#include "puadem/coupling/run.hpp"
#include "puadem/dem/motion.hpp"
#include "shaken_bed.hpp"

using namespace puadem;

namespace {

Case consolidation(int grains) {
  Case c;
  c.seed = 1;
  c.domain.periodic = {true, true, false};
  c.domain.shape = {1, 1, 4};
  c.materials = {Material{.name = "glass", .density = 2500.0, .youngs_modulus = 1.5e8, .friction_angle = 0.436}};
  c.grains.count = grains;
  c.grains.material = "glass";
  c.grains.grading = {Grading::By::mass, {{0.8e-3, 1.2e-3, 1.0}}};
  c.contact.law = ContactOptions::Law::linear_spring;
  c.fluids.wetting = {0.3, 950.0};
  CompactStage compact;
  compact.stress = 100e3;
  compact.friction_angle = 0.087;
  SaturatedStage stage;
  stage.loaded = 5;
  stage.stress = 110e3;
  stage.duration = 2e-3;
  c.stages = {compact, stage};
  return c;
}

/// The state of a run that has done some of its coupled steps.
State under_way(const Case& c, long steps) {
  State state;
  Observer observer;
  observer.progress = [&](const Progress&) { return !state.saturated || state.saturated->steps < steps; };
  run(c, state, observer);
  return state;
}

struct Timer {
  double seconds = 0.0;
  template <class Work>
  void take(const Work& work) {
    const double begin = processor_seconds();
    work();
    seconds += processor_seconds() - begin;
  }
};

void measure_cost(int count) {
  const Case c = consolidation(count);
  State state = under_way(c, 400);
  GrainSystem grains = *state.grains;
  const auto& stage = std::get<SaturatedStage>(c.stages[1]);
  SaturatedOptions options;
  options.viscosity = c.fluids.wetting.viscosity;
  options.density = c.fluids.wetting.density;
  options.faces[5] = {FaceCondition::Kind::pressure, 0.0};
  options.remesh_displacement = stage.remesh_displacement * 0.5e-3;
  options.network = c.pores;
  options.network.merge_criterion = MergeCriterion::entry_ratio;
  options.network.merge_ratio = std::numeric_limits<double>::infinity();
  SaturatedCache cache, fluid_alone;
  for (SaturatedCache* each : {&cache, &fluid_alone})
    renew_cache(options, state.network, state.particles.radius, state.saturated->place, *each);
  const PoreNetwork network = state.network;
  const long substeps = static_cast<long>(state.saturated_flows.back().coupling_interval / grains.time_step);
  std::vector<double> rate = state.saturated->pore_volume;
  options.remesh_displacement = std::numeric_limits<double>::infinity();
  saturated_step(options, substeps, *state.grains, state.particles, state.network, *state.saturated, cache);
  options.remesh_displacement = stage.remesh_displacement * 0.5e-3;
  const double interval = static_cast<double>(substeps) * grains.time_step;
  for (std::size_t p = 0; p < rate.size(); ++p) rate[p] = (state.saturated->pore_volume[p] - rate[p]) / interval;
  SinglePhaseProblem problem;
  problem.faces = options.faces;
  problem.viscosity = options.viscosity;
  problem.volume_rate = rate;
  solve_single_phase(network, state.domain, problem, fluid_alone.memory);

  constexpr int rounds = 40, steps = 10;
  const long remeshes = state.saturated->remeshes;
  Timer dry, fluid, coupled;
  for (int round = 0; round < rounds; ++round) {
    dry.take([&] { advance_grains(grains, steps * substeps); });
    fluid.take([&] {
      for (int k = 0; k < steps; ++k) solve_single_phase(network, state.domain, problem, fluid_alone.memory);
    });
    coupled.take([&] {
      for (int k = 0; k < steps; ++k)
        saturated_step(options, substeps, *state.grains, state.particles, state.network, *state.saturated, cache);
    });
  }
  constexpr double each = 1e3 / (rounds * steps);
  std::printf("%7d %7d %9ld %8.3f %8.3f %8.3f %9ld %7.2f\n", count, network.pores(), substeps, each * dry.seconds,
              each * fluid.seconds, each * coupled.seconds, state.saturated->remeshes - remeshes,
              coupled.seconds / (dry.seconds + fluid.seconds));
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  set_threads(1);
  const int most = argc > 1 ? std::atoi(argv[1]) : 5000;
  std::printf("                            ms per coupled step\n");
  std::printf(" grains   pores  substeps      dry    fluid  coupled  networks   ratio\n");
  for (const int grains : {500, 1000, 2000, 5000, 20000})
    if (grains <= most) measure_cost(grains);
}
