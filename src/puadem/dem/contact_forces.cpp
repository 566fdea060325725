#include "puadem/dem/contact_forces.hpp"

#include <variant>

#include "puadem/dem/contact_kernel.hpp"

namespace puadem {

namespace {

constexpr int blocks_per_chunk = 64;
constexpr int blocks_ahead = 4;            // whose records are asked for while a block is worked on
constexpr int blocks_worth_threads = 512;  // below, a second thread brings nothing

struct GrainLoop {
  const GrainRecord* record;
  const PairConstants<double>* table;
  int materials;
  double time_step;
  ContactBlocks* blocks;
  ContactSlot* slot;
  const ContactOptions* contact;
  RollSlot* roll_slot;  ///< null without rolling resistance
};

/// @tparam full  with rolling resistance and the energy book
/// @param done   work of the chunk, written where `full`
template <class Law, bool full>
PUADEM_CLONES void grain_blocks(const GrainLoop& loop, int begin, int end, ContactWork* done) {
  ContactWork work;
  const GrainRecord* record = loop.record;
  const std::array<int, 4>* first = loop.blocks->first.data();
  const std::array<int, 4>* second = loop.blocks->second.data();
  const bool uniform = loop.materials == 1;
  PairConstants<Lanes> pair = spread(loop.table[0]);
  const Lanes dt = broadcast(loop.time_step);
  for (int b = begin; b < end; ++b) {
    if (b + blocks_ahead < end)
      for (const auto* four : {first, second})
        for (const int k : four[b + blocks_ahead]) {
          __builtin_prefetch(record + k);
          __builtin_prefetch(&record[k].turn);
        }
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
      if (live != 0) clear(*loop.blocks, b, slot, loop.roll_slot);
      continue;
    }
    live = bits(a.touching);
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
    a.inverse_lever = squared * inverse;
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
    Lanes* pace = loop.blocks->viscous.empty() ? nullptr : &loop.blocks->viscous[to_size(b)].pace;
    const auto response = finish<Law, full>(a, pair, loop.time_step, history, pace, slot, work);
    if constexpr (full)
      if (loop.roll_slot != nullptr) {
        a.rotation = 2.0 * (turn_j.vector - turn_i.vector);
        a.radius_product = at_i.scalar * at_j.scalar;
        a.smaller_radius = at_i.scalar < at_j.scalar ? at_i.scalar : at_j.scalar;
        resist_rolling(a, response, *loop.contact, loop.blocks->roll[to_size(b)], loop.roll_slot + lane_count * b, work);
      }
  }
  if constexpr (full) *done = work;
}

struct WallLoop {
  const GrainRecord* record;
  const PairConstants<double>* table;
  int materials;
  double time_step;
  const Wall* wall;
  ContactBlocks* blocks;
  ContactSlot* slot;  ///< of wall block 0
  const ContactOptions* contact;
  RollSlot* roll_slot;  ///< of wall block 0, or null
};

/// A plane is a body of infinite radius that does not turn: the normal stands, the lever is one.
template <class Law, bool full>
PUADEM_CLONES void wall_blocks(const WallLoop& loop, int begin, int end, ContactWork* done) {
  ContactWork work;
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
      if (live != 0) clear(*loop.blocks, b, slot, loop.roll_slot);
      continue;
    }
    live = bits(a.touching);
    const Quad drift = load<&GrainRecord::drift>(loop.record, grain);
    const Quad turn = load<&GrainRecord::turn>(loop.record, grain);
    const LaneVec3 velocity = drift.vector - speed;
    a.frame = {normal, LaneVec3{}};
    a.overlap = a.touching ? at.scalar - distance : Lanes{};
    a.effective_radius = at.scalar;
    a.share_i = Lanes{};
    a.lever = a.inverse_lever = broadcast(1.0);
    a.slip = dt * velocity - cross(2.0 * at.scalar * turn.vector, normal);
    a.twist = 0.5 * dot(turn.vector, normal);
    a.approach_speed = -dot(velocity, normal);
    a.effective_mass = drift.scalar;
    std::array<int, 4> entry{};
    if (loop.materials > 1)
      for (int l = 0; l < lane_count; ++l) entry[to_size(l)] = static_cast<int>(turn.scalar[l]);
    PairConstants<Lanes> pair = loop.materials > 1 ? look_up(loop.table, entry) : spread(loop.table[0]);
    pair.friction = broadcast(wall.friction);
    Lanes* pace = loop.blocks->viscous.empty() ? nullptr : &loop.blocks->viscous[to_size(b)].pace;
    const auto response = finish<Law, full>(a, pair, loop.time_step, history, pace, slot, work);
    if constexpr (full)
      if (loop.roll_slot != nullptr) {
        a.rotation = 2.0 * turn.vector;
        a.radius_product = at.scalar * at.scalar;
        a.smaller_radius = at.scalar;
        resist_rolling(a, response, *loop.contact, loop.blocks->roll[to_size(b)], loop.roll_slot + lane_count * b, work);
      }
  }
  if constexpr (full) *done = work;
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

/// Blocks of one wall that one thread does in one go.
struct WallChunk {
  int wall, begin, end;
};

std::vector<WallChunk> wall_chunks(const GrainSystem& s) {
  std::vector<WallChunk> chunks;
  for (int w = 0; w < size_of(s.walls); ++w)
    for (int b = s.wall_start[to_size(w)]; b < s.wall_start[to_size(w) + 1]; b += blocks_per_chunk)
      chunks.push_back({w, b, std::min(b + blocks_per_chunk, s.wall_start[to_size(w) + 1])});
  return chunks;
}

double sum(const Lanes& a) { return (a[0] + a[1]) + (a[2] + a[3]); }

void book(EnergyBook& energy, const ContactWork& work) {
  energy.shear += sum(work.shear);
  energy.roll += sum(work.roll);
  energy.viscous += sum(work.viscous);
}

template <class Law, bool full>
void update_forces(GrainSystem& s) {
  RollSlot* roll_slot = s.roll_slot.empty() ? nullptr : s.roll_slot.data();
  const GrainLoop loop{s.record.data(),   s.pairs.grains.data(), s.pairs.materials, s.time_step,
                       &s.grain_contacts, s.slot.data(),         &s.contact,        roll_slot};
  const int blocks = s.grain_contacts.size();
  ContactSlot* wall_slot = s.slot.data() + lane_count * blocks;
  RollSlot* wall_roll_slot = roll_slot == nullptr ? nullptr : roll_slot + lane_count * blocks;
  const int chunks = (blocks + blocks_per_chunk - 1) / blocks_per_chunk;
  const std::vector<WallChunk> at_walls = wall_chunks(s);
  const int before = size_of(at_walls) / 2;  // walls at both ends: shares of grains match those of their motion
  std::vector<ContactWork> work(full ? to_size(chunks) + at_walls.size() : 0);
  const auto run_chunk = [&](int chunk) {
    ContactWork* done = full ? &work[to_size(chunk)] : nullptr;
    const int grain_chunk = chunk - before;
    if (grain_chunk >= 0 && grain_chunk < chunks) {
      const int begin = grain_chunk * blocks_per_chunk;
      return grain_blocks<Law, full>(loop, begin, std::min(begin + blocks_per_chunk, blocks), done);
    }
    const WallChunk& c = at_walls[to_size(grain_chunk < 0 ? chunk : chunk - chunks)];
    const WallLoop wall_loop{
        s.record.data(), s.pairs.walls.data(), s.pairs.materials, s.time_step, &s.walls[to_size(c.wall)], &s.wall_contacts,
        wall_slot,       &s.contact,           wall_roll_slot};
    wall_blocks<Law, full>(wall_loop, c.begin, c.end, done);
  };
  const int all = chunks + size_of(at_walls);
  parallel_for(all, run_chunk, blocks < blocks_worth_threads ? all : 2);
  for (int w = 0; w < size_of(s.walls); ++w) sum_wall_force(s, w, wall_slot);
  if (s.energy.is_kept)
    for (const ContactWork& w : work) book(s.energy, w);
}

}  // namespace

void update_contact_forces(GrainSystem& system) {
  std::visit(
      [&]<ContactLaw Law>(const Law&) {
        if (system.energy.is_kept || !system.roll_slot.empty())
          update_forces<Law, true>(system);
        else
          update_forces<Law, false>(system);
      },
      system.law);
}

}  // namespace puadem
