#include "puadem/io/compare.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "puadem/base/error.hpp"
#include "support/temporary_folder.hpp"

namespace puadem {
namespace {

using ::testing::HasSubstr;

/// A results folder as a run leaves it.
void write_run(const std::filesystem::path& folder, const std::string& retention, const std::string& results) {
  std::filesystem::create_directories(folder / "series");
  std::ofstream(folder / "manifest.json") << "{\"results\": {" << results << "}}";
  std::ofstream(folder / "series" / "retention.csv") << "step,branch,pc_Pa,saturation\n" << retention;
}

const ComparedCurve& curve_of(const Comparison& c, const std::string& group, const std::string& column) {
  for (const ComparedCurve& curve : c.curves)
    if (curve.group == group && curve.column == column) return curve;
  throw std::runtime_error("no such curve");
}

TEST(Compare, CurvesLieOverTheirAbscissaBranchByBranch) {
  const TemporaryFolder folder;
  write_run(folder.path / "a", "0,drainage-1,0,1\n1,drainage-1,100,0.8\n2,drainage-1,200,0.2\n3,imbibition-1,100,0.3\n",
            "\"porosity\": 0.4, \"end\": 1.5");
  // Half of the way between its rows at 100 Pa; ends before 200 Pa; its imbibition comes in another order.
  write_run(folder.path / "b",
            "0,drainage-1,0,1\n1,drainage-1,50,0.9\n2,drainage-1,150,0.5\n3,imbibition-1,150,0.4\n4,imbibition-1,50,0.6\n",
            "\"porosity\": 0.4, \"end\": 2.5, \"other\": 1");
  const Comparison c = compare(folder.path / "a", folder.path / "b");
  const ComparedCurve& drainage = curve_of(c, "drainage-1", "saturation");
  EXPECT_EQ(drainage.abscissa, "pc_Pa");
  EXPECT_THAT(drainage.x, ::testing::ElementsAre(0.0, 100.0));
  EXPECT_NEAR(drainage.second[1], 0.7, 1e-12);
  EXPECT_NEAR(drainage.largest, 0.1, 1e-12);
  EXPECT_EQ(drainage.largest_at, 100.0);
  EXPECT_NEAR(drainage.root_mean_square, 0.1 / std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(drainage.range, 0.8, 1e-12);
  EXPECT_NEAR(curve_of(c, "imbibition-1", "saturation").second.front(), 0.5, 1e-12);
  EXPECT_EQ(c.same_results, 1);
  ASSERT_EQ(c.results.size(), 1u);
  EXPECT_EQ(c.results[0].name, "end");
  EXPECT_EQ(c.results[0].second, 2.5);
  EXPECT_THAT(comparison_text(c), HasSubstr("retention.csv, drainage-1: 2 points over pc_Pa"));
  EXPECT_THAT(comparison_csv(c), HasSubstr("retention.csv,\"drainage-1\",saturation,pc_Pa,100,0.8,0.7"));
}

TEST(Compare, ATableOfAnotherOriginIsComparedByTheNamesOfItsColumns) {
  const TemporaryFolder folder;
  write_run(folder.path / "a", "0,drainage-1,0,1\n1,drainage-1,100,0.8\n", "");
  std::ofstream(folder.path / "measured.csv") << "# by hand\npc_Pa,saturation\r\n0,1\r\n200,0.5\r\n";
  const Comparison c = compare(folder.path / "a", folder.path / "measured.csv");
  ASSERT_EQ(c.curves.size(), 1u);
  EXPECT_NEAR(c.curves[0].largest, 0.05, 1e-12);
}

TEST(Compare, SaysWhatCannotBeCompared) {
  const TemporaryFolder folder;
  write_run(folder.path / "a", "0,drainage-1,0,1\n", "");
  std::filesystem::create_directories(folder.path / "empty");
  std::ofstream(folder.path / "other.csv") << "x,y\n0,1\n";
  std::ofstream(folder.path / "torn.csv") << "pc_Pa,saturation\n0,1\n2\n";
  const auto expect = [&](const std::string& second, const std::string& message) {
    EXPECT_THAT([&] { compare(folder.path / "a", folder.path / second); },
                ::testing::ThrowsMessage<InputError>(HasSubstr(message)));
  };
  expect("empty", "no run of puadem");
  expect("other.csv", "none of its columns is time_s, pc_Pa or axial_strain");
  expect("torn.csv", "torn.csv:3: 1 fields, but the header names 2");
  expect("missing.csv", "missing.csv");
}

}  // namespace
}  // namespace puadem
