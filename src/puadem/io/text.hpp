#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace puadem {

/// A text that messages quote: a file, or an option of the command line.
struct SourceText {
  std::string name;  ///< as messages show it: "case.toml", "--set"
  std::string text;
};

/// A place in one of several texts; columns count characters, not bytes, from 1.
struct Place {
  int source = 0;
  int line = 1;
  int column = 1;
  constexpr auto operator<=>(const Place&) const = default;
};

/// "name:line:column: message", the line itself and a caret below the place.
std::string located(const SourceText& source, const Place& place, std::string_view message);

/// The same for a line that is at hand.
std::string located_in_line(std::string_view name, int number, int column, std::string_view line, std::string_view message);

/// The candidate nearest to a mistyped word; none where nothing is near. Letter case and swapped
/// neighbours weigh little.
std::optional<std::string> nearest(std::string_view word, std::span<const std::string> candidates);

/// `; did you mean "candidate"?`, or nothing.
std::string did_you_mean(std::string_view word, std::span<const std::string> candidates);

/// "a, b, c".
std::string joined(std::span<const std::string> words, std::string_view separator = ", ");

/// Offset of the first byte that is not UTF-8.
std::optional<std::size_t> first_invalid_utf8(std::string_view text);

/// Line and column of a byte of a text.
Place place_of(std::string_view text, std::size_t offset);

/// Characters (code points) in a UTF-8 text.
int characters(std::string_view text);

/// One line of a text, from 1, without its end.
std::string_view line_of(std::string_view text, int line);

/// The messages of all problems below one heading, the first `limit` of them in full.
std::string summarised(std::string_view heading, std::span<const std::string> messages, int limit = 100);

}  // namespace puadem
