#include "puadem/dem/motion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "puadem/base/error.hpp"
#include "puadem/dem/bridge_exchange.hpp"
#include "puadem/dem/contact_forces.hpp"
#include "puadem/dem/contacts.hpp"
#include "puadem/dem/energy.hpp"
#include "puadem/dem/guards.hpp"
#include "puadem/dem/neighbour_list.hpp"

namespace puadem {

namespace {

constexpr long guard_interval = 100;
constexpr int grains_per_chunk = 256;
constexpr int grains_worth_threads = 1024;  // below, a second thread brings nothing

struct MotionLoop {
  GrainRecord* record;
  const ContactSlot* slot;
  const RollSlot* roll_slot;  ///< null without rolling resistance
  const BridgePull* bridges;  ///< pull of liquid bridges by record, or null
  const int* row_start;
  const int* row;
  const int* identity;
  const Vec3* external;  ///< by identity, or null
  Lanes gravity;
  Lanes lower;
  Lanes strain_rate;  ///< of the homogeneous field that damping does not act on [1/s]
  Lanes booked_rate;  ///< its mean before and after the present places, for the energy book [1/s]
  double time_step;
  double damping;
  bool keeps_energy;
};

/// Local damping takes a share of every component of the force that does work and adds it to one that
/// is worked against (Cundall and Strack 1979). @param push  change of velocity in the step, undamped
PUADEM_INLINE Lanes damped(const Lanes& push, const Lanes& velocity, double damping) {
  const Lanes power = push * (velocity + 0.5 * push);
  const Lanes zero{};
  return push * (power > zero ? broadcast(1.0 - damping) : (power < zero ? broadcast(1.0 + damping) : broadcast(1.0)));
}

/// Tangent of half the angle turned in a step, along the axis; tan(x) / x in powers of x^2. The material stays.
PUADEM_INLINE Lanes turn_of(const GrainRecord& r, double dt) {
  const Lanes half = (0.5 * dt) * Lanes{1.0, 1.0, 1.0, 0.0} * r.spin;
  const double x2 = half[0] * half[0] + half[1] * half[1] + half[2] * half[2];
  const double ratio = 1.0 + x2 * (1.0 / 3.0 + x2 * (2.0 / 15.0 + x2 * (17.0 / 315.0)));
  return half * broadcast(ratio) + Lanes{0.0, 0.0, 0.0, r.turn[3]};
}

void set_turns(GrainSystem& s) {
  for (GrainRecord& r : s.record) r.turn = turn_of(r, s.time_step);
}

/// What a chunk of grains hands back.
struct Motion {
  double fastest = 0.0;  ///< largest squared speed relative to the box [m2/s2]
  double damping = 0.0;  ///< energy lost to local damping [J]
  double body = 0.0;     ///< work of gravity and external forces [J]
  double box = 0.0;      ///< work of the straining box, images left out [J]
};

PUADEM_INLINE double dot3(const Lanes& a, const Lanes& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

PUADEM_INLINE Lanes sum_couples(const RollSlot* slot, const int* row, int begin, int end) {
  Lanes sum{};
  for (int e = begin; e < end; ++e) sum += broadcast((row[e] & 1) != 0 ? 1.0 : -1.0) * slot[row[e] >> 1].moment;
  return sum;
}

PUADEM_CLONES Motion move_chunk(const MotionLoop& loop, int begin, int end) {
  const double dt = loop.time_step;
  const Lanes step{dt, dt, dt, 0.0};  // keeps what stands in the fourth place
  Motion motion;
  for (int k = begin; k < end; ++k) {
    SlotSum sum = sum_slots(loop.slot, loop.row, loop.row_start[k], loop.row_start[k + 1]);
    if (loop.bridges != nullptr) sum.force += loop.bridges[k].force;
    GrainRecord r = loop.record[k];
    Lanes body = broadcast(r.drift[3]) * loop.gravity;
    if (loop.external != nullptr) {
      const Vec3& f = loop.external[loop.identity[k]];
      body += Lanes{f.x, f.y, f.z, 0.0};
    }
    Lanes couple = broadcast(-r.place[3]) * sum.moment;
    if (loop.roll_slot != nullptr) couple += sum_couples(loop.roll_slot, loop.row, loop.row_start[k], loop.row_start[k + 1]);
    const Lanes push = step * (sum.force + body) * broadcast(1.0 / r.drift[3]),
                spin_push = step * couple * broadcast(1.0 / r.spin[3]);
    const Lanes field = loop.strain_rate * (r.place - loop.lower);
    Lanes change = push, spin_change = spin_push;
    if (loop.damping > 0.0) {
      change = damped(push, r.drift - field, loop.damping);
      spin_change = damped(spin_push, r.spin, loop.damping);
    }
    if (loop.keeps_energy) {  // with the mean of the velocities before and after, the balance of a step is exact
      const Lanes mean = r.drift + 0.5 * change - field, mean_spin = r.spin + 0.5 * spin_change;
      motion.damping += r.drift[3] * dot3(push - change, mean) + r.spin[3] * dot3(spin_push - spin_change, mean_spin);
      motion.body += dt * dot3(body, mean);
      motion.box -= dt * dot3(loop.booked_rate, sum.force * (r.place - loop.lower) + r.drift[3] * mean * mean);
    }
    r.drift += change;
    r.spin += spin_change;
    const Lanes relative = r.drift - field;
    r.place += step * r.drift;
    r.turn = turn_of(r, dt);
    loop.record[k] = r;
    const double speed2 = dot3(relative, relative);
    motion.fastest = speed2 > motion.fastest || speed2 != speed2 ? speed2 : motion.fastest;
  }
  return motion;
}

void move_box(GrainSystem& s) {
  const Vec3 size = s.domain.size();
  double wall_speed = 0.0;
  for (Wall& wall : s.walls) {
    if (s.energy.is_kept) s.energy.walls -= 0.5 * s.time_step * dot(wall.force, wall.last_velocity + wall.velocity);
    wall.last_velocity = wall.velocity;
    wall.point += s.time_step * wall.velocity;
    wall_speed = std::max(wall_speed, std::abs(dot(wall.velocity, wall.normal)));
  }
  s.domain.upper += s.time_step * s.box_rate;
  for (const Wall& wall : s.walls)  // a servo wall takes its face of the box along
    if (wall.target && wall.face >= 0)
      (is_upper(wall.face) ? s.domain.upper : s.domain.lower)[axis_of(wall.face)] = wall.point[axis_of(wall.face)];
  const double shortening = std::max({-s.box_rate.x / size.x, -s.box_rate.y / size.y, -s.box_rate.z / size.z, 0.0});
  const double other = s.motion.strain_with_box ? s.drift_limit : std::max(s.drift_limit, wall_speed);
  // How far apart two listed grains can be: where grains follow the box they are neighbours, and the box is
  // wider than five radii; else an image moves with the whole box.
  const double reach = s.motion.strain_with_box ? 0.5 * std::min({size.x, size.y, size.z}) : std::max({size.x, size.y, size.z});
  s.slack += s.time_step * (s.drift_limit + other + shortening * reach);
}

void guard_motion(const GrainSystem& s) {
  ensure(std::isfinite(s.drift_limit),
         "step {}: a grain's velocity is not a number; the time step {:.3g} s is too long or the input is not finite", s.steps,
         s.time_step);
}

}  // namespace

void evaluate_forces(GrainSystem& system) {
  if (system.is_evaluated) return;  // the shear history takes up a displacement once
  if (system.steps == 0) set_turns(system);
  renew_neighbour_list(system);
  update_images(system);
  update_contact_forces(system);
  if (system.bridges) follow_bridges(system);
  system.is_evaluated = true;
}

void move_grains(GrainSystem& s) {
  const Vec3 size = s.domain.size();
  Lanes strain_rate{};
  if (s.motion.strain_with_box) strain_rate = Lanes{s.box_rate.x / size.x, s.box_rate.y / size.y, s.box_rate.z / size.z, 0.0};
  const Vec3 booked = 0.5 * (s.energy.last_box_rate + s.box_rate);
  const MotionLoop loop{
      .record = s.record.data(),
      .slot = s.slot.data(),
      .roll_slot = s.roll_slot.empty() ? nullptr : s.roll_slot.data(),
      .bridges = s.bridges ? s.bridges->list.pull.data() : nullptr,
      .row_start = s.row_start.data(),
      .row = s.row.data(),
      .identity = s.identity.data(),
      .external = s.external_force.empty() ? nullptr : s.external_force.data(),
      .gravity = Lanes{s.motion.gravity.x, s.motion.gravity.y, s.motion.gravity.z, 0.0},
      .lower = Lanes{s.domain.lower.x, s.domain.lower.y, s.domain.lower.z, 0.0},
      .strain_rate = strain_rate,
      .booked_rate = s.motion.strain_with_box ? Lanes{booked.x / size.x, booked.y / size.y, booked.z / size.z, 0.0} : Lanes{},
      .time_step = s.time_step,
      .damping = s.motion.damping,
      .keeps_energy = s.energy.is_kept};
  const int chunks = (s.owned + grains_per_chunk - 1) / grains_per_chunk;
  std::vector<Motion> moved(to_size(chunks));
  parallel_for(
      chunks,
      [&](int chunk) {
        const int begin = chunk * grains_per_chunk;
        moved[to_size(chunk)] = move_chunk(loop, begin, std::min(begin + grains_per_chunk, s.owned));
      },
      s.owned < grains_worth_threads ? chunks : 1);
  double squared = 0.0;
  for (const Motion& m : moved) {
    squared = m.fastest > squared || m.fastest != m.fastest ? m.fastest : squared;
    s.energy.damping += m.damping;
    s.energy.body += m.body;
    s.energy.box += m.box;
  }
  s.drift_limit = std::sqrt(squared);
  if (s.energy.is_kept && s.motion.strain_with_box) s.energy.box += s.time_step * image_power(s, booked);
  s.energy.last_box_rate = s.box_rate;
  move_box(s);
  ++s.steps;
  s.is_evaluated = false;
  guard_motion(s);
}

void advance_grains(GrainSystem& system, long steps) {
  for (long step = 0; step < steps; ++step) {
    evaluate_forces(system);
    if (system.steps % guard_interval == 0) guard_grains(system);
    steer_walls(system);
    move_grains(system);
  }
}

TimeStepLimit critical_time_step(const GrainSystem& s) {
  std::vector<Vec3> push(to_size(s.owned)), roll(to_size(s.owned));
  const auto add = [&](int record, const Vec3& normal, double kn, double ks, double other_radius) {
    const double r = radius_of(s.record[to_size(record)]);
    const double bend = resists_rolling(s.contact) ? s.contact.rolling_stiffness * ks * r * other_radius : 0.0;
    const double twist = resists_rolling(s.contact) ? s.contact.twisting_stiffness * ks * r * other_radius : 0.0;
    for (int axis = 0; axis < 3; ++axis) {
      const double n2 = normal[axis] * normal[axis];
      push[to_size(record)][axis] += kn * n2 + ks * (1.0 - n2);
      roll[to_size(record)][axis] += (ks * r * r + bend) * (1.0 - n2) + twist * n2;
    }
  };
  std::visit(
      [&]<ContactLaw Law>(const Law&) {
        for_each_grain_contact(s, [&](int first, int second, const Vec3& branch, int slot) {
          const int i = owner_of(s, first), j = owner_of(s, second);
          const auto& pair =
              s.pairs.grains[to_size(material_of(s.record[to_size(i)]) * s.pairs.materials + material_of(s.record[to_size(j)]))];
          const double kn = s.slot[to_size(slot)].moment[3];
          const double ks = pair.friction > 0.0 || resists_rolling(s.contact) ? Law::stiffness_ratio(pair) * kn : 0.0;
          add(i, normalized(branch), kn, ks, radius_of(s.record[to_size(j)]));
          add(j, normalized(branch), kn, ks, radius_of(s.record[to_size(i)]));
        });
        for_each_wall_contact(s, [&](int wall, int record, const Vec3&, int slot) {
          const auto& pair = s.pairs.walls[to_size(material_of(s.record[to_size(record)]))];
          const double kn = s.slot[to_size(slot)].moment[3];
          const double ks =
              s.walls[to_size(wall)].friction > 0.0 || resists_rolling(s.contact) ? Law::stiffness_ratio(pair) * kn : 0.0;
          add(record, s.walls[to_size(wall)].normal, kn, ks, radius_of(s.record[to_size(record)]));
        });
      },
      s.law);
  constexpr double none = std::numeric_limits<double>::infinity();
  TimeStepLimit limit{.critical = none};
  for (int k = 0; k < s.owned; ++k) {
    const GrainRecord& r = s.record[to_size(k)];
    const double kt = std::max({push[to_size(k)].x, push[to_size(k)].y, push[to_size(k)].z});
    const double kr = std::max({roll[to_size(k)].x, roll[to_size(k)].y, roll[to_size(k)].z});
    const double by_push = kt > 0.0 ? std::sqrt(2.0 * mass_of(r) / kt) : none;
    const double by_roll = kr > 0.0 ? std::sqrt(2.0 * inertia_of(r) / kr) : none;
    const double least = std::min(by_push, by_roll);
    const int id = s.identity[to_size(k)];
    if (least < limit.critical || (least == limit.critical && limit.grain > id)) limit = {least, id, by_roll < by_push};
  }
  return limit;
}

void set_box_rate(GrainSystem& s, const Vec3& rate) {
  const Vec3 change = rate - s.box_rate, size = s.domain.size();
  if (s.motion.strain_with_box)
    for (int k = 0; k < s.owned; ++k) {
      GrainRecord& r = s.record[to_size(k)];
      for (int axis = 0; axis < 3; ++axis) r.drift[axis] += change[axis] * (r.place[axis] - s.domain.lower[axis]) / size[axis];
    }
  for (Wall& wall : s.walls)
    if (wall.face >= 0 && is_upper(wall.face)) wall.velocity[axis_of(wall.face)] = rate[axis_of(wall.face)];
  s.box_rate = rate;
}

void steer_walls(GrainSystem& s) {
  for (Wall& wall : s.walls) {
    if (!wall.target) continue;
    const Vec3 push = wall.servo_stress == ServoStress::total ? wall.force + wall.fluid_force : wall.force;
    const double missing = *wall.target * wall.area + dot(push, wall.normal);  // they push against the normal
    const double wanted = wall.stiffness > 0.0 ? wall.servo_gain * missing / (wall.stiffness * s.time_step) : wall.speed_limit;
    wall.velocity = std::clamp(wanted, -wall.speed_limit, wall.speed_limit) * wall.normal + wall.slide;
  }
}

}  // namespace puadem
