#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "puadem/coupling/run.hpp"
#include "puadem/io/distributions.hpp"

namespace puadem {

/// The series of a run: CSV with units in the header. Numbers are the shortest that read back to the
/// same bits.
inline constexpr std::string_view retention_header = "step,branch,pc_Pa,pc_star,saturation,trapped_wetting,trapped_nonwetting\n";
inline constexpr std::string_view events_header = "event,kind,pc_Pa,pore,throat,units,wetting_volume_m3\n";
inline constexpr std::string_view compaction_header = "step,porosity,stress_Pa,unbalanced\n";
inline constexpr std::string_view pressure_header = "stage,place_m,pressure_Pa,linear_Pa,pores\n";
inline constexpr std::string_view distributions_header = "kind,bin_low,bin_high,pdf\n";

/// Columns of series/history.csv; forces and places only of faces that are walls, bridges only of wet grains.
std::string history_header(const Domain& domain, bool has_bridges = false);

std::string history_line(const HistoryRow& row, const Domain& domain);
std::string retention_line(const RetentionRow& row);
std::string event_line(long event, const InvasionEvent& e);
std::string compaction_line(const Progress& p);
std::string pressure_line(const PermeabilityResult& result, const PressureLayer& layer);
std::string distributions_csv(const RadiusDistributions& d);  ///< header and lines

/// Reads a retention series back. Columns are found by name; only pc_Pa and saturation must be there,
/// so a measured curve can be laid over a run. Lines that begin with '#' are skipped.
/// @throws InputError with file and line
std::vector<RetentionRow> read_retention(const std::filesystem::path& path);

/// Reads a history back, as far as curves are drawn from it: strains, stresses, void ratio. Columns are found by
/// name; only strain_zz, p_Pa and q_Pa must be there, so a measured curve can be laid over a run.
/// @throws InputError with file and line
std::vector<HistoryRow> read_history(const std::filesystem::path& path);

/// Reads series/distributions.csv back. @throws InputError with file and line
RadiusDistributions read_distributions(const std::filesystem::path& path);

}  // namespace puadem
