#include "puadem/dem/contact_forces.hpp"

#include <variant>

namespace puadem {

namespace {

constexpr int blocks_per_chunk = 64;
constexpr int blocks_worth_threads = 4096;  // below, waking a thread costs more than it does

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
/// about n by the angle 2 atan(t). Exact for a rigid motion of the pair, theory dem 3.
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
  Lanes approach_speed;    ///< -d|d|/dt [m/s]
  Lanes effective_mass;    ///< [kg]
};

/// Law, history, Coulomb limit and slots of one block: the same for grains and walls.
template <class Law>
PUADEM_INLINE void finish(const Approach& a, const PairConstants<Lanes>& pair, LaneVec3& history, ContactSlot* slot) {
  const LaneVec3& n = a.frame.normal;
  const ContactResponse<Lanes> response = Law::respond(pair, a.overlap, a.effective_radius, a.share_i);
  const LaneVec3 slip = a.slip - dot(a.slip, n) * n;
  LaneVec3 shear = turn_with_contact(history, a.frame, a.twist) - response.shear * slip;

  const Lanes limit = pair.friction * response.force / a.lever;
  const Lanes squared = dot(shear, shear);
  const LaneMask slides = a.touching & (squared > limit * limit);
  if (any(slides)) shear = (slides ? limit / square_root(squared) : broadcast(1.0)) * shear;

  Lanes normal_force = response.force;
  if (pair.damping[0] > 0.0)
    normal_force += Law::damping_factor * pair.damping * square_root(a.effective_mass * response.normal) * a.approach_speed;

  const Lanes zero{};
  const auto masked = [&](const Lanes& value) { return a.touching ? value : zero; };
  history = LaneVec3{masked(shear.x), masked(shear.y), masked(shear.z)};
  const LaneVec3 moment = cross(n, shear);
  Lanes fx = masked(normal_force * n.x + a.lever * shear.x), mx = masked(moment.x);
  Lanes fy = masked(normal_force * n.y + a.lever * shear.y), my = masked(moment.y);
  Lanes fz = masked(normal_force * n.z + a.lever * shear.z), mz = masked(moment.z);
  Lanes fn = masked(normal_force), kn = masked(response.normal);
  transpose(fx, fy, fz, fn);
  transpose(mx, my, mz, kn);
  slot[0] = ContactSlot{fx, mx};
  slot[1] = ContactSlot{fy, my};
  slot[2] = ContactSlot{fz, mz};
  slot[3] = ContactSlot{fn, kn};
}

void clear(LaneVec3& history, ContactSlot* slot) {
  history = LaneVec3{};
  for (int l = 0; l < lane_count; ++l) slot[l] = ContactSlot{};
}

PUADEM_INLINE PairConstants<Lanes> spread(const PairConstants<double>& c) {
  return {broadcast(c.youngs),          broadcast(c.shear),    broadcast(c.spring_i), broadcast(c.spring_j),
          broadcast(c.stiffness_ratio), broadcast(c.friction), broadcast(c.damping)};
}

PairConstants<Lanes> look_up(const PairConstants<double>* table, const std::array<int, 4>& entry) {
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

struct GrainLoop {
  const GrainRecord* record;
  const PairConstants<double>* table;
  int materials;
  double time_step;
  ContactBlocks* blocks;
  ContactSlot* slot;
};

template <class Law>
PUADEM_CLONES void grain_blocks(const GrainLoop& loop, int begin, int end) {
  const GrainRecord* record = loop.record;
  const std::array<int, 4>* first = loop.blocks->first.data();
  const std::array<int, 4>* second = loop.blocks->second.data();
  const bool uniform = loop.materials == 1;
  PairConstants<Lanes> pair = spread(loop.table[0]);
  const Lanes dt = broadcast(loop.time_step);
  for (int b = begin; b < end; ++b) {
    const Quad at_i = load<&GrainRecord::place>(record, first[b]), at_j = load<&GrainRecord::place>(record, second[b]);
    const LaneVec3 branch = at_j.vector - at_i.vector;
    const Lanes reach = at_i.scalar + at_j.scalar;
    const Lanes squared = dot(branch, branch);
    Approach a;
    a.touching = squared < reach * reach;
    std::uint8_t& live = loop.blocks->live[to_size(b)];
    LaneVec3& history = loop.blocks->shear[to_size(b)];
    ContactSlot* slot = loop.slot + lane_count * b;
    if (!any(a.touching)) {
      if (live != 0) clear(history, slot);
      live = 0;
      continue;
    }
    live = 1;
    const Quad drift_i = load<&GrainRecord::drift>(record, first[b]), drift_j = load<&GrainRecord::drift>(record, second[b]);
    const Quad turn_i = load<&GrainRecord::turn>(record, first[b]), turn_j = load<&GrainRecord::turn>(record, second[b]);

    const Lanes length = square_root(squared);
    const Lanes inverse = 1.0 / (length * reach);  // one division for 1/|d| and 1/(R_i + R_j)
    const Lanes inverse_length = inverse * reach;
    const LaneVec3 velocity = drift_j.vector - drift_i.vector;
    a.frame = follow_line(branch, dt * velocity, inverse_length);
    a.overlap = a.touching ? reach - length : Lanes{};
    a.share_i = at_i.scalar * inverse * length;
    a.effective_radius = a.share_i * at_j.scalar;
    a.lever = reach * inverse_length;
    const LaneVec3 roll = at_i.scalar * turn_i.vector + at_j.scalar * turn_j.vector;
    a.slip = reach * a.frame.change - cross(roll, 2.0 * a.frame.normal - a.frame.change);
    a.twist = 0.5 * dot(turn_i.vector + turn_j.vector, a.frame.normal);
    a.approach_speed = -dot(velocity, a.frame.normal);
    a.effective_mass = drift_i.scalar * drift_j.scalar / (drift_i.scalar + drift_j.scalar);
    if (!uniform) {
      std::array<int, 4> entry;
      for (int l = 0; l < lane_count; ++l)
        entry[to_size(l)] = static_cast<int>(turn_i.scalar[l]) * loop.materials + static_cast<int>(turn_j.scalar[l]);
      pair = look_up(loop.table, entry);
    }
    finish<Law>(a, pair, history, slot);
  }
}

struct WallLoop {
  const GrainRecord* record;
  const PairConstants<double>* table;
  int materials;
  double time_step;
  const Wall* wall;
  ContactBlocks* blocks;
  ContactSlot* slot;  ///< of wall block 0
};

/// A plane is a body of infinite radius that does not turn: the normal stands, the lever is one.
template <class Law>
PUADEM_CLONES void wall_blocks(const WallLoop& loop, int begin, int end) {
  const Wall& wall = *loop.wall;
  const LaneVec3 normal{broadcast(wall.normal.x), broadcast(wall.normal.y), broadcast(wall.normal.z)};
  const LaneVec3 point{broadcast(wall.point.x), broadcast(wall.point.y), broadcast(wall.point.z)};
  const LaneVec3 speed{broadcast(wall.velocity.x), broadcast(wall.velocity.y), broadcast(wall.velocity.z)};
  const Lanes dt = broadcast(loop.time_step);
  for (int b = begin; b < end; ++b) {
    const std::array<int, 4>& grain = loop.blocks->second[to_size(b)];
    const Quad at = load<&GrainRecord::place>(loop.record, grain);
    const Lanes distance = dot(at.vector - point, normal);
    Approach a;
    a.touching = distance < at.scalar;
    std::uint8_t& live = loop.blocks->live[to_size(b)];
    LaneVec3& history = loop.blocks->shear[to_size(b)];
    ContactSlot* slot = loop.slot + lane_count * b;
    if (!any(a.touching)) {
      if (live != 0) clear(history, slot);
      live = 0;
      continue;
    }
    live = 1;
    const Quad drift = load<&GrainRecord::drift>(loop.record, grain);
    const Quad turn = load<&GrainRecord::turn>(loop.record, grain);
    const LaneVec3 velocity = drift.vector - speed;
    a.frame = {normal, LaneVec3{}};
    a.overlap = a.touching ? at.scalar - distance : Lanes{};
    a.effective_radius = at.scalar;
    a.share_i = Lanes{};
    a.lever = broadcast(1.0);
    a.slip = dt * velocity - cross(2.0 * at.scalar * turn.vector, normal);
    a.twist = 0.5 * dot(turn.vector, normal);
    a.approach_speed = -dot(velocity, normal);
    a.effective_mass = drift.scalar;
    std::array<int, 4> entry{};
    if (loop.materials > 1)
      for (int l = 0; l < lane_count; ++l) entry[to_size(l)] = static_cast<int>(turn.scalar[l]);
    PairConstants<Lanes> pair = loop.materials > 1 ? look_up(loop.table, entry) : spread(loop.table[0]);
    pair.friction = broadcast(wall.friction);
    finish<Law>(a, pair, history, slot);
  }
}

/// Force of the grains on wall w and stiffness of its contacts. Wall contacts are listed by identity, so
/// the sum does not know how the records are sorted.
void sum_wall_force(GrainSystem& system, int w, const ContactSlot* slot) {
  Lanes force{}, moment{};
  for (int s = lane_count * system.wall_start[to_size(w)]; s < lane_count * system.wall_start[to_size(w) + 1]; ++s) {
    force += slot[s].force;
    moment += slot[s].moment;
  }
  system.walls[to_size(w)].force = -vec3(force);
  system.walls[to_size(w)].stiffness = moment[3];
}

}  // namespace

void update_contact_forces(GrainSystem& system) {
  std::visit(
      [&]<ContactLaw Law>(const Law&) {
        const GrainLoop loop{system.record.data(), system.pairs.grains.data(), system.pairs.materials,
                             system.time_step,     &system.grain_contacts,     system.slot.data()};
        const int blocks = system.grain_contacts.size();
        parallel_for((blocks + blocks_per_chunk - 1) / blocks_per_chunk,
                     [&](int chunk) {
                       const int begin = chunk * blocks_per_chunk;
                       grain_blocks<Law>(loop, begin, std::min(begin + blocks_per_chunk, blocks));
                     },
                     blocks < blocks_worth_threads ? blocks : 8);
        ContactSlot* wall_slot = system.slot.data() + lane_count * blocks;
        for (int w = 0; w < size_of(system.walls); ++w) {
          const WallLoop wall_loop{system.record.data(),
                                   system.pairs.walls.data(),
                                   system.pairs.materials,
                                   system.time_step,
                                   &system.walls[to_size(w)],
                                   &system.wall_contacts,
                                   wall_slot};
          wall_blocks<Law>(wall_loop, system.wall_start[to_size(w)], system.wall_start[to_size(w) + 1]);
          sum_wall_force(system, w, wall_slot);
        }
      },
      system.law);
}

}  // namespace puadem
