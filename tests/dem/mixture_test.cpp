// Grains of several materials, and contacts of pairs with constants of their own.

#include "puadem/dem/mixture.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "puadem/base/error.hpp"
#include "puadem/dem/packing.hpp"

namespace puadem {
namespace {

using ::testing::HasSubstr;

std::vector<double> sizes(int count) {
  return grain_radii({Grading::By::mass, {{0.5e-3, 0.5e-3, 0.3}, {0.6e-3, 2e-3, 0.7}}}, count, 3);
}

double volume(double r) { return r * r * r; }

/// Share by volume of material m among grains of radii between two bounds.
double share_of(int m, const std::vector<int>& material, const std::vector<double>& radius, double low, double high) {
  double part = 0.0, total = 0.0;
  for (std::size_t k = 0; k < radius.size(); ++k) {
    if (radius[k] < low || radius[k] > high) continue;
    total += volume(radius[k]);
    if (material[k] == m) part += volume(radius[k]);
  }
  return part / total;
}

TEST(Mixture, HasItsSharesByVolumeAtEverySize) {
  const auto radius = sizes(3000);
  const std::vector<MaterialShare> shares{{2, 0.5}, {0, 0.3}, {1, 0.2}};
  const auto material = assign_materials(radius, shares);
  for (const MaterialShare& s : shares) {
    EXPECT_NEAR(share_of(s.material, material, radius, 0, 1), s.fraction, 1e-3);
    for (const auto& [low, high] : {std::pair{0.24e-3, 0.26e-3}, std::pair{0.3e-3, 0.4e-3}, std::pair{0.7e-3, 1e-3}})
      EXPECT_NEAR(share_of(s.material, material, radius, low, high), s.fraction, 0.05) << low;
  }
  EXPECT_EQ(material, assign_materials(radius, shares));
}

TEST(Mixture, OfEqualGrainsIsCountedOut) {
  const auto material = assign_materials(std::vector<double>(10, 1e-3), std::vector<MaterialShare>{{0, 0.7}, {1, 0.3}});
  EXPECT_EQ(std::count(material.begin(), material.end(), 0), 7);
}

TEST(Mixture, SharesThatMakeNoSenseAreNamed) {
  const auto message = [](std::vector<MaterialShare> shares) -> std::string {
    try {
      assign_materials(std::vector<double>(10, 1e-3), shares);
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  };
  EXPECT_THAT(message({}), HasSubstr("no material"));
  EXPECT_THAT(message({{0, 0.7}, {1, 0.2}}), HasSubstr("add to 0.9"));
  EXPECT_THAT(message({{0, 1.7}, {1, -0.7}}), HasSubstr("fraction 1.7"));
}

std::vector<Material> glass_and_rubber() {
  Material glass, rubber;
  rubber.name = "rubber";
  rubber.density = 1100;
  rubber.youngs_modulus = 20e6;
  rubber.friction_angle = 35 * std::numbers::pi / 180;
  return {glass, rubber};
}

TEST(Mixture, PacksWithTheMassOfItsMaterials) {
  PackingSource source;
  source.grading = {Grading::By::mass, {{1e-3, 2e-3, 1.0}}};
  source.count = 300;
  source.periodic = {true, true, true};
  source.materials = {{0, 0.6}, {1, 0.4}};
  CompactionOptions options;
  options.friction_angle = 0.1;
  const Packing packing = make_packing(source, glass_and_rubber(), {}, options);
  const Particles& p = packing.particles;
  double mass = 0.0, solid = 0.0;
  for (int k = 0; k < p.size(); ++k) {
    mass += p.mass[to_size(k)];
    solid += 4.0 / 3.0 * std::numbers::pi * volume(p.radius[to_size(k)]);
  }
  EXPECT_NEAR(mass / solid, 0.6 * 2650 + 0.4 * 1100, 5);
  EXPECT_LT(packing.report.unbalanced, 1e-3);
  EXPECT_NEAR(packing.report.mean_stress, 10e3, 100);
  for (std::size_t pair = 0; pair < 4; ++pair)
    EXPECT_EQ(packing.system->pairs.grains[pair].friction, material_pairs(glass_and_rubber(), {}).grains[pair].friction);
}

TEST(MaterialPairs, OfTheirOwnReplaceTheSmallerAngleAndTheRestitution) {
  ContactOptions options;
  options.restitution = 0.9;
  options.pairs = {{{"rubber", "glass"}, 0.2, {}}, {{"rubber", "rubber"}, {}, 0.5}};
  const MaterialPairs own = material_pairs(glass_and_rubber(), options), plain = [&] {
    ContactOptions without = options;
    without.pairs.clear();
    return material_pairs(glass_and_rubber(), without);
  }();
  const double beta = std::log(2.0) / std::sqrt(std::numbers::pi * std::numbers::pi + std::log(2.0) * std::log(2.0));
  EXPECT_DOUBLE_EQ(own.grains[1].friction, std::tan(0.2));
  EXPECT_DOUBLE_EQ(own.grains[2].friction, std::tan(0.2));
  EXPECT_EQ(own.grains[1].damping, plain.grains[1].damping);
  EXPECT_DOUBLE_EQ(own.grains[3].damping, beta);
  EXPECT_EQ(own.grains[3].friction, plain.grains[3].friction);
  EXPECT_EQ(own.grains[0].friction, plain.grains[0].friction);
}

TEST(MaterialPairs, OfTheirOwnThatMakeNoSenseAreNamed) {
  const auto message = [](const PairOverride& pair) -> std::string {
    ContactOptions options;
    options.pairs = {pair};
    try {
      material_pairs(glass_and_rubber(), options);
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  };
  EXPECT_THAT(message({{"glass", "steel"}, 0.1, {}}), HasSubstr("no material 'steel'; defined: glass, rubber"));
  EXPECT_THAT(message({{"glass", "rubber"}, 2.0, {}}), HasSubstr("friction_angle 2 rad"));
  EXPECT_THAT(message({{"glass", "rubber"}, {}, 1.5}), HasSubstr("= 1.5 must lie in (0, 1]"));
}

}  // namespace
}  // namespace puadem
