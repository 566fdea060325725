#pragma once

#include <string>
#include <vector>

#include "puadem/coupling/case.hpp"

namespace puadem {

/// What a run of a case will do, before it is run. Estimates are marked "about".
struct CaseSummary {
  std::string text;                   ///< several lines for a terminal
  std::vector<std::string> warnings;  ///< doubts that need more than one key to see
};

/// @throws InputError where grains.file cannot be read, or the stages contradict each other
CaseSummary summarise_case(const Case& c);

}  // namespace puadem
