#include "puadem/io/vtk_fields.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "puadem/coupling/pore_space.hpp"
#include "puadem/dem/bridge_measures.hpp"
#include "puadem/dem/contacts.hpp"
#include "puadem/dem/grain_stress.hpp"

namespace puadem {

VtkPolyData grain_fields(const State& state) {
  const Particles& p = state.particles;
  std::vector<std::int64_t> material(p.material.begin(), p.material.end());
  material.resize(p.radius.size());
  VtkPolyData data;
  data.points = p.position;
  data.point_data = {{"radius", p.radius}, {"material", std::move(material)}};
  if (state.unsaturated && size_of(state.unsaturated->forces.grain) == p.size()) {
    data.point_data.push_back({"fluid_force", state.unsaturated->forces.grain});
    data.point_data.push_back({"tension_force", state.unsaturated->tension});
  }
  if (auto moved = displacements_of(state)) data.point_data.push_back({"displacement", std::move(moved->total)});
  if (!state.grains || !state.grains->is_evaluated) return data;
  if (state.grains->bridges) data.point_data.push_back({"bridge_force", bridge_pulls(*state.grains)});
  GrainStresses g = grain_stresses(*state.grains);
  std::vector<double> speed(p.radius.size());
  for (int k = 0; k < p.size(); ++k) speed[to_size(k)] = norm(p.velocity[to_size(k)]);
  data.point_data.push_back({"speed", std::move(speed)});
  data.point_data.push_back({"mean_stress", std::move(g.mean)});
  data.point_data.push_back({"deviatoric_stress", std::move(g.deviatoric)});
  data.point_data.push_back({"contacts", std::vector<std::int64_t>(g.contacts.begin(), g.contacts.end())});
  data.point_data.push_back({"cell_volume", std::move(g.volume)});
  return data;
}

VtkPolyData contact_fields(const State& state) {
  const std::vector<Contact> contacts = contacts_of(*state.grains);
  double mean_force = 0.0, mean_radius = 0.0;
  for (const Contact& c : contacts) mean_force += c.normal_force / size_of(contacts);
  for (const double r : state.particles.radius) mean_radius += r / state.particles.size();
  VtkPolyData data;
  std::vector<double> radius, normal, shear;
  std::vector<std::uint8_t> wall;
  for (const Contact& c : contacts) {
    const Vec3& end = state.particles.position[to_size(c.second)];
    const int first = size_of(data.points);
    data.points.push_back(end - c.branch);
    data.points.push_back(end);
    data.lines.push_back({first, first + 1});
    const double width = mean_radius / 3.0 * std::sqrt(std::max(c.normal_force, 0.0) / mean_force);
    radius.insert(radius.end(), {width, width});
    normal.push_back(c.normal_force);
    shear.push_back(norm(c.shear));
    wall.push_back(c.wall >= 0 ? 1 : 0);
  }
  data.point_data = {{"radius", std::move(radius)}};
  data.cell_data = {{"normal_force", std::move(normal)}, {"shear_force", std::move(shear)}, {"wall", std::move(wall)}};
  return data;
}

VtkPolyData bridge_fields(const State& state) {
  VtkPolyData data;
  std::vector<double> radius, force, volume, capillary_pressure, gap;
  std::vector<std::uint8_t> wall;
  for (const GrainBridge& b : bridges_of(*state.grains)) {
    const Vec3& from = state.particles.position[to_size(b.first)];
    const int first = size_of(data.points);
    data.points.push_back(from);
    data.points.push_back(from + b.branch);
    data.lines.push_back({first, first + 1});
    const double width = std::cbrt(0.75 * b.volume / std::numbers::pi);
    radius.insert(radius.end(), {width, width});
    force.push_back(b.force);
    volume.push_back(b.volume);
    capillary_pressure.push_back(b.capillary_pressure);
    gap.push_back(b.gap);
    wall.push_back(b.wall >= 0 ? 1 : 0);
  }
  data.point_data = {{"radius", std::move(radius)}};
  data.cell_data = {{"force", std::move(force)},
                    {"volume", std::move(volume)},
                    {"capillary_pressure", std::move(capillary_pressure)},
                    {"gap", std::move(gap)},
                    {"wall", std::move(wall)}};
  return data;
}

VtkPolyData pore_fields(const State& state) {
  const PoreNetwork& n = state.network;
  std::vector<double> saturation = state.saturation;
  saturation.resize(n.pore_volume.size(), 1.0);
  std::vector<std::uint8_t> wall(n.pore_volume.size());
  for (std::size_t i = 0; i < wall.size(); ++i) wall[i] = i < n.pore_walls.size() && n.pore_walls[i] != 0;
  VtkPolyData data;
  data.points = n.pore_centre;
  data.point_data = {{"radius", n.pore_radius},
                     {"volume", n.pore_volume},
                     {"saturation", std::move(saturation)},
                     {"faces", std::vector<std::int64_t>(n.pore_faces.begin(), n.pore_faces.end())},
                     {"wall", std::move(wall)}};
  if (std::holds_alternative<UnsaturatedProgress>(state.position.progress))
    data.point_data.push_back({"porosity", unit_porosities(n, present_cells(state))});
  return data;
}

namespace {

/// Throats as lines between the centres of their pores, with `radius` on the points.
VtkPolyData throat_lines(const PoreNetwork& n, const Domain& domain) {
  const std::size_t throats = n.throat_pores.size();
  const Vec3 period = domain.size();
  VtkPolyData data;
  data.points.reserve(2 * throats);
  data.lines.reserve(throats);
  std::vector<double> radius(2 * throats);
  for (std::size_t t = 0; t < throats; ++t) {
    const auto [i, j] = n.throat_pores[t];
    Vec3 end = n.pore_centre[to_size(j)];
    if (t < n.throat_shift.size())
      for (int axis = 0; axis < 3; ++axis) end[axis] += n.throat_shift[t][to_size(axis)] * period[axis];
    const int first = static_cast<int>(2 * t);
    data.points.push_back(n.pore_centre[to_size(i)]);
    data.points.push_back(end);
    data.lines.push_back({first, first + 1});
    radius[2 * t] = radius[2 * t + 1] = n.throat_radius[t];
  }
  data.point_data = {{"radius", std::move(radius)}};
  return data;
}

}  // namespace

VtkPolyData throat_fields(const State& state, const Fluids& fluids) {
  const PoreNetwork& n = state.network;
  const std::size_t throats = n.throat_pores.size();
  VtkPolyData data = throat_lines(n, state.domain);
  std::vector<double> entry_pressure(throats);
  std::vector<std::uint8_t> is_open(throats, 0), wall(throats, 0);
  for (std::size_t t = 0; t < throats; ++t) {
    entry_pressure[t] = n.throat_entry_radius[t] > 0 ? fluids.surface_tension / n.throat_entry_radius[t]
                                                     : std::numeric_limits<double>::infinity();
    if (state.invasion) is_open[t] = state.invasion->nonwetting.passes[t];
    if (state.unsaturated) is_open[t] = state.unsaturated->flow.nonwetting.passes[t];
    if (t < n.throat_at_wall.size()) wall[t] = n.throat_at_wall[t];
  }
  data.cell_data = {{"entry_pressure", std::move(entry_pressure)}, {"open", std::move(is_open)}, {"wall", std::move(wall)}};
  return data;
}

VtkPolyData flow_pore_fields(const DrivenFlow& flow) {
  VtkPolyData data;
  data.points = flow.network.pore_centre;
  data.point_data = {{"radius", flow.network.pore_radius},
                     {"volume", flow.network.pore_volume},
                     {"pressure", std::vector<double>(flow.pressure.begin(), flow.pressure.end())}};
  return data;
}

VtkPolyData flow_throat_fields(const DrivenFlow& flow, const Domain& domain) {
  VtkPolyData data = throat_lines(flow.network, domain);
  std::vector<Vec3> flux(data.lines.size());
  for (std::size_t t = 0; t < flux.size(); ++t) {
    const Vec3 way = data.points[2 * t + 1] - data.points[2 * t];
    const double area = flow.network.throat_area[t];
    if (area > 0.0 && squared_norm(way) > 0.0) flux[t] = flow.throat_flow[t] / area * normalized(way);
  }
  data.cell_data = {{"flow", std::vector<double>(flow.throat_flow.begin(), flow.throat_flow.end())}, {"flux", std::move(flux)}};
  return data;
}

void add_equilibrium(VtkPolyData& data, const RetentionRow& row) {
  data.field_data.push_back({"capillary_pressure", std::vector<double>{row.capillary_pressure}});
  data.field_data.push_back({"saturation", std::vector<double>{row.saturation}});
}

}  // namespace puadem
