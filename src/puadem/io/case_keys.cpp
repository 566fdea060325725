#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "puadem/base/error.hpp"
#include "puadem/io/case_file.hpp"
#include "puadem/io/case_schema.hpp"

namespace puadem {

namespace {

std::string lower(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

std::string with_unit(const KeyDoc& doc) { return doc.unit.empty() ? doc.type : fmt::format("{} [{}]", doc.type, doc.unit); }

std::string default_of(const KeyDoc& doc) {
  return doc.required ? "required" : doc.default_value.empty() ? "-" : doc.default_value;
}

std::string entry(const KeyDoc& doc) {
  std::string text = fmt::format("{}\n    {}\n    {}; default: {}", doc.path, doc.help, with_unit(doc), default_of(doc));
  if (!doc.allowed.empty()) text += "; allowed: " + doc.allowed;
  if (!doc.example.empty()) text += "\n    such as " + doc.example;
  return text + "\n";
}

/// Text in a cell of a Markdown table.
std::string cell(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '|') escaped += '\\';
    escaped += c;
  }
  return escaped;
}

}  // namespace

std::vector<KeyDoc> all_keys() {
  std::vector<KeyDoc> keys;
  describe_table("", case_section(), keys);
  return keys;
}

std::string keys_text(const std::string& word) {
  std::string text;
  std::vector<std::string> names;
  for (const KeyDoc& doc : all_keys()) {
    const std::string searched = lower(doc.path + " " + doc.help + " " + doc.allowed);
    if (searched.find(lower(word)) != std::string::npos) text += entry(doc);
    names.push_back(doc.path.substr(doc.path.rfind('.') + 1));
  }
  require(!text.empty(), "no key with \"{}\"{}", word, did_you_mean(word, names));
  return text;
}

std::string keys_markdown() {
  std::string text =
      "# The case file\n\n"
      "A case is one TOML file. Quantities are texts with a unit (`\"0.35 mm\"`, `\"72.8 mN/m\"`, `\"30 deg\"`) or bare numbers "
      "in SI\n"
      "units. Stages run in the order of the file. Faces of the box are `left`, `right` (x), `front`, `back` (y), `bottom`, "
      "`top` (z),\n"
      "or `x-`, `x+`, `y-`, `y+`, `z-`, `z+`. Any key can be set on the command line: `--set grains.count=500`,\n"
      "`--set stage.0.stress=\"5 kPa\"` (stages count from 0).\n\n"
      "This page is the output of `puadem keys --markdown`.\n";
  std::string heading;
  for (const KeyDoc& doc : all_keys()) {
    const std::size_t dot = doc.path.rfind('.');
    const std::string table = dot == std::string::npos ? "" : doc.path.substr(0, dot);
    if (table != heading || text.ends_with("markdown`.\n")) {
      heading = table;
      text += table.empty() ? "\n## Top level\n\n" : fmt::format("\n## {}\n\n", table);
      text += "| key | what | kind | allowed | default |\n|---|---|---|---|---|\n";
    }
    const std::string name = dot == std::string::npos ? doc.path : doc.path.substr(dot + 1);
    const std::string example = doc.example.empty() ? "" : fmt::format(", such as `{}`", doc.example);
    text += fmt::format("| `{}` | {}{} | {} | {} | {} |\n", name, cell(doc.help), cell(example), cell(with_unit(doc)),
                        cell(doc.allowed), cell(default_of(doc)));
  }
  return text;
}

}  // namespace puadem
