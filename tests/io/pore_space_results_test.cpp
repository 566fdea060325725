// What a drained bed makes of its pore space, in series, fields and page (theory 7.10).

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "puadem/coupling/pore_space.hpp"
#include "puadem/io/case_file.hpp"
#include "puadem/io/report_unsaturated.hpp"
#include "puadem/io/results_folder.hpp"
#include "puadem/io/series_coupled.hpp"
#include "support/resumable_cases.hpp"
#include "support/temporary_folder.hpp"

namespace puadem {
namespace {

using ::testing::HasSubstr;

struct Table {
  std::vector<std::string> header;
  std::vector<std::map<std::string, std::string>> rows;
  double number(std::size_t row, const std::string& name) const { return std::stod(rows[row].at(name)); }
};

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells(1);
  for (const char c : line) c == ',' ? cells.emplace_back().clear() : cells.back().push_back(c);
  return cells;
}

Table read_table(const std::filesystem::path& path) {
  std::ifstream file(path);
  Table table;
  std::string line;
  std::getline(file, line);
  table.header = cells_of(line);
  while (std::getline(file, line)) {
    const auto cells = cells_of(line);
    EXPECT_EQ(cells.size(), table.header.size()) << line;
    auto& row = table.rows.emplace_back();
    for (std::size_t k = 0; k < cells.size(); ++k) row[table.header[k]] = cells[k];
  }
  return table;
}

std::string slurp(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// The run with its files, made once.
struct Recorded {
  TemporaryFolder temporary;
  Case c = testing::unsaturated_case();
  ResultsFolder folder = open_results(c, "", "", temporary.path / "run");
  State state;
  RunResults results = run(c, state, recording_observer(folder, c));
  const UnsaturatedRecord& record = state.unsaturated_flows.back();

  static const Recorded& made() {
    static const Recorded once;
    return once;
  }
};

TEST(PoreSpaceResults, EveryMixtureIsWritten) {
  const Recorded& r = Recorded::made();
  const Table table = read_table(r.folder.path / "series" / "pore_space.csv");
  std::map<std::string, double> weight, mean, of_parts;
  for (std::size_t k = 0; k < table.rows.size(); ++k) {
    const auto& row = table.rows[k];
    const std::string key = row.at("branch") + row.at("pc_Pa") + row.at("quantity");
    weight[key] += table.number(k, "weight");
    of_parts[key] += table.number(k, "weight") * table.number(k, "part_mean");
    mean[key] = table.number(k, "mean");
  }
  EXPECT_EQ(weight.size(), 3 * r.record.rows.size());
  for (const auto& [key, sum] : weight) {
    EXPECT_NEAR(sum, 1.0, 1e-9) << key;
    EXPECT_NEAR(of_parts.at(key), mean.at(key), 1e-9) << key;  // maximisation keeps the mean of the samples
  }
  for (const PoreSpaceRow& row : r.record.pore_space)
    for (const auto& [sizes, per_unit] : {std::pair{&row.pore_radius, 20}, {&row.throat_radius, 50}, {&row.porosity, 50}}) {
      double share = 0.0;
      for (int k = 0; k < sizes->classes; ++k) share += r.record.pore_density[to_size(sizes->density_begin + k)] / per_unit;
      EXPECT_NEAR(share, 1.0, 1e-12);
    }
}

TEST(PoreSpaceResults, BlocksOfARowHaveThePorosityOfTheBox) {
  const Recorded& r = Recorded::made();
  const Table table = read_table(r.folder.path / "series" / "local_porosity.csv");
  const std::size_t blocks = table.rows.size() / r.record.rows.size();
  ASSERT_GT(blocks, 1u);
  ASSERT_EQ(table.rows.size(), blocks * r.record.rows.size());
  for (std::size_t row = 0; row < r.record.rows.size(); ++row) {
    double porosity = 0.0, change = 0.0, grains = 0.0;
    for (std::size_t k = row * blocks; k < (row + 1) * blocks; ++k) {
      porosity += table.number(k, "local_porosity") / static_cast<double>(blocks);
      change += table.number(k, "porosity_change") / static_cast<double>(blocks);
      grains += table.number(k, "grains");
      EXPECT_GE(table.number(k, "local_saturation"), 0.0);
      EXPECT_LE(table.number(k, "local_saturation"), 1.0 + 1e-6);  // as full as the flow leaves pores
      if (row == 0) {
        EXPECT_EQ(table.number(k, "displacement_z_m"), 0.0);
      }
    }
    // Grains reach beyond the plates by their overlap, which is not in the blocks.
    EXPECT_NEAR(porosity, r.record.rows[row].porosity, 1e-5);
    EXPECT_NEAR(change, r.record.rows[row].porosity - r.record.rows[0].porosity, 1e-5);
    EXPECT_EQ(grains, r.c.grains.count);
  }
  EXPECT_NE(table.number(table.rows.size() - 1, "displacement_z_m"), 0.0);
  EXPECT_NEAR(r.results.scalars.at("unsaturated-flow_unit_porosity_mean_end"), r.record.pore_space.back().porosity.mean, 0.0);
}

TEST(PoreSpaceResults, FieldsHavePorosityAndDisplacement) {
  const auto fields = Recorded::made().folder.path / "fields";
  EXPECT_THAT(slurp(fields / "grains_00001.vtp"), HasSubstr("\"displacement\""));
  EXPECT_THAT(slurp(fields / "pores_00001.vtp"), HasSubstr("\"porosity\""));
}

TEST(PoreSpaceResults, OfThePage) {
  const Recorded& r = Recorded::made();
  const auto space = unsaturated_json(r.folder, r.state)[0]["pore_space"];
  ASSERT_EQ(space["rows"].size(), 3u);
  const auto rows = telling_rows(r.record);
  EXPECT_EQ(rows.front(), 0);
  EXPECT_EQ(rows.back(), size_of(r.record.rows) - 1);
  // The middle row is nearest to half-way.
  double least = 1.0, most = 0.0;
  for (const UnsaturatedRow& row : r.record.rows) {
    least = std::min(least, row.saturation);
    most = std::max(most, row.saturation);
  }
  const auto off = [&](const UnsaturatedRow& row) { return std::abs(row.saturation - 0.5 * (least + most)); };
  for (const UnsaturatedRow& row : r.record.rows) EXPECT_LE(off(r.record.rows[to_size(rows[1])]), off(row));
  for (const int row : rows) EXPECT_TRUE(space["blocks"].contains(std::to_string(row)));
  // The last row has a picture, and every picture its blocks.
  ASSERT_FALSE(r.folder.unsaturated_pictures.empty());
  EXPECT_EQ(r.folder.unsaturated_pictures.back().row, rows.back());
  for (const UnsaturatedPicture& picture : r.folder.unsaturated_pictures)
    EXPECT_TRUE(space["blocks"].contains(std::to_string(picture.row)));
}

}  // namespace
}  // namespace puadem
