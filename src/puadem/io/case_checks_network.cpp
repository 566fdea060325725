#include <fmt/format.h>

#include <array>
#include <system_error>

#include "puadem/base/parallel.hpp"
#include "puadem/io/case_file.hpp"
#include "puadem/io/network_file.hpp"

namespace puadem {

namespace {

void check_unused_keys(const TomlValue& tree, Problems& problems) {
  for (const std::string_view table : {"domain", "grains", "materials", "contact", "motion"})
    if (const TomlValue* found = tree.find(table))
      problems.error(
          found->key_place,
          fmt::format("{} is not used with network.file: the network comes with its box and without grains; remove it", table));
  const TomlValue* pores = tree.find("pores");
  if (pores == nullptr || pores->kind != TomlValue::Kind::table) return;
  for (const TomlValue& entry : pores->children)
    if (entry.key != "conductance_limits")
      problems.error(
          entry.key_place,
          fmt::format("pores.{} is not used with network.file: pores and throats are taken as they are; remove it", entry.key));
}

void check_file(const TomlValue& tree, const std::filesystem::path& path, Problems& problems) {
  const Place place = tree.find("network")->find("file")->place;
  std::error_code failed;
  if (path.extension() == ".csv") {
    if (!std::filesystem::exists(path, failed)) return problems.error(place, fmt::format("no such file: {}", path.string()));
    if (!is_network(path))
      problems.error(place, fmt::format("{} has no column of pores; a packing is named by grains.file", path.string()));
    return;
  }
  const std::string first = statoil_prefix(path).string() + "_node1.dat";
  if (!std::filesystem::exists(first, failed))
    problems.error(place,
                   fmt::format("no such file: {}; give a table (.csv) or the beginning of the names of four files", first));
}

}  // namespace

void check_network_case(const TomlValue& tree, const Case& c, Problems& problems) {
  check_unused_keys(tree, problems);
  check_file(tree, *c.network_file, problems);
  const TomlValue* stages = tree.find("stage");
  if (stages == nullptr || stages->kind != TomlValue::Kind::array || stages->children.size() != c.stages.size()) return;
  for (std::size_t i = 0; i < c.stages.size(); ++i)
    if (!puts_fluid(c.stages[i])) {
      const TomlValue* kind = stages->children[i].find("kind");
      problems.error(
          kind->place,
          fmt::format("a stage \"{}\" needs grains, and network.file brings none; allowed: stages that put fluid into the "
                      "pores, such as permeability and retention",
                      kind_of(c.stages[i])));
    }
}

}  // namespace puadem
