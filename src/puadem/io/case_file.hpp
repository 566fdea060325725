#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "puadem/coupling/case.hpp"
#include "puadem/io/case_fields.hpp"

namespace puadem {

/// A case as read, with what is odd about it.
struct CaseFile {
  Case c;
  std::vector<std::string> warnings;  ///< with line and caret
  std::string text;                   ///< the file as it is, overrides not included
};

/// Reads and checks a case file (TOML; every key: docs/case_file.md).
///
/// @param overrides  "key=value" as given to `--set`: dotted key, stages by index from 0
/// @throws InputError with all errors of the file at once, each with line, caret and what is allowed
CaseFile read_case(const std::filesystem::path& path, std::span<const std::string> overrides = {});

/// The same for a text in memory. `name` stands for the file in messages, `folder` is where its
/// relative paths begin.
CaseFile parse_case(const std::string& text, const std::string& name, const std::filesystem::path& folder,
                    std::span<const std::string> overrides = {});

/// The case as a TOML file in SI units with every key written out; it reads back to the same case.
std::string resolved_case(const Case& c);

/// Description of every key, in the order of the file.
std::vector<KeyDoc> all_keys();

/// Text of `puadem keys [WORD]`: the keys whose name or help contains the word.
/// @throws InputError where no key does, with the nearest name
std::string keys_text(const std::string& word);

/// docs/case_file.md.
std::string keys_markdown();

/// The same for a case with a network in place of grains.
void check_network_case(const TomlValue& tree, const Case& c, Problems& problems);

/// Checks that concern several keys: `tree` gives the places. Called by `read_case`.
void check_case(const TomlValue& tree, Case& c, Problems& problems);

}  // namespace puadem
