#include "puadem/base/parallel.hpp"
#include "puadem/geometry/domain.hpp"
#include "puadem/io/case_schema_stages.hpp"

namespace puadem {

template <>
const Section<PermeabilityStage>& stage_section() {
  static const Section<PermeabilityStage> section = [] {
    const KeyInfo inlet =
        choice("inlet", {face_names.begin(), face_names.end()},
               "face of the high pressure, for the profile and the fields; permeability is measured along all axes");
    const Field<PermeabilityStage> inlet_field{
        inlet,
        [inlet](const TomlValue& value, Problems& problems, PermeabilityStage& s) {
          if (const auto face = read_face(value, inlet, problems)) s.inlet = *face;
        },
        [](const PermeabilityStage& s) { return toml_text(face_names[to_size(s.inlet)]); }};
    return Section<PermeabilityStage>{{
        kind_field<PermeabilityStage>(
            "permeability tensor of the box, and the wetting fluid driven through it; grains stand still"),
        inlet_field,
        bind<PermeabilityStage>(quantity("pressure_drop", "Pa", above(0), between(1e-3, 1e7), R"("1 kPa")",
                                         "from the inlet to the opposite face; permeability does not depend on it"),
                                &PermeabilityStage::pressure_drop),
        bind<PermeabilityStage>(flag("merged",
                                     "measure on merged pore units, which have no resistance inside, in place of single "
                                     "tetrahedra"),
                                &PermeabilityStage::merged),
        bind<PermeabilityStage>(whole("layers", 1, 1e5, "layers of series/pressure.csv between the two faces", "20"),
                                &PermeabilityStage::layers),
    }};
  }();
  return section;
}

}  // namespace puadem
