#include "puadem/coupling/case.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "puadem/base/error.hpp"
#include "puadem/base/parallel.hpp"

namespace puadem {

namespace {

int index_of(const Case& c, const std::string& name) {
  const auto found = std::ranges::find(c.materials, name, &Material::name);
  require(found != c.materials.end(), "no material \"{}\" for the grains", name);
  return static_cast<int>(found - c.materials.begin());
}

}  // namespace

std::vector<MaterialShare> grain_materials(const Case& c) {
  std::vector<MaterialShare> shares;
  for (const GrainOptions::Share& share : c.grains.materials) shares.push_back({index_of(c, share.name), share.fraction});
  if (shares.empty()) shares.push_back({index_of(c, c.grains.material), 1.0});
  return shares;
}

std::vector<AddedGrains> added_grains(const Case& c) {
  std::vector<AddedGrains> all;
  for (const GrainOptions::Added& added : c.grains.added)
    all.push_back({0.5 * added.diameter, index_of(c, added.material), added.count, added.at});
  return all;
}

std::string stage_name(const Case& c, int index) {
  const std::string_view kind = kind_of(c.stages[to_size(index)]);
  int before = 0;
  for (int i = 0; i < index; ++i) before += kind_of(c.stages[to_size(i)]) == kind ? 1 : 0;
  return before == 0 ? std::string(kind) : fmt::format("{}-{}", kind, before + 1);
}

}  // namespace puadem
