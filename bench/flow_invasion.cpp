// Retention loop on a synthetic network: drainage, imbibition and secondary drainage in 60 steps.
#include <benchmark/benchmark.h>

#include <array>
#include <cmath>

#include "puadem/base/random.hpp"
#include "puadem/flow/retention_path.hpp"
#include "puadem/network/pore_shape.hpp"

namespace {

using namespace puadem;

/// Pores on a cubic lattice of `edge`^3, each joined at random to about `coordination` of its 26
/// neighbours; bodies and throats as in a dense packing of grains of 0.2 mm.
PoreNetwork lattice_network(int edge, double coordination) {
  Random random(1);
  PoreNetwork network;
  const auto pore_at = [&](int x, int y, int z) { return (z * edge + y) * edge + x; };
  for (int z = 0; z < edge; ++z)
    for (int k = 0; k < edge * edge; ++k) {
      const int faces = 4 + 2 * static_cast<int>(random.below(5));
      network.pore_volume.push_back(random.uniform(2e-13, 2e-12));
      network.pore_faces.push_back(faces);
      network.pore_radius.push_back(inscribed_radius_coefficient(faces) * std::cbrt(network.pore_volume.back()));
      network.pore_walls.push_back(z == 0 ? 1 << 4 : z == edge - 1 ? 1 << 5 : 0);
    }
  const auto inside = [&](int k) { return k >= 0 && k < edge; };
  for (int z = 0; z < edge; ++z)
    for (int y = 0; y < edge; ++y)
      for (int x = 0; x < edge; ++x)
        for (int n = 14; n < 27; ++n) {  // one of each two opposite directions
          const std::array<int, 3> to{x + n % 3 - 1, y + n / 3 % 3 - 1, z + n / 9 - 1};
          if (!inside(to[0]) || !inside(to[1]) || !inside(to[2]) || random.uniform() > coordination / 26.0) continue;
          const double entry = random.uniform(2.5e-5, 6e-5);
          network.throat_pores.push_back({pore_at(x, y, z), pore_at(to[0], to[1], to[2])});
          network.throat_entry_radius.push_back(entry);
          network.throat_snap_off_radius.push_back(entry * random.uniform(1.0, 1.8));
          network.throat_at_wall.push_back(0);
        }
  return network;
}

void retention_loop(benchmark::State& bench) {
  const PoreNetwork network = lattice_network(static_cast<int>(bench.range(0)), static_cast<double>(bench.range(1)));
  const Fluids fluids;
  const RetentionPath path{{0.0, 3000.0, 0.0, 3000.0}, {150.0}, 2e-4};
  for (auto _ : bench) {
    InvasionState state = start_invasion(network, fluids, {});
    long events = 0;
    const auto rows = follow_path(network, fluids, path, state, {}, [&](const InvasionEvent&) { ++events; });
    bench.counters["events"] = static_cast<double>(events);
    bench.counters["S_drained"] = rows[20].saturation;
    bench.counters["S_imbibed"] = rows[40].saturation;
  }
  bench.counters["pores"] = network.pores();
  bench.counters["throats"] = network.throats();
}

}  // namespace

// As the merged and as the unmerged network of 10,000 grains.
BENCHMARK(retention_loop)->Args({23, 10})->Args({39, 4})->Unit(benchmark::kMillisecond);

BENCHMARK_MAIN();
