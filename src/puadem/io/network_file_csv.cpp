#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

#include "puadem/base/error.hpp"
#include "puadem/io/network_file.hpp"
#include "puadem/io/network_file_parts.hpp"
#include "puadem/io/safe_file.hpp"
#include "puadem/io/text.hpp"
#include "puadem/io/text_file.hpp"

namespace puadem {

namespace {

const std::vector<std::string>& known_columns() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> list{"pore.volume",
                                  "pore.diameter",
                                  "pore.faces",
                                  "throat.conns[0]",
                                  "throat.conns[1]",
                                  "throat.diameter",
                                  "throat.length",
                                  "throat.cross_sectional_area",
                                  "throat.conductance",
                                  "throat.entry_radius",
                                  "throat.snap_off_radius",
                                  "throat.facet_area",
                                  "throat.at_wall",
                                  "param.contact_angle"};
    for (const char* base : {"pore.coords", "throat.shift", "throat.normal", "param.box", "param.periodic"})
      for (int axis = 0; axis < 3; ++axis) list.push_back(fmt::format("{}[{}]", base, axis));
    for (const std::string_view face : face_names) list.push_back(fmt::format("pore.{}", face));
    return list;
  }();
  return names;
}

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t\r\"");
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t\r\"") - begin + 1);
}

std::vector<std::string_view> cells_of(std::string_view line) {
  std::vector<std::string_view> cells;
  for (std::size_t begin = 0; begin <= line.size();) {
    const std::size_t end = std::min(line.find(',', begin), line.size());
    cells.push_back(trimmed(line.substr(begin, end - begin)));
    begin = end + 1;
  }
  return cells;
}

/// The columns of a table, each as long as it has values.
class Columns {
 public:
  Columns(std::string_view text, const std::string& name, std::vector<std::string>& warnings) : name_(name) {
    int line_number = 0;
    std::vector<std::vector<double>*> target;
    for (std::size_t at = 0; at < text.size();) {
      const std::size_t end = std::min(text.find('\n', at), text.size());
      const auto cells = cells_of(text.substr(at, end - at));
      at = end + 1;
      if (++line_number == 1) {
        for (const std::string_view heading : cells) target.push_back(find_target(heading, warnings));
        continue;
      }
      if (cells.size() == 1 && cells[0].empty()) continue;
      require(cells.size() == target.size(), "{}:{}: {} values under {} headings", name_, line_number, cells.size(),
              target.size());
      for (std::size_t c = 0; c < cells.size(); ++c)
        if (target[c] != nullptr && !cells[c].empty()) add(*target[c], cells[c], line_number);
    }
  }

  bool has(const std::string& column) const { return values_.contains(column); }
  /// A column of one value each for `count` pores or throats.
  const std::vector<double>& get(const std::string& column, std::size_t count) const {
    require(has(column), "{}: the column \"{}\" is missing", name_, column);
    const auto& values = values_.at(column);
    require(values.size() == count, "{}: the column \"{}\" has {} values, expected are {}", name_, column, values.size(), count);
    return values;
  }
  std::size_t length(const std::string& column) const { return has(column) ? values_.at(column).size() : 0; }

 private:
  std::vector<double>* find_target(std::string_view heading, std::vector<std::string>& warnings) {
    const std::string column(heading);
    if (std::ranges::find(known_columns(), column) == known_columns().end()) {
      if (!column.empty())
        warnings.push_back(
            fmt::format("{}: the column \"{}\" is not read{}", name_, column, did_you_mean(column, known_columns())));
      return nullptr;
    }
    require(!has(column), "{}:1: a second column \"{}\"", name_, column);
    return &values_[column];
  }

  void add(std::vector<double>& values, std::string_view cell, int line) {
    if (cell == "True" || cell == "true" || cell == "TRUE") return values.push_back(1.0);
    if (cell == "False" || cell == "false" || cell == "FALSE") return values.push_back(0.0);
    const auto value = field_number(cell);
    require(value && !std::isnan(*value), "{}:{}: \"{}\" is no number", name_, line, cell);
    values.push_back(*value);
  }

  const std::string& name_;
  std::map<std::string, std::vector<double>> values_;
};

std::string indexed(const char* base, int k) { return fmt::format("{}[{}]", base, k); }

std::vector<Vec3> get_vectors(const Columns& table, const char* base, std::size_t count) {
  std::vector<Vec3> vectors(count);
  for (int axis = 0; axis < 3; ++axis) {
    const auto& values = table.get(indexed(base, axis), count);
    for (std::size_t i = 0; i < count; ++i) vectors[i][axis] = values[i];
  }
  return vectors;
}

/// Whole numbers of a column, within bounds.
std::vector<int> get_whole(const Columns& table, const std::string& column, std::size_t count, int low, int high) {
  std::vector<int> whole;
  for (const double v : table.get(column, count)) {
    require(v == std::floor(v) && v >= low && v <= high, "the column \"{}\" holds {:g}: allowed are whole numbers from {} to {}",
            column, v, low, high);
    whole.push_back(static_cast<int>(v));
  }
  return whole;
}

void read_pores(const Columns& table, PoreNetwork& network) {
  const std::size_t pores = table.length("pore.coords[0]");
  network.pore_centre = get_vectors(table, "pore.coords", pores);
  network.pore_volume = table.get("pore.volume", pores);
  if (table.has("pore.diameter")) {
    for (const double d : table.get("pore.diameter", pores)) network.pore_radius.push_back(0.5 * d);
  } else {  // spheres
    for (const double v : network.pore_volume) network.pore_radius.push_back(std::cbrt(0.75 * v / std::numbers::pi));
  }
  network.pore_walls.assign(pores, 0);
  for (int face = 0; face < 6; ++face)
    if (const std::string label = fmt::format("pore.{}", face_names[to_size(face)]); table.has(label)) {
      const auto& flags = table.get(label, pores);
      for (std::size_t p = 0; p < pores; ++p)
        if (flags[p] != 0.0) network.pore_walls[p] = static_cast<std::uint8_t>(network.pore_walls[p] | 1u << face);
    }
}

void read_throats(const Columns& table, PoreNetwork& network) {
  const std::size_t throats = table.length("throat.conns[0]");
  const int last = network.pores() - 1;
  const auto from = get_whole(table, "throat.conns[0]", throats, 0, last),
             to = get_whole(table, "throat.conns[1]", throats, 0, last);
  for (std::size_t t = 0; t < throats; ++t) network.throat_pores.push_back({std::min(from[t], to[t]), std::max(from[t], to[t])});
  if (table.has("throat.shift[0]")) {
    network.throat_shift.resize(throats);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto shift = get_whole(table, indexed("throat.shift", static_cast<int>(axis)), throats, -3, 3);
      for (std::size_t t = 0; t < throats; ++t)
        network.throat_shift[t][axis] = static_cast<std::int8_t>(to[t] < from[t] ? -shift[t] : shift[t]);
    }
  }
  for (const double d : table.get("throat.diameter", throats)) network.throat_radius.push_back(0.5 * d);
  network.throat_length = table.get("throat.length", throats);
  const auto optional = [&](const char* column, std::vector<double>& values, const auto& otherwise) {
    if (table.has(column)) {
      values = table.get(column, throats);
      return;
    }
    for (std::size_t t = 0; t < throats; ++t) values.push_back(otherwise(network.throat_radius[t], network.throat_length[t]));
  };
  // Of a round tube, where the file does not say.
  optional("throat.cross_sectional_area", network.throat_area, [](double r, double) { return std::numbers::pi * r * r; });
  optional("throat.conductance", network.throat_conductance,
           [](double r, double length) { return std::numbers::pi * r * r * r * r / (8.0 * length); });
  optional("throat.entry_radius", network.throat_entry_radius, [](double r, double) { return 0.5 * r; });
  optional("throat.snap_off_radius", network.throat_snap_off_radius, [](double r, double) { return r; });
  if (table.has("throat.facet_area")) network.throat_facet_area = table.get("throat.facet_area", throats);
  if (table.has("throat.at_wall"))
    for (const double flag : table.get("throat.at_wall", throats)) network.throat_at_wall.push_back(flag != 0.0 ? 1 : 0);
  if (!table.has("throat.normal[0]")) return;
  network.throat_normal = get_vectors(table, "throat.normal", throats);
  for (std::size_t t = 0; t < throats; ++t)  // from the pore named first to the second
    if (to[t] < from[t]) network.throat_normal[t] = -network.throat_normal[t];
}

Domain read_box(const Columns& table, PoreNetwork& network) {
  Domain box;
  if (table.has("param.box[0]")) {
    box.upper = get_vectors(table, "param.box", 1).front();
  } else {
    Vec3 low = network.pore_centre.front(), high = low;
    for (const Vec3& c : network.pore_centre)
      for (int axis = 0; axis < 3; ++axis) {
        low[axis] = std::min(low[axis], c[axis]);
        high[axis] = std::max(high[axis], c[axis]);
      }
    for (Vec3& c : network.pore_centre) c -= low;
    box.upper = high - low;
  }
  for (int axis = 0; axis < 3; ++axis) {
    const std::string column = indexed("param.periodic", axis);
    if (table.has(column)) box.periodic[to_size(axis)] = table.get(column, 1).front() != 0.0;
    require(box.upper[axis] > 0.0, "the box has the length {:g} m along {}: give \"param.box[{}]\"", box.upper[axis], "xyz"[axis],
            axis);
  }
  return box;
}

}  // namespace

NetworkFile read_csv_network(const std::filesystem::path& path) {
  NetworkFile file;
  const std::string name = path.string(), text = read_text_file(path);
  const Columns table(text, name, file.warnings);
  PoreNetwork& network = file.network;
  require(table.length("pore.coords[0]") > 0, "{}: no pore in the file; a column \"pore.coords[0]\" is needed", name);
  read_pores(table, network);
  read_throats(table, network);
  file.box = read_box(table, network);
  file.knows_walls = table.has("throat.at_wall");
  if (table.has("param.contact_angle")) file.contact_angle = table.get("param.contact_angle", 1).front();
  if (table.has("pore.faces")) {
    network.pore_faces = get_whole(table, "pore.faces", to_size(network.pores()), 0, 1 << 20);
  } else {  // the throats of a pore, at least those of a tetrahedron
    network.pore_faces.assign(to_size(network.pores()), 0);
    for (const auto& pair : network.throat_pores)
      for (const int p : pair) ++network.pore_faces[to_size(p)];
    for (int& faces : network.pore_faces) faces = std::max(faces, 4);
  }
  complete_network(network, name);
  return file;
}

void write_csv_network(const std::filesystem::path& path, const PoreNetwork& network, const Domain& box, double contact_angle) {
  const Vec3 size = box.size();
  std::vector<std::string> headings;
  for (const char* base : {"pore.coords", "param.box", "param.periodic"})
    for (int axis = 0; axis < 3; ++axis) headings.push_back(indexed(base, axis));
  headings.insert(headings.end(), {"param.contact_angle", "pore.volume", "pore.diameter", "pore.faces"});
  for (const std::string_view face : face_names) headings.push_back(fmt::format("pore.{}", face));
  headings.insert(headings.end(), {"throat.conns[0]", "throat.conns[1]", "throat.shift[0]", "throat.shift[1]", "throat.shift[2]",
                                   "throat.diameter", "throat.length", "throat.cross_sectional_area", "throat.conductance",
                                   "throat.entry_radius", "throat.snap_off_radius", "throat.facet_area", "throat.normal[0]",
                                   "throat.normal[1]", "throat.normal[2]", "throat.at_wall"});
  std::string out = joined(headings, ",") + "\n";
  for (std::size_t row = 0; row < std::max(network.pore_volume.size(), network.throat_pores.size()); ++row) {
    std::string line;
    const auto put = [&](bool there, auto value) { line += there ? fmt::format("{},", value) : ","; };
    const bool is_pore = row < network.pore_volume.size(), is_throat = row < network.throat_pores.size();
    for (int axis = 0; axis < 3; ++axis) put(is_pore, is_pore ? network.pore_centre[row][axis] - box.lower[axis] : 0.0);
    for (int axis = 0; axis < 3; ++axis) put(row == 0, size[axis]);
    for (int axis = 0; axis < 3; ++axis) put(row == 0, int{box.periodic[to_size(axis)]});
    put(row == 0, contact_angle);
    put(is_pore, is_pore ? network.pore_volume[row] : 0.0);
    put(is_pore, is_pore ? 2.0 * network.pore_radius[row] : 0.0);
    put(is_pore, is_pore ? network.pore_faces[row] : 0);
    for (int face = 0; face < 6; ++face) put(is_pore, is_pore && network.pore_walls[row] >> face & 1u ? "True" : "False");
    for (std::size_t end = 0; end < 2; ++end) put(is_throat, is_throat ? network.throat_pores[row][end] : 0);
    for (std::size_t axis = 0; axis < 3; ++axis)
      put(is_throat, is_throat && !network.throat_shift.empty() ? int{network.throat_shift[row][axis]} : 0);
    put(is_throat, is_throat ? 2.0 * network.throat_radius[row] : 0.0);
    for (const auto* values : {&network.throat_length, &network.throat_area, &network.throat_conductance,
                               &network.throat_entry_radius, &network.throat_snap_off_radius, &network.throat_facet_area})
      put(is_throat, is_throat ? (*values)[row] : 0.0);
    for (int axis = 0; axis < 3; ++axis) put(is_throat, is_throat ? network.throat_normal[row][axis] : 0.0);
    put(is_throat, is_throat && network.throat_at_wall[row] ? "True" : "False");
    line.back() = '\n';
    out += line;
  }
  write_file(path, out);
}

}  // namespace puadem
