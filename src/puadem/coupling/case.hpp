#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

#include "puadem/coupling/case_bridges.hpp"
#include "puadem/coupling/saturated_stage.hpp"
#include "puadem/coupling/two_phase_stage.hpp"
#include "puadem/coupling/unsaturated_stage.hpp"
#include "puadem/dem/contact_law.hpp"
#include "puadem/dem/material.hpp"
#include "puadem/dem/packing.hpp"
#include "puadem/flow/fluids.hpp"
#include "puadem/flow/invasion.hpp"
#include "puadem/flow/single_phase_flow.hpp"
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
  struct Added {
    double diameter = 0.0;   ///< [m]
    std::string material;    ///< name
    int count = 1;           ///< [-]
    std::optional<Vec3> at;  ///< see `AddedGrains`
  };
  std::vector<Added> added;  ///< grains beside those of the grading
  PackingSource::Cloud cloud = PackingSource::Cloud::uniform;
  double clump_size = 20.0;  ///< mean number of grains in a clump [-]
};

/// Stage "compact": a random cloud becomes a packing at rest under an isotropic stress.
struct CompactStage {
  static constexpr std::string_view kind = "compact";
  using Region = CompactionOptions::Region;
  double stress = 10e3;                   ///< target mean stress [Pa]
  std::optional<double> porosity;         ///< target porosity [-]; none: whatever the friction gives
  std::optional<double> friction_angle;   ///< between all grains while compacting [rad]; none: that of their materials
  Region porosity_region = Region::core;  ///< core: farther than one largest diameter from every wall
  double unbalanced = 1e-3;               ///< unbalanced force ratio at which the packing is at rest [-]
  double damping = 0.4;                   ///< Cundall damping [-]
};

/// Stage "isotropic": a mean stress on all axes, until the grains are at rest.
struct IsotropicStage {
  static constexpr std::string_view kind = "isotropic";
  double stress = 100e3;     ///< [Pa]
  double unbalanced = 1e-3;  ///< unbalanced force ratio at which the packing is at rest [-]
  double damping = 0.2;      ///< Cundall damping [-]
};

/// Stage "oedometer": the lateral faces stand, the box is shortened or stretched along z.
struct OedometerStage {
  static constexpr std::string_view kind = "oedometer";
  std::vector<double> path;           ///< turning points of the axial stress [Pa]
  std::optional<double> strain;       ///< in place of a path: logarithmic axial strain to reach [-]
  std::optional<double> strain_rate;  ///< [1/s]; none: at the quasi-static inertial number
  double damping = 0.2;               ///< [-]
};

/// Stage "triaxial": shortened along z while the lateral stress, the mean stress or the volume is held.
struct TriaxialStage {
  static constexpr std::string_view kind = "triaxial";
  enum class StressPath { constant_lateral, constant_mean, constant_volume };
  double stress = 100e3;  ///< lateral or mean stress to hold [Pa]
  StressPath path = StressPath::constant_lateral;
  double strain = 0.2;                ///< logarithmic axial strain to reach, negative: extension [-]
  std::optional<double> strain_rate;  ///< its magnitude [1/s]; none: at the quasi-static inertial number
  double damping = 0.2;               ///< [-]
};

/// Stage "shear": the two walls of an axis slide against each other under a normal stress.
struct ShearStage {
  static constexpr std::string_view kind = "shear";
  int axis = 2;                      ///< whose walls slide
  int direction = 0;                 ///< of the sliding
  double normal_stress = 100e3;      ///< [Pa]
  double strain = 0.2;               ///< shear strain to reach: relative displacement / height [-]
  std::optional<double> shear_rate;  ///< relative speed / height at the start [1/s]; none: quasi-static
  double damping = 0.2;              ///< [-]
};

/// Stage "settle": grains move in the box as it stands, until they are at rest.
struct SettleStage {
  static constexpr std::string_view kind = "settle";
  double time = 1.0;         ///< after which the stage ends, at rest or not [s]
  double unbalanced = 1e-3;  ///< [-]
  double damping = 0.2;      ///< [-]
};

/// Stage "strain": along every axis a rate of strain, or a stress that is held.
struct StrainStage {
  static constexpr std::string_view kind = "strain";
  std::array<std::optional<double>, 3> stress;  ///< [Pa]
  Vec3 strain_rate;                             ///< where no stress is held, shortening positive [1/s]
  double time = 1.0;                            ///< [s]
  double damping = 0.2;                         ///< [-]
};

/// Stage "retention": capillary pressure steps, each to equilibrium, grains fixed.
struct RetentionStage {
  static constexpr std::string_view kind = "retention";
  std::vector<double> path;  ///< turning points of the capillary pressure [Pa]
  double step = 100.0;       ///< output step along the path [Pa]
  InvasionOptions invasion;
};

/// Stage "permeability": one fluid driven along every axis of the box, grains fixed.
struct PermeabilityStage {
  static constexpr std::string_view kind = "permeability";
  int inlet = 5;                  ///< face from which fluid is driven through the box for fields and profile
  double pressure_drop = 1000.0;  ///< over the box, along that axis [Pa]
  bool merged = false;            ///< on merged pore units, which have no resistance inside
  int layers = 20;                ///< of the profile
};

using Stage = std::variant<CompactStage, IsotropicStage, OedometerStage, TriaxialStage, ShearStage, SettleStage, StrainStage,
                           PermeabilityStage, RetentionStage, TwoPhaseStage, SaturatedStage, UnsaturatedStage>;

/// Does this stage put fluid into the pores of grains that stand? It then needs a network, made or from a file.
template <class S>
inline constexpr bool is_flowing =
    std::is_same_v<S, PermeabilityStage> || std::is_same_v<S, RetentionStage> || std::is_same_v<S, TwoPhaseStage>;

/// Do grains and fluid move each other in this stage? It needs grains, and makes its network from them.
template <class S>
inline constexpr bool is_coupled = std::is_same_v<S, SaturatedStage> || std::is_same_v<S, UnsaturatedStage>;

/// Does this stage load the grains that another one, or a file, has made?
template <class S>
inline constexpr bool is_loading = !std::is_same_v<S, CompactStage> && !is_flowing<S> && !is_coupled<S>;

inline std::string_view kind_of(const Stage& stage) {
  return std::visit([](const auto& s) { return std::decay_t<decltype(s)>::kind; }, stage);
}

inline bool puts_fluid(const Stage& stage) {
  return std::visit([](const auto& s) { return is_flowing<std::decay_t<decltype(s)>>; }, stage);
}

inline bool couples(const Stage& stage) {
  return std::visit([](const auto& s) { return is_coupled<std::decay_t<decltype(s)>>; }, stage);
}

/// How grains are moved, in every stage.
struct MotionCase {
  Vec3 gravity{};       ///< in all stages but "compact" [m/s2]
  double safety = 0.5;  ///< share of the critical time step [-]
};

/// A curve or a finished result to draw beside this run's in the report.
struct Overlay {
  std::string label;
  std::filesystem::path folder;  ///< holds retention.csv and distributions.csv, or a run folder
};

/// States worth a set of fields and a picture.
struct FieldsAt {
  std::vector<double> saturation;  ///< of a stage with two fluids that move [-]
};

struct OutputOptions {
  bool fields = true;      ///< write VTP files
  int fields_every = 1;    ///< in equilibria of a retention stage
  int fields_count = 10;   ///< sets of files of a stage that loads the grains
  int history_rows = 200;  ///< of a stage that loads the grains, or of one with two fluids that move
  FieldsAt fields_at;
  enum class Checkpoints { latest, all };
  Checkpoints checkpoints = Checkpoints::latest;  ///< those that stay: the last two, until the run is at its end; or all
  double checkpoint_every = 300.0;                ///< of wall time [s]
};

/// A bound on a named result, checked at the end of a run.
struct Expected {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
};

/// How grains become pores and throats, and bounds on what throats conduct.
struct PoreOptions : NetworkOptions {
  std::optional<ConductanceLimits> conductance_limits;
};

/// Everything a run needs, in SI units: the resolved case file.
struct Case {
  std::string title = "untitled";
  std::uint64_t seed = 1;
  DomainOptions domain;
  GrainOptions grains;
  std::optional<std::filesystem::path> network_file;  ///< a network in place of grains
  std::vector<Material> materials;
  ContactOptions contact;
  MotionCase motion;
  std::optional<BridgeCase> bridges;  ///< none: grains without liquid between them
  Fluids fluids;
  PoreOptions pores;
  std::vector<Stage> stages;
  OutputOptions output;
  std::vector<Overlay> overlays;
  std::map<std::string, Expected> expected;
};

/// What the grains are made of, by index into `materials`.
/// @throws InputError  a name that no material has
std::vector<MaterialShare> grain_materials(const Case& c);

/// Grains beside those of the grading.
/// @throws InputError  a name that no material has
std::vector<AddedGrains> added_grains(const Case& c);

/// Name of a stage in series and results: its kind, from the second of a kind on with a number, "triaxial-2".
std::string stage_name(const Case& c, int index);

}  // namespace puadem
