#include "puadem/dem/guards.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "puadem/base/error.hpp"
#include "puadem/dem/contact_forces.hpp"
#include "puadem/dem/contacts.hpp"

namespace puadem {

namespace {

/// Place, speed, resultant and contacts of a grain, for a message.
std::string describe(const GrainSystem& s, int record) {
  const GrainRecord& r = s.record[to_size(record)];
  const SlotSum sum = sum_slots(s.slot.data(), s.row.data(), s.row_start[to_size(record)], s.row_start[to_size(record) + 1]);
  const int id = s.identity[to_size(record)];
  std::string text =
      fmt::format("grain {} of radius {:.4g} m at ({:.6g}, {:.6g}, {:.6g}) m, speed {:.3g} m/s, contact force {:.3g} N; touches",
                  id, radius_of(r), r.place[0], r.place[1], r.place[2], norm(vec3(r.drift)), norm(vec3(sum.force)));
  int listed = 0;
  for (const Contact& c : contacts_of(s)) {
    if (c.first != id && c.second != id) continue;
    if (c.wall >= 0)
      text += fmt::format("{} wall {} ({:.3g} N)", listed > 0 ? "," : "", c.wall, c.normal_force);
    else
      text += fmt::format("{} grain {} ({:.3g} N)", listed > 0 ? "," : "", c.first == id ? c.second : c.first, c.normal_force);
    if (++listed == 8) break;
  }
  return listed > 0 ? text : text + " nothing";
}

}  // namespace

void guard_grains(const GrainSystem& s, const GuardLimits& limits) {
  for_each_grain_contact(s, [&](int i, int j, const Vec3& branch, int) {
    const double ri = radius_of(s.record[to_size(i)]), rj = radius_of(s.record[to_size(j)]);
    const double share = (ri + rj - norm(branch)) / std::min(ri, rj);
    if (share > limits.overlap)
      throw NumericalError(fmt::format(
          "step {}: grains {} and {} overlap by {:.0f} % of the smaller radius (limit {:.0f} %): {}. Lower the stress or the "
          "speed, or stiffen the grains",
          s.steps, s.identity[to_size(i)], s.identity[to_size(j)], 100 * share, 100 * limits.overlap,
          describe(s, ri < rj ? owner_of(s, i) : owner_of(s, j))));
  });
  const Vec3 size = s.domain.size();
  for (int k = 0; k < s.owned; ++k) {
    const GrainRecord& r = s.record[to_size(k)];
    Vec3 velocity = vec3(r.drift);
    if (s.motion.strain_with_box)
      for (int axis = 0; axis < 3; ++axis)
        velocity[axis] -= s.box_rate[axis] * (r.place[axis] - s.domain.lower[axis]) / size[axis];
    if (!(norm(velocity) * s.time_step <= limits.displacement * radius_of(r)))
      throw NumericalError(
          fmt::format("step {}: a grain moves {:.2g} radii in one step (limit {:.2g}): {}. Shorten the time step, now {:.3g} s",
                      s.steps, norm(velocity) * s.time_step / radius_of(r), limits.displacement, describe(s, k), s.time_step));
    for (int w = 0; w < size_of(s.walls); ++w)
      if (dot(vec3(r.place) - s.walls[to_size(w)].point, s.walls[to_size(w)].normal) < 0.0)
        throw NumericalError(fmt::format("step {}: a grain has gone through wall {}: {}", s.steps, w, describe(s, k)));
  }
}

Energies guard_energy(const GrainSystem& s, const Energies& start, const GuardLimits& limits) {
  const Energies now = energies(s);
  const double input = now.input - start.input, taken = now.taken() - start.taken();
  const double surplus = now.stored() - start.stored() + taken - input;
  const double scale = std::max({now.stored(), start.stored(), std::abs(input), std::abs(taken)});
  if (surplus <= limits.energy * scale) return now;
  const auto kinetic = [&](int k) {
    const GrainRecord& r = s.record[to_size(k)];
    return mass_of(r) * squared_norm(vec3(r.drift)) + inertia_of(r) * squared_norm(vec3(r.spin));
  };
  int liveliest = 0;
  for (int k = 1; k < s.owned; ++k)
    if (kinetic(k) > kinetic(liveliest)) liveliest = k;
  throw NumericalError(fmt::format(
      "step {}: the grains have {:.3g} J of energy out of nothing: kinetic {:.3g} J, in springs {:.3g} J, taken up or "
      "lost {:.3g} J, at the start {:.3g} J, work done on them {:.3g} J. Most moves {}. Shorten the time step, now "
      "{:.3g} s",
      s.steps, surplus, now.kinetic, now.normal, taken, start.stored(), input, describe(s, liveliest), s.time_step));
}

}  // namespace puadem
