#include "puadem/dem/time_step_report.hpp"

#include <fmt/format.h>

#include "puadem/dem/contacts.hpp"

namespace puadem {

std::string time_step_text(const GrainSystem& s, const TimeStepLimit& limit) {
  if (limit.grain < 0) return "no critical step: nothing touches";
  int with_grains = 0, with_walls = 0;
  double radius = 0.0;
  const auto is_it = [&](int record) { return s.identity[to_size(owner_of(s, record))] == limit.grain; };
  for_each_grain_contact(s, [&](int i, int j, const Vec3&, int) { with_grains += is_it(i) || is_it(j) ? 1 : 0; });
  for_each_wall_contact(s, [&](int, int k, const Vec3&, int) { with_walls += is_it(k) ? 1 : 0; });
  for (int k = 0; k < s.owned; ++k)
    if (is_it(k)) radius = radius_of(s.record[to_size(k)]);
  const int contacts = with_grains + with_walls;
  return fmt::format("critical step {:.3g} s: {} of grain {} (R = {:.3g} mm, {} contact{}{})", limit.critical,
                     limit.rotation ? "rotation" : "translation", limit.grain, 1e3 * radius, contacts, contacts == 1 ? "" : "s",
                     with_walls > 0 ? fmt::format(", {} of them with walls", with_walls) : "");
}

}  // namespace puadem
