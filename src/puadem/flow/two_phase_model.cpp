#include <algorithm>
#include <cmath>

#include "puadem/base/compensated_sum.hpp"
#include "puadem/base/error.hpp"
#include "puadem/flow/invasion_thresholds.hpp"
#include "puadem/flow/two_phase_system.hpp"

namespace puadem {

namespace {

using Kind = FlowBoundary::Kind;

void check_fluids(const Fluids& fluids) {
  const auto check = [](const Fluid& fluid, std::string_view name) {
    require(std::isfinite(fluid.viscosity) && fluid.viscosity > 0.0,
            "the {} fluid has the viscosity {} Pa s; it must be positive, for each pressure follows from it", name,
            fluid.viscosity);
    require(std::isfinite(fluid.density) && fluid.density >= 0.0,
            "the {} fluid has the density {} kg/m3; it must not be negative", name, fluid.density);
  };
  check(fluids.wetting, "wetting");
  check(fluids.nonwetting, "non-wetting");
}

void check_schedule(const FlowBoundary& boundary) {
  const Schedule& s = boundary.schedule;
  require(!s.time.empty() && s.time.size() == s.value.size() && std::ranges::is_sorted(s.time),
          "the schedule of boundary \"{}\" has {} times and {} values; it needs as many of each, at least one, times ascending",
          boundary.name, s.time.size(), s.value.size());
  for (const double v : s.value)
    require(std::isfinite(v), "the schedule of boundary \"{}\" holds a value that is not finite", boundary.name);
}

void check_options(const PoreNetwork& network, const TwoPhaseModel& model) {
  const TwoPhaseOptions& options = model.options;
  require(options.scheme == TwoPhaseScheme::implicit || options.gas == GasKind::connected,
          "the scheme impes knows gas of one pressure only: choose gas = connected, or the scheme implicit");
  require(options.steps.front_change > 0.0 && options.steps.growth > 1.0 && options.steps.longest > 0.0 &&
              options.steps.tolerance > 0.0 && options.steps.newton_limit > 1,
          "time steps need a change of the front, a tolerance and a longest step above 0, a growth above 1 and more than one "
          "iteration");
  require(options.gas != GasKind::ideal || options.reference_pressure > 0.0,
          "ideal gas needs a reference pressure above 0, it is {} Pa", options.reference_pressure);
  int with_gas = 0;
  for (const FlowBoundary& b : model.boundaries) with_gas += b.fluid == FluidPhase::nonwetting;
  require(options.gas != GasKind::connected || with_gas == 1,
          "gas of one pressure (gas = connected) has one boundary of gas; there are {}", with_gas);
  if (options.gravity == Vec3{}) return;
  for (const auto& shift : network.throat_shift)
    for (int axis = 0; axis < 3; ++axis)
      require(shift[to_size(axis)] == 0 || options.gravity[axis] == 0.0,
              "gravity acts along axis {}, which is periodic: pressures would rise without end; give that axis walls",
              "xyz"[axis]);
}

void set_boundary(const PoreNetwork& network, int b, TwoPhaseModel& model) {
  const FlowBoundary& boundary = model.boundaries[to_size(b)];
  check_schedule(boundary);
  require(!boundary.pores.empty(), "boundary \"{}\" has no pore: choose a face of the box that is a wall, or a larger region",
          boundary.name);
  const bool is_gas = boundary.fluid == FluidPhase::nonwetting;
  require(!is_gas || boundary.kind == Kind::pressure || model.options.gas != GasKind::connected,
          "boundary \"{}\" prescribes a flow rate of gas, but gas of one pressure (gas = connected) needs a pressure",
          boundary.name);
  require(
      !boundary.initial_gas_fraction || (is_gas && *boundary.initial_gas_fraction > 0.0 && *boundary.initial_gas_fraction < 1.0),
      "the initial gas fraction of boundary \"{}\" is {}; it must lie between 0 and 1, on a boundary of gas", boundary.name,
      boundary.initial_gas_fraction.value_or(0.0));
  Vec3 sum{};
  for (const int i : boundary.pores) {
    require(i >= 0 && i < network.pores(), "boundary \"{}\" names pore {}; the network has {}", boundary.name, i,
            network.pores());
    const int other = model.pore_boundary[to_size(i)];
    require(other < 0, "pore {} belongs to the boundaries \"{}\" and \"{}\": give it to one of them", i,
            other < 0 ? "" : model.boundaries[to_size(std::max(other, 0))].name, boundary.name);
    model.pore_boundary[to_size(i)] = b;
    model.is_reservoir[to_size(i)] = !boundary.initial_gas_fraction;
    sum += network.pore_centre[to_size(i)];
  }
  model.boundary_place.push_back(sum / size_of(boundary.pores));
}

void set_sizes(const PoreNetwork& network, TwoPhaseModel& model) {
  CompensatedSum volume;
  std::vector<double> conductance(to_size(network.pores())), times;
  for (int t = 0; t < network.throats(); ++t) {
    const double g = network.throat_conductance[to_size(t)];
    if (network.throat_entry_radius[to_size(t)] <= 0.0) continue;
    require(std::isfinite(g) && g >= 0.0,
            "throat {} has the conductance {} m3: two pores without resistance between them are one; merge them", t, g);
    for (const int i : network.throat_pores[to_size(t)]) conductance[to_size(i)] += g;
  }
  for (int i = 0; i < network.pores(); ++i) {
    if (!model.is_counted(i)) continue;
    volume.add(network.pore_volume[to_size(i)]);
    if (conductance[to_size(i)] > 0.0)
      times.push_back(network.pore_volume[to_size(i)] * model.fluids.wetting.viscosity /
                      (conductance[to_size(i)] * model.thresholds.unit[to_size(i)].threshold));
  }
  require(!times.empty(),
          "no pore between the boundaries takes part in the flow: the packing is too thin, or all throats are closed");
  model.void_volume = volume.value();
  std::ranges::nth_element(times, times.begin() + size_of(times) / 2);
  model.time_scale = times[times.size() / 2];
  model.shortest_time = std::ranges::min(times);
}

}  // namespace

TwoPhaseModel make_two_phase_model(const PoreNetwork& network, const Fluids& fluids, const TwoPhaseOptions& options,
                                   std::vector<FlowBoundary> boundaries, ThroatFilms films) {
  TwoPhaseModel model;
  model.fluids = fluids;
  model.options = options;
  model.boundaries = std::move(boundaries);
  model.films = std::move(films);
  check_fluids(fluids);
  require(!model.boundaries.empty(), "there is no reservoir: give a boundary for at least one of the fluids");
  require(size_of(network.throat_conductance) == network.throats() && size_of(model.films.wetting_at_entry) == network.throats(),
          "two-phase flow needs conductances and corner films of all {} throats", network.throats());
  require(size_of(network.pore_centre) == network.pores(), "two-phase flow needs the places of all {} pores", network.pores());
  check_options(network, model);
  InvasionOptions rules;
  rules.snap_off = options.snap_off;
  rules.corner_films = options.corner_films;
  rules.wall_throats = options.wall_throats;
  rules.retention_law = options.retention_law;
  model.thresholds = invasion_thresholds(network, fluids, rules);
  model.links = pore_links(network);
  if (options.cooperative_filling) model.thresholds.filling_shares = filling_shares(network, model.links, fluids, options.seed);
  model.pore_boundary.assign(to_size(network.pores()), -1);
  model.is_reservoir.assign(to_size(network.pores()), 0);
  for (int b = 0; b < size_of(model.boundaries); ++b) set_boundary(network, b, model);
  require(std::ranges::any_of(model.boundaries, [](const FlowBoundary& b) { return b.kind == Kind::pressure; }),
          "all boundaries give flow rates, and the fluids do not yield: give the pressure at one of them");
  set_sizes(network, model);
  model.solver = make_two_phase_solver(network, model);
  return model;
}

}  // namespace puadem
