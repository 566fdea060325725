#include "puadem/coupling/case_bridges.hpp"

#include <numbers>

#include "puadem/base/error.hpp"
#include "puadem/coupling/run.hpp"
#include "puadem/dem/bridge_exchange.hpp"
#include "puadem/dem/bridge_measures.hpp"
#include "puadem/dem/motion.hpp"

namespace puadem {

namespace {

BridgeSupply supply_of(const Case& c, const GrainSystem& s) {
  const BridgeCase& b = *c.bridges;
  if (b.control == BridgeControl::suction) return {.suction = b.capillary_pressure.value()};
  if (b.volume) return {.each = *b.volume};
  double solid = 0.0, mass = 0.0;
  for (int k = 0; k < s.owned; ++k) {
    const double r = radius_of(s.record[to_size(k)]);
    solid += 4.0 / 3.0 * std::numbers::pi * r * r * r;
    mass += mass_of(s.record[to_size(k)]);
  }
  if (b.water_content) return {.total = *b.water_content * mass / c.fluids.wetting.density};
  return {.total = b.saturation.value() * (s.domain.volume() - solid)};
}

}  // namespace

BridgeModel bridge_model(const Case& c) {
  return bridge_model(c.fluids.surface_tension, c.fluids.contact_angle, c.bridges->control, c.bridges->law);
}

void ready_bridges(const Case& c, GrainSystem& s, const Observer& observer) {
  if (!c.bridges || s.bridges) return;
  evaluate_forces(s);
  wet_grains(s, bridge_model(c), *c.bridges, supply_of(c, s));
  if (!observer.message) return;
  const BridgeMeasures m = measure_bridges(s);
  observer.message(fmt::format("{} liquid bridges of {:.4g} m3 of water, {:.3g} N each on average, {:.3g} a grain", m.bridges,
                               m.water, m.mean_force, m.coordination));
}

}  // namespace puadem
