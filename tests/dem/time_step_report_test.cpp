#include "puadem/dem/time_step_report.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support.hpp"

namespace puadem {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

// A small grain between a wall and a large one binds; the message names it, its size and what it touches. A grain
// that touches nothing binds nothing, whatever its number.
TEST(TimeStepText, NamesTheGrainThatBinds) {
  Domain box{{0, 0, 0}, {0.02, 0.02, 0.02}, {false, false, false}};
  for (const double friction : {0.0, 0.5}) {
    const Material m = test::material(1e8, 0.3, 2500, friction);
    const Particles p = make_particles(
        std::vector<Vec3>{{0.01, 0.01, 0.015}, {0.01, 0.01, 0.495e-3}, {0.01, 0.01, 2.97e-3}, {0.01, 0.01, 6.94e-3}},
        std::vector<double>{0.5e-3, 0.5e-3, 2e-3, 2e-3}, m);
    ContactOptions contact;
    contact.wall_friction = friction;
    GrainSystem s = make_grain_system(p, box, std::span(&m, 1), contact, {});
    EXPECT_EQ(time_step_text(s, {}), "no critical step: nothing touches");
    evaluate_forces(s);
    const TimeStepLimit limit = critical_time_step(s);
    EXPECT_THAT(time_step_text(s, limit), AllOf(HasSubstr(fmt::format("critical step {:.3g} s: ", limit.critical)),
                                                HasSubstr(friction > 0 ? "rotation of grain 1 " : "translation of grain 1 "),
                                                HasSubstr("(R = 0.5 mm, 2 contacts, 1 of them with walls)")));
    TimeStepLimit other = limit;
    other.grain = 3;
    EXPECT_THAT(time_step_text(s, other), HasSubstr("grain 3 (R = 2 mm, 1 contact)"));
  }
}

}  // namespace
}  // namespace puadem
