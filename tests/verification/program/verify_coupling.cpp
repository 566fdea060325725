// Grains and fluid that move each other: the numbers of docs/validation.md, chapter 11. Usage: verify_coupling FOLDER
#include "verification/coupled.hpp"
#include "verification/program/csv.hpp"

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
  write_energy(folder);
  return 0;
}
