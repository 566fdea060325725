// Pore network of a packing, from positions: triangulation alone, then with throat sections, merging and
// pore units; and a retention loop of 60 pressure steps on it. Usage:
// PUADEM_PACKING=packing.csv bench_network_build

#include <benchmark/benchmark.h>

#include <cstdio>
#include <cstdlib>
#include <limits>

#include "puadem/flow/retention_path.hpp"
#include "puadem/io/packing_file.hpp"
#include "puadem/network/pore_units.hpp"

using namespace puadem;

namespace {

const PackingFile& packing() {
  static const PackingFile p = [] {
    const char* path = std::getenv("PUADEM_PACKING");
    if (path == nullptr) {
      std::fputs("set PUADEM_PACKING to a packing file (x,y,z,r)\n", stderr);
      std::exit(1);
    }
    return read_packing(path);
  }();
  return p;
}

void triangulation(benchmark::State& state) {
  set_threads(1);
  const PackingFile& p = packing();
  int cells = 0;
  for (auto _ : state) cells = triangulate(p.centre, p.radius, p.box).cells();
  state.counters["grains"] = static_cast<double>(p.radius.size());
  state.counters["cells"] = cells;
}

void whole_network(benchmark::State& state) {
  set_threads(static_cast<int>(state.range(0)));
  const PackingFile& p = packing();
  int pores = 0;
  for (auto _ : state) pores = build_pore_network(p.centre, p.radius, p.box, {}).pores();
  set_threads(1);
  state.counters["pores"] = pores;
}

/// Drainage to 1,000 Pa, imbibition, secondary drainage, 50 Pa a step; the start of the invasion included.
void retention_loop(benchmark::State& state) {
  set_threads(1);
  const PackingFile& p = packing();
  NetworkOptions options;
  if (state.range(0) == 0) options.merge_ratio = std::numeric_limits<double>::infinity();
  const PoreNetwork network = build_pore_network(p.centre, p.radius, p.box, options);
  const Fluids fluids;
  RetentionPath path;
  path.turning_points = {50.0, 1000.0, 0.0, 1000.0};
  path.step = {50.0};
  path.mean_grain_radius = 1e-3;
  std::size_t rows = 0;
  for (auto _ : state) {
    InvasionState invasion = start_invasion(network, fluids, {});
    rows = follow_path(network, fluids, path, invasion).size();
  }
  state.counters["steps"] = static_cast<double>(rows);
  state.counters["pores"] = network.pores();
}

BENCHMARK(triangulation)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(whole_network)->ArgName("threads")->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(retention_loop)->ArgName("merged")->Arg(1)->Arg(0)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace

BENCHMARK_MAIN();
