#pragma once

#include <vector>

#include "puadem/dem/grain_system.hpp"
#include "puadem/dem/tensor.hpp"

namespace puadem {

/// What every grain carries, by identity. Compression positive.
struct GrainStresses {
  std::vector<double> volume;      ///< of the power cell within the walls [m3]
  std::vector<Tensor> stress;      ///< mean over the power cell, theory 2.17 [Pa]
  std::vector<double> mean;        ///< p, third of the trace [Pa]
  std::vector<double> deviatoric;  ///< q = sqrt(3/2 s:s) [Pa]
  std::vector<int> contacts;       ///< walls included
};

/// Stress of every grain on its power cell. The mean over the grains, weighted by volume, is the stress of
/// the box (`measure`) to rounding.
/// @pre the forces are those of the present places; box walls stand at the faces of the box
/// @throws InputError  a grain that owns no space, see triangulate
GrainStresses grain_stresses(const GrainSystem& system);

}  // namespace puadem
