#include "puadem/coupling/history.hpp"

#include <numbers>

#include "puadem/dem/contacts.hpp"
#include "puadem/dem/fabric.hpp"
#include "puadem/dem/guards.hpp"

namespace puadem {

namespace {

/// The wall of a face, or null where it is periodic.
const Wall* wall_of(const GrainSystem& s, int face) {
  for (const Wall& wall : s.walls)
    if (wall.face == face) return &wall;
  return nullptr;
}

double offset_of_walls(const GrainSystem& s, int axis, int direction) {
  const Wall *lower = wall_of(s, 2 * axis), *upper = wall_of(s, 2 * axis + 1);
  return upper->point[direction] - lower->point[direction];
}

void add_shear(const GrainSystem& s, const HistoryStart& start, HistoryRow& row) {
  const int axis = start.shear_axis, direction = start.shear_direction;
  const Vec3 size = s.domain.size();
  row.shear_strain = (offset_of_walls(s, axis, direction) - start.wall_offset) / size[axis];
  const double area = s.domain.volume() / size[axis];
  row.normal_stress = row.stress[axis];
  row.shear_stress =
      0.5 * (row.wall_force[to_size(2 * axis)][direction] - row.wall_force[to_size(2 * axis + 1)][direction]) / area;
}

BridgeRow bridge_row(const GrainSystem& s) {
  BridgeRow row;
  static_cast<BridgeMeasures&>(row) = measure_bridges(s);
  int contacts = 0;
  const auto add = [&](int slot) {
    row.mean_contact_force += s.slot[to_size(slot)].force[3];
    ++contacts;
  };
  for_each_grain_contact(s, [&](int, int, const Vec3&, int slot) { add(slot); });
  for_each_wall_contact(s, [&](int, int, const Vec3&, int slot) { add(slot); });
  if (contacts > 0) row.mean_contact_force /= contacts;
  const Tensor stress = bridge_stress(s);
  row.stress = {stress[0].x, stress[1].y, stress[2].z};
  row.mean_stress = trace(stress) / 3.0;
  double solid = 0.0, diameter = 0.0;
  for (int k = 0; k < s.owned; ++k) {
    const double r = radius_of(s.record[to_size(k)]);
    solid += 4.0 / 3.0 * std::numbers::pi * r * r * r;
    diameter += 2.0 * r / s.owned;
  }
  row.rumpf_strength = solid / s.domain.volume() * row.coordination * row.mean_force / (std::numbers::pi * diameter * diameter);
  return row;
}

}  // namespace

HistoryStart begin_history(GrainSystem& s, int shear_axis, int shear_direction) {
  open_energy_book(s);
  HistoryStart start;
  start.size = s.domain.size();
  for (int k = 0; k < s.owned; ++k) {
    const double r = radius_of(s.record[to_size(k)]);
    start.solid_volume += 4.0 / 3.0 * std::numbers::pi * r * r * r;
  }
  start.energies = energies(s);
  start.shear_axis = shear_axis;
  start.shear_direction = shear_direction;
  if (shear_axis >= 0) start.wall_offset = offset_of_walls(s, shear_axis, shear_direction);
  return start;
}

HistoryRow history_row(const GrainSystem& s, const GrainMeasures& m, const HistoryStart& start, double time) {
  HistoryRow row;
  static_cast<ProgramRow&>(row) = program_row(s, m, start.size, time);
  row.step = s.steps;
  row.time_step = s.time_step;
  row.porosity = 1.0 - start.solid_volume / s.domain.volume();
  row.coordination_inner = m.coordination_inner;
  row.largest_overlap = m.largest_overlap;
  for (int face = 0; face < 6; ++face) {
    row.wall_position[to_size(face)] = s.domain.face_position(face);
    if (const Wall* wall = wall_of(s, face)) row.wall_force[to_size(face)] = wall->force;
  }
  if (start.shear_axis >= 0) add_shear(s, start, row);
  return row;
}

void complete_row(const GrainSystem& s, const HistoryStart& start, HistoryRow& row) {
  const auto unexplained = [](const Energies& e) { return e.stored() + e.taken() - e.input; };
  row.energy = guard_energy(s, start.energies);
  row.energy_residual = unexplained(row.energy) - unexplained(start.energies);
  const FabricMeasures fabric = measure_fabric(s);
  row.coordination_mechanical = fabric.coordination_mechanical;
  row.rattlers = fabric.rattlers;
  row.sliding = fabric.sliding;
  row.fabric_anisotropy = fabric.deviatoric;
  if (s.bridges) row.bridges = bridge_row(s);
}

}  // namespace puadem
