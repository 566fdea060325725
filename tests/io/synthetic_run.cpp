#include "synthetic_run.hpp"

#include <cmath>
#include <fstream>
#include <numbers>
#include <sstream>

#include "puadem/base/random.hpp"

namespace puadem {
namespace {

constexpr double radius = 0.4e-3;  // of the largest grain [m]
constexpr double spacing = 1e-3;   // of the lattice [m]

void add_grains(State& state, int side, Random& random) {
  for (int k = 0; k < side; ++k)
    for (int j = 0; j < side; ++j)
      for (int i = 0; i < side; ++i) {
        state.particles.position.push_back({(i + 0.5) * spacing, (j + 0.5) * spacing, (k + 0.5) * spacing});
        state.particles.radius.push_back(radius * random.uniform(0.6, 1.0));
        state.particles.material.push_back(0);
      }
  const std::size_t count = state.particles.radius.size();
  state.particles.velocity.resize(count);
  state.particles.angular_velocity.resize(count);
  state.domain.upper = Vec3{1, 1, 1} * (side * spacing);
}

/// One pore around each grain, which owns the lattice cell less the grain: the pores and grains fill the box.
void add_network(State& state, int side, Random& random) {
  PoreNetwork& n = state.network;
  std::vector<int> row_of;
  for (int g = 0; g < state.particles.size(); ++g) {
    const double r = state.particles.radius[to_size(g)];
    n.pore_centre.push_back(state.particles.position[to_size(g)] + Vec3{0.5, 0.5, 0.5} * spacing);
    n.pore_volume.push_back(spacing * spacing * spacing - 4.0 / 3.0 * std::numbers::pi * r * r * r);
    n.pore_radius.push_back(0.45 * radius * std::exp(0.3 * (random.uniform() + random.uniform() + random.uniform() - 1.5)));
    n.pore_faces.push_back(6);
    n.pore_walls.push_back(0);
  }
  const int step[3] = {1, side, side * side};
  std::vector<std::vector<int>> throats(n.pore_volume.size());
  for (int p = 0; p < n.pores(); ++p)
    for (int axis = 0; axis < 3; ++axis) {
      if (p / step[axis] % side == side - 1) continue;
      throats[to_size(p)].push_back(n.throats());
      throats[to_size(p + step[axis])].push_back(n.throats());
      n.throat_pores.push_back({p, p + step[axis]});
      n.throat_shift.push_back({});
      n.throat_radius.push_back(0.25 * radius * std::exp(0.4 * (random.uniform() + random.uniform() - 1.0)));
      n.throat_entry_radius.push_back(0.6 * n.throat_radius.back());
      n.throat_snap_off_radius.push_back(0.9 * n.throat_radius.back());
      n.throat_entry_kind.push_back(random.uniform() < 0.9 ? EntryKind::meniscus : EntryKind::half_gap);
      n.throat_at_wall.push_back(0);
      n.throat_area.push_back(0.1 * spacing * spacing);
    }
  n.pore_throats = {};
  for (const auto& list : throats) {
    n.pore_throats.index.insert(n.pore_throats.index.end(), list.begin(), list.end());
    n.pore_throats.start.push_back(size_of(n.pore_throats.index));
  }
}

void add_branch(State& state, const std::string& name, double from, double to, const VanGenuchten& curve, double scale) {
  constexpr int steps = 12;
  for (int k = 0; k <= steps; ++k) {
    RetentionRow row;
    row.step = size_of(state.retention);
    row.branch = name;
    row.capillary_pressure = from + (to - from) * k / steps;
    row.pc_star = row.capillary_pressure * scale;
    row.saturation = curve.saturation(row.capillary_pressure);
    row.trapped_wetting = 0.5 * curve.residual_saturation;
    row.trapped_nonwetting = name.starts_with("imbibition") ? 1.0 - curve.maximal_saturation : 0.0;
    state.retention.push_back(row);
  }
}

void add_results(SyntheticRun& run, bool retention) {
  run.results.scalars = {{"porosity_core", 0.3402}, {"stress_mean_Pa", 10023.0}, {"unbalanced_force", 4.1e-4}};
  if (!retention) return;
  double void_volume = 0.0;
  for (const double v : run.state.network.pore_volume) void_volume += v;
  Ledger& l = run.results.ledger;
  l.void_volume = l.wetting_start = void_volume;
  l.wetting_out = l.nonwetting_in = 1.5 * void_volume;
  l.wetting_in = l.nonwetting_out = 0.75 * void_volume;
  l.wetting_end = 0.25 * void_volume;
  l.nonwetting_end = 0.75 * void_volume;
}

}  // namespace

SyntheticRun make_synthetic_run(int side, bool retention) {
  SyntheticRun run;
  Random random(7);
  run.c.title = "Drainage and imbibition of a made-up lattice";
  run.c.seed = 7;
  run.c.grains.count = side * side * side;
  run.c.grains.grading.classes = {{2 * 0.6 * radius, 2 * radius, 1.0}};
  run.c.materials = {Material{}};
  CompactStage compact;
  compact.porosity = 0.34;
  run.c.stages.push_back(compact);
  run.c.expected["porosity_core"] = {0.338, 0.342};
  add_grains(run.state, side, random);
  add_network(run.state, side, random);
  if (retention) {
    RetentionStage stage;
    stage.path = {400, 1300, 0, 1300};
    run.c.stages.push_back(stage);
    const double scale = 0.8 * radius / run.c.fluids.surface_tension;
    add_branch(run.state, "drainage-1", 400, 1300, {1.0 / 750, 11, 0.06, 1.0}, scale);
    add_branch(run.state, "imbibition-1", 1300, 0, {1.0 / 480, 6, 0.06, 0.88}, scale);
    add_branch(run.state, "drainage-2", 0, 1300, {1.0 / 700, 9, 0.06, 0.88}, scale);
    run.state.saturation.assign(run.state.network.pore_volume.size(), 0.25);
  }
  add_results(run, retention);
  return run;
}

void play(const SyntheticRun& run, const Observer& observer) {
  State seen = run.state;
  seen.retention.clear();
  observer.message("warning: the wetting front is not measured here");
  observer.progress({"compact", 0.5, 100, 0.01, 1.0, 0.02, 0.0});
  observer.progress({"compact", 1.0, 200, 0.02, 1.0, 4e-4, 0.0});
  observer.packed(seen);
  for (const RetentionRow& row : run.state.retention) {
    if (row.step == 2) observer.event(seen, {InvasionEventKind::drain, row.capillary_pressure, 0, 0, 0, -1e-12});
    if (row.step == 20) observer.event(seen, {InvasionEventKind::fill, row.capillary_pressure, 0, -1, 0, 1e-12});
    seen.retention.push_back(row);
    observer.equilibrium(seen, row);
  }
}

std::string slurp(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream content;
  content << file.rdbuf();
  return content.str();
}

}  // namespace puadem
