#pragma once

#include <numbers>
#include <utility>
#include <variant>

#include "puadem/io/case_fields.hpp"

namespace puadem {

inline constexpr double degree = std::numbers::pi / 180.0;  ///< [rad]

// Short ways to write a line of the table of keys.

/// A number with a unit. `plausible`: outside it the reader warns.
KeyInfo quantity(std::string name, std::string unit, Interval allowed, Interval plausible, std::string example, std::string help);
/// A pure number.
KeyInfo number(std::string name, Interval allowed, std::string help, Interval plausible = {});
/// Any other kind, named in words.
KeyInfo plain(std::string name, std::string type, std::string help, std::string example = {});
KeyInfo whole(std::string name, double low, double high, std::string help, std::string example);
KeyInfo choice(std::string name, std::vector<std::string> choices, std::string help);
KeyInfo flag(std::string name, std::string help);

/// The same key, required.
KeyInfo needed(KeyInfo info);
/// The same key with words in place of its default.
KeyInfo noted(KeyInfo info, std::string note);

/// Names of the laws of a variant, in its order.
template <class Variant, std::size_t... I>
std::vector<std::string> law_names(std::index_sequence<I...>) {
  return {std::string(std::variant_alternative_t<I, Variant>::name)...};
}

/// The law at a place of a variant, with its defaults.
template <class Variant, std::size_t... I>
Variant law_at(std::size_t index, std::index_sequence<I...>) {
  Variant law;
  ((I == index ? static_cast<void>(law.template emplace<I>()) : static_cast<void>(0)), ...);
  return law;
}

/// Key that names one law of a variant; a law listed there can be named.
template <class T, class Variant, class Member>
Field<T> bind_law(std::string name, std::string help, Member member) {
  using Laws = std::make_index_sequence<std::variant_size_v<Variant>>;
  const KeyInfo info = choice(std::move(name), law_names<Variant>(Laws{}), std::move(help));
  Field<T> field;
  field.info = info;
  field.read = [info, member](const TomlValue& value, Problems& problems, T& t) {
    if (const auto index = read_choice(value, info, problems))
      std::invoke(member, t) = law_at<Variant>(static_cast<std::size_t>(*index), Laws{});
  };
  field.write = [info, member](const T& t) { return toml_text(info.choices[std::invoke(member, t).index()]); };
  return field;
}

}  // namespace puadem
