// A run taken up at any safe place ends as the run that was never stopped, to the last bit.

#include <gtest/gtest.h>

#include <map>

#include "puadem/coupling/run.hpp"
#include "support/resumable_cases.hpp"

namespace puadem {
namespace {

using testing::expect_same_run;
using testing::Outcome;

struct SafePlace {
  State state;
  RunResults results;
};

/// Runs a case and keeps a copy at every `interval`-th safe place.
std::vector<SafePlace> run_with_copies(const Case& c, State& state, RunResults& results, int interval) {
  std::vector<SafePlace> places;
  int count = 0;
  Observer observer;
  observer.safe_place = [&](const State& at, const RunResults& so_far, bool is_last) {
    EXPECT_FALSE(is_last);
    if (count++ % interval == 0) places.push_back({at, so_far});
  };
  results = run(c, state, observer);
  return places;
}

/// The run that is never stopped, with copies on its way; made once for each case.
struct Whole {
  Outcome outcome;
  std::vector<SafePlace> places;
};

const Whole& whole_run(const testing::ResumableCase& of) {
  static std::map<std::string, Whole> made;
  const auto [entry, is_new] = made.try_emplace(of.name);
  Whole& whole = entry->second;
  if (is_new) whole.places = run_with_copies(of.make(), whole.outcome.state, whole.outcome.results, of.interval);
  return whole;
}

class Resume : public ::testing::TestWithParam<testing::ResumableCase> {};

TEST_P(Resume, EndsAsTheRunThatWasNeverStopped) {
  const Case c = GetParam().make();
  const auto& [whole, places] = whole_run(GetParam());
  ASSERT_GT(places.size(), 3u);
  const std::size_t stride = std::max<std::size_t>(places.size() / 4, 1);
  for (std::size_t k = 0; k < places.size(); k += stride) {
    SCOPED_TRACE(k);
    Outcome resumed{places[k].state, {}};
    resumed.results = run(c, resumed.state, {}, places[k].results);
    expect_same_run(whole, resumed);
  }
}

TEST_P(Resume, AStopLeavesASafePlaceBehind) {
  const Case c = GetParam().make();
  Outcome stopped;
  int calls = 0;
  std::optional<SafePlace> left;
  Observer observer;
  observer.progress = [&](const Progress& p) { return p.stage == "compact" || p.stage == "network" || ++calls < 5; };
  observer.safe_place = [&](const State& at, const RunResults& so_far, bool is_last) {
    if (is_last) left = {at, so_far};
  };
  stopped.results = run(c, stopped.state, observer);
  ASSERT_TRUE(stopped.results.interrupted);
  ASSERT_TRUE(left.has_value());
  stopped.results = run(c, left->state, {}, left->results);
  stopped.state = left->state;
  EXPECT_FALSE(stopped.results.interrupted);
  expect_same_run(whole_run(GetParam()).outcome, stopped);
}

INSTANTIATE_TEST_SUITE_P(Stages, Resume, ::testing::ValuesIn(testing::resumable_cases()),
                         [](const auto& of) { return of.param.name; });

}  // namespace
}  // namespace puadem
