// Pore network of a packing, from positions: triangulation alone, then with throat sections, merging and
// pore units. Usage: PUADEM_PACKING=packing.csv bench_network_build

#include <benchmark/benchmark.h>

#include <cstdlib>

#include "puadem/io/packing_file.hpp"
#include "puadem/network/pore_units.hpp"

using namespace puadem;

namespace {

const Packing& packing() {
  static const Packing p = [] {
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
  const Packing& p = packing();
  int cells = 0;
  for (auto _ : state) cells = triangulate(p.centre, p.radius, p.box).cells();
  state.counters["grains"] = static_cast<double>(p.radius.size());
  state.counters["cells"] = cells;
}

void whole_network(benchmark::State& state) {
  set_threads(static_cast<int>(state.range(0)));
  const Packing& p = packing();
  int pores = 0;
  for (auto _ : state) pores = build_pore_network(p.centre, p.radius, p.box, {}).pores();
  set_threads(1);
  state.counters["pores"] = pores;
}

BENCHMARK(triangulation)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(whole_network)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace

BENCHMARK_MAIN();
