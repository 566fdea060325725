#include "puadem/coupling/case.hpp"

#include <algorithm>

#include "puadem/base/error.hpp"

namespace puadem {

std::vector<MaterialShare> grain_materials(const Case& c) {
  std::vector<MaterialShare> shares;
  const auto add = [&](const std::string& name, double fraction) {
    const auto found = std::ranges::find(c.materials, name, &Material::name);
    require(found != c.materials.end(), "no material \"{}\" for the grains", name);
    shares.push_back({static_cast<int>(found - c.materials.begin()), fraction});
  };
  for (const GrainOptions::Share& share : c.grains.materials) add(share.name, share.fraction);
  if (shares.empty()) add(c.grains.material, 1.0);
  return shares;
}

}  // namespace puadem
