#include "puadem/dem/material.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "puadem/base/error.hpp"
#include "puadem/dem/contacts.hpp"
#include "puadem/dem/motion.hpp"
#include "support.hpp"

namespace puadem {
namespace {

using ::testing::HasSubstr;

TEST(MaterialPairs, MixAsTheirFormulas) {
  const std::vector<Material> two{test::material(1e8, 0.3, 2500, 0.6), test::material(3e8, 0.2, 2500, 0.4)};
  const MaterialPairs pairs = material_pairs(two, {});
  const PairConstants<double>& mixed = pairs.grains[1];
  EXPECT_NEAR(mixed.youngs, 1 / ((1 - 0.09) / 1e8 + (1 - 0.04) / 3e8), 1e-12 * mixed.youngs);
  EXPECT_NEAR(mixed.shear, 1 / ((2 - 0.3) / (1e8 / 2.6) + (2 - 0.2) / (3e8 / 2.4)), 1e-12 * mixed.shear);
  EXPECT_NEAR(mixed.friction, 0.4, 1e-12);
  EXPECT_EQ(mixed.spring_i, 1e8);
  EXPECT_EQ(mixed.spring_j, 3e8);
  EXPECT_EQ(pairs.grains[2].spring_i, 3e8);
  EXPECT_NEAR(pairs.walls[1].youngs, 3e8 / (2 * 0.96), 1e-4);
}

TEST(MaterialPairs, BadConstantsAreNamed) {
  const auto message = [](auto change) -> std::string {
    std::vector<Material> one(1);
    ContactOptions options;
    change(one[0], options);
    try {
      material_pairs(one, options);
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  };
  EXPECT_THAT(message([](auto& m, auto&) { m.density = 0; }), HasSubstr("density 0"));
  EXPECT_THAT(message([](auto& m, auto&) { m.youngs_modulus = -1; }), HasSubstr("youngs_modulus -1"));
  EXPECT_THAT(message([](auto& m, auto&) { m.poisson_ratio = 0.7; }), HasSubstr("poisson_ratio 0.7"));
  EXPECT_THAT(message([](auto& m, auto&) { m.friction_angle = 2; }), HasSubstr("friction_angle 2"));
  EXPECT_THAT(message([](auto&, auto& o) { o.restitution = 1.5; }), HasSubstr("restitution = 1.5"));
  EXPECT_THAT(message([](auto&, auto& o) { o.rolling_friction = -0.1; }), HasSubstr("rolling and twisting"));
}

/// Two spheres of two materials that overlap, in either order of identity.
Contact pair_contact(ContactOptions::Law law, bool swapped) {
  const std::vector<Material> two{test::material(1e8, 0.3, 2500), test::material(3e8, 0.2, 2500)};
  ContactOptions options;
  options.law = law;
  Particles p = make_particles(std::vector<Vec3>{{0, 0, 0}, {2.49e-3, 0, 0}}, std::vector<double>{1e-3, 1.5e-3}, two[0]);
  p.material = {0, 1};
  if (swapped) {
    std::swap(p.position[0], p.position[1]);
    std::swap(p.radius[0], p.radius[1]);
    p.material = {1, 0};
  }
  Domain box;
  box.lower = {-1, -1, -1};
  GrainSystem s = make_grain_system(p, box, two, options, {});
  evaluate_forces(s);
  return contacts_of(s)[0];
}

TEST(ContactOfTwoMaterials, FollowsTheClosedFormInEitherOrder) {
  for (const bool swapped : {false, true}) {
    const double hertz =
        4.0 / 3.0 / ((1 - 0.09) / 1e8 + (1 - 0.04) / 3e8) * std::sqrt(1e-3 * 1.5e-3 / 2.5e-3) * std::pow(1e-5, 1.5);
    EXPECT_NEAR(pair_contact(ContactOptions::Law::hertz_mindlin, swapped).normal_force, hertz, 1e-9 * hertz);
    const double linear = 2 * (1e8 * 1e-3) * (3e8 * 1.5e-3) / (1e8 * 1e-3 + 3e8 * 1.5e-3) * 1e-5;
    EXPECT_NEAR(pair_contact(ContactOptions::Law::linear_spring, swapped).normal_force, linear, 1e-9 * linear);
  }
}

// The properties every law of the variant must have.
template <class>
struct TypesOf;
template <class... Laws>
struct TypesOf<std::variant<Laws...>> {
  using type = ::testing::Types<Laws...>;
};
template <class Law>
struct EveryContactLaw : ::testing::Test {};
TYPED_TEST_SUITE(EveryContactLaw, TypesOf<AnyContactLaw>::type);

const PairConstants<double> sample{
    .youngs = 5e7, .shear = 2e7, .spring_i = 1e8, .spring_j = 2e8, .stiffness_ratio = 0.4, .friction = 0.5, .damping = 0};

TYPED_TEST(EveryContactLaw, HasNoForceAtFirstTouch) { EXPECT_EQ(TypeParam::respond(sample, 0.0, 1e-3, 0.4).force, 0.0); }

TYPED_TEST(EveryContactLaw, StiffnessIsTheSlopeOfTheForceAndEnergyItsIntegral) {
  const double overlap = 1e-6, h = 1e-10;
  const auto force = [](double d) { return TypeParam::respond(sample, d, 1e-3, 0.4).force; };
  const auto response = TypeParam::respond(sample, overlap, 1e-3, 0.4);
  EXPECT_NEAR(response.normal, (force(overlap + h) - force(overlap - h)) / (2 * h), 1e-6 * response.normal);
  EXPECT_NEAR(response.shear, TypeParam::stiffness_ratio(sample) * response.normal, 1e-12 * response.shear);
  double energy = 0.0;  // Simpson in the square root of the overlap, in which both laws are polynomials
  constexpr int n = 200;
  for (int k = 0; k <= n; ++k) {
    const double root = std::sqrt(overlap) * k / n, weight = k == 0 || k == n ? 1 : k % 2 == 1 ? 4 : 2;
    energy += weight * force(root * root) * 2 * root * std::sqrt(overlap) / (3.0 * n);
  }
  EXPECT_NEAR(TypeParam::energy_share * response.normal * overlap * overlap, energy, 1e-8 * energy);
}

TYPED_TEST(EveryContactLaw, ScalesWithTheUnitsOfLengthAndForce) {
  PairConstants<double> scaled = sample;  // metres to millimetres: moduli fall by 1e6 in N/mm2
  for (double* modulus : {&scaled.youngs, &scaled.shear, &scaled.spring_i, &scaled.spring_j}) *modulus *= 1e-6;
  const auto metres = TypeParam::respond(sample, 1e-6, 1e-3, 0.4), millimetres = TypeParam::respond(scaled, 1e-3, 1.0, 0.4);
  EXPECT_NEAR(millimetres.force, metres.force, 1e-12 * metres.force);
  EXPECT_NEAR(millimetres.normal, 1e-3 * metres.normal, 1e-15 * metres.normal);
}

TEST(CriticalTimeStep, IsThatOfTranslationWithoutFriction) {
  const Material m = test::material(1e8, 0.3, 2500);
  const double radius = 1e-3, overlap = 1e-5;
  Particles p =
      make_particles(std::vector<Vec3>{{0, 0, 0}, {2 * radius - overlap, 0, 0}}, std::vector<double>{radius, radius}, m);
  GrainSystem s = test::free_grains(p, m, {}, 0.1);
  EXPECT_EQ(critical_time_step(s).critical, std::numeric_limits<double>::infinity());
  evaluate_forces(s);
  const double stiffness = 2 * 1e8 / 1.82 * std::sqrt(radius / 2 * overlap);
  const TimeStepLimit limit = critical_time_step(s);
  EXPECT_NEAR(limit.critical, std::sqrt(2 * p.mass[0] / stiffness), 1e-9 * limit.critical);
  EXPECT_EQ(limit.grain, 0);
  EXPECT_FALSE(limit.rotation);
}

TEST(CriticalTimeStep, IsThatOfRotationWithFriction) {
  const Material m = test::material(1e8, 0.3, 2500, 0.5);
  const double radius = 1e-3, overlap = 1e-5;
  Particles p =
      make_particles(std::vector<Vec3>{{0, 0, 0}, {2 * radius - overlap, 0, 0}}, std::vector<double>{radius, radius}, m);
  GrainSystem s = test::free_grains(p, m, {}, 0.1);
  evaluate_forces(s);
  const double shear = 8 * (1e8 / 2.6 / 3.4) * std::sqrt(radius / 2 * overlap);
  const TimeStepLimit limit = critical_time_step(s);
  EXPECT_NEAR(limit.critical, std::sqrt(2 * p.inertia[0] / (shear * radius * radius)), 1e-9 * limit.critical);
  EXPECT_TRUE(limit.rotation);
}

// A pair on the point of instability: just below the critical step it swings for ever, well above it flies apart.
TEST(CriticalTimeStep, IsWhereThePairBecomesUnstable) {
  const Material m = test::material(1e8, 0.3, 2500);
  ContactOptions linear;
  linear.law = ContactOptions::Law::linear_spring;
  const double radius = 1e-3;
  const auto fastest = [&](double share) {
    // pressed between two walls' worth of force, so that the spring stays closed
    Particles p = make_particles(std::vector<Vec3>{{0, 0, 0}, {2 * radius - 1e-5, 0, 0}}, std::vector<double>{radius, radius}, m);
    GrainSystem s = test::free_grains(p, m, linear, 0.1);
    const double press = 1e8 * radius * 1e-5;
    s.external_force = {{press, 0, 0}, {-press, 0, 0}};
    s.record[0].drift[0] = 1e-6;
    evaluate_forces(s);
    s.time_step = share * critical_time_step(s).critical;
    double speed = 0.0;
    for (int step = 0; step < 300 && speed < 1e-1; ++step) {
      advance_grains(s, 1);
      speed = std::max(speed, std::abs(s.record[0].drift[0]));
    }
    return speed;
  };
  EXPECT_LT(fastest(0.98), 1e-5);
  EXPECT_GT(fastest(1.05), 1e-2);
}

TEST(ExternalForce, AcceleratesItsGrainOnly) {
  const Material m = test::material(1e8, 0.3, 2500);
  Particles p = make_particles(std::vector<Vec3>{{5e-3, 0, 0}, {0, 0, 0}}, std::vector<double>{1e-3, 1e-3}, m);
  GrainSystem s = test::free_grains(p, m, {}, 0.1);
  s.external_force = {{0, 0, 0}, {0, 2e-5, 0}};
  s.time_step = 1e-5;
  advance_grains(s, 100);
  collect(s, p);
  EXPECT_NEAR(p.velocity[1].y, 2e-5 / p.mass[1] * 1e-3, 1e-12);
  EXPECT_EQ(p.velocity[0], (Vec3{0, 0, 0}));
}

}  // namespace
}  // namespace puadem
