#include "puadem/io/progress_line.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "puadem/base/parallel.hpp"
#include "puadem/io/units.hpp"

namespace puadem {

namespace {

int terminal_width(std::FILE* stream) {
  winsize size{};
  if (::ioctl(::fileno(stream), TIOCGWINSZ, &size) == 0 && size.ws_col > 0) return size.ws_col;
  return 80;
}

std::string bar(double fraction, int cells) {
  const int full = static_cast<int>(std::clamp(fraction, 0.0, 1.0) * cells);
  return fmt::format("[{:#<{}}{:.<{}}]", "", full, "", cells - full);
}

}  // namespace

std::string show_duration(double seconds) {
  if (seconds < 9.95) return fmt::format("{:.1f} s", seconds);
  const long whole = std::lround(seconds);
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
  return fmt::format("{} h {:02} min", whole / 3600, whole % 3600 / 60);
}

std::string progress_text(const Progress& p, double elapsed, int width) {
  std::string text = fmt::format("{} {:3.0f} %  {}", bar(p.fraction, 20), 100.0 * std::clamp(p.fraction, 0.0, 1.0), p.stage);
  if (p.stage == "retention") text += fmt::format("  p_c {}  S_r {:.3f}", show(p.capillary_pressure, "Pa"), p.saturation);
  if (p.stage == "two-phase-flow")
    text += fmt::format("  t {}  p_c {}  S_r {:.3f}  {} steps", show(p.time, "s"), show(p.capillary_pressure, "Pa"), p.saturation,
                        p.step);
  else if (p.stage != "retention" && p.stage != "network") {
    text += fmt::format("  unbalanced {:.1e}", p.unbalanced);
    if (elapsed > 0.5 && p.step > 0) text += fmt::format("  {:.0f} steps/s", static_cast<double>(p.step) / elapsed);
  }
  // An estimate from less than that is no more than noise.
  if (elapsed > 1.0 && p.fraction > 0.02 && p.fraction < 1.0)
    text += fmt::format("  {} to go", show_duration(elapsed * (1.0 - p.fraction) / p.fraction));
  return text.substr(0, to_size(std::max(width - 1, 10)));
}

ProgressLine::ProgressLine(std::FILE* stream) : stream_(stream) {
  const char* kind = std::getenv("TERM");
  on_terminal_ = ::isatty(::fileno(stream)) != 0 && kind != nullptr && std::string_view(kind) != "dumb";
}

void ProgressLine::show(const Progress& progress) {
  const Clock::time_point now = Clock::now();
  const bool begins = progress.stage != stage_;
  if (begins) {
    stage_ = progress.stage;
    stage_began_ = now;
  }
  const auto interval = on_terminal_ ? Clock::duration(std::chrono::milliseconds(100)) : Clock::duration(std::chrono::minutes(1));
  if (!begins && now - last_ < interval) return;
  last_ = now;
  const double elapsed = std::chrono::duration<double>(now - stage_began_).count();
  if (on_terminal_) {
    fmt::print(stream_, "\r\x1b[K{}", progress_text(progress, elapsed, terminal_width(stream_)));
    drawn_ = true;
  } else {
    fmt::print(stream_, "{}\n", progress_text(progress, elapsed, 200));
  }
  std::fflush(stream_);
}

void ProgressLine::message(std::string_view text) {
  clear();
  fmt::print(stream_, "{}\n", text);
  std::fflush(stream_);
}

void ProgressLine::clear() {
  if (!drawn_) return;
  fmt::print(stream_, "\r\x1b[K");
  std::fflush(stream_);
  drawn_ = false;
}

}  // namespace puadem
