#include "puadem/io/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "puadem/base/parallel.hpp"

namespace puadem {

namespace {

char lower(char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); }

bool continues_character(char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; }

/// Edit distance with transpositions of neighbours (optimal string alignment), in halves: a change of
/// letter case costs one, every other edit two.
int distance(std::string_view a, std::string_view b) {
  const int n = size_of(a), m = size_of(b);
  std::vector<std::vector<int>> d(to_size(n) + 1, std::vector<int>(to_size(m) + 1));
  const auto at = [&](int i, int j) -> int& { return d[to_size(i)][to_size(j)]; };
  for (int i = 0; i <= n; ++i) at(i, 0) = 2 * i;
  for (int j = 0; j <= m; ++j) at(0, j) = 2 * j;
  for (int i = 1; i <= n; ++i)
    for (int j = 1; j <= m; ++j) {
      const char x = a[to_size(i - 1)], y = b[to_size(j - 1)];
      const int change = x == y ? 0 : lower(x) == lower(y) ? 1 : 2;
      at(i, j) = std::min({at(i - 1, j) + 2, at(i, j - 1) + 2, at(i - 1, j - 1) + change});
      if (i > 1 && j > 1 && x == b[to_size(j - 2)] && y == a[to_size(i - 2)]) at(i, j) = std::min(at(i, j), at(i - 2, j - 2) + 2);
    }
  return at(n, m);
}

/// The part of a line around a column that fits on a terminal, and where the column lands in it.
struct Excerpt {
  std::string text;
  int column;
};

Excerpt excerpt_of(std::string_view line, int column) {
  constexpr int widest = 100;
  std::vector<std::string> shown;  // one entry a character
  for (const char c : line) {
    const bool control = static_cast<unsigned char>(c) < 0x20U || c == '\x7f';
    if (continues_character(c) && !shown.empty())
      shown.back() += c;
    else
      shown.emplace_back(1, c == '\t' ? ' ' : control ? '?' : c);
  }
  const int first = size_of(shown) > widest ? std::clamp(column - 1 - widest / 2, 0, size_of(shown) - widest) : 0;
  const int last = std::min(size_of(shown), first + widest);
  Excerpt excerpt{first > 0 ? "..." : "", column - first + (first > 0 ? 3 : 0)};
  for (int i = first; i < last; ++i) excerpt.text += shown[to_size(i)];
  if (last < size_of(shown)) excerpt.text += "...";
  return excerpt;
}

}  // namespace

std::string located_in_line(std::string_view name, int number, int column, std::string_view line, std::string_view message) {
  const Excerpt excerpt = excerpt_of(line, column);
  const int width = size_of(std::to_string(number));
  return fmt::format("{}:{}:{}: {}\n  {} | {}\n  {:>{}} | {:>{}}", name, number, column, message, number, excerpt.text, "", width,
                     "^", std::max(excerpt.column, 1));
}

std::string located(const SourceText& source, const Place& place, std::string_view message) {
  return located_in_line(source.name, place.line, place.column, line_of(source.text, place.line), message);
}

std::optional<std::string> nearest(std::string_view word, std::span<const std::string> candidates) {
  std::optional<std::string> best;
  int least = 0;
  for (const std::string& candidate : candidates) {
    const int d = distance(word, candidate);
    // Fewer than half of the letters may differ; the beginning of a longer name is near as well.
    const bool is_near = d <= std::max(2, 9 * static_cast<int>(std::max(word.size(), candidate.size())) / 10);
    const bool begins = word.size() >= 3 && candidate.starts_with(word);
    if ((is_near || begins) && d < 2 * size_of(candidate) && (!best || d < least)) {
      best = candidate;
      least = d;
    }
  }
  return best;
}

std::string did_you_mean(std::string_view word, std::span<const std::string> candidates) {
  const auto best = nearest(word, candidates);
  return best ? fmt::format("; did you mean \"{}\"?", *best) : std::string();
}

std::string joined(std::span<const std::string> words, std::string_view separator) {
  return fmt::format("{}", fmt::join(words, separator));
}

std::optional<std::size_t> first_invalid_utf8(std::string_view text) {
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U; };
  for (std::size_t i = 0; i < text.size();) {
    const unsigned lead = byte(i);
    const std::size_t length = lead < 0x80U ? 1 : lead < 0xC2U ? 0 : lead < 0xE0U ? 2 : lead < 0xF0U ? 3 : lead < 0xF5U ? 4 : 0;
    if (length == 0) return i;
    for (std::size_t k = 1; k < length; ++k)
      if ((byte(i + k) & 0xC0U) != 0x80U) return i;
    const unsigned second = byte(i + 1);
    const bool overlong = (lead == 0xE0U && second < 0xA0U) || (lead == 0xF0U && second < 0x90U);
    const bool outside = (lead == 0xEDU && second > 0x9FU) || (lead == 0xF4U && second > 0x8FU);
    if (overlong || outside) return i;
    i += length;
  }
  return std::nullopt;
}

Place place_of(std::string_view text, std::size_t offset) {
  Place place;
  for (std::size_t i = 0; i < std::min(offset, text.size()); ++i) {
    if (text[i] == '\n') {
      ++place.line;
      place.column = 1;
    } else if (!continues_character(text[i])) {
      ++place.column;
    }
  }
  return place;
}

int characters(std::string_view text) {
  return static_cast<int>(std::count_if(text.begin(), text.end(), [](char c) { return !continues_character(c); }));
}

std::string_view line_of(std::string_view text, int line) {
  std::size_t begin = 0;
  for (int k = 1; k < line; ++k) {
    const std::size_t end = text.find('\n', begin);
    if (end == std::string_view::npos) return {};
    begin = end + 1;
  }
  std::string_view found = text.substr(begin, text.find('\n', begin) - begin);
  if (found.ends_with('\r')) found.remove_suffix(1);
  return found;
}

std::string summarised(std::string_view heading, std::span<const std::string> messages, int limit) {
  std::string text(heading);
  const int shown = std::min(size_of(messages), limit);
  for (int i = 0; i < shown; ++i) text += "\n" + messages[to_size(i)];
  if (size_of(messages) > shown) text += fmt::format("\n... and {} more like these", size_of(messages) - shown);
  return text;
}

}  // namespace puadem
