#include "puadem/io/initial_state.hpp"

#include <algorithm>

#include "puadem/base/error.hpp"
#include "puadem/io/packing_file.hpp"

namespace puadem {

State initial_state(const Case& c, std::vector<std::string>& warnings) {
  State state;
  if (!c.grains.file) return state;
  const PackingFile file = read_packing(*c.grains.file);
  warnings.insert(warnings.end(), file.warnings.begin(), file.warnings.end());
  const auto material = std::ranges::find(c.materials, c.grains.material, &Material::name);
  require(material != c.materials.end(), "no material \"{}\" for the grains of {}", c.grains.material, c.grains.file->string());
  state.particles =
      make_particles(file.centre, file.radius, *material, static_cast<int>(std::distance(c.materials.begin(), material)));
  state.domain = file.box;
  state.domain.periodic = c.domain.periodic;
  return state;
}

}  // namespace puadem
