#pragma once

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

namespace puadem {

/// The user can repair it: a wrong case file, a packing that leaves the box. The message says what was
/// found, where, what is allowed and, where one exists, the nearest right name. Exit code 1.
struct InputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The run cannot go on: an unstable step, a fluid volume lost. The message says step, time, quantity
/// and place. Exit code 2.
struct NumericalError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Throws InputError unless `ok`. Say what was given, what is allowed, and what to do.
template <class... Args>
void require(bool ok, fmt::format_string<Args...> message, Args&&... args) {
  if (!ok) throw InputError(fmt::format(message, std::forward<Args>(args)...));
}

/// Throws NumericalError unless `ok`.
template <class... Args>
void ensure(bool ok, fmt::format_string<Args...> message, Args&&... args) {
  if (!ok) throw NumericalError(fmt::format(message, std::forward<Args>(args)...));
}

}  // namespace puadem
