#include "puadem/io/results_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <csignal>
#include <fstream>

#include "puadem/base/error.hpp"
#include "puadem/io/series_writer.hpp"
#include "support/temporary_folder.hpp"
#include "synthetic_run.hpp"

namespace puadem {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

/// Files cannot grow beyond `bytes` while this lives: what a full disk does, without filling one.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;

 private:
  rlimit before_{};
  void (*handler_)(int);
};

/// Runs in a folder of its own as working directory.
struct ResultsFolderTest : ::testing::Test {
  TemporaryFolder scratch;
  fs::path home = fs::current_path();
  SyntheticRun run = make_synthetic_run(3);

  void SetUp() override { fs::current_path(scratch.path); }
  void TearDown() override { fs::current_path(home); }

  ResultsFolder open(std::optional<fs::path> output = {}) { return open_results(run.c, "title = 'x'\n", "resolved\n", output); }

  fs::path record(std::optional<fs::path> output = {}) {
    ResultsFolder folder = open(std::move(output));
    play(run, recording_observer(folder, run.c));
    finish_results(folder, run.c, run.state, &run.results, 0, "");
    return folder.path;
  }

  std::vector<std::string> listing(const fs::path& folder) const {
    std::vector<std::string> names;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) names.push_back(entry.path().lexically_relative(folder));
    std::ranges::sort(names);
    return names;
  }
};

std::string message_of(const auto& call) {
  try {
    call();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST_F(ResultsFolderTest, HoldsEveryFileOfARun) {
  run.c.output.fields_every = 20;  // equilibria 0 and 20 of 39
  const fs::path folder = record();
  EXPECT_THAT(listing(folder),
              ::testing::ElementsAre("case.resolved.toml", "case.toml", "fields", "fields/grains.pvd", "fields/grains_00000.vtp",
                                     "fields/pores.pvd", "fields/pores_00000.vtp", "fields/pores_00001.vtp", "fields/throats.pvd",
                                     "fields/throats_00000.vtp", "fields/throats_00001.vtp", "log.txt", "manifest.json",
                                     "packing.csv", "progress.jsonl", "report.html", "series", "series/compaction.csv",
                                     "series/distributions.csv", "series/events.csv", "series/retention.csv"));
  EXPECT_EQ(slurp(folder / "case.toml"), "title = 'x'\n");
  EXPECT_EQ(slurp(folder / "case.resolved.toml"), "resolved\n");
  const std::vector<RetentionRow> rows = read_retention(folder / "series" / "retention.csv");
  ASSERT_EQ(rows.size(), run.state.retention.size());
  EXPECT_EQ(rows.back().saturation, run.state.retention.back().saturation);
  const std::string events = slurp(folder / "series" / "events.csv");
  EXPECT_EQ(std::ranges::count(events, '\n'), 3);
  EXPECT_THAT(slurp(folder / "fields" / "pores.pvd"), HasSubstr("timestep=\"20\" part=\"0\" file=\"pores_00001.vtp\""));
  EXPECT_THAT(slurp(folder / "log.txt"), HasSubstr("the wetting front is not measured here"));
}

TEST_F(ResultsFolderTest, IsNamedAfterTimeTitleAndCase) {
  const std::string name = record().filename();
  EXPECT_THAT(name, ::testing::MatchesRegex(
                        "[0-9]+-[0-9]+-[0-9]+T[0-9]+_drainage-and-imbibition-of-a-made-up-lat_[0-9a-f][0-9a-f][0-9a-f][0-9a-f]"
                        "[0-9a-f][0-9a-f]"));
}

TEST_F(ResultsFolderTest, NeverOverwritesAndPointsToTheLatest) {
  const fs::path first = record();
  const std::string before = slurp(first / "manifest.json");
  const fs::path second = record();
  EXPECT_NE(first, second);
  EXPECT_EQ(slurp(first / "manifest.json"), before);
  EXPECT_EQ(fs::read_symlink("runs/latest"), second.filename());
  EXPECT_TRUE(fs::exists("runs/latest/report.html"));
}

TEST_F(ResultsFolderTest, RefusesAFolderThatHoldsSomething) {
  fs::create_directory("mine");
  std::ofstream("mine/notes.txt") << "keep";
  EXPECT_THAT(message_of([&] { open("mine"); }), HasSubstr("'mine' is not empty"));
  EXPECT_EQ(slurp("mine/notes.txt"), "keep");
  std::ofstream("file") << "x";
  EXPECT_THAT(message_of([&] { open("file"); }), HasSubstr("'file' is a file"));
}

TEST_F(ResultsFolderTest, SaysWhatToDoWhereItCannotWrite) {
  const std::string message = message_of([&] { open("/proc/nowhere/run"); });
  EXPECT_THAT(message, HasSubstr("/proc/nowhere/run"));
  EXPECT_THAT(message, HasSubstr("--output"));
  std::ofstream("file") << "x";
  EXPECT_THAT(message_of([&] { open("file/run"); }), HasSubstr("cannot make the folder 'file/run'"));
}

TEST_F(ResultsFolderTest, TakesAnEmptyFolderAndLeavesItWhereTheRunFails) {
  fs::create_directory("mine");
  ResultsFolder folder = open("mine");
  finish_results(folder, run.c, {}, nullptr, 1, "no such porosity");
  EXPECT_TRUE(fs::is_directory("mine"));
  EXPECT_TRUE(fs::is_empty("mine"));
}

TEST_F(ResultsFolderTest, LeavesNothingOfARunThatFailedBeforeItsFirstResult) {
  ResultsFolder folder = open();
  const Observer observer = recording_observer(folder, run.c);
  observer.message("about to fail");
  observer.progress({"compact", 0.1, 10, 0.0, 1.0, 0.5, 0.0});
  finish_results(folder, run.c, {}, nullptr, 2, "the packing flew apart");
  EXPECT_TRUE(fs::is_empty(scratch.path));
}

TEST_F(ResultsFolderTest, GivesLatestBackToTheRunBefore) {
  const fs::path good = record();
  ResultsFolder folder = open();
  finish_results(folder, run.c, {}, nullptr, 2, "stopped");
  EXPECT_EQ(fs::read_symlink("runs/latest"), good.filename());
  EXPECT_EQ(std::distance(fs::directory_iterator("runs"), fs::directory_iterator()), 2);
}

TEST_F(ResultsFolderTest, KeepsWhatIsWholeOfARunThatFailedLater) {
  ResultsFolder folder = open();
  play(run, recording_observer(folder, run.c));
  finish_results(folder, run.c, run.state, nullptr, 2, "an event storm at 640 Pa");
  EXPECT_THAT(slurp(folder.path / "manifest.json"), HasSubstr("\"exit_code\": 2"));
  EXPECT_THAT(slurp(folder.path / "manifest.json"), HasSubstr("an event storm at 640 Pa"));
  EXPECT_THAT(slurp(folder.path / "log.txt"), HasSubstr("stopped: an event storm at 640 Pa"));
  EXPECT_TRUE(fs::exists(folder.path / "report.html"));
}

TEST_F(ResultsFolderTest, ADiskThatFillsAtOnceLeavesNothing) {
  const FileSizeLimit full(8);
  EXPECT_THAT(message_of([&] { open(); }), HasSubstr("cannot write"));
  EXPECT_TRUE(fs::is_empty(scratch.path));
}

TEST_F(ResultsFolderTest, ADiskThatFillsDuringTheFirstResultLeavesNothing) {
  std::string message;
  {
    const FileSizeLimit full(2000);  // less than the fields of 27 grains
    ResultsFolder folder = open();
    const Observer observer = recording_observer(folder, run.c);
    message = message_of([&] { observer.packed(run.state); });
    finish_results(folder, run.c, run.state, nullptr, 1, message);
  }
  EXPECT_THAT(message, HasSubstr("cannot write"));
  EXPECT_THAT(message, HasSubstr("--output"));
  EXPECT_TRUE(fs::is_empty(scratch.path));
}

TEST_F(ResultsFolderTest, ADiskThatFillsLaterKeepsWholeRowsAndWholeFiles) {
  run.c.output.fields = false;
  fs::path path;
  {
    ResultsFolder folder = open();
    path = folder.path;
    const Observer observer = recording_observer(folder, run.c);
    observer.packed(run.state);
    const FileSizeLimit full(500);
    const std::string message = message_of([&] {
      for (const RetentionRow& row : run.state.retention) observer.equilibrium(run.state, row);
    });
    EXPECT_THAT(message, HasSubstr("retention.csv"));
    finish_results(folder, run.c, run.state, nullptr, 1, message);
  }
  const std::vector<RetentionRow> rows = read_retention(path / "series" / "retention.csv");
  ASSERT_GT(rows.size(), 2U);
  ASSERT_LT(rows.size(), run.state.retention.size());
  EXPECT_TRUE(slurp(path / "series" / "retention.csv").ends_with("\n"));
  EXPECT_EQ(rows.back().saturation, run.state.retention[rows.size() - 1].saturation);
  for (const auto& entry : fs::recursive_directory_iterator(path)) EXPECT_NE(entry.path().extension(), ".part");
}

TEST_F(ResultsFolderTest, ADiskThatFillsAtTheEndIsAnError) {
  ResultsFolder folder = open();
  play(run, recording_observer(folder, run.c));
  const FileSizeLimit full(10000);  // the manifest fits, the report does not
  EXPECT_THAT(message_of([&] { finish_results(folder, run.c, run.state, &run.results, 0, ""); }), HasSubstr("report.html"));
  EXPECT_TRUE(fs::exists(folder.path / "manifest.json"));
  EXPECT_FALSE(fs::exists(folder.path / "report.html"));
  EXPECT_FALSE(fs::exists(folder.path / "report.html.part"));
}

TEST(SafeFile, NamesAFullDevice) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  AppendFile file("/dev/full");
  file.append("a line\n");
  const std::string message = message_of([&] { file.flush(); });
  EXPECT_THAT(message, HasSubstr("/dev/full"));
  EXPECT_THAT(message, HasSubstr("No space left"));
  EXPECT_THAT(message, HasSubstr("free space"));
}

TEST_F(ResultsFolderTest, RecordsTheSameEventsWhateverTheOutput) {
  run.c.output.fields = false;
  const fs::path quiet = record();
  EXPECT_TRUE(fs::is_empty(quiet / "fields"));
  run.c.output.fields = true;
  EXPECT_EQ(slurp(record() / "series" / "events.csv"), slurp(quiet / "series" / "events.csv"));
}

}  // namespace
}  // namespace puadem
