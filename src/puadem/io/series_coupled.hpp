#pragma once

#include <string>
#include <string_view>

#include "puadem/coupling/saturated_stage.hpp"

namespace puadem {

/// The series of stages in which grains and fluid move each other.
inline constexpr std::string_view saturated_header =
    "stage,step,time_s,time_factor,settlement_m,degree,degree_pressure,degree_terzaghi,pressure_mean_Pa,pressure_largest_Pa,"
    "inlet_pressure_Pa,gradient,contact_stress_lower_Pa,contact_stress_upper_Pa,fluid_in_m3,void_m3,ledger_error,porosity,"
    "unbalanced,remeshes\n";
inline constexpr std::string_view pressure_profile_header = "stage,time_s,time_factor,place_m,pressure_Pa,terzaghi_Pa,pores\n";

std::string saturated_line(const SaturatedRow& row);
std::string pressure_profile_lines(const SaturatedRecord& record, const PressureProfile& profile);

}  // namespace puadem
