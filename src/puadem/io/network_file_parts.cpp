#include "puadem/io/network_file_parts.hpp"

#include <algorithm>
#include <charconv>

#include "puadem/base/disjoint_sets.hpp"
#include "puadem/base/error.hpp"
#include "puadem/io/text.hpp"
#include "puadem/network/network_checks.hpp"

namespace puadem {

namespace {

/// The entries of `values` whose place has a new number >= 0.
template <class T>
void keep(std::vector<T>& values, const std::vector<int>& number) {
  if (values.empty()) return;
  std::size_t next = 0;
  for (std::size_t i = 0; i < number.size(); ++i)
    if (number[i] >= 0) values[next++] = values[i];
  values.resize(next);
}

}  // namespace

std::optional<double> field_number(std::string_view field) {
  if (field.starts_with('+')) field.remove_prefix(1);
  double value = 0.0;
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
  if (error != std::errc{} || end != field.data() + field.size()) return std::nullopt;
  return value;
}

void complete_network(PoreNetwork& network, std::string_view name) {
  const auto throats = to_size(network.throats());
  if (network.throat_shift.empty()) network.throat_shift.assign(throats, {});
  if (network.throat_facet_area.empty()) network.throat_facet_area = network.throat_area;
  network.throat_entry_kind.resize(throats);
  const bool has_normals = !network.throat_normal.empty();
  network.throat_normal.resize(throats);
  if (network.throat_at_wall.empty()) network.throat_at_wall.assign(throats, 0);
  for (std::size_t t = 0; t < throats; ++t) {
    const auto [i, j] = network.throat_pores[t];
    const Vec3 way = network.pore_centre[to_size(j)] - network.pore_centre[to_size(i)];
    if (!has_normals) network.throat_normal[t] = squared_norm(way) > 0.0 ? normalized(way) : Vec3{1, 0, 0};
    network.throat_entry_kind[t] = network.throat_entry_radius[t] > 0.0 ? EntryKind::inscribed : EntryKind::closed;
  }
  network.pore_throats = throats_of_pores(network.throat_pores, network.pores());
  std::vector<std::string> faults = find_network_faults(network);
  if (faults.empty()) return;
  throw InputError(summarised(fmt::format("{}: this network cannot be used:", name), faults, 10));
}

int drop_unreachable_pores(PoreNetwork& network) {
  DisjointSets parts(network.pores());
  for (const auto& [i, j] : network.throat_pores) parts.join(i, j);
  std::vector<char> reached(to_size(network.pores()), 0);
  for (int p = 0; p < network.pores(); ++p)
    if (network.pore_walls[to_size(p)] != 0) reached[to_size(parts.find(p))] = 1;
  std::vector<int> pore_number(to_size(network.pores())), throat_number(to_size(network.throats()));
  int pores = 0;
  for (int p = 0; p < network.pores(); ++p) pore_number[to_size(p)] = reached[to_size(parts.find(p))] ? pores++ : -1;
  for (std::size_t t = 0; t < throat_number.size(); ++t) {
    auto& [i, j] = network.throat_pores[t];
    throat_number[t] = pore_number[to_size(i)] < 0 ? -1 : 0;
    if (throat_number[t] == 0) {
      i = pore_number[to_size(i)];
      j = pore_number[to_size(j)];
    }
  }
  const int dropped = network.pores() - pores;
  keep(network.pore_centre, pore_number);
  keep(network.pore_volume, pore_number);
  keep(network.pore_radius, pore_number);
  keep(network.pore_faces, pore_number);
  keep(network.pore_walls, pore_number);
  keep(network.throat_pores, throat_number);
  for (auto* values : {&network.throat_area, &network.throat_length, &network.throat_conductance, &network.throat_radius,
                       &network.throat_entry_radius, &network.throat_snap_off_radius})
    keep(*values, throat_number);
  return dropped;
}

}  // namespace puadem
