#pragma once

#include <array>

#include "puadem/dem/grain_system.hpp"
#include "puadem/dem/tensor.hpp"

namespace puadem {

/// What a packing is like at the forces last evaluated. Compression positive.
struct GrainMeasures {
  Tensor stress{};                       ///< of the box, bridges and contacts with walls included [Pa], theory 2.13
  Tensor pair_stress{};                  ///< share of the contacts between grains [Pa]
  Tensor bridge_stress{};                ///< share of the liquid bridges, those to walls included [Pa]
  std::array<double, 6> wall_stress{};   ///< normal stress on the box's faces [Pa]; 0 on periodic ones
  double mean_stress = 0.0;              ///< p, third of the trace of `stress` [Pa]
  double deviatoric_stress = 0.0;        ///< q = sqrt(3/2 s:s) of its deviator s [Pa]
  double unbalanced = 0.0;               ///< mean net force on a grain / mean contact force [-]
  double coordination = 0.0;             ///< contacts of a grain, walls included, on average [-]
  double coordination_inner = 0.0;       ///< the same without rattlers and their contacts [-], see count_contacts
  int contacts = 0;                      ///< between grains, and with walls
  double largest_overlap = 0.0;          ///< as a share of the smaller radius [-]
  double affine_modulus[3] = {0, 0, 0};  ///< (1/V) sum k_n l^2 n_a^4, upper bound of the stiffness along an axis [Pa]
};

GrainMeasures measure(const GrainSystem& system);

}  // namespace puadem
