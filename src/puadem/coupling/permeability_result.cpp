#include "puadem/coupling/permeability_result.hpp"

#include <algorithm>
#include <cmath>

namespace puadem {

double PermeabilityResult::asymmetry() const {
  const auto& k = permeability.tensor;
  const double worst = std::max({std::abs(k[0].y - k[1].x), std::abs(k[1].z - k[2].y), std::abs(k[2].x - k[0].z)});
  return worst / permeability.mean();
}

std::optional<double> PermeabilityResult::kozeny_carman() const {
  if (!sauter_radius) return std::nullopt;
  return puadem::kozeny_carman(porosity, *sauter_radius);
}

std::vector<PressureLayer> pressure_layers(const PoreNetwork& network, const Domain& domain, int axis, int layers,
                                           std::span<const double> pressure, std::span<const double> linear) {
  const double thickness = domain.size()[axis] / layers;
  std::vector<PressureLayer> profile(to_size(layers));
  std::vector<double> volume(to_size(layers), 0.0);
  for (int p = 0; p < network.pores(); ++p) {
    const double depth = network.pore_centre[to_size(p)][axis] - domain.lower[axis];
    // A pore that lies across a periodic face may have its centre a little outside.
    const auto layer = to_size(std::clamp(static_cast<int>(std::floor(depth / thickness)), 0, layers - 1));
    const double v = network.pore_volume[to_size(p)];
    volume[layer] += v;
    profile[layer].pressure += v * pressure[to_size(p)];
    profile[layer].linear += v * linear[to_size(p)];
    ++profile[layer].pores;
  }
  for (std::size_t k = 0; k < profile.size(); ++k) {
    profile[k].place = (static_cast<double>(k) + 0.5) * thickness;
    profile[k].pressure /= volume[k];
    profile[k].linear /= volume[k];
  }
  std::erase_if(profile, [](const PressureLayer& layer) { return layer.pores == 0; });
  return profile;
}

}  // namespace puadem
