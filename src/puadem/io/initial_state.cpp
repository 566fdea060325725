#include "puadem/io/initial_state.hpp"

#include <fmt/format.h>

#include <cmath>

#include "puadem/base/error.hpp"
#include "puadem/io/network_file.hpp"
#include "puadem/io/packing_file.hpp"
#include "puadem/io/units.hpp"

namespace puadem {

namespace {

void need_face(const Case& c, const NetworkFile& file, int stage, std::string_view key, int face) {
  const bool has_pores = std::ranges::any_of(file.network.pore_walls, [=](std::uint8_t walls) { return walls >> face & 1u; });
  require(has_pores || file.box.periodic[to_size(axis_of(face))],
          "stage.{}.{}: no pore of {} lies at the {} face; its pores lie at: {}", stage, key, c.network_file->string(),
          face_names[to_size(face)], faces_with_pores(file.network));
}

void check_stage(const Case& c, const NetworkFile& file, int index, const PermeabilityStage& stage) {
  need_face(c, file, index, "inlet", stage.inlet);
  need_face(c, file, index, "inlet", opposite(stage.inlet));
}

void check_stage(const Case& c, const NetworkFile& file, int index, const RetentionStage& stage) {
  need_face(c, file, index, "air", stage.invasion.nonwetting_face);
  need_face(c, file, index, "water", stage.invasion.wetting_face);
  require(stage.invasion.wall_throats || file.knows_walls,
          "stage.{}.wall_throats = false: {} does not tell which throats lie along walls (a column \"throat.at_wall\")", index,
          c.network_file->string());
}

void check_stage(const Case& c, const NetworkFile& file, int index, const TwoPhaseStage& stage) {
  if (stage.air != TwoPhaseStage::disc) need_face(c, file, index, "air", stage.air);
  for (int face = 0; face < 6; ++face)
    if (stage.water[to_size(face)]) need_face(c, file, index, "water", face);
}

void check_stage(const Case&, const NetworkFile&, int, const auto&) {}

/// What the stages ask of the network, before the first of them.
void check_against_stages(const Case& c, const NetworkFile& file) {
  const bool has_two_fluids =
      std::ranges::any_of(c.stages, [](const Stage& s) { return !std::holds_alternative<PermeabilityStage>(s); });
  constexpr double same_angle = 1e-9;  // [rad]
  require(!has_two_fluids || std::abs(c.fluids.contact_angle - file.contact_angle) < same_angle,
          "fluids.contact_angle = {}: the entry radii of {} hold for {}; write contact_angle = \"{}\"",
          show(c.fluids.contact_angle, "rad"), c.network_file->string(), show(file.contact_angle, "rad"),
          show(file.contact_angle, "rad", 12));
  for (int i = 0; i < size_of(c.stages); ++i)
    std::visit([&](const auto& stage) { check_stage(c, file, i, stage); }, c.stages[to_size(i)]);
}

State network_state(const Case& c, std::vector<std::string>& warnings) {
  NetworkFile file = read_network(*c.network_file);
  warnings.insert(warnings.end(), file.warnings.begin(), file.warnings.end());
  check_against_stages(c, file);
  State state;
  state.network = std::move(file.network);
  state.domain = file.box;
  state.reservoir_pores = file.reservoir_pores;
  return state;
}

}  // namespace

State initial_state(const Case& c, std::vector<std::string>& warnings) {
  if (c.network_file) return network_state(c, warnings);
  State state;
  if (!c.grains.file) return state;
  const PackingFile file = read_packing(*c.grains.file);
  warnings.insert(warnings.end(), file.warnings.begin(), file.warnings.end());
  state.particles = make_particles(file.centre, file.radius, c.materials, assign_materials(file.radius, grain_materials(c)));
  state.domain = file.box;
  state.domain.periodic = c.domain.periodic;
  return state;
}

}  // namespace puadem
