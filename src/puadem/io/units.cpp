#include "puadem/io/units.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "puadem/base/parallel.hpp"
#include "puadem/io/text.hpp"

namespace puadem {

namespace {

constexpr double degree = std::numbers::pi / 180.0;

/// A unit is factor * 10^exponent of the SI unit of its dimension.
struct Unit {
  double factor = 1.0;
  int exponent = 0;
  Dimension dimension;
};

struct NamedUnit {
  std::string_view symbol;
  Unit unit;
  bool takes_prefix;
};

constexpr Dimension length{1, 0, 0, 0, 0}, mass{0, 1, 0, 0, 0}, duration{0, 0, 1, 0, 0}, angle{0, 0, 0, 0, 1};
constexpr Dimension newton{1, 1, -2, 0, 0}, pascal{-1, 1, -2, 0, 0}, joule{2, 1, -2, 0, 0}, watt{2, 1, -3, 0, 0};

constexpr std::array<NamedUnit, 26> named_units{{
    {"m", {1, 0, length}, true},
    {"g", {1, -3, mass}, true},
    {"s", {1, 0, duration}, true},
    {"N", {1, 0, newton}, true},
    {"Pa", {1, 0, pascal}, true},
    {"J", {1, 0, joule}, true},
    {"W", {1, 0, watt}, true},
    {"K", {1, 0, {0, 0, 0, 1, 0}}, true},
    {"Hz", {1, 0, {0, 0, -1, 0, 0}}, true},
    {"L", {1, -3, {3, 0, 0, 0, 0}}, true},
    {"l", {1, -3, {3, 0, 0, 0, 0}}, true},
    {"bar", {1, 5, pascal}, true},
    {"P", {1, -1, {-1, 1, -1, 0, 0}}, true},
    {"rad", {1, 0, angle}, true},
    {"deg", {degree, 0, angle}, false},
    {"\xC2\xB0", {degree, 0, angle}, false},
    {"t", {1, 3, mass}, false},
    {"min", {60, 0, duration}, false},
    {"h", {3600, 0, duration}, false},
    {"d", {86400, 0, duration}, false},
    {"dyn", {1, -5, newton}, false},
    {"atm", {101325, 0, pascal}, false},
    {"psi", {6894.757293168361, 0, pascal}, false},
    {"%", {1, -2, {}}, false},
    {"1", {1, 0, {}}, false},
    {"-", {1, 0, {}}, false},
}};

struct Prefix {
  std::string_view symbol;
  int exponent;
};

constexpr std::array<Prefix, 12> prefixes{{{"n", -9},
                                           {"u", -6},
                                           {"\xC2\xB5", -6},
                                           {"\xCE\xBC", -6},
                                           {"m", -3},
                                           {"c", -2},
                                           {"d", -1},
                                           {"h", 2},
                                           {"k", 3},
                                           {"M", 6},
                                           {"G", 9},
                                           {"T", 12}}};

std::optional<Unit> find_unit(std::string_view symbol) {
  for (const NamedUnit& named : named_units)
    if (named.symbol == symbol) return named.unit;
  for (const Prefix& prefix : prefixes) {
    if (!symbol.starts_with(prefix.symbol)) continue;
    for (const NamedUnit& named : named_units)
      if (named.takes_prefix && named.symbol == symbol.substr(prefix.symbol.size())) {
        Unit unit = named.unit;
        unit.exponent += prefix.exponent;
        return unit;
      }
  }
  return std::nullopt;
}

std::vector<std::string> common_units() {
  return {"m",    "mm",  "um",  "cm",  "km",   "m2",   "m3",   "s",    "ms",    "min",   "h",  "Pa", "kPa", "MPa",   "GPa",
          "hPa",  "bar", "N",   "mN",  "kN",   "N/m",  "mN/m", "Pa s", "mPa s", "uPa s", "kg", "g",  "mg",  "kg/m3", "g/cm3",
          "t/m3", "deg", "rad", "m/s", "mm/s", "m2/s", "J",    "W",    "K",     "L",     "mL", "cP", "%"};
}

Unit raised(const Unit& unit, int power) {
  Unit result;
  result.factor = std::pow(unit.factor, power);
  result.exponent = unit.exponent * power;
  const Dimension& d = unit.dimension;
  result.dimension = {d.length * power, d.mass * power, d.time * power, d.temperature * power, d.angle * power};
  return result;
}

Unit product(const Unit& a, const Unit& b) {
  const Dimension &x = a.dimension, &y = b.dimension;
  return {a.factor * b.factor,
          a.exponent + b.exponent,
          {x.length + y.length, x.mass + y.mass, x.time + y.time, x.temperature + y.temperature, x.angle + y.angle}};
}

/// Recursive descent:  unit = product ['/' factor];  product = factor {separator factor};
/// factor = (symbol | '(' unit ')') [power].
class UnitParser {
 public:
  UnitParser(std::string_view text, std::size_t begin) : text_(text), at_(begin) {}

  Unit whole() {
    const Unit unit = expression(0);
    skip_spaces();
    if (at_ < text_.size()) fail(peek(")") ? "')' without '('" : "unexpected character in a unit", at_, 1);
    return unit;
  }

 private:
  std::string_view text_;
  std::size_t at_;

  [[noreturn]] void fail(const std::string& message, std::size_t offset, std::size_t bytes) const {
    throw UnitError(message, offset, bytes);
  }
  bool peek(std::string_view token) const { return text_.substr(at_).starts_with(token); }
  bool take(std::string_view token) {
    if (!peek(token)) return false;
    at_ += token.size();
    return true;
  }
  void skip_spaces() {
    while (take(" ") || take("\t")) {
    }
  }
  bool at_end() {
    skip_spaces();
    return at_ >= text_.size() || peek(")");
  }

  Unit expression(int depth) {
    Unit unit = factor(depth);
    while (!at_end() && !peek("/")) {
      if (!take("*")) take("\xC2\xB7");
      unit = product(unit, factor(depth));
    }
    if (at_end()) return unit;
    take("/");
    unit = product(unit, raised(factor(depth), -1));
    if (!at_end()) fail("what is divided is not clear after '/'; write parentheses, such as N/(m s)", at_, 1);
    return unit;
  }

  Unit factor(int depth) {
    skip_spaces();
    const std::size_t begin = at_;
    if (take("(")) {
      if (depth > 8) fail("too many parentheses in a unit", begin, 1);
      const Unit inner = expression(depth + 1);
      if (!take(")")) fail("'(' without ')'", begin, 1);
      return raised(inner, power());
    }
    while (at_ < text_.size() && is_letter(text_[at_])) ++at_;
    if (at_ == begin && (peek("%") || peek("1"))) ++at_;
    // Superscripts are not part of the symbol.
    std::string_view symbol = text_.substr(begin, at_ - begin);
    for (const std::string_view mark : {"\xC2\xB2", "\xC2\xB3", "\xC2\xB9", "\xC2\xB7", "\xE2\x81"})
      symbol = symbol.substr(0, symbol.find(mark));
    at_ = begin + symbol.size();
    if (symbol.empty()) fail(at_ < text_.size() ? "a unit was expected here" : "a unit is missing at the end", begin, 1);
    const auto unit = find_unit(symbol);
    if (!unit) fail(fmt::format("unknown unit \"{}\"{}", symbol, did_you_mean(symbol, common_units())), begin, symbol.size());
    return raised(*unit, power());
  }

  static bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || static_cast<unsigned char>(c) >= 0x80U;
  }

  int power() {
    const std::size_t begin = at_;
    if (take("\xC2\xB2")) return 2;
    if (take("\xC2\xB3")) return 3;
    if (take("\xE2\x81\xBB\xC2\xB9")) return -1;
    if (take("\xE2\x81\xBB\xC2\xB2")) return -2;
    if (take("\xE2\x81\xBB\xC2\xB3")) return -3;
    const bool marked = take("^") || take("**");
    const bool negative = take("-");
    if (!negative && marked) take("+");
    int value = 0;
    const std::size_t digits = at_;
    while (at_ < text_.size() && text_[at_] >= '0' && text_[at_] <= '9' && value < 100) value = 10 * value + (text_[at_++] - '0');
    if (at_ == digits) {
      if (marked || negative) fail("a whole power is missing", begin, 1);
      return 1;
    }
    if (value > 9) fail("a power beyond 9 in a unit", digits, at_ - digits);
    return negative ? -value : value;
  }
};

/// Bytes of the number at the start of a text: sign, digits, point, exponent.
std::size_t number_length(std::string_view text) {
  std::size_t i = 0;
  const auto digits = [&] {
    const std::size_t begin = i;
    while (i < text.size() && text[i] >= '0' && text[i] <= '9') ++i;
    return i > begin;
  };
  if (i < text.size() && (text[i] == '+' || text[i] == '-')) ++i;
  bool any = digits();
  if (i < text.size() && text[i] == '.') {
    ++i;
    any = digits() || any;
  }
  if (!any) return 0;
  const std::size_t mantissa = i;
  if (i < text.size() && (text[i] == 'e' || text[i] == 'E')) {
    ++i;
    if (i < text.size() && (text[i] == '+' || text[i] == '-')) ++i;
    if (!digits()) i = mantissa;
  }
  return i;
}

/// number * 10^exponent, rounded once.
double scaled_number(std::string_view number, int exponent, std::size_t begin) {
  if (number.starts_with('+')) number.remove_prefix(1);
  const std::size_t mark = number.find_first_of("eE");
  std::string digits(number.substr(0, mark));
  if (mark != std::string_view::npos) {
    int own = 0;
    std::string_view text = number.substr(mark + 1);
    if (text.starts_with('+')) text.remove_prefix(1);
    const auto [end, failed] = std::from_chars(text.data(), text.data() + text.size(), own);
    if (failed != std::errc() || std::abs(own) > 400) throw UnitError("a number out of range", begin, number.size());
    exponent += own;
  }
  digits += fmt::format("e{}", exponent);
  double value = 0.0;
  const auto [end, failed] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (failed != std::errc() || !std::isfinite(value)) throw UnitError("a number out of range", begin, number.size());
  return value;
}

/// Rounded to significant digits, with an exponent only where the number is far from 1.
std::string rounded(double value, int digits) {
  if (!std::isfinite(value)) return fmt::format("{}", value);
  return fmt::format("{}", std::stod(fmt::format("{:.{}e}", value, digits - 1)));
}

}  // namespace

Quantity parse_quantity(std::string_view text) {
  std::size_t begin = 0;
  while (begin < text.size() && (text[begin] == ' ' || text[begin] == '\t')) ++begin;
  std::size_t last = text.size();
  while (last > begin && (text[last - 1] == ' ' || text[last - 1] == '\t')) --last;
  const std::string_view trimmed = text.substr(0, last);

  const std::string_view rest = trimmed.substr(begin);
  if (rest.empty()) throw UnitError("an empty text where a number with a unit was expected", 0, 1);
  const std::size_t count = number_length(rest);
  if (count == 0) throw UnitError("a number with a unit was expected", begin, rest.size());
  if (rest.substr(count).starts_with(',')) throw UnitError("a comma in a number; write a decimal point", begin + count, 1);

  std::size_t unit_begin = begin + count;
  while (unit_begin < trimmed.size() && (trimmed[unit_begin] == ' ' || trimmed[unit_begin] == '\t')) ++unit_begin;
  if (unit_begin == trimmed.size()) return {scaled_number(rest.substr(0, count), 0, begin), {}, false};
  const Unit unit = UnitParser(trimmed, unit_begin).whole();
  const double value = scaled_number(rest.substr(0, count), unit.exponent, begin) * unit.factor;
  if (!std::isfinite(value)) throw UnitError("a number out of range", begin, count);
  return {value, unit.dimension, true};
}

Dimension dimension_of(std::string_view unit) {
  if (unit.empty() || unit == "-") return {};
  return UnitParser(unit, 0).whole().dimension;
}

std::string si_unit(const Dimension& d) {
  std::vector<std::string> factors;
  const auto add = [&](std::string_view symbol, int power) {
    if (power != 0) factors.push_back(power == 1 ? std::string(symbol) : fmt::format("{}{}", symbol, power));
  };
  add("kg", d.mass);
  add("m", d.length);
  add("s", d.time);
  add("K", d.temperature);
  add("rad", d.angle);
  return factors.empty() ? "1" : joined(factors, " ");
}

std::string describe(const Dimension& dimension) {
  struct Name {
    Dimension dimension;
    std::string_view text;
  };
  static constexpr std::array<Name, 17> names{{{{}, "a pure number"},
                                               {length, "a length"},
                                               {{2, 0, 0, 0, 0}, "an area"},
                                               {{3, 0, 0, 0, 0}, "a volume"},
                                               {mass, "a mass"},
                                               {duration, "a time"},
                                               {angle, "an angle"},
                                               {newton, "a force"},
                                               {pascal, "a pressure or stress"},
                                               {joule, "an energy"},
                                               {{-3, 1, 0, 0, 0}, "a density"},
                                               {{0, 1, -2, 0, 0}, "a surface tension or stiffness"},
                                               {{-1, 1, -1, 0, 0}, "a viscosity"},
                                               {{1, 0, -1, 0, 0}, "a velocity"},
                                               {{1, 0, -2, 0, 0}, "an acceleration"},
                                               {{0, 0, -1, 0, 0}, "a rate"},
                                               {{0, 0, 0, 1, 0}, "a temperature"}}};
  for (const Name& name : names)
    if (name.dimension == dimension) return std::string(name.text);
  return "a quantity in " + si_unit(dimension);
}

std::string show(double value, std::string_view unit, int digits) {
  if (unit == "rad") return rounded(value / degree, digits) + " deg";
  if (unit.empty() || unit == "-") return rounded(value, digits);
  const bool takes_prefix = unit == "m" || unit == "s" || unit == "N" || unit == "N/m" || unit == "Pa" || unit == "Pa s";
  if (!takes_prefix || value == 0.0 || !std::isfinite(value)) return fmt::format("{} {}", rounded(value, digits), unit);
  constexpr std::array<std::string_view, 7> steps{"n", "u", "m", "", "k", "M", "G"};
  // Prefixes up to the magnitude of the rounded value: 0.99999e-3 reads as 1 m..., not 1000 u...
  const double magnitude = std::abs(std::stod(rounded(value, digits)));
  int step = static_cast<int>(std::floor(std::log10(magnitude) / 3.0 + 1e-12));
  if (unit == "m" && magnitude >= 1e-4) step = std::max(step, -1);  // 0.35 mm rather than 350 um
  step = std::clamp(step, -3, unit == "m" || unit == "s" ? 0 : 3);
  return fmt::format("{} {}{}", rounded(value / std::pow(10.0, 3 * step), digits), steps[to_size(step + 3)], unit);
}

}  // namespace puadem
