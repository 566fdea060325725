#include <algorithm>
#include <cmath>

#include "puadem/base/error.hpp"
#include "puadem/coupling/stages.hpp"
#include "puadem/dem/grain_statistics.hpp"
#include "puadem/dem/sphere_in_box.hpp"

namespace puadem {

void run_compact_stage(const Case& c, const CompactStage& stage, State& state, const Observer& observer, RunResults& results) {
  require(state.particles.size() == 0,
          "a stage of kind 'compact' makes its grains itself: it must come first and not with grains.file");

  PackingSource source;
  source.grading = c.grains.grading;
  source.count = c.grains.count;
  source.materials = grain_materials(c);
  source.added = added_grains(c);
  source.shape = c.domain.size.value_or(c.domain.shape);
  source.periodic = c.domain.periodic;
  source.seed = c.seed;
  source.cloud = c.grains.cloud;
  source.clump_size = c.grains.clump_size;

  CompactionOptions options;
  options.stress = stage.stress;
  options.porosity = stage.porosity;
  options.friction_angle = stage.friction_angle;
  options.region = stage.porosity_region;
  options.unbalanced = stage.unbalanced;
  options.damping = stage.damping;
  options.safety = c.motion.safety;

  bool stopped = false;
  Packing packing = make_packing(source, c.materials, c.contact, options, [&](const CompactionProgress& p) {
    Progress progress;
    progress.stage = "compact";
    progress.fraction = p.fraction;
    progress.step = p.step;
    progress.unbalanced = p.unbalanced;
    progress.stress = p.stress;
    progress.porosity = p.porosity;
    stopped = observer.progress && !observer.progress(progress);
    return !stopped;
  });
  state.particles = std::move(packing.particles);
  state.domain = packing.domain;
  state.grains = std::move(packing.system);
  if (stopped) throw Interrupted{};

  const CompactionReport& r = packing.report;
  auto& s = results.scalars;
  s["stress_mean_Pa"] = r.mean_stress;
  for (int axis = 0; axis < 3; ++axis) s[std::string("stress_") + "xyz"[axis] + "_Pa"] = r.axis_stress[axis];
  s["unbalanced_force"] = r.unbalanced;
  s["coordination_number"] = r.coordination;
  s["compaction_friction"] = r.friction_used;
  s["grading_error"] = r.grading_error;
  s["largest_overlap"] = r.largest_overlap;
  s["dem_time_step_s"] = r.time_step;
  s["dem_steps"] = static_cast<double>(r.steps);
}

void describe_packing(const State& state, RunResults& results) {
  const auto& radius = state.particles.radius;
  const GrainStatistics grains = statistics_of(radius);
  auto& s = results.scalars;
  s["grains"] = state.particles.size();
  s["radius_mean_m"] = grains.mean_radius;
  s["radius_sauter_m"] = grains.sauter_radius;
  s["porosity_box"] = porosity_of(state.particles.position, radius, state.domain);
  const Vec3 size = state.domain.size();
  bool has_core = true;  // farther than one largest diameter from every wall
  for (int axis = 0; axis < 3; ++axis)
    has_core = has_core && (state.domain.periodic[to_size(axis)] || size[axis] > 4.0 * grains.largest);
  if (has_core) s["porosity_core"] = porosity_of(state.particles.position, radius, core_of(state.domain, 2.0 * grains.largest));
  for (int axis = 0; axis < 3; ++axis) s[std::string("box_") + "xyz"[axis] + "_m"] = size[axis];
}

}  // namespace puadem
