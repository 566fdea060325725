#pragma once

#include <cstdint>
#include <vector>

#include "puadem/dem/grain_system.hpp"
#include "puadem/dem/tensor.hpp"

namespace puadem {

/// Contacts of every grain, walls included, and what is left of them when rattlers are taken away.
struct GrainContacts {
  std::vector<int> count;                ///< by record
  std::vector<std::uint8_t> is_rattler;  ///< by record
  int rattlers = 0;
  long backbone_ends = 0;  ///< contacts of the other grains among themselves and with walls, one for each grain at each
};

/// Rattlers are grains that a rigid framework cannot hold: with friction those of less than two contacts,
/// without any those of less than four. Taking one away takes its contacts from its neighbours, which may
/// make them rattlers; so again until none is left.
GrainContacts count_contacts(const GrainSystem& system);

/// How contacts and their forces are spread over directions and sizes.
struct FabricMeasures {
  Tensor fabric{};          ///< mean n (outer) n over the contacts between grains [-], trace one
  Tensor fabric_all{};      ///< the same with contacts at walls
  Tensor anisotropy{};      ///< a = 15/2 (fabric - I/3), deviatoric; density of directions 1/4pi (1 + a_ij n_i n_j), theory 2.17
  double deviatoric = 0.0;  ///< sqrt(3/2 a:a) [-]; 0 where directions are spread evenly
  double coordination = 0.0;             ///< contacts of a grain, walls included, on average [-]
  double coordination_mechanical = 0.0;  ///< Z_m = (2 N_c - N_1) / (N - N_0 - N_1) of Thornton 2000 [-]
  double coordination_backbone = 0.0;    ///< mean over the grains that are no rattlers, without contacts with those [-]
  double rattlers = 0.0;                 ///< share of the grains [-]
  double sliding = 0.0;                  ///< share of contacts at their Coulomb limit [-]
  double mean_force = 0.0;               ///< normal force of a contact between grains [N]
  double force_moment[3] = {0, 0, 0};    ///< means of (F_n / mean)^2, ^3 and ^4 [-]
};

/// @pre the forces are those of the present places
FabricMeasures measure_fabric(const GrainSystem& system);

}  // namespace puadem
