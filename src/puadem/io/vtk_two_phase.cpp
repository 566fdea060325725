#include "puadem/io/vtk_two_phase.hpp"

#include <algorithm>
#include <limits>

#include "puadem/flow/fluid_topology.hpp"
#include "puadem/io/vtk_fields.hpp"

namespace puadem {
namespace {

/// Values where the fluid is.
std::vector<double> where(const std::vector<std::uint8_t>& holds, const std::vector<double>& values) {
  std::vector<double> shown(values.size(), std::numeric_limits<double>::quiet_NaN());
  for (std::size_t i = 0; i < values.size(); ++i)
    if (holds[i]) shown[i] = values[i];
  return shown;
}

std::vector<Vec3> flux(const VtkPolyData& throats, const PoreNetwork& network, const std::vector<double>& flow) {
  std::vector<Vec3> flux(flow.size());
  for (std::size_t t = 0; t < flow.size(); ++t) {
    const Vec3 way = throats.points[2 * t + 1] - throats.points[2 * t];
    const double area = network.throat_area[t];
    if (area > 0.0 && squared_norm(way) > 0.0) flux[t] = flow[t] / area * normalized(way);
  }
  return flux;
}

}  // namespace

VtkPolyData two_phase_pore_fields(const State& state, const TwoPhaseModel& model) {
  const PoreNetwork& n = state.network;
  const TwoPhaseState& flow = *state.flow;
  std::vector<double> gas(n.pore_volume);
  for (std::size_t i = 0; i < gas.size(); ++i) gas[i] -= flow.wetting_volume[i];
  const std::vector<int> cluster = fluid_cluster_numbers(n, flow.nonwetting.holds, flow.nonwetting.passes, gas);
  VtkPolyData data = pore_fields(state);
  data.point_data.push_back({"wetting_pressure", where(flow.wetting.holds, flow.wetting_pressure)});
  data.point_data.push_back({"nonwetting_pressure", where(flow.nonwetting.holds, flow.nonwetting_pressure)});
  data.point_data.push_back({"gas_cluster", std::vector<std::int64_t>(cluster.begin(), cluster.end())});
  data.point_data.push_back({"reservoir", model.is_reservoir});
  return data;
}

VtkPolyData two_phase_throat_fields(const State& state, const TwoPhaseModel& model) {
  const ThroatFlows flows = throat_flows(state.network, model, *state.flow);
  VtkPolyData data = throat_fields(state, model.fluids);
  std::ranges::find(data.cell_data, "open", &VtkArray::name)->values = state.flow->nonwetting.passes;
  data.cell_data.push_back({"wetting_flux", flux(data, state.network, flows.wetting)});
  data.cell_data.push_back({"nonwetting_flux", flux(data, state.network, flows.nonwetting)});
  return data;
}

}  // namespace puadem
