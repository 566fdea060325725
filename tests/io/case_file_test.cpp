#include "puadem/io/case_file.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <numbers>
#include <set>

#include "puadem/base/error.hpp"
#include "support/temporary_folder.hpp"

namespace puadem {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

const std::string beads = R"(
title = "beads \u00b5 \"quoted\""
seed = 7
[domain]
shape = [1, 1, 2]
[grains]
count = 5000
material = "glass"
grading = { by = "number", classes = [
  { diameter = "0.60 mm", fraction = 0.35 },
  { diameter = ["1.0 mm", "1.4 mm"], fraction = 0.65 } ] }
[materials.glass]
density = "2.5 g/cm3"
youngs_modulus = "150 MPa"
poisson_ratio = 0.25
friction_angle = "25 deg"
[materials."heavy metal"]
density = "11 t/m3"
[contact]
law = "linear-spring"
stiffness_ratio = 0.5
wall_friction = 0.1
[fluids]
surface_tension = "50 mN/m"
contact_angle = "20 deg"
wetting = { viscosity = "2 mPa s", density = "900 kg/m3" }
nonwetting = { viscosity = "18 uPa s" }
[pores]
entry_pressure = "haines"
merge_ratio = "none"
merge_limit = 9
pore_shape = "vertices"
throat_section = "window"
no_slip = ["top", "y-"]
conductance_limits = [1e-3, 50]
[[stage]]
kind = "compact"
stress = "5 kPa"
porosity = 0.36
porosity_region = "box"
unbalanced = 1e-4
damping = 0.2
[[stage]]
kind = "retention"
grains = "fixed"
air = "y+"
water = "front"
path = ["400 Pa", "1.3 kPa", 0]
step = "50 Pa"
snap_off = true
trap_wetting = false
trap_nonwetting = false
corner_films = true
corner_water = false
wall_throats = false
body_entry = false
side_pores = false
trap_check = "step"
retention_law = "polyhedron"
[output]
fields = false
fields_every = 4
[[overlay]]
label = "other"
folder = "../other/run"
[expected]
porosity_core = [0.338, 0.342]
"pc_star_half_drainage-1" = { value = 5, tolerance = 0.5 }
trapped = { min = 0.01 }
)";

// A field added to Case, or to a struct in it, stops these from compiling: compare it then.
bool same(const GradingClass& a, const GradingClass& b) {
  const auto& [low, high, fraction] = a;
  return low == b.diameter_min && high == b.diameter_max && fraction == b.fraction;
}
template <class T>
bool same(const std::vector<T>& a, const std::vector<T>& b);
template <class T>
bool same(const std::optional<T>& a, const std::optional<T>& b);
bool same(const SwellingLaw& a, const SwellingLaw& b) {
  const auto& [diffusivity, largest_ratio, largest_stress] = a;
  return diffusivity == b.diffusivity && largest_ratio == b.largest_ratio && largest_stress == b.largest_stress;
}
bool same(const Material& a, const Material& b) {
  const auto& [name, density, youngs_modulus, poisson_ratio, friction_angle, swelling] = a;
  return name == b.name && density == b.density && youngs_modulus == b.youngs_modulus && poisson_ratio == b.poisson_ratio &&
         friction_angle == b.friction_angle && same(swelling, b.swelling);
}
bool same(const PairOverride& a, const PairOverride& b) {
  const auto& [materials, friction_angle, restitution] = a;
  return materials == b.materials && friction_angle == b.friction_angle && restitution == b.restitution;
}
bool same(const BridgeCase& a, const BridgeCase& b) {
  const auto& [formation, split, exchange, by_pores] = static_cast<const BridgeRules&>(a);
  return formation == b.formation && split == b.split && exchange == b.exchange && by_pores == b.by_pores &&
         a.control == b.control && a.capillary_pressure == b.capillary_pressure && a.water_content == b.water_content &&
         a.saturation == b.saturation && a.volume == b.volume && a.law == b.law;
}
bool same(const GrainOptions::Added& a, const GrainOptions::Added& b) {
  const auto& [diameter, material, count, at] = a;
  return diameter == b.diameter && material == b.material && count == b.count && at == b.at;
}
bool same(const GrainOptions::Share& a, const GrainOptions::Share& b) {
  const auto& [name, fraction] = a;
  return name == b.name && fraction == b.fraction;
}
bool same(const ContactOptions& a, const ContactOptions& b) {
  const auto& [law, stiffness_ratio, wall_friction, wall_elasticity, restitution, rolling_stiffness, rolling_friction,
               twisting_stiffness, twisting_friction, pairs] = a;
  return law == b.law && stiffness_ratio == b.stiffness_ratio && wall_friction == b.wall_friction &&
         wall_elasticity == b.wall_elasticity && restitution == b.restitution && rolling_stiffness == b.rolling_stiffness &&
         rolling_friction == b.rolling_friction && twisting_stiffness == b.twisting_stiffness &&
         twisting_friction == b.twisting_friction && same(pairs, b.pairs);
}
bool same(const Fluid& a, const Fluid& b) {
  const auto& [viscosity, density] = a;
  return viscosity == b.viscosity && density == b.density;
}
bool same(const Fluids& a, const Fluids& b) {
  const auto& [surface_tension, contact_angle, wetting, nonwetting] = a;
  return surface_tension == b.surface_tension && contact_angle == b.contact_angle && same(wetting, b.wetting) &&
         same(nonwetting, b.nonwetting);
}
bool same(const NetworkOptions& a, const NetworkOptions& b) {
  const auto& [entry_law, contact_angle, merge_ratio, merge_limit, no_slip, merge_criterion, pore_shape, throat_section] = a;
  return entry_law.index() == b.entry_law.index() && contact_angle == b.contact_angle && merge_ratio == b.merge_ratio &&
         merge_limit == b.merge_limit && no_slip == b.no_slip && merge_criterion == b.merge_criterion &&
         pore_shape == b.pore_shape && throat_section == b.throat_section;
}
bool same(const PoreOptions& a, const PoreOptions& b) {
  const auto &x = a.conductance_limits, &y = b.conductance_limits;
  return same(static_cast<const NetworkOptions&>(a), b) && x.has_value() == y.has_value() &&
         (!x || (x->low == y->low && x->high == y->high));
}
bool same(const CompactStage& a, const CompactStage& b) {
  const auto& [stress, porosity, friction_angle, region, unbalanced, damping] = a;
  return stress == b.stress && porosity == b.porosity && friction_angle == b.friction_angle && region == b.porosity_region &&
         unbalanced == b.unbalanced && damping == b.damping;
}
bool same(const InvasionOptions& a, const InvasionOptions& b) {
  const auto& [air, water, snap_off, trap_wetting, trap_nonwetting, films, corner_water, wall_throats, body_entry, side_pores,
               trap_check, cooperative, seed, law] = a;
  return air == b.nonwetting_face && water == b.wetting_face && snap_off == b.snap_off && trap_wetting == b.trap_wetting &&
         trap_nonwetting == b.trap_nonwetting && films == b.corner_films && corner_water == b.corner_water &&
         wall_throats == b.wall_throats && body_entry == b.body_entry && side_pores == b.side_pores &&
         trap_check == b.trap_check && cooperative == b.cooperative_filling && seed == b.seed &&
         law.index() == b.retention_law.index();
}
bool same(const PermeabilityStage& a, const PermeabilityStage& b) {
  const auto& [inlet, pressure_drop, merged, layers] = a;
  return inlet == b.inlet && pressure_drop == b.pressure_drop && merged == b.merged && layers == b.layers;
}
bool same(const RetentionStage& a, const RetentionStage& b) {
  const auto& [path, step, invasion] = a;
  return path == b.path && step == b.step && same(invasion, b.invasion);
}
bool same(const TwoPhaseSteps& a, const TwoPhaseSteps& b) {
  const auto& [front_change, growth, longest, newton_limit, tolerance, step_limit] = a;
  return front_change == b.front_change && growth == b.growth && longest == b.longest && newton_limit == b.newton_limit &&
         tolerance == b.tolerance && step_limit == b.step_limit;
}
bool same(const TwoPhaseOptions& a, const TwoPhaseOptions& b) {
  const auto& [scheme, gas, reference_pressure, snap_off, cooperative, seed, films, touching_first, wall_throats, gravity, law,
               steps, solver] = a;
  return scheme == b.scheme && gas == b.gas && reference_pressure == b.reference_pressure && snap_off == b.snap_off &&
         cooperative == b.cooperative_filling && seed == b.seed && films == b.corner_films &&
         touching_first == b.touching_first && wall_throats == b.wall_throats && gravity == b.gravity &&
         law.index() == b.retention_law.index() && same(steps, b.steps) && solver.tolerance == b.solver.tolerance;
}
bool same(const TwoPhaseStage& a, const TwoPhaseStage& b) {
  const auto& [air, disc_radius, water, initial_air_fraction, air_pressure, path, water_pressure, withdrawal, capillary_number,
               step, hold, water_times, duration, until_saturation, until_breakthrough, record_jump, options] = a;
  return air == b.air && disc_radius == b.disc_radius && water == b.water && initial_air_fraction == b.initial_air_fraction &&
         air_pressure == b.air_pressure && path == b.path && water_pressure == b.water_pressure && withdrawal == b.withdrawal &&
         capillary_number == b.capillary_number && step == b.step && hold == b.hold && water_times == b.water_times &&
         duration == b.duration && until_saturation == b.until_saturation && until_breakthrough == b.until_breakthrough &&
         record_jump == b.record_jump && same(options, b.options);
}
bool same(const IsotropicStage& a, const IsotropicStage& b) {
  const auto& [stress, unbalanced, damping] = a;
  return stress == b.stress && unbalanced == b.unbalanced && damping == b.damping;
}
bool same(const OedometerStage& a, const OedometerStage& b) {
  const auto& [path, strain, strain_rate, damping] = a;
  return path == b.path && strain == b.strain && strain_rate == b.strain_rate && damping == b.damping;
}
bool same(const TriaxialStage& a, const TriaxialStage& b) {
  const auto& [stress, path, strain, strain_rate, damping] = a;
  return stress == b.stress && path == b.path && strain == b.strain && strain_rate == b.strain_rate && damping == b.damping;
}
bool same(const ShearStage& a, const ShearStage& b) {
  const auto& [axis, direction, normal_stress, strain, shear_rate, damping] = a;
  return axis == b.axis && direction == b.direction && normal_stress == b.normal_stress && strain == b.strain &&
         shear_rate == b.shear_rate && damping == b.damping;
}
bool same(const SettleStage& a, const SettleStage& b) {
  const auto& [time, unbalanced, damping] = a;
  return time == b.time && unbalanced == b.unbalanced && damping == b.damping;
}
bool same(const StrainStage& a, const StrainStage& b) {
  const auto& [stress, strain_rate, time, damping] = a;
  return stress == b.stress && strain_rate == b.strain_rate && time == b.time && damping == b.damping;
}
bool same(const Stage& a, const Stage& b) {
  if (a.index() != b.index()) return false;
  return std::visit([&](const auto& x) { return same(x, std::get<std::decay_t<decltype(x)>>(b)); }, a);
}
bool same(const GradingTable& a, const GradingTable& b) {
  const auto& [diameter, passing, interpolation] = a;
  return diameter == b.diameter && passing == b.passing && interpolation == b.interpolation;
}
bool same(const LogNormalGrading& a, const LogNormalGrading& b) {
  const auto& [median, deviation, smallest, largest] = a;
  return median == b.median && deviation == b.deviation && smallest == b.smallest && largest == b.largest;
}
bool same(const Overlay& a, const Overlay& b) {
  const auto& [label, folder] = a;
  return label == b.label && folder == b.folder;
}
template <class T>
bool same(const std::vector<T>& a, const std::vector<T>& b) {
  return std::ranges::equal(a, b, [](const T& x, const T& y) { return same(x, y); });
}
template <class T>
bool same(const std::optional<T>& a, const std::optional<T>& b) {
  return a.has_value() == b.has_value() && (!a || same(*a, *b));
}
bool same(const Case& a, const Case& b) {
  const auto& [title, seed, domain, grains, network_file, materials, contact, motion, bridges, fluids, pores, stages, output,
               overlays, expected] = a;
  const auto& [size, shape, periodic] = domain;
  const auto& [file, count, grading, material, mixture, added, cloud, clump_size] = grains;
  const auto& [by, classes, table, lognormal] = grading;
  const auto& [fields, fields_every, fields_count, history_rows, fields_at, checkpoints, checkpoint_every] = output;
  const auto& [gravity, safety] = motion;
  return title == b.title && seed == b.seed && size == b.domain.size && shape == b.domain.shape &&
         periodic == b.domain.periodic && file == b.grains.file && count == b.grains.count && by == b.grains.grading.by &&
         same(classes, b.grains.grading.classes) && same(table, b.grains.grading.table) &&
         same(lognormal, b.grains.grading.lognormal) && material == b.grains.material && same(mixture, b.grains.materials) &&
         network_file == b.network_file && cloud == b.grains.cloud && clump_size == b.grains.clump_size &&
         same(materials, b.materials) && same(added, b.grains.added) && same(bridges, b.bridges) && same(contact, b.contact) &&
         same(fluids, b.fluids) && same(pores, b.pores) && same(stages, b.stages) && fields == b.output.fields &&
         fields_every == b.output.fields_every && fields_count == b.output.fields_count &&
         history_rows == b.output.history_rows && gravity == b.motion.gravity &&
         fields_at.saturation == b.output.fields_at.saturation && checkpoints == b.output.checkpoints &&
         checkpoint_every == b.output.checkpoint_every && safety == b.motion.safety && same(overlays, b.overlays) &&
         std::ranges::equal(expected, b.expected, [](const auto& x, const auto& y) {
           return x.first == y.first && x.second.low == y.second.low && x.second.high == y.second.high;
         });
}

Case read(const std::string& text, std::vector<std::string> overrides = {}) {
  return parse_case(text, "case.toml", "/study", overrides).c;
}

TEST(CaseFile, FillsEveryField) {
  const Case c = read(beads, {"contact.wall_elasticity=rigid", "contact.restitution=0.8", "contact.rolling_friction=0.2"});
  EXPECT_EQ(c.title, "beads \xC2\xB5 \"quoted\"");
  EXPECT_EQ(c.seed, 7U);
  EXPECT_EQ(c.domain.shape, (Vec3{1, 1, 2}));
  EXPECT_FALSE(c.domain.size);
  EXPECT_EQ(c.grains.count, 5000);
  EXPECT_EQ(c.grains.grading.by, Grading::By::number);
  ASSERT_EQ(c.grains.grading.classes.size(), 2U);
  EXPECT_TRUE(same(c.grains.grading.classes[0], {0.6e-3, 0.6e-3, 0.35}));
  EXPECT_TRUE(same(c.grains.grading.classes[1], {1.0e-3, 1.4e-3, 0.65}));
  ASSERT_EQ(c.materials.size(), 2U);
  EXPECT_TRUE(same(c.materials[0], {"glass", 2500, 150e6, 0.25, 25 * (std::numbers::pi / 180)}));
  EXPECT_EQ(c.materials[1].name, "heavy metal");
  EXPECT_EQ(c.materials[1].density, 11000);
  EXPECT_EQ(c.materials[1].youngs_modulus, Material{}.youngs_modulus);
  EXPECT_EQ(c.contact.law, ContactOptions::Law::linear_spring);
  EXPECT_EQ(c.contact.stiffness_ratio, 0.5);
  EXPECT_EQ(c.contact.wall_friction, 0.1);
  EXPECT_EQ(c.contact.wall_elasticity, ContactOptions::WallElasticity::rigid);
  EXPECT_EQ(c.contact.restitution, 0.8);
  EXPECT_EQ(c.contact.rolling_friction, 0.2);
  EXPECT_EQ(c.fluids.surface_tension, 0.05);
  EXPECT_EQ(c.fluids.contact_angle, 20 * (std::numbers::pi / 180));
  EXPECT_TRUE(same(c.fluids.wetting, {2e-3, 900}));
  EXPECT_TRUE(same(c.fluids.nonwetting, {18e-6, Fluids{}.nonwetting.density}));
  EXPECT_TRUE(std::holds_alternative<Haines>(c.pores.entry_law));
  EXPECT_EQ(c.pores.contact_angle, c.fluids.contact_angle);
  EXPECT_EQ(c.pores.merge_ratio, std::numeric_limits<double>::infinity());
  EXPECT_EQ(c.pores.merge_limit, 9);
  EXPECT_EQ(c.pores.merge_criterion, MergeCriterion::entry_ratio);
  EXPECT_EQ(c.pores.pore_shape, PoreShape::vertices);
  EXPECT_EQ(c.pores.throat_section, ThroatOutline::window);
  EXPECT_EQ(c.pores.no_slip, (std::array<bool, 6>{false, false, true, false, false, true}));
  ASSERT_TRUE(c.pores.conductance_limits);
  EXPECT_EQ(c.pores.conductance_limits->low, 1e-3);
  EXPECT_EQ(c.pores.conductance_limits->high, 50);
  ASSERT_EQ(c.stages.size(), 2U);
  EXPECT_TRUE(same(std::get<CompactStage>(c.stages[0]), {5e3, 0.36, {}, CompactStage::Region::box, 1e-4, 0.2}));
  const auto& retention = std::get<RetentionStage>(c.stages[1]);
  EXPECT_THAT(retention.path, ElementsAre(400, 1300, 0));
  EXPECT_EQ(retention.step, 50);
  EXPECT_TRUE(same(retention.invasion, {3, 2, true, false, false, true, false, false, false, false, TrapCheck::step, false, 1,
                                        PolyhedronRetention{}}));
  EXPECT_FALSE(c.output.fields);
  EXPECT_EQ(c.output.fields_every, 4);
  ASSERT_EQ(c.overlays.size(), 1U);
  EXPECT_EQ(c.overlays[0].folder, "/other/run");
  EXPECT_EQ(c.expected.at("porosity_core").low, 0.338);
  EXPECT_EQ(c.expected.at("porosity_core").high, 0.342);
  EXPECT_EQ(c.expected.at("pc_star_half_drainage-1").low, 4.5);
  EXPECT_EQ(c.expected.at("trapped").high, std::numeric_limits<double>::infinity());
}

TEST(CaseFile, LeavesOutWhatHasADefault) {
  const Case c = read(
      "[grains]\ncount = 10\ngrading.classes = [{ diameter = 1e-3 }]\n[materials.glass]\n[[stage]]\nkind = \"compact\"\nstress = "
      "100");
  Case expected;
  expected.grains.count = 10;
  expected.grains.grading.classes = {{1e-3, 1e-3, 1.0}};
  expected.materials.emplace_back();
  CompactStage compact;
  compact.stress = 100;
  expected.stages.emplace_back(compact);
  EXPECT_TRUE(same(c, expected));
}

TEST(CaseFile, TakesAGradingAsATableOrALogNormalCurve) {
  const std::string start = "[grains]\ncount = 10\n[materials.glass]\n[[stage]]\nkind = \"compact\"\nstress = 100\n";
  const Case table = read(start +
                          "[grains.grading]\ntable = { diameter = [\"0.1 mm\", \"0.2 mm\", 0.4e-3], passing = [0, \"35 %\", 1], "
                          "interpolation = \"linear\" }\n");
  EXPECT_TRUE(same(*table.grains.grading.table, {{0.1e-3, 0.2e-3, 0.4e-3}, {0, 0.35, 1}, GradingTable::Interpolation::linear}));
  EXPECT_TRUE(same(parse_case(resolved_case(table), "resolved", "/elsewhere").c, table));
  const Case curve = read(
      start + "[grains.grading]\nby = \"number\"\nlognormal = { median = \"0.4 mm\", deviation = 1.5, largest = \"1 mm\" }\n");
  EXPECT_TRUE(same(*curve.grains.grading.lognormal, {0.4e-3, 1.5, {}, 1e-3}));
  EXPECT_EQ(
      read(start + "[grains.grading]\nlognormal = { median = 1e-3, deviation = 2 }\n", {"grains.cloud=clumped"}).grains.cloud,
      PackingSource::Cloud::clumped);
  EXPECT_TRUE(same(parse_case(resolved_case(curve), "resolved", "/elsewhere").c, curve));
}

TEST(CaseFile, TakesAMixtureAndPairsOfItsMaterials) {
  const Case c = read(
      "[grains]\ncount = 10\ngrading.classes = [{ diameter = 1e-3 }]\nmaterials = [{ name = \"a\", fraction = 0.7 }, { name = "
      "\"b\", "
      "fraction = 0.3 }]\n[materials.a]\n[materials.b]\n[[contact.pair]]\nmaterials = [\"a\", \"b\"]\nfriction_angle = 0.2\n"
      "restitution = 0.5\n[[stage]]\nkind = \"compact\"\nstress = 100\n");
  ASSERT_EQ(c.grains.materials.size(), 2U);
  EXPECT_TRUE(same(c.grains.materials[1], {"b", 0.3}));
  EXPECT_EQ(grain_materials(c)[1].material, 1);
  EXPECT_TRUE(same(c.contact.pairs, {{{"a", "b"}, 0.2, 0.5}}));
  EXPECT_TRUE(same(parse_case(resolved_case(c), "resolved", "/elsewhere").c, c));
}

TEST(CaseFile, TakesAFrictionAngleInPlaceOfAPorosity) {
  std::string text = beads;
  text.replace(text.find("porosity = 0.36"), 15, "friction_angle = \"9 deg\"");
  const Case c = read(text);
  EXPECT_TRUE(
      same(std::get<CompactStage>(c.stages[0]), {5e3, {}, 9 * (std::numbers::pi / 180), CompactStage::Region::box, 1e-4, 0.2}));
  EXPECT_TRUE(same(parse_case(resolved_case(c), "resolved", "/elsewhere").c, c));
}

const std::string loading = R"(
[domain]
periodic = ["x", "y"]
[grains]
count = 100
grading.classes = [{ diameter = "1 mm" }]
[materials.glass]
[contact]
wall_friction = 0.3
[motion]
gravity = [0, 0, "-9.81 m/s2"]
safety = 0.25
[[stage]]
kind = "compact"
stress = "50 kPa"
[[stage]]
kind = "isotropic"
stress = "60 kPa"
unbalanced = 1e-4
damping = 0.1
[[stage]]
kind = "oedometer"
path = ["100 kPa", "20 kPa"]
strain_rate = "2 1/s"
[[stage]]
kind = "oedometer"
strain = -0.01
[[stage]]
kind = "triaxial"
stress = "100 kPa"
stress_path = "constant-mean"
strain = 0.1
strain_rate = "500 1/s"
damping = 0.3
[[stage]]
kind = "shear"
axis = "z"
direction = "y"
normal_stress = "70 kPa"
strain = 0.5
shear_rate = "1 1/s"
[[stage]]
kind = "settle"
time = "20 ms"
unbalanced = 0.01
[[stage]]
kind = "strain"
stress_x = "30 kPa"
strain_rate_z = "-2 1/s"
time = "1 ms"
[output]
fields_count = 3
history_rows = 50
)";

TEST(CaseFile, ReadsTheStagesThatLoadGrains) {
  const CaseFile file = parse_case(loading, "case.toml", "/study");
  const Case& c = file.c;
  EXPECT_EQ(c.motion.gravity, (Vec3{0, 0, -9.81}));
  EXPECT_EQ(c.motion.safety, 0.25);
  EXPECT_EQ(c.output.fields_count, 3);
  EXPECT_EQ(c.output.history_rows, 50);
  ASSERT_EQ(c.stages.size(), 8U);
  EXPECT_TRUE(same(c.stages[1], IsotropicStage{60e3, 1e-4, 0.1}));
  EXPECT_TRUE(same(c.stages[2], OedometerStage{{100e3, 20e3}, {}, 2.0, 0.2}));
  EXPECT_TRUE(same(c.stages[3], OedometerStage{{}, -0.01, {}, 0.2}));
  EXPECT_TRUE(same(c.stages[4], TriaxialStage{100e3, TriaxialStage::StressPath::constant_mean, 0.1, 500.0, 0.3}));
  EXPECT_TRUE(same(c.stages[5], ShearStage{2, 1, 70e3, 0.5, 1.0, 0.2}));
  EXPECT_TRUE(same(c.stages[6], SettleStage{0.02, 0.01, 0.2}));
  EXPECT_TRUE(same(c.stages[7], StrainStage{{30e3, {}, {}}, {0, 0, -2}, 1e-3, 0.2}));
  const Case back = parse_case(resolved_case(c), "resolved", "/elsewhere").c;
  EXPECT_TRUE(same(back, c));
  EXPECT_EQ(resolved_case(back), resolved_case(c));
}

TEST(ResolvedCase, ReadsBackToTheSameCase) {
  const Case c = read(beads, {"contact.wall_elasticity=rigid", "contact.restitution=0.8", "contact.rolling_friction=0.2"});
  const Case back = parse_case(resolved_case(c), "resolved", "/elsewhere").c;
  EXPECT_TRUE(same(back, c));
  EXPECT_EQ(resolved_case(back), resolved_case(c));
}

TEST(CaseFile, ReadsAPermeabilityStage) {
  const Case c = read(beads +
                      "[[stage]]\nkind = \"permeability\"\n[[stage]]\nkind = \"permeability\"\ninlet = \"x-\"\npressure_drop = "
                      "\"2 kPa\"\nmerged = true\nlayers = 7\n");
  EXPECT_TRUE(same(std::get<PermeabilityStage>(c.stages[2]), PermeabilityStage{}));
  EXPECT_TRUE(same(std::get<PermeabilityStage>(c.stages[3]), {0, 2000.0, true, 7}));
  EXPECT_TRUE(same(parse_case(resolved_case(c), "resolved", "/elsewhere").c, c));
}

TEST(ResolvedCase, OfAPackingFileReadsBack) {
  const TemporaryFolder folder;
  std::ofstream(folder.path / "p.csv") << "# box 1 1 1\n";
  const Case c = parse_case(
                     "[domain]\nperiodic = [\"y\", \"x\"]\n[grains]\nfile = \"p.csv\"\n[[stage]]\nkind = \"retention\"\npath = "
                     "[1, 1e3]\n[expected]\nx = { max = 3 }",
                     "case.toml", folder.path)
                     .c;
  EXPECT_EQ(c.grains.file, folder.path / "p.csv");
  EXPECT_EQ(c.domain.periodic, (std::array<bool, 3>{true, true, false}));
  EXPECT_TRUE(same(parse_case(resolved_case(c), "resolved", "/elsewhere").c, c));
}

TEST(ResolvedCase, OfOverlappingInspheresHasNoRatio) {
  std::string text = beads;
  text.replace(text.find("merge_ratio = \"none\""), 20, "merge_criterion = \"insphere-overlap\"");
  const Case c = read(text);
  EXPECT_EQ(c.pores.merge_criterion, MergeCriterion::insphere_overlap);
  EXPECT_TRUE(same(parse_case(resolved_case(c), "resolved", "/").c, c));
}

TEST(ResolvedCase, KeepsABoxOfGivenSize) {
  Case c = read(beads);
  c.domain.size = Vec3{0.01, 0.02 / 3, 1e-2 / 7};
  c.domain.shape = {1, 1, 1};
  EXPECT_TRUE(same(parse_case(resolved_case(c), "resolved", "/").c, c));
}

TEST(Overrides, ReplaceAddAndIndex) {
  const Case c = read(beads, {"grains.count=500", "stage.0.stress=7 kPa", "stage.1.path=[\"1 kPa\", 0.0]", "title=plain words",
                              "fluids.wetting.density=\"1000 kg/m3\"", "contact.law=hertz-mindlin", "domain.periodic=[\"x\"]",
                              "expected.x.min=3", "grains.grading.classes.0.diameter=0.5 mm"});
  EXPECT_EQ(c.grains.count, 500);
  EXPECT_EQ(std::get<CompactStage>(c.stages[0]).stress, 7e3);
  EXPECT_THAT(std::get<RetentionStage>(c.stages[1]).path, ElementsAre(1000, 0));
  EXPECT_EQ(c.title, "plain words");
  EXPECT_EQ(c.fluids.wetting.density, 1000);
  EXPECT_EQ(c.contact.law, ContactOptions::Law::hertz_mindlin);
  EXPECT_TRUE(c.domain.periodic[0]);
  EXPECT_EQ(c.expected.at("x").low, 3);
  EXPECT_EQ(c.grains.grading.classes[0].diameter_max, 0.5e-3);
}

TEST(CaseFile, WarnsOfWhatIsHardlyMeant) {
  const CaseFile file =
      parse_case(beads, "case.toml", "/study",
                 std::vector<std::string>{"fluids.surface_tension=72 N/m", "grains.grading.classes.0.diameter=0.35"});
  std::string warnings;
  for (const std::string& warning : file.warnings) warnings += warning + "\n";
  EXPECT_THAT(warnings, HasSubstr("fluids.surface_tension = 72 N/m is unusual"));
  EXPECT_THAT(warnings, HasSubstr("grains.grading.classes.0.diameter = 350 mm is unusual"));
  EXPECT_THAT(warnings, HasSubstr("no such folder: /other/run"));
}

TEST(Keys, DescribeWhatTheReaderAccepts) {
  std::set<std::string> names;
  for (const KeyDoc& doc : all_keys()) {
    EXPECT_TRUE(names.insert(doc.path).second) << doc.path;
    EXPECT_FALSE(doc.help.empty()) << doc.path;
    EXPECT_FALSE(doc.type.empty()) << doc.path;
  }
  // Every key that a full resolved case writes is documented.
  const std::string resolved = resolved_case(read(beads, {"contact.restitution=0.8"}));
  for (const char* key : {"domain.periodic", "grains.grading.classes[].diameter", "materials.NAME.friction_angle",
                          "stage[compact].stress", "stage[retention].retention_law", "contact.restitution",
                          "fluids.nonwetting.viscosity", "pores.no_slip", "pores.conductance_limits", "output.fields_every"}) {
    EXPECT_TRUE(names.contains(key)) << key;
    const std::string path = key;
    EXPECT_THAT(resolved, HasSubstr(fmt::format("\n{} = ", path.substr(path.rfind('.') + 1)))) << key;
  }
  EXPECT_THAT(keys_text("merge_ratio"), HasSubstr("pores.merge_ratio"));
  EXPECT_THAT(keys_text("merge_ratio"), HasSubstr("\"none\""));
  EXPECT_THAT(keys_markdown(), HasSubstr("## stage[retention]"));
  try {
    keys_text("strss");
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("did you mean \"stress\"?"));
  }
}

}  // namespace
}  // namespace puadem
