#include "puadem/io/series_coupled.hpp"

#include <fmt/format.h>

namespace puadem {

namespace {

std::string text_of(const std::optional<double>& value) { return value ? fmt::format("{}", *value) : std::string(); }

}  // namespace

std::string saturated_line(const SaturatedRow& r) {
  return fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", r.stage, r.step, r.time,
                     text_of(r.time_factor), r.settlement, text_of(r.degree), text_of(r.degree_pressure),
                     text_of(r.degree_terzaghi), r.pressure_mean, r.pressure_largest, r.inlet_pressure, r.gradient,
                     r.contact_stress_lower, r.contact_stress_upper, r.fluid_in, r.void_volume, r.ledger_error, r.porosity,
                     r.unbalanced, r.remeshes);
}

std::string pressure_profile_lines(const SaturatedRecord& record, const PressureProfile& profile) {
  std::string lines;
  for (const PressureLayer& layer : profile.layers)
    lines += fmt::format("{},{},{},{},{},{},{}\n", record.stage, profile.time, text_of(profile.time_factor), layer.place,
                         layer.pressure, record.reference ? fmt::format("{}", layer.linear) : std::string(), layer.pores);
  return lines;
}

}  // namespace puadem
