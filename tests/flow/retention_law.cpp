#include "puadem/flow/retention_law.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "puadem/flow/capillary_laws/regular_polyhedron.hpp"

namespace puadem {
namespace {

// The laws come from the variant itself: a law added there is tested here.
template <class>
struct GTestTypes;
template <class... Laws>
struct GTestTypes<std::variant<Laws...>> {
  using type = ::testing::Types<Laws...>;
};

template <class Law>
struct EveryRetentionLaw : ::testing::Test {
  Law law{};
  // With more faces the exponential law is flat to rounding near S = 1.
  std::vector<CapillaryUnit> units(const std::vector<int>& with_faces = {4, 5, 6, 7, 8, 10, 12, 16, 20}) const {
    std::vector<CapillaryUnit> all;
    for (const int faces : with_faces)
      for (const double threshold : {1e-3, 4.8042, 723.1, 1e6}) all.push_back({threshold, faces});
    return all;
  }
  static std::vector<double> parts() { return {1e-3, 0.01, 0.1, 0.3, 0.5, 0.7, 0.9, 0.99}; }
};
TYPED_TEST_SUITE(EveryRetentionLaw, GTestTypes<AnyRetentionLaw>::type);

TYPED_TEST(EveryRetentionLaw, ModelsTheConcept) { static_assert(RetentionLaw<TypeParam>); }

TYPED_TEST(EveryRetentionLaw, PressureFallsWithSaturation) {
  for (const CapillaryUnit& unit : this->units()) {
    double last = std::numeric_limits<double>::infinity();
    for (const double part : this->parts()) {
      const double pressure = this->law.capillary_pressure(unit, part * this->law.largest_saturation(unit));
      EXPECT_LT(pressure, last);
      last = pressure;
    }
    EXPECT_GE(last, this->law.saturated_pressure(unit) * (1.0 - 1e-12));
  }
}

TYPED_TEST(EveryRetentionLaw, InverseUndoesIt) {
  for (const CapillaryUnit& unit : this->units())
    for (const double part : this->parts()) {
      const double saturation = part * this->law.largest_saturation(unit);
      const double pressure = this->law.capillary_pressure(unit, saturation);
      // An error of one rounding in p_c comes back as that over the slope.
      const double tolerance = 1e-12 * saturation + 1e-15 * pressure / std::abs(this->law.slope(unit, saturation));
      EXPECT_NEAR(this->law.saturation(unit, pressure), saturation, tolerance) << unit.faces << " " << part;
    }
}

TYPED_TEST(EveryRetentionLaw, SlopeIsTheFiniteDifference) {
  for (const CapillaryUnit& unit : this->units())
    for (const double part : {0.01, 0.1, 0.3, 0.5}) {
      const double saturation = part * this->law.largest_saturation(unit), h = 1e-4 * saturation;
      const double difference =
          (this->law.capillary_pressure(unit, saturation + h) - this->law.capillary_pressure(unit, saturation - h)) / (2.0 * h);
      const double slope = this->law.slope(unit, saturation);
      EXPECT_LT(slope, 0.0);
      EXPECT_NEAR(difference, slope, 1e-6 * std::abs(slope) + 1e-10 * unit.threshold / h) << unit.faces << " " << part;
    }
}

TYPED_TEST(EveryRetentionLaw, ScalesWithTheThreshold) {
  for (const int faces : {4, 8, 20}) {
    const CapillaryUnit unit{3.0, faces}, large{3000.0, faces};
    EXPECT_NEAR(this->law.saturation(large, 5000.0), this->law.saturation(unit, 5.0), 1e-14);
    EXPECT_NEAR(this->law.capillary_pressure(large, 0.1), 1000.0 * this->law.capillary_pressure(unit, 0.1), 1e-9);
  }
}

TYPED_TEST(EveryRetentionLaw, StaysInRangeFromTheSaturatedPressureOn) {
  for (const CapillaryUnit& unit : this->units({4, 6, 7, 8, 12, 20, 26, 28, 30, 31, 42, 60})) {
    double pressure = this->law.saturated_pressure(unit);
    EXPECT_GE(pressure, unit.threshold);
    EXPECT_LT(pressure, 1.03 * unit.threshold);
    double last = this->law.largest_saturation(unit) * (1.0 + 1e-15);
    for (int k = 0; k < 100; ++k) {  // the very next doubles, where rounding could lead beyond 1
      const double saturation = this->law.saturation(unit, pressure);
      EXPECT_LE(saturation, last);
      EXPECT_LE(saturation, 1.0);
      EXPECT_GT(saturation, 0.0);
      last = saturation;
      pressure = std::nextafter(pressure, 2.0 * pressure);
    }
    EXPECT_LT(this->law.saturation(unit, 1e6 * unit.threshold), 1e-6);
  }
}

// Regular tetrahedron of volume 1 with kappa = 3.8716: R = 0.4163, p_thr = 2 / R.
TEST(ExponentialRetention, MatchesTheWorkedTetrahedron) {
  const ExponentialRetention law{0.0, 3.8716};
  const CapillaryUnit unit{2.0 / 0.4163, 4};
  EXPECT_NEAR(unit.threshold, 4.8042, 5e-5);
  EXPECT_NEAR(law.capillary_pressure(unit, 0.5), 5.614, 5e-4);
  EXPECT_NEAR(law.saturation(unit, 2.0 * unit.threshold), 0.17903, 5e-6);
  EXPECT_NEAR(law.saturation(unit, 2.0 * unit.threshold), std::numbers::ln2 / 3.8716, 1e-15);
}

TEST(ExponentialRetention, KappaRisesWithFaces) {
  const ExponentialRetention law;
  EXPECT_NEAR(law.kappa(4), 3.9323, 1e-12);
  EXPECT_NEAR(law.kappa(12), 14.0051, 1e-12);
}

// A cube at five times its threshold holds edge and corner water only: 0.009, the exponential law 0.033.
TEST(PolyhedronRetention, RetainsLessThanTheExponentialWhenDry) {
  const CapillaryUnit cube{1.0, 6};
  EXPECT_NEAR(PolyhedronRetention{}.saturation(cube, 5.0), 0.009, 5e-4);
  EXPECT_NEAR((ExponentialRetention{0.0, 6.7419}.saturation(cube, 5.0)), 0.033, 5e-4);
}

// A cube of edge a with edge menisci of radius r: 12 edges with (1 - pi/4) r^2 each, far from the corners.
TEST(PolyhedronRetention, FollowsTheEdgesOfACubeAtHighSuction) {
  const double edge = 1.0, threshold = 2.0 / 0.5 / edge, pressure = 1e5 * threshold;
  const double radius = 1.0 / pressure;
  const double water = 12.0 * edge * (1.0 - std::numbers::pi / 4.0) * radius * radius;
  EXPECT_NEAR(PolyhedronRetention{}.saturation({threshold, 6}, pressure), water, 1e-4 * water);
}

struct Shape {
  int faces;
  double chi, angle, touching, edge_water;
};

TEST(RegularPolyhedron, MatchesKnownSolids) {
  for (const Shape& s :
       {Shape{4, 0.4163, 70.53, 0.6977, 1.4040}, Shape{6, 0.5, 90.0, 0.4764, 0.6438}, Shape{8, 0.5246, 109.47, 0.3954, 0.3532},
        Shape{12, 0.5648, 116.57, 0.2453, 0.2452}, Shape{20, 0.5827, 138.19, 0.1712, 0.0989}}) {
    const RegularPolyhedron p = regular_polyhedron(s.faces);
    EXPECT_NEAR(p.inscribed_radius, s.chi, 1e-4) << s.faces;
    EXPECT_NEAR(p.dihedral_angle * 180.0 / std::numbers::pi, s.angle, 5e-3) << s.faces;
    EXPECT_NEAR(p.touching_saturation(), s.touching, 1.5e-4) << s.faces;
    EXPECT_NEAR(p.edge_water, s.edge_water, 1e-4) << s.faces;
  }
}

TEST(RegularPolyhedron, LiesBetweenItsNeighbours) {
  const auto angle = [](int faces) { return regular_polyhedron(faces).dihedral_angle; };
  const double t = std::log(10.0 / 8.0) / std::log(12.0 / 8.0);
  EXPECT_NEAR(angle(10), (1.0 - t) * angle(8) + t * angle(12), 1e-14);
  EXPECT_EQ(angle(40), angle(20));
}

TEST(CornerAngleLimit, MatchesKnownSolids) {
  const double degree = std::numbers::pi / 180.0;
  EXPECT_NEAR(corner_angle_limit(4), 54.7 * degree, 0.05 * degree);
  EXPECT_NEAR(corner_angle_limit(6), 45.0 * degree, 1e-12);
  EXPECT_NEAR(corner_angle_limit(8), 35.3 * degree, 0.05 * degree);
  EXPECT_NEAR(corner_angle_limit(20), 20.9 * degree, 0.05 * degree);
}

}  // namespace
}  // namespace puadem
