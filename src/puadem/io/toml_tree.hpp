#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "puadem/io/text.hpp"

namespace puadem {

/// A value of a TOML document with the place it was written at.
struct TomlValue {
  enum class Kind { text, integer, number, boolean, date, array, table };
  Kind kind = Kind::table;
  Place place;      ///< of the value
  std::string key;  ///< in a table
  Place key_place;
  std::string text;                 ///< Kind::text
  std::int64_t integer = 0;         ///< Kind::integer
  double number = 0.0;              ///< Kind::integer and Kind::number
  bool boolean = false;             ///< Kind::boolean
  std::vector<TomlValue> children;  ///< of an array in order, of a table in order of the text

  /// Entry of a table; null where it has none.
  const TomlValue* find(std::string_view name) const;
  TomlValue* find(std::string_view name);
};

/// "a text", "a list", ...
std::string_view kind_name(TomlValue::Kind kind);

/// The value as it would be written, shortened for a message.
std::string short_text(const TomlValue& value);

/// A TOML document as a tree.
/// @param source  index that its places carry
/// @throws InputError  with place and caret for a text that is not TOML
TomlValue parse_toml(const SourceText& text, int source);

/// Puts `key=value` into a tree, as the option `--set` does: dotted key, arrays by index from 0, a value
/// in TOML or else a plain text ("stage.0.stress=5 kPa"). Tables on the way are made.
/// @throws InputError  with a caret for a text that is no assignment or an index outside its array
void apply_override(const SourceText& assignment, int source, TomlValue& tree);

}  // namespace puadem
