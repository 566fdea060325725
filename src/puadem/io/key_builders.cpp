#include "puadem/io/key_builders.hpp"

#include "puadem/io/units.hpp"

namespace puadem {

KeyInfo quantity(std::string name, std::string unit, Interval allowed, Interval plausible, std::string example,
                 std::string help) {
  KeyInfo info;
  info.name = std::move(name);
  info.type = describe(dimension_of(unit));
  info.unit = std::move(unit);
  info.allowed = allowed;
  info.plausible = plausible;
  info.example = std::move(example);
  info.help = std::move(help);
  return info;
}

KeyInfo number(std::string name, Interval allowed, std::string help, Interval plausible) {
  KeyInfo info = quantity(std::move(name), "", allowed, plausible, "", std::move(help));
  info.type = "a number";
  return info;
}

KeyInfo plain(std::string name, std::string type, std::string help, std::string example) {
  KeyInfo info;
  info.name = std::move(name);
  info.type = std::move(type);
  info.help = std::move(help);
  info.example = std::move(example);
  return info;
}

KeyInfo whole(std::string name, double low, double high, std::string help, std::string example) {
  KeyInfo info = plain(std::move(name), "a whole number", std::move(help), std::move(example));
  info.allowed = between(low, high);
  return info;
}

KeyInfo choice(std::string name, std::vector<std::string> choices, std::string help) {
  KeyInfo info = plain(std::move(name), "a choice", std::move(help));
  info.choices = std::move(choices);
  return info;
}

KeyInfo flag(std::string name, std::string help) { return plain(std::move(name), "true or false", std::move(help), "true"); }

KeyInfo needed(KeyInfo info) {
  info.required = true;
  return info;
}

KeyInfo noted(KeyInfo info, std::string note) {
  info.default_note = std::move(note);
  return info;
}

}  // namespace puadem
