#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "puadem/coupling/state.hpp"

namespace puadem {

/// FNV-1a, 64 bits (Fowler, Noll and Vo): a fingerprint that tells two runs apart, not a signature.
std::uint64_t fingerprint(std::string_view bytes, std::uint64_t hash = 0xcbf29ce484222325ULL);

/// Fingerprint of every number of a state, bit by bit: equal on any number of threads, and different
/// where one bit of a position or a saturation differs.
std::uint64_t state_hash(const State& state);

/// Sixteen hexadecimal digits.
std::string hex(std::uint64_t value);

}  // namespace puadem
