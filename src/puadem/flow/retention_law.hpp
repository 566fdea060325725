#pragma once

#include <concepts>
#include <string_view>
#include <variant>

#include "puadem/flow/capillary_laws/pore_unit_retention.hpp"

namespace puadem {

/// Local law of a pore unit that holds both fluids: capillary pressure [Pa] against saturation [-].
/// Falls strictly with S on (0, largest_saturation].
template <class Law>
concept RetentionLaw = requires(const Law law, const CapillaryUnit& unit, double saturation, double pressure) {
  { law.capillary_pressure(unit, saturation) } -> std::same_as<double>;
  { law.saturation(unit, pressure) } -> std::same_as<double>;  ///< for p_c >= saturated_pressure
  { law.slope(unit, saturation) } -> std::same_as<double>;     ///< dp_c / dS [Pa], < 0
  { law.saturated_pressure(unit) } -> std::same_as<double>;    ///< lowest p_c at which both fluids stay
  { law.largest_saturation(unit) } -> std::same_as<double>;    ///< S there, <= 1
  { Law::name } -> std::convertible_to<std::string_view>;
};

/// Every law a case file can name. A new law is one struct in capillary_laws/ and one word here.
using AnyRetentionLaw = std::variant<ExponentialRetention, PolyhedronRetention>;

}  // namespace puadem
