#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "puadem/base/vec3.hpp"
#include "puadem/io/toml_tree.hpp"

namespace puadem {

/// Values allowed for a number. In SI units.
struct Interval {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool low_open = false;
  bool high_open = false;

  bool contains(double x) const { return (low_open ? x > low : x >= low) && (high_open ? x < high : x <= high); }
};

constexpr Interval above(double low) { return {low, std::numeric_limits<double>::infinity(), true, false}; }
constexpr Interval at_least(double low) { return {low, std::numeric_limits<double>::infinity(), false, false}; }
constexpr Interval between(double low, double high) { return {low, high, false, false}; }
constexpr Interval inside(double low, double high) { return {low, high, true, true}; }

/// "> 0 Pa", "0 to 1".
std::string text_of(const Interval& interval, std::string_view unit);

/// What is known of a key besides where it is stored.
struct KeyInfo {
  std::string name;
  std::string type;  ///< in words: "pressure or stress", "whole number", "list of ..."
  std::string unit;  ///< SI unit of a quantity; empty for anything else
  Interval allowed;
  Interval plausible;  ///< outside: a warning
  std::vector<std::string> choices;
  std::string word_for_infinity;  ///< "none" where an infinite value has a name
  bool required = false;
  std::string example;       ///< as written in a file
  std::string default_note;  ///< in place of the default where that is not one value
  std::string help;
};

/// Everything that is wrong or odd in a case, in the order found.
struct Problems {
  struct Entry {
    Place place;
    std::string key;      ///< that was being read
    std::string message;  ///< with excerpt and caret
  };
  std::vector<SourceText> sources;  ///< the file first, then the overrides
  std::filesystem::path folder;     ///< of the case file: paths in it are relative to this
  std::vector<Entry> errors, warnings;
  std::string key;  ///< full name of the key that is being read

  void error(const Place& place, std::string_view message);
  void warning(const Place& place, std::string_view message);
};

/// One line of the documentation of keys.
struct KeyDoc {
  std::string path, type, unit, allowed, default_value, example, help;
  bool required = false;
};

// Readers: store a value if it is what the key wants, or report what is wrong.
void read_value(const TomlValue& value, const KeyInfo& info, Problems& problems, double& out);
void read_value(const TomlValue& value, const KeyInfo& info, Problems& problems, int& out);
void read_value(const TomlValue& value, const KeyInfo& info, Problems& problems, std::uint64_t& out);
void read_value(const TomlValue& value, const KeyInfo& info, Problems& problems, bool& out);
void read_value(const TomlValue& value, const KeyInfo& info, Problems& problems, std::string& out);
void read_value(const TomlValue& value, const KeyInfo& info, Problems& problems, std::filesystem::path& out);
void read_value(const TomlValue& value, const KeyInfo& info, Problems& problems, Vec3& out);
void read_value(const TomlValue& value, const KeyInfo& info, Problems& problems, std::vector<double>& out);
void read_value(const TomlValue& value, const KeyInfo& info, Problems& problems, std::array<bool, 3>& out);
void read_value(const TomlValue& value, const KeyInfo& info, Problems& problems, std::array<bool, 6>& out);  ///< faces
template <class X>
void read_value(const TomlValue& value, const KeyInfo& info, Problems& problems, std::optional<X>& out) {
  X x{};
  const std::size_t before = problems.errors.size();
  read_value(value, info, problems, x);
  if (problems.errors.size() == before) out = x;
}

/// Index of the choice that a text names; none after an error.
std::optional<int> read_choice(const TomlValue& value, const KeyInfo& info, Problems& problems);

/// Face of the box by name ("top") or axis ("z+").
std::optional<int> read_face(const TomlValue& value, const KeyInfo& info, Problems& problems);

// Writers: the value in TOML and SI; empty: left out.
std::string toml_text(std::string_view text);
std::string toml_key(std::string_view name);  ///< with quotes only where TOML needs them
std::string write_value(const KeyInfo& info, double value);
std::string write_value(const KeyInfo& info, int value);
std::string write_value(const KeyInfo& info, std::uint64_t value);
std::string write_value(const KeyInfo& info, bool value);
std::string write_value(const KeyInfo& info, const std::string& value);
std::string write_value(const KeyInfo& info, const std::filesystem::path& value);
std::string write_value(const KeyInfo& info, const Vec3& value);
std::string write_value(const KeyInfo& info, const std::vector<double>& value);
std::string write_value(const KeyInfo& info, const std::array<bool, 3>& value);
std::string write_value(const KeyInfo& info, const std::array<bool, 6>& value);
template <class X>
std::string write_value(const KeyInfo& info, const std::optional<X>& value) {
  return value ? write_value(info, *value) : std::string();
}

/// A key of a table: how it is read, written and described.
template <class T>
struct Field {
  KeyInfo info;
  std::function<void(const TomlValue&, Problems&, T&)> read;
  std::function<std::string(const T&)> write;                                        ///< a value on one line
  std::function<std::string(const std::string& path, const T&)> write_tables = {};   ///< or tables below it
  std::function<void(const std::string& path, std::vector<KeyDoc>&)> describe = {};  ///< keys below it
};

/// A table of the case file.
template <class T>
struct Section {
  std::vector<Field<T>> fields;
};

/// Key stored by `member`, a pointer to a member or a function `T& -> X&`.
template <class T, class Member>
Field<T> bind(KeyInfo info, Member member) {
  const auto read = [info, member](const TomlValue& value, Problems& problems, T& t) {
    read_value(value, info, problems, std::invoke(member, t));
  };
  const auto write = [info, member](const T& t) { return write_value(info, std::invoke(member, t)); };
  return {std::move(info), read, write};
}

/// Key that names one value of an enumeration, in the order of `info.choices`.
template <class T, class Base, class E>
Field<T> bind_choice(KeyInfo info, E Base::*member) {
  const auto read = [info, member](const TomlValue& value, Problems& problems, T& t) {
    if (const auto index = read_choice(value, info, problems)) t.*member = static_cast<E>(*index);
  };
  const auto write = [info, member](const T& t) { return toml_text(info.choices[static_cast<std::size_t>(t.*member)]); };
  return {std::move(info), read, write};
}

std::vector<std::string> names_of_keys(const TomlValue& table);
void report_unknown_key(const TomlValue& entry, std::span<const std::string> known, Problems& problems);
void report_missing_key(const TomlValue& table, const KeyInfo& info, Problems& problems);
/// False after an error if the value is no table.
bool expect_table(const TomlValue& value, Problems& problems);
KeyDoc describe_key(const std::string& path, const KeyInfo& info, const std::string& default_value);

/// Reads a table by its section. Keys of `problems.key` stand before the names in messages.
template <class T>
void read_table(const TomlValue& table, const Section<T>& section, Problems& problems, T& out) {
  if (!expect_table(table, problems)) return;
  const std::string prefix = problems.key;
  std::vector<std::string> known;
  for (const auto& field : section.fields) known.push_back(field.info.name);
  for (const TomlValue& entry : table.children) {
    problems.key = prefix.empty() ? entry.key : prefix + "." + entry.key;
    const auto field = std::ranges::find_if(section.fields, [&](const auto& f) { return f.info.name == entry.key; });
    if (field == section.fields.end())
      report_unknown_key(entry, known, problems);
    else
      field->read(entry, problems, out);
  }
  problems.key = prefix;
  for (const auto& field : section.fields)
    if (field.info.required && !table.find(field.info.name)) report_missing_key(table, field.info, problems);
}

/// The lines of a table in TOML, without its heading; tables below it come last.
template <class T>
std::string write_table(const std::string& path, const Section<T>& section, const T& value) {
  std::string text;
  for (const auto& field : section.fields) {
    const std::string written = field.write ? field.write(value) : std::string();
    if (written.empty()) continue;
    text += field.info.name + " = " + written;
    text += field.info.unit.empty() ? "\n" : "  # " + field.info.unit + "\n";
  }
  for (const auto& field : section.fields)
    if (field.write_tables) text += field.write_tables(path.empty() ? field.info.name : path + "." + field.info.name, value);
  return text;
}

template <class T>
void describe_table(const std::string& path, const Section<T>& section, std::vector<KeyDoc>& out) {
  const T defaults{};
  for (const auto& field : section.fields) {
    const std::string full = path.empty() ? field.info.name : path + "." + field.info.name;
    if (field.describe)
      field.describe(full, out);
    else
      out.push_back(describe_key(full, field.info, field.write ? field.write(defaults) : std::string()));
  }
}

/// A table inside a table.
template <class T, class U>
Field<T> bind_table(KeyInfo info, const Section<U>& (*section)(), U T::*member) {
  Field<T> field;
  field.info = std::move(info);
  field.read = [=](const TomlValue& value, Problems& problems, T& t) { read_table(value, section(), problems, t.*member); };
  field.write_tables = [=](const std::string& path, const T& t) {
    return "\n[" + path + "]\n" + write_table(path, section(), t.*member);
  };
  field.describe = [=](const std::string& path, std::vector<KeyDoc>& out) { describe_table(path, section(), out); };
  return field;
}

/// A table inside a table that may be absent.
template <class T, class U>
Field<T> bind_table(KeyInfo info, const Section<U>& (*section)(), std::optional<U> T::*member) {
  Field<T> field;
  field.info = std::move(info);
  field.read = [=](const TomlValue& value, Problems& problems, T& t) {
    read_table(value, section(), problems, (t.*member).emplace());
  };
  field.write_tables = [=](const std::string& path, const T& t) {
    return t.*member ? "\n[" + path + "]\n" + write_table(path, section(), *(t.*member)) : std::string();
  };
  field.describe = [=](const std::string& path, std::vector<KeyDoc>& out) { describe_table(path, section(), out); };
  return field;
}

/// A list of tables.
template <class T, class U>
Field<T> bind_tables(KeyInfo info, const Section<U>& (*section)(), std::vector<U> T::*member) {
  Field<T> field;
  field.info = info;
  field.read = [=](const TomlValue& value, Problems& problems, T& t) {
    if (value.kind != TomlValue::Kind::array) {
      problems.error(value.place, problems.key + " must be a list of tables, not " + short_text(value));
      return;
    }
    const std::string prefix = problems.key;
    for (std::size_t i = 0; i < value.children.size(); ++i) {
      problems.key = prefix + "." + std::to_string(i);
      read_table(value.children[i], section(), problems, (t.*member).emplace_back());
    }
    problems.key = prefix;
  };
  field.write_tables = [=](const std::string& path, const T& t) {
    std::string text;
    for (const U& u : t.*member) text += "\n[[" + path + "]]\n" + write_table(path, section(), u);
    return text;
  };
  field.describe = [=](const std::string& path, std::vector<KeyDoc>& out) { describe_table(path + "[]", section(), out); };
  return field;
}

}  // namespace puadem
