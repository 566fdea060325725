#include "puadem/io/case_schema.hpp"
#include "puadem/io/key_builders.hpp"

namespace puadem {

namespace {

KeyInfo coalescence_key() {
  KeyInfo info = noted(number("coalescence_saturation", inside(0, 1),
                              "in a stage unsaturated-flow: saturation from which a pore takes in the bridges around it; "
                              "\"threshold\": that at which its gas touches its walls no more",
                              between(0.01, 0.9)),
                       "0.3");
  info.word_for_infinity = "threshold";
  return info;
}

/// A key that is written only where bridges keep their volume.
Field<BridgeCase> of_given_volume(Field<BridgeCase> field) {
  field.write = [write = field.write](const BridgeCase& b) {
    return b.control == BridgeControl::volume ? write(b) : std::string();
  };
  return field;
}

const Section<BridgeCase>& bridges_section() {
  static const Section<BridgeCase> section{{
      bind_choice<BridgeCase>(
          choice("control", {"suction", "volume"},
                 "what a bridge keeps while its ends move: the suction, as if joined to much more water, or its volume"),
          &BridgeCase::control),
      bind<BridgeCase>(noted(quantity("capillary_pressure", "Pa", above(0), between(10, 1e7), R"("10 kPa")",
                                      "of all bridges, with control = \"suction\", in stages that load the grains"),
                             "required there"),
                       &BridgeCase::capillary_pressure),
      bind<BridgeCase>(noted(number("water_content", Interval{0, 1, true, false},
                                    "mass of water over mass of grains, with control = \"volume\": shared as bridges of one "
                                    "suction would share it",
                                    between(1e-6, 0.2)),
                             "this, saturation or volume is required there"),
                       &BridgeCase::water_content),
      bind<BridgeCase>(noted(number("saturation", Interval{0, 1, true, false},
                                    "volume of water over volume of the void, in place of water_content", between(1e-6, 0.3)),
                             "water_content or volume"),
                       &BridgeCase::saturation),
      bind<BridgeCase>(noted(quantity("volume", "m3", above(0), {}, R"("1e-13 m3")",
                                      "of every bridge that is there at the start, in place of water_content"),
                             "water_content or saturation"),
                       &BridgeCase::volume),
      bind_choice<BridgeCase>(choice("law", {"table", "willett", "soulie"},
                                     "forces and rupture: exact by a table of the Young-Laplace equation, or a published fit of "
                                     "given volume"),
                              &BridgeCase::law),
      bind_choice<BridgeCase>(
          choice("formation", {"at-contact", "at-any-distance"},
                 "where the first bridges stand: where grains touch, as when they get wet; or wherever one can, as when a "
                 "packing has dried; later ones form at contact"),
          &BridgeCase::formation),
      of_given_volume(
          bind_choice<BridgeCase>(choice("rupture", {"halves", "neck"},
                                         "how a ruptured bridge leaves its water to its grains: in halves, or divided at "
                                         "its neck"),
                                  &BridgeCase::split)),
      bind<BridgeCase>(coalescence_key(), &BridgeCase::coalescence_saturation),
      of_given_volume(bind_choice<BridgeCase>(
          choice(
              "exchange", {"neighbours", "films"},
              "what water left on a grain does, at given volume: it goes to the grain's other bridges, which give each new one "
              "its share; or it stays until the grain touches something"),
          &BridgeCase::exchange)),
  }};
  return section;
}

}  // namespace

Field<Case> bridges_field() {
  return bind_table<Case>(
      plain("bridges", "a table",
            "liquid bridges between grains, in the stages that load them and between the dry pores of unsaturated-flow"),
      bridges_section, &Case::bridges);
}

}  // namespace puadem
