#include "puadem/coupling/case.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "puadem/base/error.hpp"
#include "puadem/base/parallel.hpp"

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

std::string stage_name(const Case& c, int index) {
  const std::string_view kind = kind_of(c.stages[to_size(index)]);
  int before = 0;
  for (int i = 0; i < index; ++i) before += kind_of(c.stages[to_size(i)]) == kind ? 1 : 0;
  return before == 0 ? std::string(kind) : fmt::format("{}-{}", kind, before + 1);
}

}  // namespace puadem
