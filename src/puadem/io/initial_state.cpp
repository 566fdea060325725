#include "puadem/io/initial_state.hpp"

#include "puadem/io/packing_file.hpp"

namespace puadem {

State initial_state(const Case& c, std::vector<std::string>& warnings) {
  State state;
  if (!c.grains.file) return state;
  const PackingFile file = read_packing(*c.grains.file);
  warnings.insert(warnings.end(), file.warnings.begin(), file.warnings.end());
  state.particles = make_particles(file.centre, file.radius, c.materials, assign_materials(file.radius, grain_materials(c)));
  state.domain = file.box;
  state.domain.periodic = c.domain.periodic;
  return state;
}

}  // namespace puadem
