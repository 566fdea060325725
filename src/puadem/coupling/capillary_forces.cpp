#include "puadem/coupling/capillary_forces.hpp"

#include <cmath>

namespace puadem {

double wetted_fraction(double x) {
  if (x >= 1.0) return 1.0;
  const double dry = 2.0 * (1.0 - x) / (2.0 - x);
  return 1.0 - dry * dry;
}

std::vector<double> effective_pressures(const PoreNetwork& network, const TwoPhaseModel& model, const TwoPhaseState& state) {
  std::vector<double> pressure(to_size(network.pores()));
  for (int p = 0; p < network.pores(); ++p) {
    const auto i = to_size(p);
    if (!state.nonwetting.holds[i]) {
      pressure[i] = state.wetting_pressure[i];
    } else if (!model.is_counted(p)) {
      pressure[i] = state.nonwetting_pressure[i];
    } else {
      // Not by the local law: where air only waits at its face, the pore is full and its capillary pressure below that law.
      const double pc = state.nonwetting_pressure[i] - state.wetting_pressure[i], touching = model.thresholds.unit[i].threshold;
      pressure[i] =
          pc > touching ? state.nonwetting_pressure[i] - wetted_fraction(touching / pc) * pc : state.wetting_pressure[i];
    }
  }
  return pressure;
}

std::vector<Vec3> tension_forces(const PoreNetwork& network, const PushedAreas& areas, std::span<const double> pressure,
                                 int grains) {
  PushedAreas menisci;
  menisci.throat = areas.throat_void;
  menisci.bearer = areas.bearer;
  return pressure_forces(network, menisci, pressure, {}, grains).grain;
}

Tensor fluid_stress(const FluidForces& forces, std::span<const Vec3> centre, const Domain& domain) {
  Tensor stress{};
  const double volume = domain.volume();
  const auto add = [&](const Vec3& force, const Vec3& place) {
    for (int a = 0; a < 3; ++a) stress[to_size(a)] += force[a] / volume * (place - domain.lower);
  };
  for (std::size_t k = 0; k < centre.size(); ++k) add(forces.grain[k], centre[k]);
  for (int face = 0; face < 6; ++face) {
    Vec3 place = 0.5 * (domain.lower + domain.upper);
    place[axis_of(face)] = domain.face_position(face);
    add(forces.wall[to_size(face)], place);
  }
  return stress;
}

ForceFabric force_fabric(std::span<const Vec3> force) {
  Tensor directions{};
  double sum = 0.0;
  for (const Vec3& f : force) {
    const double size = norm(f);
    if (size == 0.0) continue;
    sum += size;
    for (int a = 0; a < 3; ++a) directions[to_size(a)] += f[a] / size * f;
  }
  ForceFabric fabric;
  if (sum == 0.0) return fabric;
  double squares = 0.0;
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < 3; ++b) {
      const double entry = 7.5 * (directions[to_size(a)][b] / sum - (a == b ? 1.0 / 3.0 : 0.0));
      squares += entry * entry;
    }
  fabric.anisotropy = std::sqrt(1.5 * squares);
  fabric.mean = sum / static_cast<double>(force.size());
  return fabric;
}

}  // namespace puadem
