#include <algorithm>
#include <cmath>

#include "puadem/base/compensated_sum.hpp"
#include "puadem/base/error.hpp"
#include "puadem/coupling/checked_network.hpp"
#include "puadem/coupling/stages.hpp"
#include "puadem/dem/grain_statistics.hpp"
#include "puadem/dem/tensor.hpp"

namespace puadem {

namespace {

double void_of(const PoreNetwork& network, int reservoir_pores) {
  return compensated_sum(std::span(network.pore_volume).first(to_size(network.pores() - reservoir_pores)));
}

/// Flow along the axis of the inlet, at the drop and the viscosity of the stage.
struct Driven {
  std::vector<double> pressure, throat_flow, linear;
};

/// The solve has one pascal a metre falling with the axis and a viscosity of one.
Driven scaled(const SinglePhaseFlow& flow, const PoreNetwork& network, const Domain& domain, const PermeabilityStage& stage,
              double viscosity) {
  const int axis = axis_of(stage.inlet);
  const double length = domain.size()[axis], gradient = stage.pressure_drop / length;
  const bool turned = is_upper(stage.inlet);
  Driven driven;
  for (const double p : flow.pressure) driven.pressure.push_back(turned ? stage.pressure_drop - gradient * p : gradient * p);
  for (const double q : flow.throat_flow) driven.throat_flow.push_back((turned ? -gradient : gradient) * q / viscosity);
  for (const Vec3& c : network.pore_centre) {
    const double depth = turned ? domain.upper[axis] - c[axis] : c[axis] - domain.lower[axis];
    driven.linear.push_back(stage.pressure_drop - gradient * depth);
  }
  return driven;
}

/// Between periodic faces pressures have no level of their own: they take that of the straight line. Returns the root
/// mean square distance from it, by volume and over the drop.
double set_level(const PoreNetwork& network, bool is_periodic, double drop, Driven& driven) {
  double volume = 0.0, mean = 0.0, squares = 0.0;
  for (std::size_t p = 0; p < driven.pressure.size(); ++p) {
    volume += network.pore_volume[p];
    mean += network.pore_volume[p] * (driven.pressure[p] - driven.linear[p]);
  }
  mean = is_periodic ? mean / volume : 0.0;
  for (std::size_t p = 0; p < driven.pressure.size(); ++p) {
    driven.pressure[p] -= mean;
    const double off = driven.pressure[p] - driven.linear[p];
    squares += network.pore_volume[p] * off * off;
  }
  return std::sqrt(squares / volume) / drop;
}

void describe(const PermeabilityResult& r, const Domain& domain, RunResults& results) {
  const auto set = [&](std::string_view name, double value) { results.scalars[fmt::format("{}_{}", r.stage, name)] = value; };
  const Permeability& k = r.permeability;
  const std::string axes = "xyz";
  for (int b = 0; b < 3; ++b)
    for (int a = 0; a < 3; ++a)  // across the flow only where all directions are known
      if (k.measured[to_size(b)] && (a == b || k.is_complete()))
        set(fmt::format("{}{}_m2", axes[to_size(a)], axes[to_size(b)]), k.tensor[to_size(a)][b]);
  set("mean_m2", k.mean());
  if (k.is_complete()) {
    const Vec3 principal = principal_values(k.tensor);
    for (int i = 0; i < 3; ++i) set(fmt::format("principal_{}_m2", i + 1), principal[i]);
    if (domain.periodic == std::array{true, true, true}) set("asymmetry", r.asymmetry());
  }
  set("porosity", r.porosity);
  if (const auto reference = r.kozeny_carman()) {
    set("sauter_radius_m", *r.sauter_radius);
    set("over_R32_squared", k.mean() / (*r.sauter_radius * *r.sauter_radius));
    set("kozeny_carman_m2", *reference);
    set("over_kozeny_carman", k.mean() / *reference);
  }
  set("darcy_velocity_m_s", r.darcy_velocity);
  set("linear_error", r.linear_error);
  set("imbalance", k.imbalance);
  set("carried", k.carried);
  set("pores", r.pores);
  set("throats", r.throats);
  set("throats_closed", r.closed_throats);
  set("throats_joined", k.joined);
  set("throats_raised", k.limited_low);
  set("throats_lowered", k.limited_high);
  set("unknowns", k.unknowns);
  set("iterations", k.iterations);
  set("multigrid", k.is_factorised ? 0.0 : 1.0);
}

}  // namespace

void run_permeability_stage(const Case& c, int index, State& state, const Observer& observer, RunResults& results) {
  const auto& stage = std::get<PermeabilityStage>(c.stages[to_size(index)]);
  PermeabilityResult r;
  r.stage = stage_name(c, index);
  const auto report = [&](std::string_view name, double fraction) {
    Progress progress;
    progress.stage = name;
    progress.fraction = fraction;
    if (observer.progress && !observer.progress(progress)) throw Interrupted{};
  };

  report("network", 0.0);
  PoreNetwork own;
  if (!c.network_file) own = checked_network(c, state, observer, stage.merged);
  // The units that a retention stage has filled stay those of the state.
  const bool is_kept = state.network.pores() == 0;
  if (is_kept) state.network = std::move(own);
  const PoreNetwork& network = is_kept || c.network_file ? state.network : own;
  if (observer.packed) observer.packed(state);

  r.inlet = stage.inlet;
  r.pressure_drop = stage.pressure_drop;
  r.viscosity = c.fluids.wetting.viscosity;
  r.pores = network.pores();
  r.throats = network.throats();
  r.closed_throats = static_cast<int>(std::ranges::count(network.throat_conductance, 0.0));
  r.porosity = void_of(network, state.reservoir_pores) / state.domain.volume();
  if (state.particles.size() > 0) r.sauter_radius = statistics_of(state.particles.radius).sauter_radius;

  report(kind_of(c.stages[to_size(index)]), 0.0);
  const int axis = axis_of(stage.inlet);
  std::optional<Driven> driven;
  r.permeability =
      measure_permeability(network, state.domain, {}, c.pores.conductance_limits, [&](int solved, const SinglePhaseFlow& flow) {
        report(kind_of(c.stages[to_size(index)]), (solved + 1) / 3.0);
        if (solved == axis) driven = scaled(flow, network, state.domain, stage, r.viscosity);
      });
  require(driven.has_value(), "no fluid can enter at the {} face and leave at the {} one: the network has no pores at both",
          face_names[to_size(stage.inlet)], face_names[to_size(opposite(stage.inlet))]);
  r.darcy_velocity = r.permeability.tensor[to_size(axis)][axis] * stage.pressure_drop / (state.domain.size()[axis] * r.viscosity);
  r.linear_error = set_level(network, state.domain.periodic[to_size(axis)], stage.pressure_drop, *driven);
  r.profile = pressure_layers(network, state.domain, axis, stage.layers, driven->pressure, driven->linear);
  describe(r, state.domain, results);
  state.permeability.push_back(std::move(r));
  if (observer.permeability)
    observer.permeability(state, {network, driven->pressure, driven->throat_flow}, state.permeability.back());
}

}  // namespace puadem
