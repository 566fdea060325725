#pragma once

#include <string>
#include <string_view>

#include "puadem/dem/grain_statistics.hpp"
#include "puadem/io/case_summary.hpp"

namespace puadem {

inline constexpr double loose_porosity = 0.38;  ///< of a packing whose porosity nothing fixes

/// What the estimates of a summary start from.
struct SummaryBasis {
  int grains = 0;
  GrainStatistics sizes;
  Vec3 box;  ///< [m]
  double porosity = loose_porosity;
  bool box_is_estimate = true;
};

void add_line(CaseSummary& summary, std::string_view heading, const std::string& text);

/// What every stage does, how long it takes and what it writes.
void describe_stages(const Case& c, const SummaryBasis& basis, CaseSummary& summary);

}  // namespace puadem
