#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "csv.hpp"
#include "puadem/flow/two_phase_flow.hpp"
#include "puadem/network/pore_units.hpp"
#include "support/packings.hpp"

namespace puadem::verification {

/// A packing between two walls, gas above and water below, with its network. Water and air at 20 C.
struct Bed {
  testing::Spheres spheres;
  PoreNetwork network;
  ThroatFilms films;
  Fluids fluids{};

  /// Capillary pressure of a dimensionless one, p_c <r> / gamma [Pa].
  double pressure(double dimensionless) const;
  /// Area of a face across the flow [m2].
  double area() const { return spheres.domain.size().x * spheres.domain.size().y; }
};

/// 1,000 grains or so between walls at bottom and top, periodic across (see dense_packing).
Bed make_bed(int grains, int seed, const NetworkOptions& options = {});
Bed bed_of(testing::Spheres spheres, const NetworkOptions& options = {});

/// Both reservoirs at a pressure: gas at 0, water at minus the suction [Pa].
TwoPhaseModel driven_by_suction(const Bed& bed, const TwoPhaseOptions& options, double suction);
/// Water drawn off at a rate, gas at 0 beside pores at the top that drain like the others.
TwoPhaseModel driven_by_rate(const Bed& bed, const TwoPhaseOptions& options, double capillary_number);

const char* name_of(TwoPhaseScheme scheme);
const char* name_of(GasKind gas);

/// Looks at every step of a run: balance of both fluids and range of saturations.
struct Watch {
  const Bed& bed;
  const TwoPhaseModel& model;
  TwoPhaseState start;
  long steps = 0;
  double ledger = 0.0;             ///< largest error of either fluid, over the void [-]
  double least = 1.0, most = 0.0;  ///< saturation of a pore [-]
  double saturation = 1.0;         ///< of all pores after the last step [-]
  double until = 0.0;              ///< the run ends at this saturation [-]
  bool keeps_curve = false;
  std::vector<std::pair<double, double>> curve{};  ///< time, saturation

  TwoPhaseCallbacks callbacks();

 private:
  bool look(const TwoPhaseState& state);
};

/// One row a run: what was found in all its steps.
struct LedgerFile {
  Csv csv;
  LedgerFile(const std::filesystem::path& folder, const char* study)
      : csv(folder / fmt::format("ledger_{}.csv", study), "run,scheme,gas,steps,largest_error,least_saturation,most_saturation") {
  }
  void row(const std::string& run, const Watch& watch);
};

/// Processor time of this program so far [s].
double processor_seconds();

// Each writes the CSV files of one part of the document.
void write_chains(const std::filesystem::path& folder);
void write_slow_limit(const std::filesystem::path& folder);
void write_schemes(const std::filesystem::path& folder);
void write_step_lengths(const std::filesystem::path& folder);
void write_merging(const std::filesystem::path& folder);
void write_two_phase_invariances(const std::filesystem::path& folder);

}  // namespace puadem::verification
