#include "puadem/io/state_hash.hpp"

#include <fmt/format.h>

#include <type_traits>

namespace puadem {
namespace {

template <class T>
std::string_view bytes_of(const T& value) {
  static_assert(std::has_unique_object_representations_v<T> || std::is_same_v<T, double> || std::is_same_v<T, Vec3>);
  return {reinterpret_cast<const char*>(&value), sizeof(T)};
}

struct Hasher {
  std::uint64_t hash = fingerprint("");

  template <class T>
  void add(const T& value) {
    hash = fingerprint(bytes_of(value), hash);
  }
  template <class T>
  void add(const std::vector<T>& values) {
    add(size_of(values));  // so that an entry cannot move from one array to the next unseen
    for (const T& value : values) add(value);
  }
};

}  // namespace

std::uint64_t fingerprint(std::string_view bytes, std::uint64_t hash) {
  for (const char byte : bytes) {
    hash ^= static_cast<unsigned char>(byte);
    hash *= 0x100000001b3ULL;
  }
  return hash;
}

std::uint64_t state_hash(const State& state) {
  Hasher h;
  h.add(state.time);
  h.add(state.domain.lower);
  h.add(state.domain.upper);
  const Particles& p = state.particles;
  h.add(p.position);
  h.add(p.velocity);
  h.add(p.angular_velocity);
  h.add(p.radius);
  h.add(p.material);
  const PoreNetwork& n = state.network;
  h.add(n.pore_centre);
  h.add(n.pore_volume);
  h.add(n.pore_radius);
  h.add(n.pore_faces);
  h.add(n.throat_pores);
  h.add(n.throat_area);
  h.add(n.throat_radius);
  h.add(n.throat_entry_radius);
  h.add(n.throat_snap_off_radius);
  h.add(state.saturation);
  for (const PermeabilityResult& r : state.permeability) {
    h.add(std::vector<Vec3>(r.permeability.tensor.begin(), r.permeability.tensor.end()));
    h.add(r.linear_error);
  }
  if (state.flow) {
    h.add(state.flow->time);
    h.add(state.flow->wetting_volume);
    h.add(state.flow->wetting_pressure);
    h.add(state.flow->nonwetting_pressure);
    h.add(state.flow->nonwetting.holds);
    h.add(state.flow->nonwetting.passes);
  }
  if (state.grains && state.grains->bridges) {
    h.add(state.grains->bridges->bridges.volume);
    h.add(state.grains->bridges->film);
  }
  for (const RetentionRow& row : state.retention) {
    h.add(row.step);
    h.hash = fingerprint(row.branch, h.hash);
    h.add(row.capillary_pressure);
    h.add(row.saturation);
    h.add(row.trapped_wetting);
    h.add(row.trapped_nonwetting);
  }
  return h.hash;
}

std::string hex(std::uint64_t value) { return fmt::format("{:016x}", value); }

}  // namespace puadem
