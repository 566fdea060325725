#include "puadem/io/checkpoint.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "puadem/base/error.hpp"
#include "puadem/io/resume.hpp"
#include "puadem/io/state_hash.hpp"
#include "support/resumable_cases.hpp"
#include "support/temporary_folder.hpp"

namespace puadem {
namespace {

using testing::expect_same_run;
using ::testing::HasSubstr;
using testing::Outcome;

constexpr std::string_view resolved = "the case";

std::string message_of(const std::function<void()>& act) {
  try {
    act();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

class Checkpoints : public ::testing::TestWithParam<testing::ResumableCase> {};

TEST_P(Checkpoints, ARunReadFromOneEndsAsTheRunThatWasNeverStopped) {
  const TemporaryFolder folder;
  const Case c = GetParam().make();
  Outcome whole, back;
  int count = 0;
  Observer observer;
  const auto file = folder.path / "one.h5";
  observer.safe_place = [&](const State& state, const RunResults& results, bool) {
    if (++count == 3 * GetParam().interval) write_checkpoint(file, resolved, state, results);
  };
  whole.results = run(c, whole.state, observer);
  ASSERT_TRUE(std::filesystem::exists(file));
  EXPECT_FALSE(std::filesystem::exists(folder.path / "one.h5.part"));
  read_checkpoint(file, c, resolved, back.state, back.results);
  back.results = run(c, back.state, {}, back.results);
  expect_same_run(whole, back);
  EXPECT_EQ(state_hash(whole.state), state_hash(back.state));
}

INSTANTIATE_TEST_SUITE_P(Stages, Checkpoints, ::testing::ValuesIn(testing::resumable_cases()),
                         [](const auto& of) { return of.param.name; });

TEST(Checkpoint, OfAnotherCaseOrFormatOrCutOffIsRefused) {
  const TemporaryFolder folder;
  const auto file = folder.path / "one.h5";
  State state;
  RunResults results;
  results.scalars["answer"] = 42.0;
  write_checkpoint(file, resolved, state, results);
  RunResults back;
  read_checkpoint(file, {}, resolved, state, back);
  EXPECT_EQ(back.scalars, results.scalars);

  EXPECT_THAT(message_of([&] { read_checkpoint(file, {}, "another", state, back); }), HasSubstr("belongs to another case"));
  EXPECT_THAT(message_of([&] { read_checkpoint(folder.path / "none.h5", {}, resolved, state, back); }),
              HasSubstr("it is missing, cut off, or no HDF5 file"));
  std::filesystem::resize_file(file, std::filesystem::file_size(file) / 2);
  EXPECT_THAT(message_of([&] { read_checkpoint(file, {}, resolved, state, back); }), HasSubstr("cut off"));
  {
    Hdf5File other = Hdf5File::create(file);
    ArchiveWriter archive(other);
    archive("format", checkpoint_format + 1);
    archive("version", std::string("9.9"));
    other.close();
  }
  EXPECT_THAT(message_of([&] { read_checkpoint(file, {}, resolved, state, back); }),
              HasSubstr(fmt::format("has format {} of puadem 9.9", checkpoint_format + 1)));
  std::ofstream(file) << "no such thing";
  EXPECT_THAT(message_of([&] { read_checkpoint(file, {}, resolved, state, back); }), HasSubstr("no HDF5 file"));
}

TEST(Checkpoint, CannotBeWrittenIntoAFolderThatIsGone) {
  EXPECT_THAT(message_of([] { write_checkpoint("/nowhere/one.h5", resolved, {}, {}); }), HasSubstr("cannot write '/nowhere"));
}

TEST(Resume, SaysWhatIsNoRunAndWhatHasNoCheckpoint) {
  const TemporaryFolder folder;
  EXPECT_THAT(message_of([&] { resume_run(folder.path, {}, {}); }), HasSubstr("is no folder of a run"));
  std::ofstream(folder.path / "case.resolved.toml") << "title = \"t\"\n";
  EXPECT_THAT(message_of([&] { resume_run(folder.path, {}, {}); }), HasSubstr("has no checkpoint"));
  std::ofstream(folder.path / "manifest.json") << R"({"exit_code": 0})";
  EXPECT_THAT(message_of([&] { resume_run(folder.path, {}, {}); }), HasSubstr("has come to its end"));
}

// Every kind of value an archive knows, there and back.

struct Inner {
  std::array<int, 2> pair{};
  std::string word;
  std::optional<double> maybe;
};
struct Everything {
  bool flag = false;
  double number = 0.0;
  long big = 0;
  std::optional<double> none, some;
  std::variant<std::monostate, double, Inner> choice;
  std::vector<double> list, empty;
  std::vector<std::string> words;
  std::vector<Inner> rows, no_rows;
  std::vector<std::vector<int>> lists;
  std::map<std::string, double> named;
};

void fields(auto& a, Is<Inner> auto& x) {
  auto& [pair, word, maybe] = x;
  each(a, "pair word maybe", pair, word, maybe);
}
void fields(auto& a, Is<Everything> auto& x) {
  auto& [flag, number, big, none, some, choice, list, empty, words, rows, no_rows, lists, named] = x;
  each(a, "flag number big none some choice list empty words rows no_rows lists named", flag, number, big, none, some, choice,
       list, empty, words, rows, no_rows, lists, named);
}

}  // namespace

template <>
inline constexpr bool is_row<Inner> = true;

namespace {

TEST(Archive, KeepsEveryKindOfValue) {
  const TemporaryFolder folder;
  Everything x{true,
               0.1,
               1L << 40,
               {},
               0.3,
               Inner{{3, 4}, "inner", {}},
               {1.5, -0.0},
               {},
               {"a", "", "äö"},
               {{{1, 2}, "x", 0.5}, {{5, 6}, "", {}}},
               {},
               {{1, 2}, {}, {3}},
               {{"k", 1.0}, {"b", 2.0}}};
  {
    Hdf5File file = Hdf5File::create(folder.path / "all.h5");
    ArchiveWriter archive(file);
    archive("x", x);
    file.close();
  }
  Everything y;
  y.none = 1.0;
  y.named["gone"] = 1.0;
  const Hdf5File file = Hdf5File::open(folder.path / "all.h5");
  ArchiveReader archive(file);
  archive("x", y);
  EXPECT_TRUE(y.flag);
  EXPECT_EQ(y.number, x.number);
  EXPECT_EQ(y.big, x.big);
  EXPECT_FALSE(y.none);
  EXPECT_EQ(y.some, x.some);
  ASSERT_EQ(y.choice.index(), 2u);
  EXPECT_EQ(std::get<Inner>(y.choice).word, "inner");
  EXPECT_EQ(std::get<Inner>(y.choice).pair, (std::array{3, 4}));
  EXPECT_EQ(y.list, x.list);
  EXPECT_TRUE(std::signbit(y.list[1]));
  EXPECT_EQ(y.words, x.words);
  ASSERT_EQ(y.rows.size(), 2u);
  EXPECT_EQ(y.rows[0].word, "x");
  EXPECT_EQ(y.rows[1].pair, (std::array{5, 6}));
  EXPECT_EQ(y.rows[0].maybe, 0.5);
  EXPECT_FALSE(y.rows[1].maybe);
  EXPECT_TRUE(y.no_rows.empty());
  EXPECT_EQ(y.lists, x.lists);
  EXPECT_EQ(y.named, x.named);
}

}  // namespace
}  // namespace puadem
