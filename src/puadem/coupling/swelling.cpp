#include "puadem/coupling/swelling.hpp"

#include <algorithm>
#include <numbers>

#include "puadem/coupling/capillary_forces.hpp"
#include "puadem/dem/contacts.hpp"
#include "puadem/dem/growth.hpp"
#include "puadem/geometry/cell.hpp"
#include "puadem/geometry/packing_sites.hpp"

namespace puadem {

namespace {

/// 4/3 pi (b^3 - a^3), without the loss of digits where both are near each other.
double shell(double a, double b) { return 4.0 / 3.0 * std::numbers::pi * (b - a) * (a * a + a * b + b * b); }

/// Number of each grain among those that swell, or -1.
std::vector<int> numbers_of(const SwellingState& state, std::size_t grains) {
  std::vector<int> number(grains, -1);
  for (int k = 0; k < state.size(); ++k) number[to_size(state.grain[to_size(k)])] = k;
  return number;
}

double wetted_share(const TwoPhaseModel& model, const TwoPhaseState& flow, int pore) {
  const auto i = to_size(pore);
  if (!flow.nonwetting.holds[i]) return 1.0;
  if (!model.is_counted(pore) || !flow.wetting.holds[i]) return 0.0;
  const double pc = flow.nonwetting_pressure[i] - flow.wetting_pressure[i], touching = model.thresholds.unit[i].threshold;
  return pc > touching ? wetted_fraction(touching / pc) : 1.0;
}

/// Mean stress within each swelling grain, from its contacts [Pa]: (1/3V) sum R F_n. Contacts pull at no lever.
std::vector<double> grain_pressures(const GrainSystem& grains, const Particles& particles, const SwellingState& state) {
  const std::vector<int> number = numbers_of(state, particles.radius.size());
  std::vector<double> push(to_size(state.size()));
  const auto add = [&](int record, int slot) {
    const int k = number[to_size(grains.identity[to_size(record)])];
    if (k >= 0) push[to_size(k)] += grains.slot[to_size(slot)].force[3];
  };
  for_each_grain_contact(grains, [&](int first, int second, const Vec3&, int slot) {
    add(first, slot);
    add(second, slot);
  });
  for_each_wall_contact(grains, [&](int, int record, const Vec3&, int slot) { add(record, slot); });
  for (int k = 0; k < state.size(); ++k) {
    const double radius = particles.radius[to_size(state.grain[to_size(k)])];
    push[to_size(k)] /= 4.0 * std::numbers::pi * radius * radius;  // R / 3V
  }
  return push;
}

}  // namespace

SwellingState start_swelling(const Particles& particles, std::span<const Material> materials) {
  SwellingState state;
  for (int k = 0; k < particles.size(); ++k) {
    if (!materials[to_size(particles.material[to_size(k)])].swelling) continue;
    state.grain.push_back(k);
    state.start_radius.push_back(particles.radius[to_size(k)]);
    state.start_mass.push_back(particles.mass[to_size(k)]);
  }
  state.wetted.assign(state.grain.size(), 0.0);
  return state;
}

SwellingShares set_wetting(const PoreNetwork& network, const TwoPhaseModel& model, const TwoPhaseState& flow,
                           std::span<const Vec3> centre, std::span<const double> radius, const Domain& domain,
                           SwellingState& state) {
  const std::vector<int> number = numbers_of(state, radius.size());
  SwellingShares shares;
  shares.of_grain.resize(state.grain.size());
  std::vector<double> whole(state.grain.size(), 0.0), wet(state.grain.size(), 0.0);
  const PackingSites sites_of(centre, radius, domain);
  for (int c = 0; c < network.triangulation.cells(); ++c) {
    const auto& vertices = network.triangulation.vertices[to_size(c)];
    const auto swells = [&](const Vertex& v) { return !v.is_wall() && number[to_size(v.index)] >= 0; };
    if (std::ranges::none_of(vertices, swells)) continue;
    const auto angles = grain_solid_angles(sites_of(vertices));
    const int pore = network.tetrahedron_pore[to_size(c)];
    for (std::size_t v = 0; v < 4; ++v) {
      if (!swells(vertices[v])) continue;
      const auto k = to_size(number[to_size(vertices[v].index)]);
      const double wetted = angles[v] * wetted_share(model, flow, pore);
      whole[k] += angles[v];
      wet[k] += wetted;
      if (wetted > 0.0) shares.of_grain[k].push_back({pore, wetted});
    }
  }
  for (std::size_t k = 0; k < state.grain.size(); ++k) {
    state.wetted[k] = wet[k] / whole[k];
    for (SwellingShares::Share& share : shares.of_grain[k]) share.part /= wet[k];
  }
  return shares;
}

void swell_grains(std::span<const Material> materials, double density, double duration, GrainSystem& grains, Particles& particles,
                  SwellingState& state) {
  const auto law_of = [&](int grain) -> const SwellingLaw& {
    return *materials[to_size(particles.material[to_size(grain)])].swelling;
  };
  const bool is_limited = std::ranges::any_of(state.grain, [&](int g) { return law_of(g).largest_stress.has_value(); });
  std::vector<double> pressure;
  if (is_limited) pressure = grain_pressures(grains, particles, state);
  double growth = 0.0;
  for (std::size_t k = 0; k < state.grain.size(); ++k) {
    const auto g = to_size(state.grain[k]);
    const SwellingLaw& law = law_of(state.grain[k]);
    const double share = is_limited ? unhindered_share(law, pressure[k]) : 1.0, start = state.start_radius[k];
    const double radius = swollen_radius(law, start, particles.radius[g], share * state.wetted[k] * duration);
    growth = std::max(growth, radius - particles.radius[g]);
    particles.radius[g] = radius;
    particles.mass[g] = state.start_mass[k] + density * shell(start, radius);
    particles.inertia[g] = 0.4 * particles.mass[g] * radius * radius;
  }
  state.grown += growth;
  set_radii(grains, particles.radius, particles.mass);
}

std::vector<double> take_up(const TwoPhaseModel& model, const SwellingShares& shares, std::span<const double> before,
                            double duration, const Particles& particles, SwellingState& state) {
  std::vector<double> rate(model.is_reservoir.size(), 0.0);
  for (std::size_t k = 0; k < state.grain.size(); ++k) {
    const double volume = shell(before[k], particles.radius[to_size(state.grain[k])]);
    for (const auto [pore, part] : shares.of_grain[k]) {
      (model.is_counted(pore) ? state.from_pores : state.from_reservoirs).add(part * volume);
      rate[to_size(pore)] += part * volume / duration;
    }
  }
  return rate;
}

std::vector<double> swelling_radii(const Particles& particles, const SwellingState& state) {
  std::vector<double> radius;
  for (const int g : state.grain) radius.push_back(particles.radius[to_size(g)]);
  return radius;
}

double grown_volume(const Particles& particles, const SwellingState& state) {
  CompensatedSum sum;
  for (std::size_t k = 0; k < state.grain.size(); ++k)
    sum.add(shell(state.start_radius[k], particles.radius[to_size(state.grain[k])]));
  return sum.value();
}

}  // namespace puadem
