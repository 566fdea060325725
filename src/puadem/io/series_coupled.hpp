#pragma once

#include <string>
#include <string_view>

#include "puadem/coupling/saturated_stage.hpp"
#include "puadem/coupling/unsaturated_stage.hpp"

namespace puadem {

/// The series of stages in which grains and fluid move each other.
inline constexpr std::string_view saturated_header =
    "stage,step,time_s,time_factor,settlement_m,degree,degree_pressure,degree_terzaghi,pressure_mean_Pa,pressure_largest_Pa,"
    "inlet_pressure_Pa,gradient,contact_stress_lower_Pa,contact_stress_upper_Pa,fluid_in_m3,void_m3,ledger_error,porosity,"
    "unbalanced,remeshes\n";
inline constexpr std::string_view pressure_profile_header = "stage,time_s,time_factor,place_m,pressure_Pa,terzaghi_Pa,pores\n";

inline constexpr std::string_view unsaturated_header =
    "stage,branch,time_s,pc_Pa,pc_star,saturation,axial_strain,volume_strain,porosity,total_stress_Pa,contact_stress_xx_Pa,"
    "contact_stress_yy_Pa,contact_stress_zz_Pa,fluid_stress_xx_Pa,fluid_stress_yy_Pa,fluid_stress_zz_Pa,chi_contact,chi_fluid,"
    "mean_normal_force_N,mean_force_ratio,strong_contacts,chains_span,coordination,contact_anisotropy,capillary_anisotropy,"
    "capillary_force_N,pressure_force_N,tension_force_N,trapped_wetting,trapped_nonwetting,wetting_error,nonwetting_error,rounds,"
    "remeshes,pores_changed,bridge_stress_xx_Pa,bridge_stress_yy_Pa,bridge_stress_zz_Pa,bridges,bridge_force_N,"
    "bridge_saturation\n";
inline constexpr std::string_view swelling_header =
    "stage,time_s,pc_Pa,saturation,radius_mean_m,radius_least_m,radius_most_m,wetted,grown_m3,from_pores_m3,from_reservoirs_m3,"
    "water_error,porosity,mean_stress_Pa,deviatoric_stress_Pa,grain_deviator_mean_Pa,grain_deviator_deviation_Pa\n";

inline constexpr std::string_view pore_space_header =
    "stage,branch,time_s,pc_Pa,saturation,quantity,samples,mean,deviation,part,weight,part_mean,part_deviation\n";
inline constexpr std::string_view local_porosity_header =
    "stage,branch,time_s,pc_Pa,saturation,x,y,z,grains,local_porosity,porosity_change,local_saturation,displacement_x_m,"
    "displacement_y_m,displacement_z_m\n";

std::string saturated_line(const SaturatedRow& row);
std::string unsaturated_line(const UnsaturatedRow& row);
std::string swelling_line(const UnsaturatedRow& row, const SwellingRow& swelling);
/// Long: a line for each part of the mixture of each quantity.
std::string pore_space_lines(const UnsaturatedRow& row, const PoreSpaceRow& pores);
/// A line for each block, whose middle is given as fractions of the box.
std::string local_porosity_lines(const UnsaturatedRecord& record, int row);
std::string pressure_profile_lines(const SaturatedRecord& record, const PressureProfile& profile);

}  // namespace puadem
