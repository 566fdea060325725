#include "puadem/io/case_file.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "puadem/base/error.hpp"
#include "puadem/base/parallel.hpp"
#include "puadem/io/case_schema.hpp"
#include "puadem/io/text_file.hpp"

namespace puadem {

namespace {

std::vector<std::string> in_order(std::vector<Problems::Entry> entries) {
  std::ranges::stable_sort(entries, [](const auto& a, const auto& b) { return a.place < b.place; });
  std::vector<std::string> messages;
  for (const auto& entry : entries)
    if (messages.empty() || messages.back() != entry.message) messages.push_back(entry.message);
  return messages;
}

}  // namespace

CaseFile parse_case(const std::string& text, const std::string& name, const std::filesystem::path& folder,
                    std::span<const std::string> overrides) {
  require(text.find_first_not_of(" \t\r\n") != std::string::npos, "{}: the file is empty; begin with `puadem new`", name);
  Problems problems;
  problems.folder = folder;
  problems.sources.push_back({name, text});
  TomlValue tree = parse_toml(problems.sources[0], 0);
  for (const std::string& assignment : overrides) {
    problems.sources.push_back({"--set", assignment});
    apply_override(problems.sources.back(), size_of(problems.sources) - 1, tree);
  }

  CaseFile file;
  file.text = text;
  read_table(tree, case_section(), problems, file.c);
  check_case(tree, file.c, problems);
  const std::vector<std::string> errors = in_order(std::move(problems.errors));
  if (!errors.empty()) {
    const std::string heading = fmt::format("{}: {} error{}", name, errors.size(), errors.size() == 1 ? "" : "s");
    throw InputError(summarised(heading, errors));
  }
  file.warnings = in_order(std::move(problems.warnings));
  return file;
}

CaseFile read_case(const std::filesystem::path& path, std::span<const std::string> overrides) {
  return parse_case(read_text_file(path), path.string(), std::filesystem::absolute(path).parent_path(), overrides);
}

std::string resolved_case(const Case& c) { return "# All values in SI units.\n" + write_table("", case_section(), c); }

}  // namespace puadem
