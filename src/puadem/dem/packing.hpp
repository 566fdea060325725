#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "puadem/dem/contact_law.hpp"
#include "puadem/dem/grading.hpp"
#include "puadem/dem/grain_system.hpp"
#include "puadem/dem/material.hpp"
#include "puadem/dem/mixture.hpp"
#include "puadem/dem/particles.hpp"
#include "puadem/dem/stress.hpp"
#include "puadem/geometry/domain.hpp"

namespace puadem {

/// How a cloud becomes a packing.
struct CompactionOptions {
  enum class Region { core, box };
  double stress = 10e3;                  ///< isotropic [Pa]
  std::optional<double> porosity;        ///< target [-]; none: whatever the friction gives
  std::optional<double> friction_angle;  ///< between all grains while compacting [rad]; none: that of their materials
  Region region = Region::core;          ///< core: farther than one largest diameter from every wall
  double unbalanced = 1e-3;              ///< ratio at which the packing is at rest [-]
  double damping = 0.4;                  ///< Cundall damping [-]
  double safety = 0.5;                   ///< share of the critical time step [-]
  long max_steps = 2'000'000;
};

/// What a compaction has reached.
struct CompactionReport {
  double porosity_core = 0.0;  ///< NaN where the box is too small for a core
  double porosity_box = 0.0;
  double mean_stress = 0.0;      ///< [Pa]
  Vec3 axis_stress;              ///< on the walls of an axis, or of the contacts along a periodic axis [Pa]
  double unbalanced = 0.0;       ///< [-]
  double coordination = 0.0;     ///< [-]
  double friction_used = 0.0;    ///< between grains while compacting, mu; with a target porosity the lowest [-]
  double grading_error = 0.0;    ///< [-]
  double largest_overlap = 0.0;  ///< share of the smaller radius [-]
  double time_step = 0.0;        ///< last [s]
  long steps = 0;
  int list_builds = 0;
};

/// Where a compaction stands. Return false to stop: the result is then not at rest, but whole.
struct CompactionProgress {
  long step = 0;
  double porosity = 0.0;    ///< of the region asked for [-]
  double stress = 0.0;      ///< mean [Pa]
  double unbalanced = 0.0;  ///< [-]
  double fraction = 0.0;    ///< of the work, roughly, in [0, 1]
};
using CompactionCallback = std::function<bool(const CompactionProgress&)>;

/// Grains beside those of the grading, all alike.
struct AddedGrains {
  double radius = 0.0;     ///< [m]
  int material = 0;        ///< index into the materials of the case
  int count = 1;           ///< [-]
  std::optional<Vec3> at;  ///< of a single one: its centre in the cloud, as shares of the box [-]; none: anywhere
};

/// What to pack.
struct PackingSource {
  Grading grading;
  int count = 1000;
  std::vector<MaterialShare> materials{{}};  ///< what the grains are made of, by volume
  Vec3 shape{1, 1, 1};                       ///< proportions of the box [-]
  std::array<bool, 3> periodic{false, false, false};
  std::uint64_t seed = 1;
  enum class Cloud { uniform, clumped };
  Cloud cloud = Cloud::uniform;      ///< grains scattered one by one, or in clumps that all but touch; no rigid bodies
  double clump_size = 20.0;          ///< mean number of grains in a clump [-]
  std::vector<AddedGrains> added{};  ///< after the others in the arrays, before them in the cloud
};

struct Packing {
  Particles particles;
  Domain domain;  ///< lower corner at the origin
  CompactionReport report;
  std::optional<GrainSystem> system;  ///< of a compaction: the grains at rest with their contacts, forces evaluated
};

/// A random cloud of the grading, without overlaps, at a solid fraction of 0.3, or 0.08 in clumps. The time it takes is
/// linear in the number of grains at any ratio of their sizes.
Packing random_cloud(const PackingSource& source, std::span<const Material> materials);

/// A packing at rest under an isotropic stress (theory 2.15): a random cloud is strained with its box
/// until it carries the stress. How dense it gets is set in one of two ways: by `friction_angle`, which holds
/// until the packing is at rest (0 gives the densest one); or by `porosity`, for which the friction between
/// grains is lowered step by step. Then the grains' own friction is set again and the packing comes to rest
/// once more. Grain sizes are never changed.
/// @throws InputError      a target that the grading, the friction or the count cannot reach, with the reachable value;
///                         both a porosity and a friction angle
/// @throws NumericalError  no rest within `max_steps`
Packing make_packing(const PackingSource& source, std::span<const Material> materials, const ContactOptions& contact,
                     const CompactionOptions& options, const CompactionCallback& callback = {});

/// Contacts, stresses and unbalanced force of a given packing at rest in a given box; sets the forces.
/// @throws InputError  a grain outside the box
GrainMeasures evaluate_packing(Particles& particles, const Domain& domain, std::span<const Material> materials,
                               const ContactOptions& contact);

}  // namespace puadem
