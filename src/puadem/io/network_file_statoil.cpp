#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "puadem/base/error.hpp"
#include "puadem/io/network_file.hpp"
#include "puadem/io/network_file_parts.hpp"
#include "puadem/io/safe_file.hpp"
#include "puadem/io/text_file.hpp"

namespace puadem {

namespace {

constexpr std::uint8_t at_left = 1, at_right = 2;
constexpr double most_triangular = std::numbers::sqrt3 / 36.0;  // shape factor of the equilateral triangle
constexpr double most_square = 0.07;                            // between the square's 1/16 and the circle's 1/(4 pi)

/// One of the files, read number by number.
class Table {
 public:
  Table(const std::filesystem::path& prefix, const char* ending)
      : path_(prefix.string() + ending), text_(read_text_file(path_)) {}

  /// The next line that has anything in it; false at the end.
  bool next_line() {
    fields_.clear();
    while (fields_.empty() && at_ < text_.size()) {
      ++line_;
      const std::size_t end = std::min(text_.find('\n', at_), text_.size());
      const std::string_view line = std::string_view(text_).substr(at_, end - at_);
      at_ = end + 1;
      for (std::size_t i = 0; i < line.size();) {
        i = std::min(line.find_first_not_of(" \t\r", i), line.size());
        const std::size_t stop = std::min(line.find_first_of(" \t\r", i), line.size());
        if (stop > i) fields_.push_back(line.substr(i, stop - i));
        i = stop;
      }
    }
    return !fields_.empty();
  }
  void need_line(std::string_view what) { require(next_line(), "{}: the file ends before {}", path_, what); }

  int fields() const { return size_of(fields_); }
  double number(int field, std::string_view what) const {
    require(field < fields(), "{}:{}: {} numbers where {} is number {}", path_, line_, fields(), what, field + 1);
    const auto value = field_number(fields_[to_size(field)]);
    require(value && std::isfinite(*value), "{}:{}: {} is \"{}\", which is no number", path_, line_, what,
            fields_[to_size(field)]);
    return *value;
  }
  double positive(int field, std::string_view what) const {
    const double value = number(field, what);
    require(value > 0.0, "{}:{}: {} is {:g}: it must be > 0", path_, line_, what, value);
    return value;
  }
  int index(int field, std::string_view what, int low, int high) const {
    const double value = number(field, what);
    require(value == std::floor(value) && value >= low && value <= high, "{}:{}: {} is {:g}: allowed are {} to {}", path_, line_,
            what, value, low, high);
    return static_cast<int>(value);
  }

 private:
  std::string path_, text_;
  std::size_t at_ = 0;
  int line_ = 0;
  std::vector<std::string_view> fields_;
};

double area_of(double radius, double shape) { return radius * radius / (4.0 * shape); }

/// Conductance of a tube times viscosity and over length, theory 3.10 [m4].
double tube(double radius, double shape) {
  const double factor = shape <= most_triangular ? 0.6 : shape < most_square ? 0.5623 : 0.5;
  return factor * area_of(radius, shape) * area_of(radius, shape) * shape;
}

struct Body {
  double radius = 0.0, shape = 0.0;
};

void add_reservoir(PoreNetwork& network, const Vec3& at, std::uint8_t wall, double volume) {
  network.pore_centre.push_back(at);
  network.pore_volume.push_back(volume);
  network.pore_radius.push_back(*std::ranges::max_element(network.pore_radius));
  network.pore_faces.push_back(6);
  network.pore_walls.push_back(wall);
}

std::vector<Body> read_nodes(const std::filesystem::path& prefix, NetworkFile& file) {
  PoreNetwork& network = file.network;
  Table node1(prefix, "_node1.dat"), node2(prefix, "_node2.dat");
  node1.need_line("its heading: number of pores, size of the box");
  const int pores = node1.index(0, "the number of pores", 1, std::numeric_limits<int>::max() - 2);
  file.box.upper = {node1.positive(1, "the box along x"), node1.positive(2, "the box along y"),
                    node1.positive(3, "the box along z")};
  std::vector<Body> bodies;
  for (int p = 0; p < pores; ++p) {
    node1.need_line(fmt::format("pore {} of {}", p + 1, pores));
    node2.need_line(fmt::format("pore {} of {}", p + 1, pores));
    node1.index(0, "the index of the pore", p + 1, p + 1);
    node2.index(0, "the index of the pore", p + 1, p + 1);
    network.pore_centre.push_back({node1.number(1, "x"), node1.number(2, "y"), node1.number(3, "z")});
    network.pore_faces.push_back(std::max(4, node1.index(4, "the number of neighbours", 0, 1 << 20)));
    network.pore_walls.push_back(0);
    const double volume = node2.number(1, "the volume");
    network.pore_volume.push_back(volume);
    bodies.push_back({node2.positive(2, "the radius"), node2.positive(3, "the shape factor")});
    network.pore_radius.push_back(bodies.back().radius);
  }
  double total = 0.0;
  for (const double v : network.pore_volume) total += v;
  const Vec3 middle = 0.5 * file.box.upper;
  add_reservoir(network, {0.0, middle.y, middle.z}, at_left, total / pores);
  add_reservoir(network, {file.box.upper.x, middle.y, middle.z}, at_right, total / pores);
  return bodies;
}

void read_links(const std::filesystem::path& prefix, const std::vector<Body>& bodies, PoreNetwork& network) {
  const int pores = size_of(bodies);
  Table link1(prefix, "_link1.dat"), link2(prefix, "_link2.dat");
  link1.need_line("its heading: number of throats");
  const int throats = link1.index(0, "the number of throats", 0, std::numeric_limits<int>::max());
  const auto resistance = [&](int pore, double length) {  // of the half that lies in a pore; none in a reservoir
    return pore < pores ? length / tube(bodies[to_size(pore)].radius, bodies[to_size(pore)].shape) : 0.0;
  };
  for (int t = 0; t < throats; ++t) {
    link1.need_line(fmt::format("throat {} of {}", t + 1, throats));
    link2.need_line(fmt::format("throat {} of {}", t + 1, throats));
    link2.index(0, "the index of the throat", t + 1, t + 1);
    std::array<int, 2> ends;
    for (int end = 0; end < 2; ++end) {
      const int pore = link1.index(1 + end, "a pore of the throat (-1: inlet, 0: outlet)", -1, pores);
      ends[to_size(end)] = pore > 0 ? pore - 1 : pore == -1 ? pores : pores + 1;
    }
    const double radius = link1.positive(3, "the radius"), shape = link1.positive(4, "the shape factor");
    double drag = link2.number(5, "the length of the throat") / tube(radius, shape);
    for (int end = 0; end < 2; ++end) drag += resistance(ends[to_size(end)], link2.number(3 + end, "the length in a pore"));
    const double volume = link2.number(6, "the volume");
    for (const int p : ends)  // what the reservoirs get is not counted
      network.pore_volume[to_size(p)] += 0.5 * volume;
    network.throat_pores.push_back({std::min(ends[0], ends[1]), std::max(ends[0], ends[1])});
    network.throat_area.push_back(area_of(radius, shape));
    network.throat_length.push_back(link1.number(5, "the length from pore to pore"));
    network.throat_conductance.push_back(drag > 0.0 ? 1.0 / drag : std::numeric_limits<double>::infinity());
    network.throat_radius.push_back(radius);
    network.throat_entry_radius.push_back(radius / (1.0 + 2.0 * std::sqrt(std::numbers::pi * shape)));
    network.throat_snap_off_radius.push_back(radius);
  }
}

}  // namespace

NetworkFile read_statoil_network(const std::filesystem::path& prefix) {
  NetworkFile file;
  const std::vector<Body> bodies = read_nodes(prefix, file);
  read_links(prefix, bodies, file.network);
  if (const int dropped = drop_unreachable_pores(file.network); dropped > 0)
    file.warnings.push_back(fmt::format("{}: {} of {} pores reach neither inlet nor outlet and are left out", prefix.string(),
                                        dropped, bodies.size()));
  complete_network(file.network, prefix.string());
  file.reservoir_pores = 2;
  return file;
}

void write_statoil_network(const std::filesystem::path& prefix, const PoreNetwork& network, const Domain& box, int inlet_face) {
  require(std::ranges::none_of(network.throat_shift, [](const auto& s) { return s != std::array<std::int8_t, 3>{}; }),
          "a network of a periodic box cannot be written in this format: use walls, or a table (.csv)");
  // The flow axis becomes x, the others follow in their cyclic order; positions grow from the inlet.
  const int axis = axis_of(inlet_face);
  const auto turned = [&](const Vec3& v) { return Vec3{v[axis], v[(axis + 1) % 3], v[(axis + 2) % 3]}; };
  const Vec3 size = turned(box.size());
  fmt::memory_buffer link1, link2, node1, node2;
  std::vector<std::vector<std::array<int, 2>>> ways(to_size(network.pores()));  // neighbour and throat, as written
  int throats = 0;
  const auto add_link = [&](int from, int to, double radius, double area, double conductance, double length) {
    const double shape = std::min(radius * radius / (4.0 * area), 0.25 / std::numbers::pi);
    const double least = 1e-6 * length;  // the format knows no throat without resistance
    const double tube_length = std::max(tube(radius, shape) / conductance, least);
    fmt::format_to(std::back_inserter(link1), "{} {} {} {} {} {}\n", ++throats, from, to, radius, shape, length);
    fmt::format_to(std::back_inserter(link2), "{} {} {} 0 0 {} 0 0\n", throats, from, to, tube_length);
    if (from > 0) ways[to_size(from - 1)].push_back({to, throats});
    if (to > 0) ways[to_size(to - 1)].push_back({from, throats});
  };
  for (int t = 0; t < network.throats(); ++t) {
    const auto i = to_size(t);
    if (network.throat_conductance[i] <= 0.0 || network.throat_radius[i] <= 0.0) continue;
    const auto [a, b] = network.throat_pores[i];
    const double apart = norm(network.pore_centre[to_size(b)] - network.pore_centre[to_size(a)]);
    add_link(a + 1, b + 1, network.throat_radius[i], network.throat_area[i], network.throat_conductance[i], apart);
  }
  const auto touches = [&](int p, int face) { return (network.pore_walls[to_size(p)] >> face & 1u) != 0; };
  for (int p = 0; p < network.pores(); ++p)  // a wide throat of no resistance to each reservoir
    for (const int face : {inlet_face, opposite(inlet_face)}) {
      const double r = network.pore_radius[to_size(p)];
      if (touches(p, face))
        add_link(p + 1, face == inlet_face ? -1 : 0, r, std::numbers::pi * r * r, std::numeric_limits<double>::infinity(), r);
    }
  fmt::format_to(std::back_inserter(node1), "{} {} {} {}\n", network.pores(), size.x, size.y, size.z);
  for (int p = 0; p < network.pores(); ++p) {
    Vec3 c = turned(network.pore_centre[to_size(p)] - box.lower);
    if (is_upper(inlet_face)) c.x = size.x - c.x;
    const auto& list = ways[to_size(p)];
    fmt::format_to(std::back_inserter(node1), "{} {} {} {} {}", p + 1, c.x, c.y, c.z, list.size());
    for (const auto& way : list) fmt::format_to(std::back_inserter(node1), " {}", way[0]);
    fmt::format_to(std::back_inserter(node1), " {} {}", int{touches(p, inlet_face)}, int{touches(p, opposite(inlet_face))});
    for (const auto& way : list) fmt::format_to(std::back_inserter(node1), " {}", way[1]);
    node1.push_back('\n');
    fmt::format_to(std::back_inserter(node2), "{} {} {} {} 0\n", p + 1, network.pore_volume[to_size(p)],
                   network.pore_radius[to_size(p)], 1.0 / 16.0);
  }
  const std::string count = fmt::format("{}\n", throats);
  write_file(prefix.string() + "_link1.dat", count + fmt::to_string(link1));
  write_file(prefix.string() + "_link2.dat", fmt::to_string(link2));
  write_file(prefix.string() + "_node1.dat", fmt::to_string(node1));
  write_file(prefix.string() + "_node2.dat", fmt::to_string(node2));
}

}  // namespace puadem
