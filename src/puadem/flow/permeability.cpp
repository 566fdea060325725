#include "puadem/flow/permeability.hpp"

#include <algorithm>

#include "puadem/base/error.hpp"

namespace puadem {

namespace {

/// Volume average of the flux, (1/V) sum q (x_j - x_i) over the links: a pore without sources adds nothing,
/// wherever its centre is put.
Vec3 mean_flux(const PoreNetwork& network, const Domain& domain, const FlowGraph& graph, const SinglePhaseFlow& flow) {
  const Vec3 period = domain.size();
  const Vec3 sum = parallel_sum<Vec3>(graph.links(), [&](int k) {
    const auto [a, b] = graph.link[to_size(k)];
    const auto& s = graph.link_shift[to_size(k)];
    const Vec3 way = network.pore_centre[to_size(graph.node_pore[to_size(b)])] +
                     Vec3{s[0] * period.x, s[1] * period.y, s[2] * period.z} -
                     network.pore_centre[to_size(graph.node_pore[to_size(a)])];
    return flow.throat_flow[to_size(graph.link_throat[to_size(k)])] * way;
  });
  return sum / domain.volume();
}

/// Periodic, or with pores at both faces.
bool can_be_driven(const PoreNetwork& network, const Domain& domain, int axis) {
  if (domain.periodic[to_size(axis)]) return true;
  std::uint8_t touched = 0;
  for (const std::uint8_t walls : network.pore_walls) touched |= walls;
  return (touched >> (2 * axis) & 3u) == 3u;
}

}  // namespace

Permeability measure_permeability(const PoreNetwork& network, const Domain& domain, const PressureSolverOptions& solver,
                                  const std::optional<ConductanceLimits>& limits, const AxisFlowCallback& on_axis) {
  Permeability k;
  SinglePhaseMemory memory;
  memory.solver = solver;
  for (int axis = 0; axis < 3; ++axis) k.measured[to_size(axis)] = can_be_driven(network, domain, axis);
  require(k.measured != std::array<bool, 3>{},
          "no axis is periodic or has pores at both its faces: fluid can be driven through this network along none");
  for (int axis = 0; axis < 3; ++axis) {
    if (!k.measured[to_size(axis)]) continue;
    SinglePhaseProblem problem;
    problem.viscosity = 1.0;  // and a gradient of 1 Pa/m against the axis: the flux is the permeability
    problem.conductance_limits = limits;
    const double length = domain.size()[axis];
    const auto low = to_size(2 * axis), high = low + 1;
    if (domain.periodic[to_size(axis)]) {
      problem.pressure_gradient[axis] = -1.0;
    } else {
      problem.faces[low] = {FaceCondition::Kind::pressure, length};
      problem.faces[high] = {FaceCondition::Kind::pressure, 0.0};
    }
    const SinglePhaseFlow flow = solve_single_phase(network, domain, problem, memory);
    Vec3 flux = mean_flux(network, domain, memory.graph, flow);
    if (!domain.periodic[to_size(axis)]) flux[axis] = flow.face_inflow[low] * length / domain.volume();
    for (int a = 0; a < 3; ++a) k.tensor[to_size(a)][axis] = flux[a];
    k.imbalance = std::max(k.imbalance, flow.imbalance);
    k.carried = std::max(k.carried, flow.carried);
    k.iterations += flow.solve.iterations;
    k.joined = flow.joined;
    k.limited_low = flow.limited_low;
    k.limited_high = flow.limited_high;
    k.unknowns = std::max(k.unknowns, memory.system->unknowns());
    k.is_factorised = memory.system->is_factorised();
    if (on_axis) on_axis(axis, flow);
  }
  return k;
}

double kozeny_carman(double porosity, double sauter_radius) {
  const double solid = 1.0 - porosity, diameter = 2.0 * sauter_radius;
  return porosity * porosity * porosity * diameter * diameter / (180.0 * solid * solid);
}

}  // namespace puadem
