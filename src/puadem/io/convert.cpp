#include "puadem/io/convert.hpp"

#include <fmt/format.h>

#include <optional>
#include <system_error>

#include "puadem/base/error.hpp"
#include "puadem/coupling/checked_network.hpp"
#include "puadem/io/case_file.hpp"
#include "puadem/io/network_file.hpp"
#include "puadem/io/packing_file.hpp"

namespace puadem {

namespace {

namespace fs = std::filesystem;
using Target = ConvertOptions::Target;

/// What was read: a packing, a network, or a packing whose case says how it becomes a network.
struct Source {
  std::optional<PackingFile> packing;
  std::optional<NetworkFile> network;
  Case c;  ///< options of the network
};

bool is_there(const fs::path& path) {
  std::error_code failed;
  return fs::exists(path, failed);
}

Source read_run(const fs::path& folder) {
  require(is_there(folder / "case.resolved.toml"), "{}: a folder without case.resolved.toml is no run of puadem",
          folder.string());
  Source source;
  source.c = read_case(folder / "case.resolved.toml").c;
  if (source.c.network_file)
    source.network = read_network(*source.c.network_file);
  else
    source.packing = read_packing(folder / "packing.csv");
  return source;
}

Source read_source(const fs::path& in, const ConvertOptions& options) {
  std::error_code failed;
  if (fs::is_directory(in, failed)) return read_run(in);
  Source source;
  if (is_network(in)) {
    source.network = read_network(in);
    return source;
  }
  require(in.has_extension() || is_there(in), "no such file: {0}, and no {0}_node1.dat", in.string());
  source.packing = read_packing(in);
  source.c.domain.periodic = options.periodic;
  source.c.pores.merge_ratio = options.merge_ratio;
  return source;
}

Target target_of(const fs::path& out, const Source& source, const ConvertOptions& options) {
  if (options.target != Target::by_name) return options.target;
  if (statoil_prefix(out) != out || !out.has_extension()) return Target::statoil;
  require(out.extension() == ".csv", "{}: the ending {} is not known; write NAME.csv, or NAME alone for Statoil's four files",
          out.string(), out.extension().string());
  require(source.network.has_value(), "{} may become a packing or a network: write --to packing or --to network", out.string());
  return Target::network;
}

/// The network of the source, made where it is a packing.
NetworkFile network_of(const Source& source, std::string& warnings) {
  if (source.network) return *source.network;
  State state;
  state.particles.position = source.packing->centre;
  state.particles.radius = source.packing->radius;
  state.domain = source.packing->box;
  state.domain.periodic = source.c.domain.periodic;
  Observer observer;
  observer.message = [&](std::string_view text) { warnings += fmt::format("{}\n", text); };
  NetworkFile file;
  file.network = checked_network(source.c, state, observer);
  file.box = state.domain;
  file.contact_angle = source.c.fluids.contact_angle;
  return file;
}

std::string write_packing_of(const Source& source, const fs::path& out) {
  require(source.packing.has_value(), "a network does not tell where its grains are: it cannot become a packing");
  write_packing(out, source.packing->centre, source.packing->radius, source.packing->box);
  return fmt::format("{}: {} grains\n", out.string(), source.packing->radius.size());
}

}  // namespace

std::string convert(const fs::path& in, const fs::path& out, const ConvertOptions& options) {
  const Source source = read_source(in, options);
  const Target target = target_of(out, source, options);
  const fs::path prefix = statoil_prefix(out);
  const fs::path first = target == Target::statoil ? fs::path(prefix.string() + "_node1.dat") : out;
  require(!is_there(first), "{} exists already; name another file", first.string());
  std::string text;
  const auto& read = source.packing ? source.packing->warnings : source.network->warnings;
  for (const std::string& warning : read) text += fmt::format("warning: {}\n", warning);
  if (target == Target::packing) return text + write_packing_of(source, out);

  const NetworkFile file = network_of(source, text);
  const PoreNetwork& n = file.network;
  if (target == Target::network) {
    write_csv_network(out, n, file.box, file.contact_angle);
    return text + fmt::format("{}: {} pores, {} throats; holds all that flow needs, bit for bit, but no grains\n", out.string(),
                              n.pores(), n.throats());
  }
  require(source.packing || file.reservoir_pores == 0 || options.inlet == 0,
          "this network has its inlet at the left face: write --inlet left");
  write_statoil_network(prefix, n, file.box, options.inlet);
  return text + fmt::format(
                    "{}_node1.dat, _node2.dat, _link1.dat, _link2.dat: {} pores, {} throats, from {} to {}; holds volumes, "
                    "conductances, radii and areas of section; entry and snap-off radii follow from these and are not those of "
                    "the grains; other faces, periodic axes and the contact angle are lost\n",
                    prefix.string(), n.pores(), n.throats(), face_names[to_size(options.inlet)],
                    face_names[to_size(opposite(options.inlet))]);
}

}  // namespace puadem
