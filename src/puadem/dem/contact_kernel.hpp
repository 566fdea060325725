#pragma once

#include <limits>

#include "puadem/dem/contact_law.hpp"
#include "puadem/dem/grain_system.hpp"

namespace puadem {

// The arithmetic of four contacts at once, the same for grains and walls. Only contact_forces.cpp and
// bridge_forces.cpp include it: the loops there are what is compiled for several machines.

/// Four quantities of four grains, one grain a lane.
struct Quad {
  LaneVec3 vector;
  Lanes scalar;
};

template <Lanes GrainRecord::*field>
PUADEM_INLINE Quad load(const GrainRecord* record, const std::array<int, 4>& k) {
  Lanes a = record[k[0]].*field, b = record[k[1]].*field, c = record[k[2]].*field, d = record[k[3]].*field;
  transpose(a, b, c, d);
  return {{a, b, c}, d};
}

/// How the line of centres moved in the last step.
struct Frame {
  LaneVec3 normal;  ///< n, from the first to the second [-]
  LaneVec3 change;  ///< n - n_old [-]
};

/// n_old follows from the displacement without a second square root: |d| / |d_old| = 1 - c to the
/// fifth order of the change of length in one step, below rounding for changes under a thousandth.
PUADEM_INLINE Frame follow_line(const LaneVec3& branch, const LaneVec3& displacement, const Lanes& inverse_length) {
  const LaneVec3 normal = inverse_length * branch;
  const LaneVec3 step = inverse_length * displacement;
  const Lanes e = dot(step, step) - 2.0 * dot(normal, step);
  const Lanes c = e * (0.5 - e * (0.375 - e * (0.3125 - e * 0.2734375)));
  return {normal, (1.0 - c) * step + c * normal};
}

/// Turns a vector that lay across n_old with the contact: by the smallest rotation from n_old to n, then
/// about n by the angle 2 atan(t). Exact for a rigid motion of the pair, theory 2.3.
PUADEM_INLINE LaneVec3 turn_with_contact(const LaneVec3& h, const Frame& f, const Lanes& t) {
  const Lanes q = 0.25 * dot(f.change, f.change);  // 1 / (1 + n.n_old) = 1 / (2 - 2 q)
  const Lanes along = 0.5 * dot(h, f.normal) * (1.0 + q * (1.0 + q));
  const LaneVec3 swung = h - along * (2.0 * f.normal - f.change);
  const Lanes t2 = t * t;
  const Lanes inverse = 1.0 - t2 * (1.0 - t2);
  return ((1.0 - t2) * inverse) * swung + (2.0 * t * inverse) * cross(f.normal, swung);
}

/// What the two kinds of contact hand to the common part.
struct Approach {
  Frame frame;
  LaneMask touching;
  Lanes overlap;           ///< [m]
  Lanes effective_radius;  ///< [m]
  Lanes share_i;           ///< R_i / (R_i + R_j) [-]
  LaneVec3 slip;           ///< of j's surface over i's in the last step [m]
  Lanes twist;             ///< tangent of half the mean turn about n [-]
  Lanes lever;             ///< (R_i + R_j) / |d|, factor from generalised to real shear force [-]
  Lanes inverse_lever;     ///< [-]
  Lanes approach_speed;    ///< -d|d|/dt [m/s]
  Lanes effective_mass;    ///< [kg]
  LaneVec3 rotation;       ///< of j against i in the last step [rad]; used where contacts resist rolling
  Lanes radius_product;    ///< R_i R_j, R_i^2 at a wall [m2]
  Lanes smaller_radius;    ///< [m]
};

/// Work of the contacts of a chunk in one step [J].
struct alignas(32) ContactWork {
  Lanes shear{}, roll{}, viscous{};
};

PUADEM_INLINE LaneVec3 masked(const LaneMask& mask, const LaneVec3& v) {
  const Lanes zero{};
  return {mask ? v.x : zero, mask ? v.y : zero, mask ? v.z : zero};
}

/// Elastic-plastic moments against rolling and twisting, theory 2.9.
PUADEM_INLINE void resist_rolling(const Approach& a, const ContactResponse<Lanes>& response, const ContactOptions& options,
                                  RollHistory& history, RollSlot* slot, ContactWork& work) {
  const LaneVec3& n = a.frame.normal;
  const Lanes about = dot(a.rotation, n);
  const LaneVec3 across = a.rotation - about * n;
  const Lanes stiffness = response.shear * a.radius_product, strength = a.smaller_radius * response.force;
  const Lanes zero{};

  const LaneVec3 old_bend = turn_with_contact(history.bend, a.frame, a.twist);
  LaneVec3 bend = old_bend - (options.rolling_stiffness * stiffness) * across;
  const Lanes bend_limit = options.rolling_friction * strength, size = square_root(dot(bend, bend));
  bend = (size > bend_limit ? bend_limit / size : broadcast(1.0)) * bend;

  Lanes twist = history.twist - options.twisting_stiffness * stiffness * about;
  const Lanes twist_limit = options.twisting_friction * strength;
  twist = twist > twist_limit ? twist_limit : (twist < -twist_limit ? -twist_limit : twist);

  const Lanes done = -0.5 * (dot(old_bend + bend, across) + (history.twist + twist) * about);
  work.roll += a.touching ? done : zero;
  history.bend = masked(a.touching, bend);
  history.twist = a.touching ? twist : zero;
  const LaneVec3 moment = masked(a.touching, bend + twist * n);
  Lanes mx = moment.x, my = moment.y, mz = moment.z, rest = zero;
  transpose(mx, my, mz, rest);
  slot[0].moment = mx;
  slot[1].moment = my;
  slot[2].moment = mz;
  slot[3].moment = rest;
}

/// Viscous part of the normal force, theory 2.8. The speed of approach at the time of the places follows from
/// that of the half step: what bodies other than the contact did to it in the last step, they go on doing, and
/// the contact's own force is solved for. A first or last step counts for the part that the contact lives.
/// @param pace  history of the contact: 0 where it is new, infinite once its last step has been counted, should
///              it outlive that by a little
template <class Law>
PUADEM_INLINE Lanes viscous_force(const Approach& a, const ContactResponse<Lanes>& response, const Lanes& damping,
                                  double time_step, Lanes& pace, Lanes& speed) {
  const Lanes zero{}, one = broadcast(1.0);
  const Lanes half = 0.5 * time_step / a.effective_mass;
  const Lanes dashpot = Law::damping_factor * damping * square_root(a.effective_mass * response.normal);
  const Lanes counted = broadcast(std::numeric_limits<double>::infinity());
  const LaneMask is_over = (pace == counted) & (a.approach_speed < zero);
  const LaneMask is_new = (pace == zero) | (pace == counted);
  speed = is_new ? a.approach_speed : (1.5 * a.approach_speed - pace - half * response.force) / (1.0 + half * dashpot);
  Lanes force = dashpot * speed;
  // Overlap gained in the step that ends here by a new contact, or lost in the next step by an old one.
  const Lanes way = time_step * (is_new ? a.approach_speed : a.approach_speed - 2.0 * speed);
  // A contact that begins or ends at a sampled moment, to rounding, counts there as partial.
  const LaneMask partial = (a.overlap > zero) & (a.overlap < 1.000001 * way);
  if (any(partial)) {
    const Lanes depth = partial ? a.overlap / way : one;
    force = partial ? Law::partial_dashpot(depth) * force : force;
  }
  force = is_over ? zero : force;
  pace = is_over | (partial & ~is_new) ? counted : 0.5 * a.approach_speed - half * (response.force + force);
  pace = a.touching ? pace : zero;
  return force;
}

/// Law, history, Coulomb limit and slots of one block: the same for grains and walls.
template <class Law, bool full>
PUADEM_INLINE ContactResponse<Lanes> finish(const Approach& a, const PairConstants<Lanes>& pair, double time_step,
                                            LaneVec3& history, Lanes* pace, ContactSlot* slot, ContactWork& work) {
  const LaneVec3& n = a.frame.normal;
  const ContactResponse<Lanes> response = Law::respond(pair, a.overlap, a.effective_radius, a.share_i);
  const LaneVec3 slip = a.slip - dot(a.slip, n) * n;
  const LaneVec3 old_shear = turn_with_contact(history, a.frame, a.twist);
  LaneVec3 shear = old_shear - response.shear * slip;

  const Lanes limit = pair.friction * response.force * a.inverse_lever;
  const Lanes squared = dot(shear, shear);
  const LaneMask slides = a.touching & (squared > limit * limit);
  if (any(slides)) shear = (slides ? limit / square_root(squared) : broadcast(1.0)) * shear;

  const Lanes zero{};
  Lanes normal_force = response.force;
  if (pace != nullptr) {
    Lanes speed;
    const Lanes viscous = viscous_force<Law>(a, response, pair.damping, time_step, *pace, speed);
    normal_force += viscous;
    if constexpr (full) work.viscous += a.touching ? viscous * speed * time_step : zero;
  }
  if constexpr (full) work.shear -= a.touching ? 0.5 * dot(old_shear + shear, slip) : zero;

  history = masked(a.touching, shear);
  const LaneVec3 force = masked(a.touching, normal_force * n + a.lever * shear), moment = masked(a.touching, cross(n, shear));
  Lanes fx = force.x, fy = force.y, fz = force.z, fn = a.touching ? normal_force : zero;
  Lanes mx = moment.x, my = moment.y, mz = moment.z, kn = a.touching ? response.normal : zero;
  transpose(fx, fy, fz, fn);
  transpose(mx, my, mz, kn);
  slot[0] = ContactSlot{fx, mx};
  slot[1] = ContactSlot{fy, my};
  slot[2] = ContactSlot{fz, mz};
  slot[3] = ContactSlot{fn, kn};
  return response;
}

/// One bit for every lane that touches.
PUADEM_INLINE std::uint8_t bits(const LaneMask& m) {
  return static_cast<std::uint8_t>((m[0] & 1) | (m[1] & 2) | (m[2] & 4) | (m[3] & 8));
}

/// Empties a block that has lost its last contact.
inline void clear(ContactBlocks& blocks, int b, ContactSlot* slot, RollSlot* roll_slot) {
  blocks.live[to_size(b)] = 0;
  blocks.shear[to_size(b)] = LaneVec3{};
  if (!blocks.viscous.empty()) blocks.viscous[to_size(b)] = ViscousHistory{};
  for (int l = 0; l < lane_count; ++l) slot[l] = ContactSlot{};
  if (blocks.roll.empty()) return;
  blocks.roll[to_size(b)] = RollHistory{};
  for (int l = 0; l < lane_count; ++l) roll_slot[lane_count * b + l] = RollSlot{};
}

PUADEM_INLINE PairConstants<Lanes> spread(const PairConstants<double>& c) {
  return {broadcast(c.youngs),          broadcast(c.shear),    broadcast(c.spring_i), broadcast(c.spring_j),
          broadcast(c.stiffness_ratio), broadcast(c.friction), broadcast(c.damping)};
}

inline PairConstants<Lanes> look_up(const PairConstants<double>* table, const std::array<int, 4>& entry) {
  PairConstants<Lanes> c;
  for (int l = 0; l < lane_count; ++l) {
    const PairConstants<double>& e = table[entry[to_size(l)]];
    c.youngs[l] = e.youngs;
    c.shear[l] = e.shear;
    c.spring_i[l] = e.spring_i;
    c.spring_j[l] = e.spring_j;
    c.stiffness_ratio[l] = e.stiffness_ratio;
    c.friction[l] = e.friction;
    c.damping[l] = e.damping;
  }
  return c;
}

}  // namespace puadem
