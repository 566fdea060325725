#include "puadem/io/network_file.hpp"

#include <fmt/format.h>

#include <array>
#include <fstream>
#include <string_view>
#include <system_error>

#include "puadem/io/text.hpp"

namespace puadem {

std::filesystem::path statoil_prefix(const std::filesystem::path& path) {
  const std::string name = path.string();
  for (const std::string_view ending : {"_node1.dat", "_node2.dat", "_link1.dat", "_link2.dat"})
    if (name.ends_with(ending)) return name.substr(0, name.size() - ending.size());
  return path;
}

NetworkFile read_network(const std::filesystem::path& path) {
  return path.extension() == ".csv" ? read_csv_network(path) : read_statoil_network(statoil_prefix(path));
}

bool is_network(const std::filesystem::path& path) {
  std::error_code failed;
  if (std::filesystem::exists(statoil_prefix(path).string() + "_node1.dat", failed)) return true;
  if (path.extension() != ".csv") return false;
  std::ifstream file(path);
  std::string heading;
  std::getline(file, heading);
  return heading.find("pore.") != std::string::npos;
}

std::string faces_with_pores(const PoreNetwork& network) {
  unsigned touched = 0;
  for (const std::uint8_t walls : network.pore_walls) touched |= walls;
  std::vector<std::string> names;
  for (int face = 0; face < 6; ++face)
    if (touched >> face & 1u) names.emplace_back(face_names[to_size(face)]);
  return names.empty() ? "none" : joined(names);
}

}  // namespace puadem
