#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "puadem/base/large_array.hpp"
#include "puadem/dem/contact_law.hpp"
#include "puadem/dem/grain_bridges.hpp"
#include "puadem/dem/lanes.hpp"
#include "puadem/dem/material.hpp"
#include "puadem/dem/particles.hpp"
#include "puadem/dem/walls.hpp"
#include "puadem/geometry/domain.hpp"

namespace puadem {

/// All that a contact asks of a grain, in two cache lines. The velocities are those of the half step
/// behind the position, so that the last displacement is `velocity * time_step` to the last bit.
struct alignas(128) GrainRecord {
  Lanes place;  ///< x, y, z [m], radius [m]
  Lanes drift;  ///< velocity [m/s], mass [kg]
  Lanes turn;   ///< tan(|w| dt / 2) w / |w| of the last step [-], material
  Lanes spin;   ///< angular velocity w [rad/s], moment of inertia [kg m2]
};

/// Force and moment of one contact, written by the contact and read by both grains.
struct alignas(64) ContactSlot {
  Lanes force;   ///< on the second grain [N], normal force F_n [N]
  Lanes moment;  ///< normal x shear force [N]; times -R it is the torque on either grain; tangent stiffness k_n [N/m]
};

/// Moment by which a contact resists rolling and twisting, on the second grain [N m].
struct alignas(32) RollSlot {
  Lanes moment;
};

/// History of that moment: its part across the normal, and about it [N m].
struct alignas(32) RollHistory {
  LaneVec3 bend;
  Lanes twist;
};

/// History of the viscous part of a contact, 0 where there was none: w of theory 2.8 [m/s].
struct alignas(32) ViscousHistory {
  Lanes pace;
};

/// Candidate contacts in blocks of four; a block is padded with the dummy record. Between grains the first
/// has the lower identity, so that a contact has one orientation however the records are sorted. A
/// contact with a wall names the grain as second.
struct ContactBlocks {
  LargeArray<std::array<int, 4>> first;  ///< record indices; for wall contacts the wall
  LargeArray<std::array<int, 4>> second;
  LargeArray<LaneVec3> shear;          ///< history: shear force on the second grain [N]
  LargeArray<RollHistory> roll;        ///< empty unless contacts resist rolling
  LargeArray<ViscousHistory> viscous;  ///< empty unless contacts have a viscous part
  std::vector<std::uint8_t> live;      ///< bits of the lanes that touch; 0 where no slot or history of the block is set
  int size() const { return size_of(first); }
};

/// Work done since `is_kept` was set [J]. Stored energies are functions of the state, see energy.hpp.
struct EnergyBook {
  bool is_kept = false;
  double shear = 0.0;    ///< taken up by shear springs and sliders
  double roll = 0.0;     ///< taken up by rolling and twisting springs and sliders
  double viscous = 0.0;  ///< lost in viscous contacts
  double damping = 0.0;  ///< lost to local damping
  double walls = 0.0;    ///< done by walls on grains
  double box = 0.0;      ///< done by the straining of a box that the grains follow
  Vec3 last_box_rate;    ///< of the step before [m/s]
  double body = 0.0;     ///< done by gravity and external forces
  double wetting = 0.0;  ///< given off where liquid forms bridges or moves between them
};

/// How grains are moved.
struct MotionOptions {
  double damping = 0.0;          ///< lambda of Cundall's local damping [-]
  Vec3 gravity{};                ///< [m/s2]
  double safety = 0.3;           ///< share of the critical time step [-]
  bool strain_with_box = false;  ///< grains follow the box: its rate of strain acts on all of them at once
};

/// What the grain engine holds between steps: plain data, worked on by the free functions of this module.
/// Grains live in `record`, sorted along a space-filling curve; `identity` leads back to `Particles`.
struct GrainSystem {
  Domain domain;
  Vec3 box_rate;  ///< velocity of the upper corner, the lower one stands [m/s]
  std::vector<Wall> walls;
  MaterialPairs pairs;
  ContactOptions contact;
  AnyContactLaw law;
  MotionOptions motion;
  double time_step = 0.0;  ///< [s]
  long steps = 0;
  bool is_evaluated = false;  ///< do the slots belong to the present places?
  EnergyBook energy;
  std::vector<Vec3> external_force;  ///< by identity [N]; empty: none

  int owned = 0;  ///< grains; images follow them, then one dummy
  LargeArray<GrainRecord> record;
  std::vector<int> identity;                    ///< of every owned grain and image
  std::vector<int> image_owner;                 ///< record of the grain that image k repeats
  std::vector<std::array<int, 3>> image_shift;  ///< in box lengths

  double skin = 0.0;            ///< of the neighbour list [m]
  double slack = 0.0;           ///< bound on the approach since the list was made [m]
  double grown = 0.0;           ///< bound on the growth of a radius since the list was made [m]
  double drift_limit = 0.0;     ///< largest speed relative to the box in the last step [m/s]
  std::vector<Vec3> listed_at;  ///< positions at which the list was made, by record [m]
  Domain listed_in;             ///< the box then
  std::vector<Vec3> walls_listed_at;
  long listed_step = 0;
  int list_builds = 0;

  ContactBlocks grain_contacts;
  ContactBlocks wall_contacts;
  std::vector<int> wall_start;     ///< blocks of wall w: wall_start[w] .. wall_start[w + 1]
  LargeArray<ContactSlot> slot;    ///< of grain contacts, then of wall contacts
  LargeArray<RollSlot> roll_slot;  ///< like `slot`; empty unless contacts resist rolling
  LargeArray<int> row_start;       ///< slots of record k: row[row_start[k]] .. row[row_start[k + 1]], by identity of the partner
  LargeArray<int> row;             ///< 2 * slot + (is the grain the second one)

  std::optional<GrainBridges> bridges;  ///< none: dry grains
};

/// A system that holds `particles` in a box with six walls or periodic faces, list and forces not yet made.
/// @throws InputError  a grain outside the box, a periodic box narrower than two of the largest grains
GrainSystem make_grain_system(const Particles& particles, const Domain& domain, std::span<const Material> materials,
                              const ContactOptions& contact, const MotionOptions& motion);

/// Writes places, velocities, resultant forces and torques back in order of identity.
void collect(const GrainSystem& system, Particles& particles);

/// The places alone, within the box.
void collect_places(const GrainSystem& system, Particles& particles);

/// Have contacts a viscous part?
inline bool has_dashpots(const GrainSystem& s) {
  const auto is_viscous = [](const PairConstants<double>& pair) { return pair.damping > 0.0; };
  return std::any_of(s.pairs.grains.begin(), s.pairs.grains.end(), is_viscous) ||
         std::any_of(s.pairs.walls.begin(), s.pairs.walls.end(), is_viscous);
}

inline double radius_of(const GrainRecord& r) { return r.place[3]; }
inline double mass_of(const GrainRecord& r) { return r.drift[3]; }
inline double inertia_of(const GrainRecord& r) { return r.spin[3]; }
inline Vec3 vec3(const Lanes& a) { return {a[0], a[1], a[2]}; }

}  // namespace puadem
