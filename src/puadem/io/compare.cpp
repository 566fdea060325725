#include "puadem/io/compare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>

#include "puadem/base/error.hpp"
#include "puadem/base/parallel.hpp"
#include "puadem/io/text.hpp"
#include "puadem/io/text_file.hpp"

namespace puadem {

namespace {

namespace fs = std::filesystem;

// What curves lie over: the first of these that a group of rows has.
constexpr std::array<std::string_view, 3> abscissas{"time_s", "pc_Pa", "axial_strain"};
// A straining under a constant suction lies over its strain.
constexpr std::string_view strained_branch = "strain";

struct Table {
  std::string name;
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;

  int column(std::string_view wanted) const {
    const auto found = std::ranges::find(columns, wanted);
    return found == columns.end() ? -1 : static_cast<int>(found - columns.begin());
  }
};

std::vector<std::string> fields_of(std::string_view line) {
  std::vector<std::string> fields;
  for (std::size_t begin = 0;;) {
    const std::size_t end = line.find(',', begin);
    fields.emplace_back(line.substr(begin, end == std::string_view::npos ? end : end - begin));
    if (end == std::string_view::npos) return fields;
    begin = end + 1;
  }
}

Table read_table(const fs::path& path) {
  const std::string text = read_text_file(path);
  Table table{path.filename().string(), {}, {}};
  int number = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    std::size_t end = std::min(text.find('\n', begin), text.size());
    std::string_view line(text.data() + begin, end - begin);
    begin = end + 1;
    ++number;
    if (line.ends_with('\r')) line.remove_suffix(1);
    if (line.empty() || line.starts_with('#')) continue;
    std::vector<std::string> fields = fields_of(line);
    if (table.columns.empty()) {
      table.columns = std::move(fields);
      continue;
    }
    require(fields.size() == table.columns.size(), "{}:{}: {} fields, but the header names {}", path.string(), number,
            fields.size(), table.columns.size());
    table.rows.push_back(std::move(fields));
  }
  return table;
}

std::optional<double> number_of(const std::string& field) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
  if (error != std::errc() || end != field.data() + field.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

bool is_run(const fs::path& path) { return fs::is_directory(path) && fs::exists(path / "manifest.json"); }

/// Tables of a run with a known abscissa, or the one table that is given.
std::vector<Table> tables_of(const fs::path& path) {
  const auto has_abscissa = [](const Table& table) {
    return std::ranges::any_of(abscissas, [&](std::string_view a) { return table.column(a) >= 0; });
  };
  std::vector<Table> tables;
  if (!fs::is_directory(path)) {
    Table table = read_table(path);
    require(has_abscissa(table), "{}: none of its columns is time_s, pc_Pa or axial_strain, over which curves are compared",
            path.string());
    tables.push_back(std::move(table));
    return tables;
  }
  require(is_run(path), "{}: a folder without manifest.json is no run of puadem", path.string());
  std::vector<fs::path> files;
  if (fs::exists(path / "series"))
    for (const auto& entry : fs::directory_iterator(path / "series"))
      if (entry.path().extension() == ".csv") files.push_back(entry.path());
  std::ranges::sort(files);
  for (const fs::path& file : files)
    if (Table table = read_table(file); has_abscissa(table) && !table.rows.empty()) tables.push_back(std::move(table));
  return tables;
}

/// Rows of each stage and branch.
std::map<std::string, std::vector<int>> groups_of(const Table& table, const Table& other) {
  std::map<std::string, std::vector<int>> groups;
  for (int row = 0; row < size_of(table.rows); ++row) {
    std::string group;
    for (const std::string_view by : {"stage", "branch"}) {
      const int c = table.column(by);
      if (c < 0 || other.column(by) < 0) continue;
      group += (group.empty() ? "" : ", ") + table.rows[to_size(row)][to_size(c)];
    }
    groups[group].push_back(row);
  }
  return groups;
}

/// Points of a column, by rising abscissa.
std::vector<std::pair<double, double>> points_of(const Table& table, const std::vector<int>& rows, int x, int y) {
  std::vector<std::pair<double, double>> points;
  for (const int row : rows) {
    const auto a = number_of(table.rows[to_size(row)][to_size(x)]), b = number_of(table.rows[to_size(row)][to_size(y)]);
    if (a && b) points.emplace_back(*a, *b);
  }
  std::ranges::stable_sort(points, {}, [](const auto& p) { return p.first; });
  return points;
}

double between(const std::vector<std::pair<double, double>>& points, double x) {
  const auto above = std::ranges::lower_bound(points, x, {}, [](const auto& p) { return p.first; });
  if (above == points.begin() || above->first == x) return above->second;
  const auto below = above - 1;
  return below->second + (above->second - below->second) * (x - below->first) / (above->first - below->first);
}

std::optional<ComparedCurve> compare_columns(const std::vector<std::pair<double, double>>& first,
                                             const std::vector<std::pair<double, double>>& second) {
  if (first.empty() || second.empty()) return std::nullopt;
  ComparedCurve curve;
  double squares = 0.0, least = first.front().second, most = least;
  for (const auto& [x, y] : first) {
    least = std::min(least, y);
    most = std::max(most, y);
    if (x < second.front().first || x > second.back().first) continue;
    const double other = between(second, x), apart = std::abs(other - y);
    curve.x.push_back(x);
    curve.first.push_back(y);
    curve.second.push_back(other);
    squares += apart * apart;
    if (apart > curve.largest || curve.x.size() == 1) {
      curve.largest = apart;
      curve.largest_at = x;
    }
  }
  if (curve.x.empty()) return std::nullopt;
  curve.root_mean_square = std::sqrt(squares / static_cast<double>(curve.x.size()));
  curve.range = most - least;
  return curve;
}

/// The abscissa of a group of rows that both tables have.
int abscissa_of(const Table& a, const Table& b, const std::vector<int>& rows, const std::string& group) {
  for (const std::string_view name : abscissas) {
    if (name != "axial_strain" && group.ends_with(strained_branch)) continue;
    const int x = a.column(name);
    if (x < 0 || b.column(name) < 0) continue;
    if (std::ranges::any_of(rows, [&](int row) { return number_of(a.rows[to_size(row)][to_size(x)]).has_value(); })) return x;
  }
  return -1;
}

void compare_tables(const Table& a, const Table& b, Comparison& comparison) {
  const auto groups = groups_of(a, b), others = groups_of(b, a);
  for (const auto& [group, rows] : groups) {
    const auto other = others.find(group);
    const int x = abscissa_of(a, b, rows, group);
    if (other == others.end() || x < 0) continue;
    const std::string& abscissa = a.columns[to_size(x)];
    for (int y = 0; y < size_of(a.columns); ++y) {
      const std::string& column = a.columns[to_size(y)];
      if (y == x || b.column(column) < 0) continue;
      auto curve = compare_columns(points_of(a, rows, x, y), points_of(b, other->second, b.column(abscissa), b.column(column)));
      if (!curve) continue;
      curve->series = a.name;
      curve->group = group;
      curve->abscissa = abscissa;
      curve->column = column;
      comparison.curves.push_back(std::move(*curve));
    }
  }
}

std::map<std::string, double> results_of(const fs::path& run) {
  std::map<std::string, double> results;
  const auto manifest = nlohmann::json::parse(read_text_file(run / "manifest.json"), nullptr, false);
  require(manifest.is_object(), "{}: not a manifest of puadem", (run / "manifest.json").string());
  if (const auto found = manifest.find("results"); found != manifest.end() && found->is_object())
    for (const auto& [name, value] : found->items())
      if (value.is_number()) results[name] = value.get<double>();
  return results;
}

double relative(const ComparedCurve& c) { return c.range > 0.0 ? c.root_mean_square / c.range : c.root_mean_square; }

}  // namespace

Comparison compare(const fs::path& first, const fs::path& second) {
  Comparison comparison;
  const std::vector<Table> of_second = tables_of(second);
  const bool by_name = fs::is_directory(first) && fs::is_directory(second);
  for (const Table& a : tables_of(first))
    for (const Table& b : of_second)
      if (!by_name || a.name == b.name) compare_tables(a, b, comparison);
  if (by_name) {
    const auto results = results_of(first), others = results_of(second);
    for (const auto& [name, value] : results) {
      const auto other = others.find(name);
      if (other == others.end()) continue;
      if (other->second == value)
        ++comparison.same_results;
      else
        comparison.results.push_back({name, value, other->second});
    }
  }
  require(!comparison.curves.empty() || !comparison.results.empty() || comparison.same_results > 0,
          "{} and {} have no curve and no result in common", first.string(), second.string());
  return comparison;
}

std::string comparison_text(const Comparison& comparison) {
  std::string text;
  std::vector<const ComparedCurve*> curves;
  for (const ComparedCurve& c : comparison.curves) curves.push_back(&c);
  // Columns of one series and group stay together; within, the largest share of the range first.
  std::ranges::stable_sort(curves, [](const ComparedCurve* a, const ComparedCurve* b) {
    if (a->series != b->series) return a->series < b->series;
    if (a->group != b->group) return a->group < b->group;
    return relative(*a) > relative(*b);
  });
  const ComparedCurve* last = nullptr;
  int same = 0;
  const auto tell_same = [&] {
    if (same > 0) text += fmt::format("  {} columns the same\n", same);
    same = 0;
  };
  for (const ComparedCurve* c : curves) {
    if (last == nullptr || c->series != last->series || c->group != last->group) {
      tell_same();
      text += fmt::format("{}{}{}: {} points over {} from {:.4g} to {:.4g}\n", c->series, c->group.empty() ? "" : ", ", c->group,
                          c->x.size(), c->abscissa, c->x.front(), c->x.back());
    }
    last = c;
    if (c->largest == 0.0) {
      ++same;
      continue;
    }
    const auto at = to_size(static_cast<int>(std::ranges::find(c->x, c->largest_at) - c->x.begin()));
    text += fmt::format("  {:<28} apart {:.3g} (root mean square), {:.3g} at {:.4g}: {:.6g}, {:.6g}\n", c->column,
                        c->root_mean_square, c->largest, c->largest_at, c->first[at], c->second[at]);
  }
  tell_same();
  if (comparison.same_results > 0) text += fmt::format("{} results are the same\n", comparison.same_results);
  for (const ComparedResult& r : comparison.results) text += fmt::format("{:<40} {:.6g}, {:.6g}\n", r.name, r.first, r.second);
  return text;
}

std::string comparison_csv(const Comparison& comparison) {
  std::string text = "series,group,column,abscissa,x,first,second\n";
  for (const ComparedCurve& c : comparison.curves)
    for (std::size_t k = 0; k < c.x.size(); ++k)
      text += fmt::format("{},\"{}\",{},{},{},{},{}\n", c.series, c.group, c.column, c.abscissa, c.x[k], c.first[k], c.second[k]);
  return text;
}

}  // namespace puadem
