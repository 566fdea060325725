#include "puadem/io/series_coupled.hpp"

#include <fmt/format.h>

#include "puadem/coupling/pore_space.hpp"

namespace puadem {

namespace {

std::string text_of(const std::optional<double>& value) { return value ? fmt::format("{}", *value) : std::string(); }

/// Which row a line belongs to.
std::string row_name(const UnsaturatedRow& r) {
  return fmt::format("{},{},{},{},{}", r.stage, r.branch, text_of(r.time), r.capillary_pressure, r.saturation);
}

}  // namespace

std::string saturated_line(const SaturatedRow& r) {
  return fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", r.stage, r.step, r.time,
                     text_of(r.time_factor), r.settlement, text_of(r.degree), text_of(r.degree_pressure),
                     text_of(r.degree_terzaghi), r.pressure_mean, r.pressure_largest, r.inlet_pressure, r.gradient,
                     r.contact_stress_lower, r.contact_stress_upper, r.fluid_in, r.void_volume, r.ledger_error, r.porosity,
                     r.unbalanced, r.remeshes);
}

std::string unsaturated_line(const UnsaturatedRow& r) {
  std::string spans;
  for (unsigned a = 0; a < 3; ++a)
    if (r.chains_span[a]) spans += "xyz"[a];
  const Vec3 &s = r.contact_stress, &f = r.fluid_stress;
  std::string line = fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}", r.stage, r.branch, text_of(r.time),
                                 r.capillary_pressure, r.pc_star, r.saturation, r.strain, r.volume_strain, r.porosity,
                                 r.total_stress, s.x, s.y, s.z, f.x, f.y, f.z, text_of(r.chi_contact), text_of(r.chi_fluid));
  line +=
      fmt::format(",{},{},{},{},{},{},{},{},{},{}", r.mean_force, r.mean_force_ratio, r.strong_share, spans, r.coordination,
                  r.contact_anisotropy, text_of(r.capillary_anisotropy), r.capillary_force, r.pressure_force, r.tension_force);
  return line + fmt::format(",{},{},{},{},{},{},{},{},{},{},{},{},{}\n", r.trapped_wetting, r.trapped_nonwetting, r.wetting_error,
                            r.nonwetting_error, r.rounds, r.remeshes, r.pores_changed, r.bridge_stress.x, r.bridge_stress.y,
                            r.bridge_stress.z, r.bridges, r.bridge_force, r.bridge_saturation);
}

std::string swelling_line(const UnsaturatedRow& r, const SwellingRow& s) {
  return fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", r.stage, text_of(r.time), r.capillary_pressure,
                     r.saturation, s.radius_mean, s.radius_least, s.radius_most, s.wetted, s.grown, s.from_pores,
                     s.from_reservoirs, s.water_error, r.porosity, s.mean_stress, s.deviatoric_stress, s.grain_deviator_mean,
                     s.grain_deviator_deviation);
}

std::string pore_space_lines(const UnsaturatedRow& row, const PoreSpaceRow& pores) {
  std::string lines;
  const auto add = [&](std::string_view quantity, const PoreSizes& sizes) {
    for (int k = 0; k < sizes.parts; ++k) {
      const NormalPart& part = sizes.part[to_size(k)];
      lines += fmt::format("{},{},{},{},{},{},{},{},{}\n", row_name(row), quantity, sizes.samples, sizes.mean, sizes.deviation,
                           k + 1, part.weight, part.mean, part.deviation);
    }
  };
  add("pore_radius", pores.pore_radius);
  add("throat_radius", pores.throat_radius);
  add("unit_porosity", pores.porosity);
  return lines;
}

std::string local_porosity_lines(const UnsaturatedRecord& record, int row) {
  const auto [nx, ny, nz] = record.blocks;
  const auto first = blocks_of(record, 0), now = blocks_of(record, row);
  std::string lines;
  for (int b = 0; b < size_of(now); ++b) {
    const LocalBlock& block = now[to_size(b)];
    const Vec3 &moved = block.displacement, at{(b % nx + 0.5) / nx, (b / nx % ny + 0.5) / ny, (b / nx / ny + 0.5) / nz};
    lines +=
        fmt::format("{},{},{},{},{},{},{},{},{},{},{}\n", row_name(record.rows[to_size(row)]), at.x, at.y, at.z, block.grains,
                    block.porosity, block.porosity - first[to_size(b)].porosity, block.saturation, moved.x, moved.y, moved.z);
  }
  return lines;
}

std::string pressure_profile_lines(const SaturatedRecord& record, const PressureProfile& profile) {
  std::string lines;
  for (const PressureLayer& layer : profile.layers)
    lines += fmt::format("{},{},{},{},{},{},{}\n", record.stage, profile.time, text_of(profile.time_factor), layer.place,
                         layer.pressure, record.reference ? fmt::format("{}", layer.linear) : std::string(), layer.pores);
  return lines;
}

}  // namespace puadem
