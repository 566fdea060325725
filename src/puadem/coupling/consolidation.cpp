#include "puadem/coupling/consolidation.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "puadem/base/error.hpp"
#include "puadem/coupling/saturated_stage.hpp"
#include "puadem/dem/boundary_program.hpp"
#include "puadem/dem/motion.hpp"
#include "puadem/dem/time_step.hpp"
#include "puadem/flow/permeability.hpp"

namespace puadem {

namespace {

constexpr double pi = std::numbers::pi;
constexpr double negligible = 40.0;  // exponents beyond add less than 1e-17
constexpr long check_interval = 50;  // steps
constexpr long most_steps = 2'000'000;
constexpr double ramp = 200.0;  // steps per grain of the height in which the load is put on
constexpr double rest = 1e-4;   // unbalanced force ratio, and of the load that has not come down to the other wall

/// The height in mean diameters of the grains.
double height_in_grains(const GrainSystem& grains, double height) {
  double sum = 0.0;
  for (int k = 0; k < grains.owned; ++k) sum += radius_of(grains.record[to_size(k)]);
  return height * grains.owned / (2.0 * sum);
}

}  // namespace

double terzaghi_degree(double time_factor) {
  if (!(time_factor > 0.0)) return 0.0;
  // The series below converges too slowly at first; then the layer is half a space.
  if (time_factor < 0.01) return 2.0 * std::sqrt(time_factor / pi);
  double left = 0.0;
  for (int m = 0;; ++m) {
    const double root = 0.5 * pi * (2 * m + 1), exponent = root * root * time_factor;
    if (exponent > negligible) return 1.0 - left;
    left += 2.0 / (root * root) * std::exp(-exponent);
  }
}

double terzaghi_pressure(double time_factor, double depth) {
  if (!(time_factor > 0.0)) return 1.0;
  if (time_factor < 0.01) return std::erf(depth / (2.0 * std::sqrt(time_factor)));
  double pressure = 0.0;
  for (int m = 0;; ++m) {
    const double root = 0.5 * pi * (2 * m + 1), exponent = root * root * time_factor;
    if (exponent > negligible) return pressure;
    pressure += 2.0 / root * std::sin(root * depth) * std::exp(-exponent);
  }
}

ConsolidationReference measure_consolidation(GrainSystem grains, const PoreNetwork& network, int loaded, double drainage_length,
                                             double viscosity) {
  const int axis = axis_of(loaded);
  ConsolidationReference r;
  r.drainage_length = drainage_length;
  r.permeability = measure_permeability(network, grains.domain).tensor[to_size(axis)][axis];
  const double height = grains.domain.size()[axis];
  evaluate_forces(grains);
  const auto wall = std::ranges::find_if(grains.walls, [&](const Wall& w) { return w.face == loaded; });
  const double target = *wall->target;
  r.load = target + dot(wall->force, wall->normal) / wall->area;
  // A load put on at once runs through dry grains as a wave, is doubled at the other wall, and compacts them for good.
  const double loading_steps = ramp * height_in_grains(grains, height);
  for (long step = 0;; step += check_interval) {
    const double missing = std::max(1.0 - static_cast<double>(step) / loading_steps, 0.0);
    wall->target = target - missing * r.load;
    ensure(step < most_steps, "step {}: the dry grains do not come to rest under {:.4g} Pa within {} steps", grains.steps, target,
           step);
    evaluate_forces(grains);
    renew_time_step(grains, grains.time_step);
    const GrainMeasures m = measure(grains);
    const double away = std::max(std::abs(m.wall_stress[to_size(loaded)] - target),
                                 std::abs(m.wall_stress[to_size(opposite(loaded))] - m.wall_stress[to_size(loaded)]));
    const bool has_weight = squared_norm(grains.motion.gravity) > 0.0;
    if (missing == 0.0 && m.unbalanced < rest && (has_weight || away < 10.0 * rest * r.load)) break;
    advance_grains(grains, check_interval);
  }
  r.settlement = height - grains.domain.size()[axis];
  r.stiffness = r.load * height / r.settlement;
  r.coefficient = r.permeability * r.stiffness / viscosity;
  ensure(r.coefficient > 0.0, "the load of {:.4g} Pa does not compress the packing (it settles by {:.4g} m): no consolidation",
         r.load, r.settlement);
  return r;
}

}  // namespace puadem
