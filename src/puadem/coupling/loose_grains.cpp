#include "puadem/coupling/loose_grains.hpp"

#include <utility>

#include "puadem/base/error.hpp"
#include "puadem/dem/fabric.hpp"
#include "puadem/dem/motion.hpp"
#include "puadem/dem/stress.hpp"
#include "puadem/dem/time_step.hpp"

namespace puadem {

namespace {

constexpr int contacts_that_hold = 4;  // a grain, without any help of friction
constexpr double gentle = 1e-3;        // push over the mean force of the contacts
constexpr double rest = 0.05;          // unbalanced forces over those while all loose grains fly
constexpr double damping = 0.7;
constexpr long check_interval = 50;  // steps
constexpr long most_steps = 500'000;

}  // namespace

int seat_loose_grains(const Vec3& direction, GrainSystem& grains) {
  evaluate_forces(grains);
  const GrainContacts contacts = count_contacts(grains);
  const double force_between_grains = measure_fabric(grains).mean_force;
  if (!(force_between_grains > 0.0)) return 0;
  const Vec3 push = gentle * force_between_grains * direction;
  std::vector<Vec3> force(to_size(grains.owned));
  int loose = 0;
  for (int k = 0; k < grains.owned; ++k) {
    if (contacts.is_rattler[to_size(k)] == 0 && contacts.count[to_size(k)] >= contacts_that_hold) continue;
    force[to_size(grains.identity[to_size(k)])] = push;
    ++loose;
  }
  if (loose == 0) return 0;
  const double before = std::exchange(grains.motion.damping, damping);
  grains.external_force = std::move(force);
  const double flying = gentle * loose / grains.owned;
  for (long step = 0;; step += check_interval) {
    evaluate_forces(grains);
    if (step > 0 && measure(grains).unbalanced < rest * flying) break;
    ensure(step < most_steps, "step {}: {} loose grains do not come to rest against their neighbours within {} steps",
           grains.steps, loose, step);
    renew_time_step(grains);
    advance_grains(grains, check_interval);
  }
  grains.external_force.clear();
  grains.motion.damping = before;
  return loose;
}

}  // namespace puadem
