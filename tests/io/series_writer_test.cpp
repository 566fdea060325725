#include "puadem/io/series_writer.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <set>

#include "puadem/base/error.hpp"
#include "support/temporary_folder.hpp"
#include "synthetic_run.hpp"

namespace puadem {
namespace {

using ::testing::HasSubstr;

std::string message_of(const auto& call) {
  try {
    call();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(SeriesWriter, KeepsTheColumnsThatScriptsRelyOn) {
  EXPECT_EQ(retention_header, "step,branch,pc_Pa,pc_star,saturation,trapped_wetting,trapped_nonwetting\n");
  EXPECT_EQ(events_header, "event,kind,pc_Pa,pore,throat,units,wetting_volume_m3\n");
  EXPECT_EQ(distributions_header, "kind,bin_low,bin_high,pdf\n");
  EXPECT_EQ(event_line(3, {InvasionEventKind::snap_off, 512.5, 7, 9, 0, 0.0}), "3,snap_off,512.5,7,9,0,0\n");
}

TEST(SeriesWriter, HistoryNamesForcesOfWallsOnly) {
  const TemporaryFolder scratch;
  Domain box;
  box.periodic = {true, true, false};
  const std::string header = history_header(box);
  EXPECT_TRUE(header.starts_with("time_s,stage,step,time_step_s,strain_xx,strain_yy,strain_zz,strain_volumetric,porosity,"));
  EXPECT_THAT(header, HasSubstr(",sigma_zz_Pa,p_Pa,q_Pa,"));
  EXPECT_THAT(header, HasSubstr(",force_top_z_N,position_top_m,"));
  EXPECT_THAT(header, ::testing::Not(HasSubstr("force_left")));

  HistoryRow row;
  row.time = 0.25;
  row.stage = "shear-2";
  row.strain = {0.125, -0.5, 0.75};
  row.volumetric = 0.375;
  row.stress = {1.0, 2.0, 6.0};
  row.mean = 3.0;
  row.deviator = 4.5;
  row.porosity = 0.5;
  row.shear_strain = 0.0625;
  row.normal_stress = 6.0;
  row.shear_stress = 1.5;
  row.wall_force[5] = {1.5, 0.0, 6.0};
  row.energy.input = 7.0;
  const std::string line = history_line(row, box);
  EXPECT_EQ(std::ranges::count(line, ','), std::ranges::count(header, ','));
  EXPECT_THAT(line, HasSubstr(",1.5,0,6,"));
  std::ofstream(scratch.path / "history.csv") << header << line;
  const auto back = read_history(scratch.path / "history.csv");
  ASSERT_EQ(back.size(), 1U);
  EXPECT_EQ(back[0].stage, "shear-2");
  EXPECT_EQ(back[0].strain.z, 0.75);
  EXPECT_EQ(back[0].volumetric, 0.375);
  EXPECT_EQ(back[0].mean, 3.0);
  EXPECT_EQ(back[0].deviator, 4.5);
  EXPECT_EQ(back[0].stress.z, 6.0);
  EXPECT_EQ(back[0].shear_stress, 1.5);
  EXPECT_EQ(back[0].normal_stress, 6.0);

  // A measured curve has few columns.
  std::ofstream(scratch.path / "measured.csv") << "# source\nstrain_zz,p_Pa,q_Pa\n0.01,100,90\n";
  const auto measured = read_history(scratch.path / "measured.csv");
  ASSERT_EQ(measured.size(), 1U);
  EXPECT_EQ(measured[0].stress.z, 160.0);  // p + 2 q / 3
}

TEST(SeriesWriter, NamesEveryEventDifferently) {
  std::set<std::string_view> names;
  for (int kind = 0; kind <= static_cast<int>(InvasionEventKind::free_nonwetting); ++kind)
    names.insert(event_name(static_cast<InvasionEventKind>(kind)));
  EXPECT_EQ(names.size(), 8U);
  EXPECT_FALSE(names.contains("unknown"));
}

TEST(SeriesWriter, RetentionReadsBackToTheSameBits) {
  const TemporaryFolder scratch;
  const SyntheticRun run = make_synthetic_run(2);
  std::string csv(retention_header);
  for (const RetentionRow& row : run.state.retention) csv += retention_line(row);
  std::ofstream(scratch.path / "retention.csv") << csv;
  const std::vector<RetentionRow> read = read_retention(scratch.path / "retention.csv");
  ASSERT_EQ(read.size(), run.state.retention.size());
  for (std::size_t k = 0; k < read.size(); ++k) {
    const RetentionRow& row = run.state.retention[k];
    EXPECT_EQ(read[k].step, row.step);
    EXPECT_EQ(read[k].branch, row.branch);
    EXPECT_EQ(read[k].capillary_pressure, row.capillary_pressure);
    EXPECT_EQ(read[k].pc_star, row.pc_star);
    EXPECT_EQ(read[k].saturation, row.saturation);
    EXPECT_EQ(read[k].trapped_wetting, row.trapped_wetting);
    EXPECT_EQ(read[k].trapped_nonwetting, row.trapped_nonwetting);
  }
}

TEST(SeriesWriter, ReadsAMeasuredCurveWithFewColumnsAndComments) {
  const TemporaryFolder scratch;
  std::ofstream(scratch.path / "retention.csv") << "# source: a paper\nsaturation,pc_Pa\r\n0.9,500\r\n\n0.4,700\r\n";
  const std::vector<RetentionRow> read = read_retention(scratch.path / "retention.csv");
  ASSERT_EQ(read.size(), 2U);
  EXPECT_EQ(read[1].branch, "data");
  EXPECT_EQ(read[1].capillary_pressure, 700.0);
  EXPECT_EQ(read[1].saturation, 0.4);
}

TEST(SeriesWriter, SaysWhereACurveIsWrong) {
  const TemporaryFolder scratch;
  const auto file = scratch.path / "retention.csv";
  const auto read = [&] { (void)read_retention(file); };
  std::ofstream(file) << "saturation,pc_Pa\n0.9,5oo\n";
  EXPECT_THAT(message_of(read), HasSubstr("retention.csv:2: '5oo' in column 'pc_Pa' is not a number"));
  std::ofstream(file) << "saturation,pc_Pa\n0.9,500\n0.8\n";
  EXPECT_THAT(message_of(read), HasSubstr("retention.csv:3: 1 fields where the header names 2"));
  std::ofstream(file) << "saturation,p\n0.9,500\n";
  EXPECT_THAT(message_of(read), HasSubstr("no column 'pc_Pa'"));
  EXPECT_THAT(message_of([&] { (void)read_retention(scratch.path / "absent.csv"); }), HasSubstr("absent.csv"));
}

TEST(Distributions, CountEveryValueOnceOnAFixedGrid) {
  const std::vector<double> values{0.26, 0.31, 0.34, 0.55};
  const std::vector<Bin> bins = histogram(values, 10);
  ASSERT_EQ(bins.size(), 4U);
  EXPECT_EQ(bins[0], (Bin{0.2, 0.3, 2.5}));  // one of four in a width of 0.1
  EXPECT_EQ(bins[1], (Bin{0.3, 0.4, 5.0}));
  EXPECT_EQ(bins[2], (Bin{0.4, 0.5, 0.0}));
  EXPECT_EQ(bins[3], (Bin{0.5, 0.6, 2.5}));
}

TEST(Distributions, AreDensitiesThatSumToOneAndReadBack) {
  const TemporaryFolder scratch;
  SyntheticRun run = make_synthetic_run(6);
  run.state.network.throat_radius[0] = 0.0;  // closed: not a radius
  const RadiusDistributions d = radius_distributions(run.state);
  for (const auto* bins : {&d.pore, &d.throat}) {
    double sum = 0.0;
    for (const Bin& bin : *bins) sum += bin.density * (bin.high - bin.low);
    EXPECT_NEAR(sum, 1.0, 1e-12);
  }
  EXPECT_GT(d.throat.front().low, 0.0);
  std::ofstream(scratch.path / "distributions.csv") << distributions_csv(d);
  EXPECT_EQ(read_distributions(scratch.path / "distributions.csv"), d);
}

TEST(Distributions, DoNotChangeWithTheUnitOfLength) {
  SyntheticRun run = make_synthetic_run(4);
  const RadiusDistributions before = radius_distributions(run.state);
  for (auto* radii : {&run.state.particles.radius, &run.state.network.pore_radius, &run.state.network.throat_radius})
    for (double& r : *radii) r *= 1024.0;
  EXPECT_EQ(radius_distributions(run.state), before);
}

TEST(Distributions, OfNothingAreEmpty) {
  EXPECT_TRUE(radius_distributions({}).pore.empty());
  EXPECT_EQ(mean_radius({}), 0.0);
}

}  // namespace
}  // namespace puadem
