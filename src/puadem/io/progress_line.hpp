#pragma once

#include <chrono>
#include <cstdio>
#include <string>

#include "puadem/coupling/run.hpp"

namespace puadem {

/// A stretch of seconds for people: "0.4 s", "37 s", "4 min 05 s", "2 h 07 min".
std::string show_duration(double seconds);

/// The line that shows progress: bar, stage, the numbers that stage has, speed and time to go.
///
/// @param elapsed  since the stage began [s]
/// @param width    of the terminal [characters]
std::string progress_text(const Progress& progress, double elapsed, int width);

/// Shows progress on stderr: one line that is redrawn ten times a second on a terminal, a line at the
/// start of each stage and every minute elsewhere.
class ProgressLine {
 public:
  using Clock = std::chrono::steady_clock;

  explicit ProgressLine(std::FILE* stream);
  ~ProgressLine() { clear(); }
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  void show(const Progress& progress);
  /// Prints a line of its own above the progress line.
  void message(std::string_view text);
  void clear();

 private:
  std::FILE* stream_;
  bool on_terminal_;
  bool drawn_ = false;
  std::string stage_;
  Clock::time_point stage_began_, last_;
};

}  // namespace puadem
