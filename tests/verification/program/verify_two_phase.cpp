// Runs the verification cases of two fluids that move and writes what came out as CSV files: the tables and figures of
// docs/validation.md. tools/verify_two_phase calls it.
#include "puadem/base/parallel.hpp"
#include "two_phase_bed.hpp"

using namespace puadem;
using namespace puadem::verification;

int main(int argc, char** argv) {
  if (argc < 2) {
    fmt::print(stderr, "usage: verify_two_phase FOLDER [chains | slow | schemes | lengths | merging | same]...\n");
    return 1;
  }
  const std::filesystem::path folder = argv[1];
  std::filesystem::create_directories(folder);
  const std::vector<std::string> parts(argv + 2, argv + argc);
  const auto is_asked = [&](const char* part) { return parts.empty() || std::ranges::find(parts, part) != parts.end(); };
  set_threads(1);
  if (is_asked("chains")) write_chains(folder);
  if (is_asked("same")) write_two_phase_invariances(folder);
  if (is_asked("merging")) write_merging(folder);
  if (is_asked("slow")) write_slow_limit(folder);
  if (is_asked("lengths")) write_step_lengths(folder);
  if (is_asked("schemes")) write_schemes(folder);
}
