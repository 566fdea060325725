// Grains and fluid that move each other: the numbers of docs/validation.md, chapter 11. Usage: verify_coupling FOLDER
#include <algorithm>
#include <cmath>

#include "verification/coupled.hpp"
#include "verification/program/csv.hpp"
#include "verification/remesh.hpp"

using namespace puadem::verification;

namespace {

void write_identities(const std::filesystem::path& folder) {
  Csv csv(folder / "identities.csv", "what,found");
  for (const Identity& i : force_identities()) csv.row('"' + i.what + '"', i.found);
  csv.row("\"step of the grains with a new network every step, over that with none, less one\"", time_step_change_by_remeshing());
}

void write_resting_beds(const std::filesystem::path& folder) {
  Csv csv(folder / "resting_beds.csv", "grains,weight,force,unbalanced");
  for (const int count : {100, 200, 400}) {
    const RestingBed bed = rest_in_water(count);
    csv.row(count, bed.weight, bed.force, bed.unbalanced);
  }
}

void write_energy(const std::filesystem::path& folder) {
  Csv csv(folder / "energy.csv", "substeps,interval,taken,gained");
  for (const long substeps : {1, 2, 4, 8, 16, 32, 64}) {
    const EnergyGain gain = gain_of_energy(substeps);
    csv.row(substeps, gain.interval, gain.taken, gain.gained);
  }
}

constexpr int networks = 1000;

void write_sheared(const std::filesystem::path& folder) {
  Csv csv(folder / "remesh_sheared.csv", "grains,networks,cells,shear,ledger,overfull,saturation,saturation_last,bits");
  for (const int count : {60, 150, 300}) {
    const ShearedLayer l = shear_under_suction(count, networks);
    csv.row(count, l.remeshes, l.cells_renewed, l.shear, l.ledger, l.overfull, l.saturation, l.saturation_last,
            bits_changed_at_rest(count, networks));
  }
}

void write_fronts(const std::filesystem::path& folder) {
  Csv csv(folder / "remesh_front.csv", "displacement,networks,cells,passed,farthest,water");
  for (const double displacement : {0.02, 0.05, 0.1}) {
    const RemeshedFront f = front_through(300, networks, displacement);
    csv.row(displacement, f.remeshes, f.cells_renewed, f.passed, f.farthest, f.water);
  }
}

void write_drainages(const std::filesystem::path& folder) {
  Csv csv(folder / "remesh_drainage.csv", "grains,networks,networks_tenth,largest_strain,saturation_apart,strain_apart");
  for (const int count : {150, 200, 300, 600}) {
    const RemeshedDrainage each = drain_with_remeshes(count, 1), tenth = drain_with_remeshes(count, 10);
    double saturation = 0.0, strain = 0.0;
    for (std::size_t k = 0; k < each.strain.size(); ++k) {
      saturation = std::max(saturation, std::abs(each.saturation[k] - tenth.saturation[k]));
      strain = std::max(strain, std::abs(each.strain[k] - tenth.strain[k]));
    }
    csv.row(count, each.remeshes, tenth.remeshes, *std::ranges::max_element(each.strain), saturation, strain);
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    fmt::print(stderr, "usage: verify_coupling FOLDER\n");
    return 1;
  }
  const std::filesystem::path folder = argv[1];
  std::filesystem::create_directories(folder);
  write_identities(folder);
  write_resting_beds(folder);
  write_sheared(folder);
  write_fronts(folder);
  write_drainages(folder);
  write_energy(folder);
  return 0;
}
