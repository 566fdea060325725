// Runs the verification cases of the pore network and of one fluid in it and writes what came out as CSV files: the
// tables and figures of docs/validation.md. tools/verify_network calls it.
#include <limits>

#include "csv.hpp"
#include "one_fluid.hpp"
#include "verification/finney.hpp"

using namespace puadem;
using namespace puadem::verification;

namespace {

void write_radii(const std::filesystem::path& folder, const FinneyPacking& packing) {
  const FinneyRadii radii = inscribed_radii(packing);
  Csv percentiles(folder / "finney_percentiles.csv", "percent,throats,throats_reference,pores,pores_reference");
  for (std::size_t k = 0; k < finney_percent.size(); ++k)
    percentiles.row(finney_percent[k], percentile(radii.throats, finney_percent[k]), finney_throat_percentiles[k],
                    percentile(radii.pores, finney_percent[k]), finney_pore_percentiles[k]);
  Csv densities(folder / "finney_densities.csv", "radius,throats,throats_reference,pores,pores_reference");
  for (const FinneyDensities& bin : finney_densities_reference()) {
    constexpr double width = 0.02;
    const auto density = [&](const std::vector<double>& values) {
      double inside = 0.0;
      for (const double r : values) inside += r >= bin.radius - 0.5 * width && r < bin.radius + 0.5 * width;
      return inside / (width * static_cast<double>(values.size()));
    };
    densities.row(bin.radius, density(radii.throats), bin.throats, density(radii.pores), bin.pores);
  }
}

void write_drainage(const std::filesystem::path& folder, const FinneyPacking& packing) {
  std::vector<double> pressures;
  for (int k = 60; k <= 280; ++k) pressures.push_back(0.05 * k);
  Csv csv(folder / "finney_drainage.csv", "series,pressure,saturation");
  const auto write = [&](const char* series, const FinneyHeap& heap, const InvasionOptions& options) {
    const std::vector<double> saturation = drain_heap(heap, options, pressures);
    for (std::size_t k = 0; k < pressures.size(); ++k) csv.row(series, pressures[k], saturation[k]);
  };
  for (const FinneyDrainage& row : finney_drainage_reference()) {
    csv.row("reference: Haines", row.pressure, row.haines);
    csv.row("reference: Mayer-Stowe-Princen", row.pressure, row.mayer_stowe_princen);
  }
  NetworkOptions options;
  options.merge_ratio = std::numeric_limits<double>::infinity();
  FinneyHeap heap = finney_heap(packing, options, HeapReservoirs::gas_around);
  write("Mayer-Stowe-Princen", heap, plain_percolation());
  enter_with_fitting_menisci(packing, heap.network);
  write("arcs where they fit", heap, plain_percolation());
  options.entry_law = Haines{};
  write("Haines", finney_heap(packing, options, HeapReservoirs::gas_around), plain_percolation());
  write("defaults", finney_heap(packing, {}, HeapReservoirs::gas_on_top), {});
  options = {};
  options.throat_section = ThroatOutline::window;
  write("defaults with windows", finney_heap(packing, options, HeapReservoirs::gas_on_top), {});
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2 && argc != 3) {
    fmt::print(stderr, "usage: verify_network FOLDER [FOLDER OF finney_packing_4021.csv]\n");
    return 1;
  }
  const std::filesystem::path folder = argv[1];
  std::filesystem::create_directories(folder);
  if (const FinneyPacking packing = read_finney_packing(argc == 3 ? argv[2] : ""); !packing.centre.empty()) {
    write_radii(folder, packing);
    write_drainage(folder, packing);
  }
  write_throats(folder);
  write_lattices(folder);
  write_invariances(folder);
  write_columns(folder);
  write_random_packings(folder);
}
