#include "puadem/dem/time_step.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "puadem/base/error.hpp"

namespace puadem {

double critical_time_step_at(const GrainSystem& s, double stress) {
  const auto smaller = [](const GrainRecord& a, const GrainRecord& b) { return radius_of(a) < radius_of(b); };
  const GrainRecord& smallest = *std::min_element(s.record.begin(), s.record.begin() + s.owned, smaller);
  const double radius = radius_of(smallest), force = 4.0 * radius * radius * stress;
  return std::visit(
      [&]<ContactLaw Law>(const Law&) {
        double stiffest = 0.0;
        for (const PairConstants<double>& pair : s.pairs.grains) {
          double low = 0.0, overlap = radius;  // bisection on a law of unknown shape
          for (int k = 0; k < 60; ++k) {
            const double middle = 0.5 * (low + overlap);
            (Law::respond(pair, middle, 0.5 * radius, 0.5).force < force ? low : overlap) = middle;
          }
          stiffest = std::max(stiffest, Law::respond(pair, overlap, 0.5 * radius, 0.5).normal);
        }
        return std::sqrt(2.0 * mass_of(smallest) / (3.0 * stiffest));
      },
      s.law);
}

TimeStepLimit renew_time_step(GrainSystem& s, double longest) {
  assert(s.is_evaluated || s.steps == 0);
  const TimeStepLimit limit = critical_time_step(s);
  const double safe = std::min(s.motion.safety * limit.critical, longest);
  ensure(std::isfinite(safe), "step {}: no contact bounds the time step", s.steps);
  s.time_step = s.time_step > 0.0 ? std::min(safe, 1.05 * s.time_step) : safe;
  return limit;
}

}  // namespace puadem
