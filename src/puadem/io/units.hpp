#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "puadem/base/error.hpp"

namespace puadem {

/// Exponents of metre, kilogram, second, kelvin and radian. The angle counts as a dimension of its own,
/// so that degrees are not taken for a pure number.
struct Dimension {
  int length = 0, mass = 0, time = 0, temperature = 0, angle = 0;
  constexpr bool operator==(const Dimension&) const = default;
};

/// A number with its unit, in SI: value [metre^length kilogram^mass ...].
struct Quantity {
  double value = 0.0;
  Dimension dimension;
  bool has_unit = false;  ///< false: a bare number
};

/// A text that is no quantity; `offset` and `length` mark the part that is wrong [bytes].
struct UnitError : InputError {
  UnitError(const std::string& message, std::size_t begin, std::size_t bytes)
      : InputError(message), offset(begin), length(bytes) {}
  std::size_t offset, length;
};

/// "0.35 mm", "72.8 mN/m", "18 uPa s", "2500 kg/m^3", "12": a number, then products of units with
/// prefixes and powers; '/' divides by the one factor after it, which may be in parentheses.
///
/// Powers of ten of prefixes are joined to the number before it is converted: "0.35 mm" has the bits
/// of 0.35e-3.
/// @throws UnitError
Quantity parse_quantity(std::string_view text);

/// Dimension of a unit such as "N/m". @throws UnitError
Dimension dimension_of(std::string_view unit);

/// "a length", "a pressure or stress", ...; for dimensions without a name their SI unit.
std::string describe(const Dimension& dimension);

/// "kg m-1 s-2"; "1" for a pure number.
std::string si_unit(const Dimension& dimension);

/// A value in an SI unit as a person would write it: (3.5e-4, "m") gives "0.35 mm", (0.5236, "rad")
/// gives "30 deg". Rounded to `digits` significant digits.
std::string show(double value, std::string_view unit, int digits = 4);

}  // namespace puadem
