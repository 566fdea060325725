#include "puadem/geometry/throat_entry.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "puadem/geometry/corner_meniscus.hpp"

using namespace puadem;

namespace {

constexpr double degree = std::numbers::pi / 180.0;

/// Equal spheres of radius 1 in an equilateral triangle of the given side.
std::array<Site, 3> triple_of(double side) {
  return {Site::grain({0, 0, 0}, 1), Site::grain({side, 0, 0}, 1), Site::grain({side / 2, side * std::sqrt(3.0) / 2, 0}, 1)};
}

/// Three mutually touching spheres.
std::array<Site, 3> touching(double a, double b, double c) {
  const double x = ((a + b) * (a + b) + (a + c) * (a + c) - (b + c) * (b + c)) / (2 * (a + b));
  return {Site::grain({0, 0, 0}, a), Site::grain({a + b, 0, 0}, b), Site::grain({x, std::sqrt((a + c) * (a + c) - x * x), 0}, c)};
}

double entry_pressure(const ThroatSection& s, double theta = 0.0) { return 1.0 / MayerStowePrincen{}.entry(s, theta).radius; }

}  // namespace

// Solutions of the Mayer-Stowe-Princen balance for three equal spheres, found independently of this code.
TEST(MayerStowePrincen, EqualSpheresApart) {
  struct Row {
    double side, inscribed, haines, radius, pressure, void_area, wetting_share;
  };
  for (const Row& row : {Row{2.00, 0.15470, 12.9282, 0.0883408, 11.3198, 0.16125, 0.2741},
                         Row{2.02, 0.16625, 12.0303, 0.09504, 10.5216, 0.19607, 0.3064},
                         Row{2.05, 0.18357, 10.8951, 0.10513, 9.5124, 0.24894, 0.3278},
                         Row{2.10, 0.21244, 9.4146, 0.12201, 8.1961, 0.33879, 0.3278},
                         Row{2.20, 0.27017, 7.4027, 0.15609, 6.4064, 0.52499, 0.2736},
                         Row{2.40, 0.38564, 5.1862, 0.22569, 4.4308, 0.92336, 0.0809}}) {
    const ThroatSection s = throat_section(triple_of(row.side));
    EXPECT_NEAR(s.inscribed_radius, row.inscribed, 0.6e-5) << row.side;
    EXPECT_NEAR(1.0 / Haines{}.entry(s, 0.0).radius, row.haines, 0.6e-4) << row.side;
    EXPECT_NEAR(s.void_area, row.void_area, 0.6e-5) << row.side;
    const Entry entry = MayerStowePrincen{}.entry(s, 0.0);
    EXPECT_EQ(entry.kind, EntryKind::meniscus);
    EXPECT_NEAR(entry.radius, row.radius, row.side == 2.0 ? 0.6e-7 : 0.6e-5) << row.side;
    EXPECT_NEAR(1.0 / entry.radius, row.pressure, 0.6e-4) << row.side;
    EXPECT_NEAR(section_menisci(s, entry.radius, 0.0).wetting_area / s.void_area, row.wetting_share, 0.6e-4) << row.side;
  }
}

TEST(MayerStowePrincen, WideEdgesAndNoSolution) {
  const Entry wide = MayerStowePrincen{}.entry(throat_section(triple_of(2.5)), 0.0);
  EXPECT_EQ(wide.kind, EntryKind::wide_edge);
  EXPECT_NEAR(wide.radius, 0.26141, 0.6e-5);
  const Entry none = MayerStowePrincen{}.entry(throat_section(triple_of(2.6)), 0.0);
  EXPECT_EQ(none.kind, EntryKind::half_gap);
  EXPECT_NEAR(none.radius, 0.3, 1e-14);
}

TEST(MayerStowePrincen, ContactAngle) {
  const ThroatSection s = throat_section(triple_of(2.0));
  const std::pair<double, double> expected[] = {{10, 11.2206}, {20, 10.8975}, {30, 10.3193},
                                                {40, 9.4645},  {45, 8.9287},  {50, 8.3188}};
  for (const auto& [angle, pressure] : expected) EXPECT_NEAR(entry_pressure(s, angle * degree), pressure, 0.6e-4) << angle;
}

TEST(MayerStowePrincen, UnequalTouchingSpheres) {
  const ThroatSection s = throat_section(touching(1.0, 0.7, 0.5));
  // Descartes' circle theorem for the inscribed circle.
  const double k = 1 / 1.0 + 1 / 0.7 + 1 / 0.5 + 2 * std::sqrt(1 / 0.7 + 1 / 0.5 + 1 / (0.7 * 0.5));
  EXPECT_NEAR(s.inscribed_radius, 1 / k, 1e-14);
  EXPECT_NEAR(s.inscribed_radius, 0.105900, 0.6e-6);
  EXPECT_NEAR(MayerStowePrincen{}.entry(s, 0.0).radius, 0.0605268, 0.6e-7);
  EXPECT_NEAR(entry_pressure(s), 16.5216, 0.6e-4);
}

TEST(MayerStowePrincen, SquareWindowOfFourSpheres) {
  const std::array<Site, 4> window{Site::grain({0, 0, 0}, 1), Site::grain({2, 0, 0}, 1), Site::grain({2, 2, 0}, 1),
                                   Site::grain({0, 2, 0}, 1)};
  const ThroatSection s = grain_window_section(window);
  EXPECT_NEAR(s.inscribed_radius, std::sqrt(2.0) - 1.0, 1e-14);
  EXPECT_NEAR(MayerStowePrincen{}.entry(s, 0.0).radius, 0.222596, 0.6e-6);
  EXPECT_NEAR(entry_pressure(s), 4.49244, 0.6e-5);
  EXPECT_NEAR(1.0 / Haines{}.entry(s, 0.0).radius, 4.82843, 0.6e-5);
  // Cut along its diagonal, half the window has no solution and keeps half the gap.
  EXPECT_NEAR(entry_pressure(throat_section({window[0], window[1], window[2]})), 2.41421, 0.6e-5);
}

// Straight tubes with flat walls have closed forms: Mayer and Stowe 1965; Princen 1969.
TEST(MayerStowePrincen, Tubes) {
  const auto rectangle = [](double d, double h) {
    const std::array<std::array<double, 2>, 4> corners{{{0, 0}, {d, 0}, {d, h}, {0, h}}};
    return polygon_section(corners);
  };
  const auto closed_form = [](double d, double h) {
    return (4 - std::numbers::pi) / ((d + h) - std::sqrt((d + h) * (d + h) - (4 - std::numbers::pi) * d * h));
  };
  for (const double h : {1.0, 2.0, 1000.0})
    EXPECT_NEAR(entry_pressure(rectangle(1, h)), closed_form(1, h), 1e-9 * closed_form(1, h)) << h;
  EXPECT_NEAR(entry_pressure(rectangle(1, 1)), 2.0 * (1.0 + std::sqrt(std::numbers::pi) / 2.0), 1e-12);
  EXPECT_NEAR(entry_pressure(rectangle(1, 1)), 3.772454, 0.6e-6);
  EXPECT_NEAR(entry_pressure(rectangle(1, 2)), 2.849369, 0.6e-6);
  EXPECT_NEAR(entry_pressure(rectangle(1, 1000)), 2.00157, 0.6e-5);
  const std::array<std::array<double, 2>, 3> triangle{{{0, 0}, {1, 0}, {0.5, std::sqrt(3.0) / 2}}};
  EXPECT_NEAR(entry_pressure(polygon_section(triangle)), 6.157649, 0.6e-6);
}

TEST(MayerStowePrincen, WallIsAGrainOfInfiniteRadius) {
  // The facet of two touching spheres on a wall against a very large third sphere in its place. The
  // facet of the large sphere is a long triangle, so only what happens at the crevices must agree.
  const std::array<Site, 3> wall{Site::grain({-1, 1, 0}, 1), Site::grain({1, 1, 0}, 1), Site::wall({0, -1, 0}, 0)};
  for (const double theta : {0.0, 20 * degree}) {
    double last = 1.0;
    for (const double big : {1e2, 1e3, 1e4}) {
      const std::array<Site, 3> sphere{Site::grain({-1, std::sqrt((1 + big) * (1 + big) - 1) - big, 0}, 1),
                                       Site::grain({1, std::sqrt((1 + big) * (1 + big) - 1) - big, 0}, 1),
                                       Site::grain({0, -big, 0}, big)};
      const double difference =
          std::abs(entry_pressure(throat_section(sphere), theta) / entry_pressure(throat_section(wall), theta) - 1);
      EXPECT_LT(difference, 3.0 / big);
      EXPECT_LT(difference, last);
      last = difference;
    }
  }
}

TEST(MayerStowePrincen, CornerOfTwoWalls) {
  // One sphere in a square corner is a quarter of the square tube around a sphere: by symmetry the whole
  // cross-section of a sphere between four walls has the same balance.
  const ThroatSection s = throat_section({Site::grain({1, 1, 0}, 1), Site::wall({-1, 0, 0}, 0), Site::wall({0, -1, 0}, 0)});
  EXPECT_NEAR(s.void_area, 1 - std::numbers::pi / 4, 1e-14);
  EXPECT_NEAR(s.inscribed_radius, (std::sqrt(2.0) - 1) / (std::sqrt(2.0) + 1), 1e-14);
  const double r = MayerStowePrincen{}.entry(s, 0.0).radius;
  // Independent balance: the square corner holds (1 - pi/4) r^2 behind an arc of pi/2; each crevice of
  // sphere and wall is half of the crevice between the sphere and its mirror image.
  const double along = 2 * std::sqrt(r), at_sphere = std::atan2(along, 1 - r);
  const double crevice = 0.5 * (1 + r) * along - 0.5 * at_sphere - 0.5 * r * r * (std::numbers::pi - at_sphere);
  const double area = s.void_area - (1 - std::numbers::pi / 4) * r * r - 2 * crevice;
  const double menisci = r * std::numbers::pi / 2 + 2 * r * (std::numbers::pi - at_sphere);
  const double dry = (std::numbers::pi / 2 - 2 * at_sphere) + 2 * (1 - along - r);
  EXPECT_NEAR((menisci + dry) * r, area, 1e-13);
}

// At entry the menisci are in equilibrium: virtual changes of their radius do no work.
TEST(CornerMeniscus, IsInEquilibriumAtEveryContactAngle) {
  for (const double theta : {0.0, 15 * degree, 35 * degree}) {
    for (const auto& sites :
         {triple_of(2.1), touching(1.0, 0.8, 0.5),
          std::array<Site, 3>{Site::grain({-1, 1.05, 0}, 1), Site::grain({1.1, 1, 0}, 1), Site::wall({0, -1, 0}, 0)}}) {
      const ThroatSection s = throat_section(sites);
      const double r0 = 0.4 * s.inscribed_radius + 0.06, h = 1e-5 * r0;
      const auto work = [&](double r) {
        const SectionMenisci m = section_menisci(s, r, theta);
        return m.meniscus_length + m.dry_length * std::cos(theta) - (s.void_area - m.wetting_area) / r0;
      };
      EXPECT_NEAR((work(r0 + h) - work(r0 - h)) / (2 * h), 0.0, 1e-6) << theta;
    }
  }
}

TEST(ThroatEntry, ScalesWithTheUnitOfLength) {
  const auto scaled = [](double s) {
    return throat_section(
        {Site::grain({0, 0, 0}, s), Site::grain({2.1 * s, 0, 0}, 0.8 * s), Site::grain({0.9 * s, 2.0 * s, 0.3 * s}, 1.1 * s)});
  };
  EXPECT_NEAR(entry_pressure(scaled(1e-6)) * 1e-6, entry_pressure(scaled(1.0)), 1e-12 * entry_pressure(scaled(1.0)));
  EXPECT_NEAR(snap_off_radius(scaled(1e-6), 0.3) / 1e-6, snap_off_radius(scaled(1.0), 0.3), 1e-10);
}

TEST(ThroatEntry, ClosedThroatIsNeverEntered) {
  const ThroatSection s = throat_section({Site::grain({0, 0, 0}, 1), Site::grain({1, 0, 0}, 1), Site::grain({0.5, 0.8, 0}, 1)});
  EXPECT_EQ(MayerStowePrincen{}.entry(s, 0.0).kind, EntryKind::closed);
  EXPECT_EQ(MayerStowePrincen{}.entry(s, 0.0).radius, 0.0);
  EXPECT_EQ(Haines{}.entry(s, 0.0).radius, 0.0);
}

TEST(SnapOff, TouchingTripleAndTubes) {
  const ThroatSection s = throat_section(triple_of(2.0));
  EXPECT_NEAR(1.0 / snap_off_radius(s, 0.0), 6.4641, 0.6e-4);
  EXPECT_NEAR(snap_off_radius(s, 1e-7), snap_off_radius(s, 0.0), 1e-6);  // no jump at perfect wetting
  // A square tube closes where menisci of neighbouring corners meet half-way along a side:
  // r (cos theta - sin theta) = half the side.
  const std::array<std::array<double, 2>, 4> corners{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
  const double theta = 0.3;
  EXPECT_NEAR(snap_off_radius(polygon_section(corners), theta), 0.5 / (std::cos(theta) - std::sin(theta)), 1e-12);
  EXPECT_TRUE(std::isinf(snap_off_radius(polygon_section(corners), 0.8)));  // corners hold nothing beyond 45 degrees
}

TEST(SnapOff, NeverAboveEntry) {
  for (const double side : {2.0, 2.05, 2.2, 2.4, 2.6, 3.0}) {
    const ThroatSection s = throat_section(triple_of(side));
    EXPECT_GE(snap_off_radius(s, 0.0), MayerStowePrincen{}.entry(s, 0.0).radius) << side;
  }
}
