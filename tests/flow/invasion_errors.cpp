#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <numbers>

#include "flow/sample_networks.hpp"
#include "puadem/base/error.hpp"
#include "puadem/flow/invasion.hpp"

namespace puadem::testing {
namespace {

using ::testing::HasSubstr;

template <class Error>
std::string message_of(const std::function<void()>& act) {
  try {
    act();
  } catch (const Error& error) {
    return error.what();
  }
  return "nothing thrown";
}

std::string start_error(const PoreNetwork& network, const Fluids& fluids = unit_fluids(), const InvasionOptions& options = {}) {
  return message_of<InputError>([&] { start_invasion(network, fluids, options); });
}

TEST(StartInvasion, SaysWhatIsWrongWithTheReservoirs) {
  const PoreNetwork good = chain({1.0, 2.0});
  InvasionOptions options;
  options.nonwetting_face = 1;
  EXPECT_THAT(start_error(good, unit_fluids(), options),
              HasSubstr("no pore touches the right face, where the non-wetting reservoir"));
  options = {};
  options.wetting_face = 2;
  EXPECT_THAT(start_error(good, unit_fluids(), options),
              HasSubstr("no pore touches the front face, where the wetting reservoir"));
  options.wetting_face = 6;
  EXPECT_THAT(start_error(good, unit_fluids(), options), HasSubstr("at face 6; faces are numbered 0 to 5"));
  options.wetting_face = 5;
  EXPECT_THAT(start_error(good, unit_fluids(), options),
              HasSubstr("pore 0 touches both reservoirs, at the top and the top face"));

  PoreNetwork thin = good;
  thin.pore_walls[1] = at_top | at_bottom;
  EXPECT_THAT(start_error(thin),
              HasSubstr("pore 1 touches both reservoirs, at the top and the bottom face: the packing is too thin"));
  EXPECT_THAT(start_error(chain({1.0})), HasSubstr("every pore belongs to a reservoir"));
  EXPECT_THAT(start_error(PoreNetwork{}), HasSubstr("no pore touches the top face"));
}

TEST(StartInvasion, SaysWhichOptionsExcludeOneAnother) {
  InvasionOptions options;
  options.body_entry = false;
  EXPECT_THAT(start_error(chain({1.0, 2.0}), unit_fluids(), options), HasSubstr("body_entry = false needs corner_water = false"));
  options.corner_water = false;
  EXPECT_EQ(start_error(chain({1.0, 2.0}), unit_fluids(), options), "nothing thrown");
  options.side_pores = false;
  PoreNetwork narrow = chain({1.0, 2.0});
  narrow.pore_walls[1] = 1;
  EXPECT_THAT(start_error(narrow, unit_fluids(), options), HasSubstr("every pore touches a wall: the packing is too thin"));
}

TEST(StartInvasion, SaysWhatIsWrongWithTheFluids) {
  Fluids fluids = unit_fluids();
  fluids.surface_tension = -0.07;
  EXPECT_THAT(start_error(chain({1.0, 2.0}), fluids), HasSubstr("surface tension is -0.07 N/m; it must be positive"));
  fluids = unit_fluids();
  fluids.contact_angle = std::numbers::pi / 2.0;
  EXPECT_THAT(start_error(chain({1.0, 2.0}), fluids), HasSubstr("contact angle is 90 degrees; it must lie in [0, 90)"));
}

TEST(StartInvasion, SaysWhatIsWrongWithTheNetwork) {
  const auto with = [](const auto& change) {
    PoreNetwork network = chain({1.0, 2.0});
    change(network);
    return start_error(network, unit_fluids(), with_snap_off());
  };
  EXPECT_THAT(with([](auto& n) { n.pore_volume[1] = 0.0; }), HasSubstr("pore 1 has the volume 0 m3"));
  EXPECT_THAT(with([](auto& n) { n.pore_radius[1] = std::numeric_limits<double>::quiet_NaN(); }),
              HasSubstr("pore 1 has the radius nan m"));
  EXPECT_THAT(with([](auto& n) { n.pore_faces[2] = 0; }), HasSubstr("pore 2 has 0 faces"));
  EXPECT_THAT(with([](auto& n) { n.throat_entry_radius[1] = -1.0; }), HasSubstr("throat 1 has the entry radius -1 m"));
  EXPECT_THAT(with([](auto& n) { n.throat_snap_off_radius[1] = 0.4; }),
              HasSubstr("throat 1 has the snap-off radius 0.4 m below its entry radius 0.5 m"));
}

TEST(AdvanceTo, RefusesAPressureThatIsNone) {
  const PoreNetwork network = chain({1.0, 2.0});
  InvasionState state = start_invasion(network, unit_fluids(), {});
  EXPECT_THAT(message_of<InputError>([&] { advance_to(network, -1.0, state); }),
              HasSubstr("capillary pressure -1 Pa cannot be reached"));
  EXPECT_THAT(message_of<InputError>([&] { advance_to(network, std::numeric_limits<double>::infinity(), state); }),
              HasSubstr("inf Pa"));
}

// Thresholds that contradict one another: snap-off above entry.
TEST(AdvanceTo, StopsAnEndlessStorm) {
  PoreNetwork network = chain({1.0, 4.0, 1e6});
  add_throat(network, 2, 3, 1e-6, 1e-6);
  add_throat(network, 1, 3, 1e-6, 1e-6);
  InvasionState state = start_invasion(network, unit_fluids(), {});
  state.thresholds.snap_off_pressure[1] = 20.0;
  EXPECT_THAT(message_of<NumericalError>([&] { advance_to(network, 5.0, state); }),
              HasSubstr("throat 1 between pores 1 and 2 opens and closes again"));
}

}  // namespace
}  // namespace puadem::testing
