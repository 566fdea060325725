#include "puadem/flow/invasion_thresholds.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "puadem/base/error.hpp"
#include "puadem/flow/capillary_laws/regular_polyhedron.hpp"

namespace puadem {

namespace {

bool is_positive(double value) { return std::isfinite(value) && value > 0.0; }

void check_fluids(const Fluids& fluids) {
  require(is_positive(fluids.surface_tension), "surface tension is {} N/m; it must be positive", fluids.surface_tension);
  require(fluids.contact_angle >= 0.0 && fluids.contact_angle < 0.5 * std::numbers::pi,
          "contact angle is {:.6g} degrees; it must lie in [0, 90): swap the fluids if the other one wets the grains",
          fluids.contact_angle * 180.0 / std::numbers::pi);
}

void set_pore(const PoreNetwork& network, const Fluids& fluids, const InvasionOptions& options, int i, InvasionThresholds& out) {
  const double radius = network.pore_radius[to_size(i)], volume = network.pore_volume[to_size(i)];
  const int faces = network.pore_faces[to_size(i)];
  require(is_positive(volume), "pore {} has the volume {} m3; it must be positive", i, volume);
  require(is_positive(radius), "pore {} has the radius {} m; it must be positive", i, radius);
  require(faces >= 1, "pore {} has {} faces; it must have some", i, faces);
  const CapillaryUnit unit{2.0 * fluids.surface_tension * std::cos(fluids.contact_angle) / radius, std::max(faces, 4)};
  const bool keeps_water = options.corner_water && fluids.contact_angle < corner_angle_limit(unit.faces);
  out.unit[to_size(i)] = unit;
  out.keeps_water[to_size(i)] = keeps_water;
  out.all_keep_water = out.all_keep_water && keeps_water;
  out.body_pressure[to_size(i)] =
      keeps_water ? std::visit([&](const RetentionLaw auto& law) { return law.saturated_pressure(unit); }, options.retention_law)
                  : unit.threshold;
}

void set_throat(const PoreNetwork& network, const Fluids& fluids, const InvasionOptions& options, int t,
                InvasionThresholds& out) {
  // Rounding of the two radii may put snap-off above entry; more than that is a wrong network.
  constexpr double rounding = 1e-9;
  const double entry = network.throat_entry_radius[to_size(t)], snap_off = network.throat_snap_off_radius[to_size(t)];
  require(std::isfinite(entry) && entry >= 0.0,
          "throat {} has the entry radius {} m; it must be positive, or 0 where it is closed", t, entry);
  if (entry == 0.0) {
    out.entry_pressure[to_size(t)] = std::numeric_limits<double>::infinity();
    return;
  }
  const double entry_pressure = fluids.surface_tension / entry;
  out.entry_pressure[to_size(t)] = entry_pressure;
  const auto [i, j] = network.throat_pores[to_size(t)];
  const bool joins_walls = network.pore_walls[to_size(i)] && network.pore_walls[to_size(j)];
  out.may_open[to_size(t)] =
      (options.wall_throats || !network.throat_at_wall[to_size(t)]) && (options.side_pores || !joins_walls);
  if (!options.snap_off) return;
  require(snap_off >= entry * (1.0 - rounding), "throat {} has the snap-off radius {} m below its entry radius {} m", t, snap_off,
          entry);
  out.snap_off_pressure[to_size(t)] = std::min(fluids.surface_tension / snap_off, entry_pressure);
}

}  // namespace

InvasionThresholds invasion_thresholds(const PoreNetwork& network, const Fluids& fluids, const InvasionOptions& options) {
  check_fluids(fluids);
  const std::size_t pores = to_size(network.pores()), throats = to_size(network.throats());
  InvasionThresholds thresholds;
  thresholds.unit.resize(pores);
  thresholds.keeps_water.resize(pores);
  thresholds.body_pressure.resize(pores);
  thresholds.entry_pressure.resize(throats);
  thresholds.snap_off_pressure.resize(throats);
  thresholds.may_open.resize(throats);
  for (int i = 0; i < network.pores(); ++i) set_pore(network, fluids, options, i, thresholds);
  for (int t = 0; t < network.throats(); ++t) set_throat(network, fluids, options, t, thresholds);
  return thresholds;
}

}  // namespace puadem
