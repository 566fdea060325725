#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "puadem/dem/contact_law.hpp"
#include "puadem/dem/material.hpp"
#include "puadem/dem/packing.hpp"
#include "puadem/flow/fluids.hpp"
#include "puadem/flow/invasion.hpp"
#include "puadem/network/pore_units.hpp"

namespace puadem {

/// The box. Either `size`, or a `shape` whose size follows from count, grading and porosity.
struct DomainOptions {
  std::optional<Vec3> size;  ///< edge lengths [m]
  Vec3 shape{1, 1, 1};       ///< proportions [-], used where size is not given
  std::array<bool, 3> periodic{false, false, false};
};

/// Where the grains come from: a grading and a count, or a packing file.
struct GrainOptions {
  std::optional<std::filesystem::path> file;  ///< x,y,z,r in metres; then count and grading are unused
  int count = 1000;
  Grading grading;
  std::string material = "glass";
  struct Share {
    std::string name;       ///< of a material
    double fraction = 1.0;  ///< of the solid volume [-]
  };
  std::vector<Share> materials;  ///< a mixture, in place of `material`
};

/// Stage "compact": a random cloud becomes a packing at rest under an isotropic stress.
struct CompactStage {
  using Region = CompactionOptions::Region;
  double stress = 10e3;                   ///< target mean stress [Pa]
  std::optional<double> porosity;         ///< target porosity [-]; none: whatever the friction gives
  std::optional<double> friction_angle;   ///< between all grains while compacting [rad]; none: that of their materials
  Region porosity_region = Region::core;  ///< core: farther than one largest diameter from every wall
  double unbalanced = 1e-3;               ///< unbalanced force ratio at which the packing is at rest [-]
  double damping = 0.4;                   ///< Cundall damping [-]
};

/// Stage "retention": capillary pressure steps, each to equilibrium, grains fixed.
struct RetentionStage {
  std::vector<double> path;  ///< turning points of the capillary pressure [Pa]
  double step = 100.0;       ///< output step along the path [Pa]
  InvasionOptions invasion;
};

using Stage = std::variant<CompactStage, RetentionStage>;

/// A curve or a finished result to draw beside this run's in the report.
struct Overlay {
  std::string label;
  std::filesystem::path folder;  ///< holds retention.csv and distributions.csv, or a run folder
};

struct OutputOptions {
  bool fields = true;    ///< write VTP files
  int fields_every = 1;  ///< in equilibria of a retention stage
};

/// A bound on a named result, checked at the end of a run.
struct Expected {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
};

/// Everything a run needs, in SI units: the resolved case file.
struct Case {
  std::string title = "untitled";
  std::uint64_t seed = 1;
  DomainOptions domain;
  GrainOptions grains;
  std::vector<Material> materials;
  ContactOptions contact;
  Fluids fluids;
  NetworkOptions pores;
  std::vector<Stage> stages;
  OutputOptions output;
  std::vector<Overlay> overlays;
  std::map<std::string, Expected> expected;
};

/// What the grains are made of, by index into `materials`.
/// @throws InputError  a name that no material has
std::vector<MaterialShare> grain_materials(const Case& c);

}  // namespace puadem
