#pragma once

#include <string>
#include <vector>

#include "puadem/coupling/case.hpp"
#include "puadem/coupling/state.hpp"

namespace puadem {

/// State a run of the case begins with: the grains of `grains.file` at rest in their box, or nothing where
/// the first stage makes the grains. What is odd about the file is appended to `warnings`.
/// @throws InputError as `read_packing`
State initial_state(const Case& c, std::vector<std::string>& warnings);

}  // namespace puadem
