#include "puadem/io/packing_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "puadem/base/error.hpp"
#include "puadem/base/parallel.hpp"
#include "puadem/base/random.hpp"
#include "support/temporary_folder.hpp"

namespace puadem {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

std::string error_of(std::string_view text) {
  try {
    parse_packing(text, "p.csv");
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(PackingFile, ReadsBoxCommentsAndHeading) {
  const PackingFile p =
      parse_packing("# made by hand\n# box 2 3 4\nx,y,z,r\n0.5, 0.5,\t0.5,0.25\r\n\n# last\n1.5,2.5,3.5,1e-1", "p.csv");
  EXPECT_EQ(p.box, (Domain{{0, 0, 0}, {2, 3, 4}, {}}));
  ASSERT_EQ(p.radius.size(), 2U);
  EXPECT_EQ(p.centre[1], (Vec3{1.5, 2.5, 3.5}));
  EXPECT_EQ(p.radius[1], 0.1);
}

TEST(PackingFile, NeedsNoHeading) { EXPECT_EQ(parse_packing("#box 1 1 1\n0.5,0.5,0.5,0.1\n", "p.csv").radius.size(), 1U); }

TEST(PackingFile, EveryBitComesBack) {
  Random random(3);
  std::vector<Vec3> centre;
  std::vector<double> radius;
  const Domain box{{0, 0, 0}, {0.017 / 3, 0.021 / 7, 0.1 / 3}, {}};
  for (int i = 0; i < 500; ++i) {
    centre.push_back({random.uniform() * box.upper.x, random.uniform() * box.upper.y, random.uniform() * box.upper.z});
    radius.push_back(1e-12 * (1.0 + random.uniform()));
  }
  const TemporaryFolder folder;
  write_packing(folder.path / "p.csv", centre, radius, box);
  const PackingFile back = read_packing(folder.path / "p.csv");
  EXPECT_EQ(back.box, box);
  EXPECT_EQ(back.centre, centre);
  EXPECT_EQ(back.radius, radius);
}

struct Wrong {
  const char* rows;
  const char* message;
};

TEST(PackingFile, SaysWhatIsWrongAndWhere) {
  const std::vector<Wrong> wrongs{
      {"0.5,0.5,nan,0.1", "p.csv:2:9: \"nan\" is not a finite number"},
      {"0.5,0.5,1e999,0.1", "p.csv:2:9: \"1e999\" is no number"},
      {"0.5,0.5,0.5,0.1\n0.5,0.5,a,0.1", "p.csv:3:9: \"a\" is no number"},
      {"0.5,0.5,0.5,0", "p.csv:2:13: a radius must be > 0, not 0 m"},
      {"0.5,0.5,0.5,-0.1", "a radius must be > 0, not -0.1 m"},
      {"0.5,0.5,1.5,0.1", "p.csv:2:1: the centre lies outside the box: z = 1.5 m, allowed 0 to 1 m"},
      {"0.5,0.5,0.5", "3 columns where x,y,z,r has four"},
      {"0.5,0.5,0.5,0.1,7", "5 columns"},
      {"0.5;0.5;0.5;0.1", "the columns must be x,y,z,r"},
      {"x,y,z,d\n0.5,0.5,0.5,0.1", "the columns must be x,y,z,r"},
      {"0.5,,0.5,0.1", "p.csv:2:5: a value is missing"},
      {"0.5,0.5,0.5,0.1\n# again\n0.5,0.5,0.5,0.1", "p.csv:4:1: this sphere is at the place of the one in line 2"},
      {"0.5,0.5,0.5,0.3\n0.5,0.5,0.55,0.1", "in line 2 lie one inside the other"},
      {"0.5,0.5,0.4,0.1\n0.5,0.5,0.54,0.1", "overlaps the one in line 2 by 60 mm, more than half the smaller radius (100 mm)"},
      {"# box 1 1 1\n0.5,0.5,0.5,0.1", "p.csv:2:1: a second box"},
      {"", "no sphere in the file"},
  };
  for (const Wrong& wrong : wrongs)
    EXPECT_THAT(error_of(std::string("# box 1 1 1\n") + wrong.rows), HasSubstr(wrong.message)) << wrong.rows;
  EXPECT_THAT(error_of("0.5,0.5,0.5,0.1"), AllOf(HasSubstr("no line with the box"), HasSubstr("# box lx ly lz")));
  EXPECT_THAT(error_of("# box 1 1\n0.5,0.5,0.5,0.1"), HasSubstr("three edge lengths [m], not 2"));
  EXPECT_THAT(error_of("# box 1 0 1\n0.5,0.5,0.5,0.1"), HasSubstr("p.csv:1:9: an edge length of the box must be a number > 0"));
}

TEST(PackingFile, CaretStandsBelowTheValue) {
  EXPECT_THAT(error_of("# box 1 1 1\n0.5,0.5,nan,0.1"), HasSubstr("\n  2 | 0.5,0.5,nan,0.1\n    |         ^"));
}

TEST(PackingFile, SummarisesManyErrors) {
  std::string text = "# box 1 1 1\n";
  for (int i = 0; i < 50; ++i) text += "0.5,0.5,0.5,-1\n";
  const std::string error = error_of(text);
  EXPECT_THAT(error,
              AllOf(HasSubstr("p.csv:11:13"), Not(HasSubstr("p.csv:12:13")), HasSubstr("... and 40 more errors in this file")));
}

TEST(PackingFile, WarnsOfMillimetres) {
  EXPECT_EQ(parse_packing("# box 10 10 10\n5,5,5,0.6\n", "p.csv").warnings.size(), 1U);
  EXPECT_EQ(parse_packing("# box 1 1 1\n0.5,0.5,0.5,0.01\n", "p.csv").warnings.size(), 0U);
}

// Against the obvious: every pair, for a wide range of sizes.
TEST(BadPairs, AreThoseOfTheSlowSearch) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Random random(seed);
    const Domain box{{0, 0, 0}, {1.0, random.uniform(0.05, 2.0), random.uniform(0.3, 1.0)}, {}};
    std::vector<Vec3> centre;
    std::vector<double> radius;
    for (int i = 0; i < 300; ++i) {
      centre.push_back({random.uniform() * box.upper.x, random.uniform() * box.upper.y, random.uniform() * box.upper.z});
      radius.push_back(0.002 * std::pow(100.0, random.uniform()));
    }
    centre[7] = centre[3];
    std::vector<std::array<int, 2>> slow, fast;
    for (int j = 0; j < 300; ++j)
      for (int i = 0; i < j; ++i) {
        const double ri = radius[to_size(i)], rj = radius[to_size(j)];
        if (ri + rj - norm(centre[to_size(i)] - centre[to_size(j)]) > 0.5 * std::min(ri, rj)) slow.push_back({i, j});
      }
    for (const BadPair& pair : find_bad_pairs(centre, radius, box)) fast.push_back({pair.first, pair.second});
    EXPECT_EQ(fast, slow);
    EXPECT_GT(slow.size(), 1U);
  }
}

}  // namespace
}  // namespace puadem
