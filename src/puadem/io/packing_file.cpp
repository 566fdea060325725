#include "puadem/io/packing_file.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>

#include "puadem/base/error.hpp"
#include "puadem/base/parallel.hpp"
#include "puadem/io/safe_file.hpp"
#include "puadem/io/text.hpp"
#include "puadem/io/text_file.hpp"
#include "puadem/io/units.hpp"

namespace puadem {

namespace {

constexpr int shown_errors = 10;

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t\r");
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t\r") - begin + 1);
}

std::optional<double> number(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0.0;
  const auto [end, failed] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (failed != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

/// Reads a text line by line and keeps what is wrong with it.
class PackingParser {
 public:
  PackingParser(std::string_view text, const std::string& name) : text_(text), name_(name) {}

  PackingFile parse() {
    for (std::size_t begin = 0; begin < text_.size(); ++line_) {
      const std::size_t end = std::min(text_.find('\n', begin), text_.size());
      read_line(text_.substr(begin, end - begin));
      begin = end + 1;
    }
    if (!has_box_ && errors_.empty())
      throw InputError(
          fmt::format("{}: no line with the box; begin the file with \"# box lx ly lz\" (edge lengths in metres, "
                      "lower corner at 0), such as \"# box 0.012 0.012 0.012\"",
                      name_));
    if (errors_.empty() && packing_.radius.empty()) errors_.push_back(fmt::format("{}: no sphere in the file", name_));
    stop_at_errors();
    check_centres();
    stop_at_errors();
    check_pairs();
    stop_at_errors();
    add_warnings();
    return std::move(packing_);
  }

 private:
  std::string_view text_;
  const std::string& name_;
  int line_ = 1;
  bool has_box_ = false;
  bool has_row_ = false;
  PackingFile packing_;
  std::vector<int> line_of_;              // of each sphere
  std::vector<std::string_view> row_of_;  // text of each sphere
  std::vector<std::string> errors_;
  int more_errors_ = 0;

  /// `part` lies inside `line`, the text of line `number`.
  void error(std::string_view line, int number, std::string_view part, std::string_view message) {
    if (size_of(errors_) >= shown_errors) {
      ++more_errors_;
      return;
    }
    const int column = 1 + characters(line.substr(0, static_cast<std::size_t>(part.data() - line.data())));
    errors_.push_back(located_in_line(name_, number, column, line, message));
  }

  void stop_at_errors() const {
    if (errors_.empty()) return;
    std::string text = joined(errors_, "\n");
    if (more_errors_ > 0) text += fmt::format("\n... and {} more errors in this file", more_errors_);
    throw InputError(text);
  }

  void read_line(std::string_view raw) {
    const std::string_view line = raw.ends_with('\r') ? raw.substr(0, raw.size() - 1) : raw;
    const std::string_view content = trimmed(line);
    if (content.empty()) return;
    if (content.front() == '#')
      read_comment(line, content);
    else
      read_row(line, content);
  }

  void read_comment(std::string_view line, std::string_view content) {
    std::string_view rest = trimmed(content.substr(1));
    if (!rest.starts_with("box") || (rest.size() > 3 && rest[3] != ' ' && rest[3] != '\t' && rest[3] != ',')) return;
    rest = rest.substr(3);
    if (has_box_) return error(line, line_, content, "a second box; only one line \"# box lx ly lz\" is allowed");
    has_box_ = true;
    std::vector<std::string_view> fields;
    for (std::size_t i = 0; i < rest.size();) {
      i = std::min(rest.find_first_not_of(" \t,", i), rest.size());
      const std::size_t end = std::min(rest.find_first_of(" \t,", i), rest.size());
      if (end > i) fields.push_back(rest.substr(i, end - i));
      i = end;
    }
    if (fields.size() != 3)
      return error(line, line_, content,
                   fmt::format("the box needs three edge lengths [m], not {}: # box lx ly lz", fields.size()));
    for (int axis = 0; axis < 3; ++axis) {
      const auto value = number(fields[to_size(axis)]);
      if (!value || !std::isfinite(*value) || *value <= 0.0)
        return error(line, line_, fields[to_size(axis)], "an edge length of the box must be a number > 0 [m]");
      packing_.box.upper[axis] = *value;
    }
  }

  void read_row(std::string_view line, std::string_view content) {
    std::array<std::string_view, 4> fields;
    int count = 0;
    for (std::size_t begin = 0; begin <= content.size(); ++count) {
      const std::size_t end = std::min(content.find(',', begin), content.size());
      if (count < 4) {
        const std::string_view field = trimmed(content.substr(begin, end - begin));
        fields[to_size(count)] = field.empty() ? content.substr(begin, 0) : field;
      }
      begin = end + 1;
    }
    const bool is_heading = !has_row_ && !fields[0].empty() && !number(fields[0]);
    has_row_ = true;
    if (is_heading) {
      const bool known = count == 4 && fields[0] == "x" && fields[1] == "y" && fields[2] == "z" && fields[3] == "r";
      if (!known) error(line, line_, content, "the columns must be x,y,z,r: centre and radius in metres, separated by commas");
      return;
    }
    if (count != 4)
      return error(line, line_, content, fmt::format("{} columns where x,y,z,r has four, separated by commas", count));
    std::array<double, 4> values{};
    for (int k = 0; k < 4; ++k) {
      const std::string_view field = fields[to_size(k)];
      const auto value = number(field);
      if (!value)
        return error(line, line_, field, field.empty() ? "a value is missing" : fmt::format("\"{}\" is no number", field));
      if (!std::isfinite(*value)) return error(line, line_, field, fmt::format("\"{}\" is not a finite number", field));
      values[to_size(k)] = *value;
    }
    if (values[3] <= 0.0) return error(line, line_, fields[3], fmt::format("a radius must be > 0, not {} m", values[3]));
    packing_.centre.push_back({values[0], values[1], values[2]});
    packing_.radius.push_back(values[3]);
    line_of_.push_back(line_);
    row_of_.push_back(line);
  }

  void check_centres() {
    const Vec3 size = packing_.box.upper;
    for (int i = 0; i < size_of(packing_.radius); ++i) {
      const Vec3& c = packing_.centre[to_size(i)];
      for (int axis = 0; axis < 3; ++axis) {
        if (c[axis] >= 0.0 && c[axis] <= size[axis]) continue;
        error(row_of_[to_size(i)], line_of_[to_size(i)], row_of_[to_size(i)],
              fmt::format("the centre lies outside the box: {} = {} m, allowed 0 to {} m", "xyz"[axis], c[axis], size[axis]));
        break;
      }
    }
  }

  void check_pairs() {
    for (const BadPair& pair : find_bad_pairs(packing_.centre, packing_.radius, packing_.box)) {
      const int i = pair.first, j = pair.second;
      const int other = line_of_[to_size(i)];
      const double smaller = std::min(packing_.radius[to_size(i)], packing_.radius[to_size(j)]);
      std::string message;
      if (pair.kind == BadPair::Kind::same_place)
        message = fmt::format("this sphere is at the place of the one in line {}; remove one of them", other);
      else if (pair.kind == BadPair::Kind::inside)
        message = fmt::format("this sphere and the one in line {} lie one inside the other; remove the smaller", other);
      else
        message = fmt::format("this sphere overlaps the one in line {} by {}, more than half the smaller radius ({})", other,
                              show(pair.overlap, "m"), show(smaller, "m"));
      error(row_of_[to_size(j)], line_of_[to_size(j)], row_of_[to_size(j)], message);
    }
  }

  void add_warnings() {
    const double largest = *std::ranges::max_element(packing_.radius);
    if (largest > 0.1)
      packing_.warnings.push_back(fmt::format("{}: the largest radius is {} m; are the lengths in metres?", name_, largest));
    else if (largest < 1e-7)
      packing_.warnings.push_back(
          fmt::format("{}: the largest radius is {}; are the lengths in metres?", name_, show(largest, "m")));
  }
};

}  // namespace

PackingFile parse_packing(std::string_view text, const std::string& name) { return PackingParser(text, name).parse(); }

PackingFile read_packing(const std::filesystem::path& path) { return parse_packing(read_text_file(path), path.string()); }

std::string packing_text(std::span<const Vec3> centre, std::span<const double> radius, const Domain& box) {
  assert(centre.size() == radius.size());
  fmt::memory_buffer text;
  const auto out = std::back_inserter(text);
  const Vec3 size = box.size();
  fmt::format_to(out, "# box {} {} {}\nx,y,z,r\n", size.x, size.y, size.z);
  for (std::size_t i = 0; i < centre.size(); ++i) {
    const Vec3 c = centre[i] - box.lower;
    fmt::format_to(out, "{},{},{},{}\n", c.x, c.y, c.z, radius[i]);
  }
  return fmt::to_string(text);
}

void write_packing(const std::filesystem::path& path, std::span<const Vec3> centre, std::span<const double> radius,
                   const Domain& box) {
  write_file(path, packing_text(centre, radius, box));
}

}  // namespace puadem
