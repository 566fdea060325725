#include "puadem/io/toml_tree.hpp"

// Wrong files must end in an error, never in an assertion of the parser.
#define TOML_ASSERT(expression) static_assert(true)
#define TOML_HEADER_ONLY 1
#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <charconv>

#include "puadem/base/error.hpp"
#include "puadem/base/parallel.hpp"

namespace puadem {

namespace {

using Kind = TomlValue::Kind;

Place place_from(const toml::source_position& position, int source) {
  return {source, std::max(1, static_cast<int>(position.line)), std::max(1, static_cast<int>(position.column))};
}

void sort_by_place(std::vector<TomlValue>& entries) {
  std::ranges::stable_sort(entries, [](const TomlValue& a, const TomlValue& b) { return a.key_place < b.key_place; });
}

TomlValue converted(const toml::node& node, int source) {
  TomlValue value;
  value.place = place_from(node.source().begin, source);
  if (const auto* table = node.as_table()) {
    value.kind = Kind::table;
    for (const auto& [key, child] : *table) {
      value.children.push_back(converted(child, source));
      value.children.back().key = std::string(key.str());
      value.children.back().key_place = place_from(key.source().begin, source);
    }
    sort_by_place(value.children);
  } else if (const auto* array = node.as_array()) {
    value.kind = Kind::array;
    for (const auto& child : *array) value.children.push_back(converted(child, source));
  } else if (const auto* text = node.as_string()) {
    value.kind = Kind::text;
    value.text = text->get();
  } else if (const auto* integer = node.as_integer()) {
    value.kind = Kind::integer;
    value.integer = integer->get();
    value.number = static_cast<double>(integer->get());
  } else if (const auto* number = node.as_floating_point()) {
    value.kind = Kind::number;
    value.number = number->get();
  } else if (const auto* boolean = node.as_boolean()) {
    value.kind = Kind::boolean;
    value.boolean = boolean->get();
  } else {
    value.kind = Kind::date;
  }
  return value;
}

/// Gives a tree the place of the option it came from.
void move_to(const Place& place, TomlValue& value) {
  value.place = value.key_place = place;
  for (TomlValue& child : value.children) move_to(place, child);
}

TomlValue parsed_value(std::string_view text) {
  try {
    const toml::table table = toml::parse(fmt::format("value = {}\n", text));
    if (table.size() == 1 && table.contains("value")) return converted(*table.get("value"), 0);
  } catch (const toml::parse_error&) {
    // No TOML: a plain text, as a shell leaves it.
  }
  TomlValue value;
  value.kind = Kind::text;
  value.text = std::string(text);
  return value;
}

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t");
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t") - begin + 1);
}

/// The entry that one part of a dotted key names, made where it is missing in a table.
TomlValue& descend(TomlValue& parent, std::string_view part, const SourceText& source, const Place& place) {
  require(!part.empty(), "{}", located(source, place, "an empty part in a dotted key; write --set table.key=value"));
  if (parent.kind == Kind::array) {
    int index = -1;
    const auto [end, failed] = std::from_chars(part.data(), part.data() + part.size(), index);
    const bool whole = failed == std::errc() && end == part.data() + part.size();
    require(whole && index >= 0 && index < size_of(parent.children), "{}",
            located(source, place,
                    fmt::format("\"{}\" is no index of this list of {}; indices count from 0", part, parent.children.size())));
    return parent.children[to_size(index)];
  }
  require(parent.kind == Kind::table, "{}",
          located(source, place, fmt::format("\"{}\" lies inside {}, which has no keys", part, kind_name(parent.kind))));
  if (TomlValue* found = parent.find(part)) return *found;
  TomlValue& made = parent.children.emplace_back();
  made.key = std::string(part);
  made.place = made.key_place = place;
  return made;
}

}  // namespace

const TomlValue* TomlValue::find(std::string_view name) const {
  const auto found = std::ranges::find_if(children, [&](const TomlValue& child) { return child.key == name; });
  return kind == Kind::table && found != children.end() ? &*found : nullptr;
}

TomlValue* TomlValue::find(std::string_view name) {
  const auto found = std::ranges::find_if(children, [&](const TomlValue& child) { return child.key == name; });
  return kind == Kind::table && found != children.end() ? &*found : nullptr;
}

std::string_view kind_name(Kind kind) {
  switch (kind) {
    case Kind::text:
      return "a text";
    case Kind::integer:
      return "a whole number";
    case Kind::number:
      return "a number";
    case Kind::boolean:
      return "true or false";
    case Kind::date:
      return "a date or time";
    case Kind::array:
      return "a list";
    case Kind::table:
      return "a table";
  }
  return "a value";
}

std::string short_text(const TomlValue& value) {
  switch (value.kind) {
    case Kind::text: {
      std::string text = value.text.substr(0, 40);
      while (first_invalid_utf8(text)) text.pop_back();
      std::ranges::replace_if(
          text, [](char c) { return static_cast<unsigned char>(c) < 0x20U; }, ' ');
      return fmt::format("\"{}{}\"", text, text.size() < value.text.size() ? "..." : "");
    }
    case Kind::integer:
      return std::to_string(value.integer);
    case Kind::number: {
      const std::string text = fmt::format("{}", value.number);
      return text.find_first_not_of("-0123456789") == std::string::npos ? text + ".0" : text;
    }
    case Kind::boolean:
      return value.boolean ? "true" : "false";
    case Kind::array:
      return fmt::format("a list of {}", value.children.size());
    default:
      return std::string(kind_name(value.kind));
  }
}

TomlValue parse_toml(const SourceText& source, int index) {
  try {
    return converted(toml::parse(source.text), index);
  } catch (const toml::parse_error& error) {
    const Place place = place_from(error.source().begin, index);
    std::string message = fmt::format("not valid TOML: {}", error.description());
    if (message.find("end-of-file") != std::string::npos) message += "; the file seems to end too early";
    throw InputError(located(source, place, message));
  }
}

void apply_override(const SourceText& assignment, int source, TomlValue& tree) {
  const std::string_view text = assignment.text;
  const std::size_t equals = text.find('=');
  require(equals != std::string_view::npos && equals > 0, "{}",
          located(assignment, {source, 1, 1}, "write --set key=value, such as --set grains.count=500"));

  TomlValue* target = &tree;
  const std::string_view key = text.substr(0, equals);
  for (std::size_t begin = 0;;) {
    const std::size_t end = std::min(key.find('.', begin), key.size());
    Place place = place_of(text, begin);
    place.source = source;
    target = &descend(*target, trimmed(key.substr(begin, end - begin)), assignment, place);
    if (end == key.size()) break;
    begin = end + 1;
  }
  const std::string name = target->key;
  *target = parsed_value(trimmed(text.substr(equals + 1)));
  Place place = place_of(text, equals + 1);
  place.source = source;
  move_to(place, *target);
  target->key = name;
  target->key_place = {source, 1, 1};
}

}  // namespace puadem
