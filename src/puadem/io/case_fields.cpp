#include "puadem/io/case_fields.hpp"

#include <fmt/format.h>

#include <cmath>

#include "puadem/base/error.hpp"
#include "puadem/base/parallel.hpp"
#include "puadem/geometry/domain.hpp"
#include "puadem/io/units.hpp"

namespace puadem {

namespace {

using Kind = TomlValue::Kind;

/// "> 0 Pa" in front of a verb; nothing where everything is allowed.
std::string allowed_text(const KeyInfo& info) {
  std::string text = text_of(info.allowed, info.unit);
  if (!info.word_for_infinity.empty()) text += fmt::format("{}\"{}\"", text.empty() ? "" : " or ", info.word_for_infinity);
  return text;
}

std::string such_as(const KeyInfo& info) { return info.example.empty() ? "" : ", such as " + info.example; }

/// The same for one value of a list: the first text of the example.
std::string such_as_one(const KeyInfo& info) {
  const std::size_t begin = info.example.find('"');
  const std::size_t end = begin == std::string::npos ? begin : info.example.find('"', begin + 1);
  return end == std::string::npos ? std::string() : ", such as " + info.example.substr(begin, end - begin + 1);
}

void wrong_kind(const TomlValue& value, const KeyInfo& info, Problems& problems) {
  problems.error(value.place, fmt::format("{} must be {}{}, not {}", problems.key, info.type, such_as(info), short_text(value)));
}

/// Place inside a text value, if the text stands in its line as it is.
Place place_inside(const TomlValue& value, std::size_t offset, const Problems& problems) {
  Place place = value.place;
  const std::string_view line = line_of(problems.sources[to_size(place.source)].text, place.line);
  const std::size_t quote = line.find(value.text, 0);
  if (value.text.empty() || quote == std::string_view::npos) return place;
  const int opening = characters(line.substr(0, quote));
  // The text begins at the place itself (an override without quotes) or behind one quote.
  if (opening + 1 != place.column && opening != place.column) return place;
  place.column = opening + 1 + characters(std::string_view(value.text).substr(0, offset));
  return place;
}

/// Number of a value in SI units, its dimension checked but not its range.
std::optional<double> number_of(const TomlValue& value, const KeyInfo& info, Problems& problems) {
  if (value.kind == Kind::integer || value.kind == Kind::number) return value.number;
  if (value.kind != Kind::text) {
    wrong_kind(value, info, problems);
    return std::nullopt;
  }
  try {
    const Quantity quantity = parse_quantity(value.text);
    const Dimension dimension = dimension_of(info.unit);
    if (!quantity.has_unit || quantity.dimension == dimension) return quantity.value;
    problems.error(value.place, fmt::format("{} = {} is {}; {} is needed{}", problems.key, short_text(value),
                                            describe(quantity.dimension), describe(dimension), such_as_one(info)));
  } catch (const UnitError& error) {
    std::string message = fmt::format("{} = {}: {}", problems.key, short_text(value), error.what());
    if (message.ends_with("was expected")) message += such_as_one(info);
    if (!info.word_for_infinity.empty()) message += fmt::format("; or write \"{}\"", info.word_for_infinity);
    problems.error(place_inside(value, error.offset, problems), message);
  }
  return std::nullopt;
}

std::optional<double> checked_number(const TomlValue& value, const KeyInfo& info, Problems& problems) {
  if (!info.word_for_infinity.empty() && value.kind == Kind::text && value.text == info.word_for_infinity)
    return std::numeric_limits<double>::infinity();
  const auto number = number_of(value, info, problems);
  if (!number) return std::nullopt;
  if (!std::isfinite(*number)) {
    problems.error(value.place, fmt::format("{} = {} is not a finite number; allowed: {}", problems.key, short_text(value),
                                            allowed_text(info)));
    return std::nullopt;
  }
  if (!info.allowed.contains(*number)) {
    std::string message =
        fmt::format("{} = {} is out of range; allowed: {}", problems.key, short_text(value), allowed_text(info));
    if (info.unit == "rad" && value.kind != Kind::text) message += "; a bare number is in radians, write \"30 deg\"";
    problems.error(value.place, message);
    return std::nullopt;
  }
  if (*number != 0.0 && !info.plausible.contains(*number))
    problems.warning(value.place, fmt::format("{} = {} is unusual (usual: {}); is the unit right?", problems.key,
                                              show(*number, info.unit), text_of(info.plausible, info.unit)));
  return number;
}

bool expect_list(const TomlValue& value, const KeyInfo& info, Problems& problems) {
  if (value.kind != Kind::array) wrong_kind(value, info, problems);
  return value.kind == Kind::array;
}

}  // namespace

std::string text_of(const Interval& interval, std::string_view unit) {
  const bool has_low = std::isfinite(interval.low), has_high = std::isfinite(interval.high);
  if (has_low && has_high) {
    std::string text = fmt::format("{} to {}", show(interval.low, unit), show(interval.high, unit));
    if (interval.low_open && interval.high_open) return text + ", both excluded";
    if (interval.high_open) return text + ", the upper excluded";
    if (interval.low_open) return text + ", the lower excluded";
    return text;
  }
  if (has_low) return fmt::format("{} {}", interval.low_open ? ">" : ">=", show(interval.low, unit));
  if (has_high) return fmt::format("{} {}", interval.high_open ? "<" : "<=", show(interval.high, unit));
  return {};
}

void Problems::error(const Place& place, std::string_view message) {
  errors.push_back({place, key, located(sources[to_size(place.source)], place, message)});
}

void Problems::warning(const Place& place, std::string_view message) {
  warnings.push_back({place, key, located(sources[to_size(place.source)], place, message)});
}

void read_value(const TomlValue& value, const KeyInfo& info, Problems& problems, double& out) {
  if (const auto number = checked_number(value, info, problems)) out = *number;
}

void read_value(const TomlValue& value, const KeyInfo& info, Problems& problems, std::uint64_t& out) {
  if (value.kind != Kind::integer) return wrong_kind(value, info, problems);
  if (!info.allowed.contains(value.number)) {
    problems.error(value.place,
                   fmt::format("{} = {} is out of range; allowed: {}", problems.key, value.integer, allowed_text(info)));
    return;
  }
  out = static_cast<std::uint64_t>(value.integer);
}

void read_value(const TomlValue& value, const KeyInfo& info, Problems& problems, int& out) {
  std::uint64_t wide = 0;
  const std::size_t before = problems.errors.size();
  read_value(value, info, problems, wide);
  if (problems.errors.size() == before) out = static_cast<int>(wide);
}

void read_value(const TomlValue& value, const KeyInfo& info, Problems& problems, bool& out) {
  if (value.kind != Kind::boolean) return wrong_kind(value, info, problems);
  out = value.boolean;
}

void read_value(const TomlValue& value, const KeyInfo& info, Problems& problems, std::string& out) {
  if (value.kind != Kind::text) return wrong_kind(value, info, problems);
  if (value.text.empty()) return problems.error(value.place, problems.key + " is empty");
  out = value.text;
}

void read_value(const TomlValue& value, const KeyInfo& info, Problems& problems, std::filesystem::path& out) {
  std::string text;
  read_value(value, info, problems, text);
  if (!text.empty()) out = std::filesystem::absolute(problems.folder / text).lexically_normal();
}

void read_value(const TomlValue& value, const KeyInfo& info, Problems& problems, Vec3& out) {
  if (!expect_list(value, info, problems)) return;
  if (value.children.size() != 3) {
    problems.error(value.place, fmt::format("{} must have three values (x, y, z), not {}", problems.key, value.children.size()));
    return;
  }
  for (int axis = 0; axis < 3; ++axis)
    if (const auto number = checked_number(value.children[to_size(axis)], info, problems)) out[axis] = *number;
}

void read_value(const TomlValue& value, const KeyInfo& info, Problems& problems, std::vector<double>& out) {
  if (!expect_list(value, info, problems)) return;
  out.clear();
  for (const TomlValue& child : value.children)
    if (const auto number = checked_number(child, info, problems)) out.push_back(*number);
}

void read_value(const TomlValue& value, const KeyInfo& info, Problems& problems, std::array<bool, 3>& out) {
  if (!expect_list(value, info, problems)) return;
  out = {};
  for (const TomlValue& child : value.children)
    if (const auto index = read_choice(child, info, problems)) out[to_size(*index)] = true;
}

void read_value(const TomlValue& value, const KeyInfo& info, Problems& problems, std::array<bool, 6>& out) {
  if (!expect_list(value, info, problems)) return;
  out = {};
  for (const TomlValue& child : value.children)
    if (const auto face = read_face(child, info, problems)) out[to_size(*face)] = true;
}

std::optional<int> read_choice(const TomlValue& value, const KeyInfo& info, Problems& problems) {
  if (value.kind != Kind::text) {
    problems.error(value.place,
                   fmt::format("{} must be one of {}, not {}", problems.key, joined(info.choices), short_text(value)));
    return std::nullopt;
  }
  for (int i = 0; i < size_of(info.choices); ++i)
    if (info.choices[to_size(i)] == value.text) return i;
  problems.error(value.place, fmt::format("{} = {} is not known; allowed: {}{}", problems.key, short_text(value),
                                          joined(info.choices), did_you_mean(value.text, info.choices)));
  return std::nullopt;
}

std::optional<int> read_face(const TomlValue& value, const KeyInfo& info, Problems& problems) {
  static constexpr std::array<std::string_view, 6> by_axis{"x-", "x+", "y-", "y+", "z-", "z+"};
  for (int face = 0; face < 6; ++face)
    if (value.kind == Kind::text && value.text == by_axis[to_size(face)]) return face;
  return read_choice(value, info, problems);
}

std::string toml_text(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) {
    const unsigned code = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\')
      quoted += fmt::format("\\{}", c);
    else if (code < 0x20U || code == 0x7FU)
      quoted += fmt::format("\\u{:04X}", code);
    else
      quoted += c;
  }
  return quoted + "\"";
}

std::string toml_key(std::string_view name) {
  const bool bare = !name.empty() && std::ranges::all_of(name, [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  });
  return bare ? std::string(name) : toml_text(name);
}

std::string write_value(const KeyInfo& info, double value) {
  if (std::isinf(value) && !info.word_for_infinity.empty()) return toml_text(info.word_for_infinity);
  return fmt::format("{}", value);
}
std::string write_value(const KeyInfo&, int value) { return std::to_string(value); }
std::string write_value(const KeyInfo&, std::uint64_t value) { return std::to_string(value); }
std::string write_value(const KeyInfo&, bool value) { return value ? "true" : "false"; }
std::string write_value(const KeyInfo&, const std::string& value) { return value.empty() ? std::string() : toml_text(value); }
std::string write_value(const KeyInfo&, const std::filesystem::path& value) {
  return value.empty() ? std::string() : toml_text(value.string());
}
std::string write_value(const KeyInfo&, const Vec3& value) { return fmt::format("[{}, {}, {}]", value.x, value.y, value.z); }
std::string write_value(const KeyInfo&, const std::vector<double>& value) { return fmt::format("[{}]", fmt::join(value, ", ")); }

namespace {

std::string write_chosen(const KeyInfo& info, std::span<const bool> value) {
  std::vector<std::string> chosen;
  for (std::size_t k = 0; k < value.size(); ++k)
    if (value[k]) chosen.push_back(toml_text(info.choices[k]));
  return fmt::format("[{}]", joined(chosen));
}

}  // namespace

std::string write_value(const KeyInfo& info, const std::array<bool, 3>& value) { return write_chosen(info, value); }
std::string write_value(const KeyInfo& info, const std::array<bool, 6>& value) { return write_chosen(info, value); }

void report_unknown_key(const TomlValue& entry, std::span<const std::string> known, Problems& problems) {
  const std::string suggestion = did_you_mean(entry.key, known);
  problems.error(entry.key_place, fmt::format("unknown key {}{}", problems.key,
                                              suggestion.empty() ? "; allowed here: " + joined(known) : suggestion));
}

void report_missing_key(const TomlValue& table, const KeyInfo& info, Problems& problems) {
  const std::string full = problems.key.empty() ? info.name : problems.key + "." + info.name;
  problems.error(table.place, fmt::format("missing key {}: {}{}", full, info.help,
                                          info.example.empty() ? "" : fmt::format("; write {} = {}", info.name, info.example)));
}

bool expect_table(const TomlValue& value, Problems& problems) {
  if (value.kind == Kind::table) return true;
  problems.error(value.place, fmt::format("{} must be a table, not {}", problems.key, short_text(value)));
  return false;
}

KeyDoc describe_key(const std::string& path, const KeyInfo& info, const std::string& default_value) {
  KeyDoc doc{path, info.type, info.unit, allowed_text(info), default_value, info.example, info.help, info.required};
  if (!info.choices.empty()) doc.allowed = joined(info.choices);
  // Bare SI numbers as a person would write them.
  if (!info.unit.empty() && default_value.find_first_not_of("+-.0123456789e") == std::string::npos && !default_value.empty())
    doc.default_value = show(std::stod(default_value), info.unit, 6);
  if (!info.default_note.empty()) doc.default_value = info.default_note;
  return doc;
}

}  // namespace puadem
