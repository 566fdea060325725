#pragma once

#include <string>
#include <vector>

#include "puadem/coupling/case.hpp"
#include "puadem/coupling/state.hpp"

namespace puadem {

/// State a run of the case begins with: the grains of `grains.file` at rest in their box, the network of
/// `network.file`, or nothing where the first stage makes the grains. What is odd about the file is appended to `warnings`.
/// @throws InputError as `read_packing` and `read_network`; where a stage asks of the network what its file does not hold
State initial_state(const Case& c, std::vector<std::string>& warnings);

}  // namespace puadem
