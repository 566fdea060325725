#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace puadem {

/// A column of a series in two runs, over the same abscissa.
struct ComparedCurve {
  std::string series, group, abscissa, column;  ///< group: stage and branch, where the series has them
  std::vector<double> x, first, second;         ///< at the first's places within the range of both; the second between its rows
  double root_mean_square = 0.0;                ///< of the difference
  double largest = 0.0, largest_at = 0.0;       ///< of its size, and where
  double range = 0.0;                           ///< of the first: largest less least
};

/// A result of both runs.
struct ComparedResult {
  std::string name;
  double first, second;
};

struct Comparison {
  std::vector<ComparedCurve> curves;
  std::vector<ComparedResult> results;  ///< that are not the same
  int same_results = 0;
};

/// Two runs, or a run and a table of another origin with the same names of columns. Curves lie over time, capillary pressure
/// or strain, whichever the series has.
/// @throws InputError  a folder that is no run, a table without a known abscissa, nothing in common
Comparison compare(const std::filesystem::path& first, const std::filesystem::path& second);

/// As a text, curves that differ most first.
std::string comparison_text(const Comparison& comparison);

/// All curves side by side: a table with header.
std::string comparison_csv(const Comparison& comparison);

}  // namespace puadem
