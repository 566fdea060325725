#include "puadem/io/checkpoint.hpp"

#include "puadem/base/error.hpp"
#include "puadem/build_info.hpp"
#include "puadem/dem/bridge_exchange.hpp"
#include "puadem/dem/contact_law.hpp"
#include "puadem/io/state_fields.hpp"
#include "puadem/io/state_hash.hpp"

namespace puadem {
namespace {

/// Adds what a checkpoint leaves out because it follows from the case.
void complete_state(const Case& c, State& state) {
  if (state.grains) {
    state.grains->pairs = material_pairs(c.materials, c.contact);
    state.grains->contact = c.contact;
    state.grains->law = contact_law(c.contact.law);
    if (state.grains->bridges) restore_bridges(*state.grains, bridge_model(c), *c.bridges);
  }
  if (!state.invasion) return;
  const RetentionStage* stage = nullptr;  // the last that has begun
  for (int k = 0; k < size_of(c.stages) && k <= state.position.stage; ++k)
    if (const auto* found = std::get_if<RetentionStage>(&c.stages[to_size(k)])) stage = found;
  require(stage != nullptr, "the checkpoint has fluids at rest, and the case no stage before it that puts them there");
  InvasionState started = start_invasion(state.network, c.fluids, stage->invasion);
  state.invasion->options = started.options;
  state.invasion->links = std::move(started.links);
  state.invasion->thresholds = std::move(started.thresholds);
  state.invasion->search = std::move(started.search);
}

}  // namespace

void write_checkpoint(const std::filesystem::path& path, std::string_view resolved_case, const State& state,
                      const RunResults& results, const std::function<void(ArchiveWriter&)>& more) {
  std::filesystem::path part = path;
  part += ".part";
  try {
    Hdf5File file = Hdf5File::create(part);
    ArchiveWriter archive(file);
    archive("format", checkpoint_format);
    archive("version", std::string(build_info::version));
    archive("commit", std::string(build_info::commit));
    archive("case", hex(fingerprint(resolved_case)));
    archive("state", state);
    archive("results", results);
    if (more) more(archive);
    file.close();
  } catch (const InputError&) {
    std::error_code ignored;
    std::filesystem::remove(part, ignored);
    throw;
  }
  std::filesystem::rename(part, path);
}

void read_checkpoint(const std::filesystem::path& path, const Case& c, std::string_view resolved_case, State& state,
                     RunResults& results, const std::function<void(ArchiveReader&)>& more) {
  const Hdf5File file = Hdf5File::open(path);
  ArchiveReader archive(file);
  int format = 0;
  archive("format", format);
  std::string version, of_case;
  archive("version", version);
  require(format == checkpoint_format,
          "'{}' has format {} of puadem {}; this is puadem {}, which reads format {}: go on with that version, or run anew",
          path.string(), format, version, build_info::version, checkpoint_format);
  archive("case", of_case);
  require(of_case == hex(fingerprint(resolved_case)), "'{}' belongs to another case", path.string());
  archive("state", state);
  archive("results", results);
  complete_state(c, state);
  if (more) more(archive);
}

}  // namespace puadem
