// Cost of the pore network and of one fluid in it, from 1,000 to a million grains on one thread: seconds of each
// stage, bytes, and how both grow. Usage: bench_network_scale [largest number of grains [PACKING.csv ...]]

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>

#include "puadem/flow/single_phase_flow.hpp"
#include "puadem/io/packing_file.hpp"
#include "puadem/network/merging.hpp"
#include "puadem/network/network_geometry.hpp"
#include "puadem/network/pore_units.hpp"
#include "shaken_bed.hpp"

using namespace puadem;

namespace {

constexpr int largest_factored = 60000;  // the factor of more takes gigabytes

double peak_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

template <class Work>
double timed(const Work& work) {
  const double start = processor_seconds();
  work();
  return processor_seconds() - start;
}

struct Row {
  int grains = 0, cells = 0, iterations = 0;
  double triangulate = 0, geometry = 0, merge = 0, network = 0, first = 0, again = 0, factor = 0, factored = 0, bytes = 0;
};

/// One after another, inlet and outlet exchanged: as far from the last solution as it gets.
void solve_twice(const PoreNetwork& network, const Domain& box, PressureSolverOptions::Method method, double& first,
                 double& again, int& iterations) {
  SinglePhaseMemory memory;
  memory.solver.method = method;
  SinglePhaseProblem problem;
  problem.faces[4] = {FaceCondition::Kind::pressure, 1.0};
  problem.faces[5] = {FaceCondition::Kind::pressure, 0.0};
  first = timed([&] { iterations = solve_single_phase(network, box, problem, memory).solve.iterations; });
  std::swap(problem.faces[4].value, problem.faces[5].value);
  again = timed([&] { solve_single_phase(network, box, problem, memory); });
}

Row measured_here(const ShakenBed& bed) {
  const double before = peak_bytes();
  Row row;
  row.grains = size_of(bed.radius);
  NetworkOptions options;
  options.merge_ratio = std::numeric_limits<double>::infinity();
  PoreNetwork network;
  row.network = timed([&] { network = build_pore_network(bed.centre, bed.radius, bed.box, options); });
  row.cells = network.triangulation.cells();
  solve_twice(network, bed.box, PressureSolverOptions::Method::multigrid, row.first, row.again, row.iterations);
  row.bytes = peak_bytes() - before;
  if (row.grains <= largest_factored) {
    int none = 0;
    solve_twice(network, bed.box, PressureSolverOptions::Method::cholesky, row.factor, row.factored, none);
  }
  const PackingSites sites_of(bed.centre, bed.radius, bed.box);
  Triangulation triangulation;
  row.triangulate = timed([&] { triangulation = triangulate(bed.centre, bed.radius, bed.box); });
  CellGeometry cells;
  const std::vector<Facet> facets = find_facets(triangulation);
  FacetGeometry geometry(0);
  row.geometry = timed([&] {
    cells = measure_cells(triangulation, sites_of);
    geometry = measure_facets(triangulation, facets, cells, sites_of, options);
  });
  std::vector<double> wide(facets.size());
  for (std::size_t f = 0; f < wide.size(); ++f) wide[f] = 2.0 * geometry.entry_radius[f];
  const std::vector<int> faces(to_size(triangulation.cells()), 4);
  row.merge = timed([&] { merge_cells(triangulation.cells(), facets, cells.void_volume, faces, wide, geometry.void_area, {}); });
  return row;
}

/// In a process of its own, whose peak of memory is its alone.
Row measure(const ShakenBed& bed) {
  int ends[2];
  if (pipe(ends) != 0) return {};
  const pid_t child = fork();
  if (child == 0) {
    const Row row = measured_here(bed);
    _exit(write(ends[1], &row, sizeof row) == sizeof row ? 0 : 1);
  }
  Row row;
  close(ends[1]);
  if (read(ends[0], &row, sizeof row) != sizeof row) std::printf("a measurement failed\n");
  close(ends[0]);
  waitpid(child, nullptr, 0);
  return row;
}

void print(const char* name, const Row& r) {
  std::printf("| %s | %d | %d | %.4f | %.4f | %.4f | %.4f | %.4f | %.4f | %d | ", name, r.grains, r.cells, r.triangulate,
              r.geometry, r.merge, r.network, r.first, r.again, r.iterations);
  if (r.factor > 0)
    std::printf("%.4f | %.4f", r.factor, r.factored);
  else
    std::printf(" | ");
  std::printf(" | %.0f | %.0f |\n", r.bytes / r.grains, r.bytes / r.cells);
  std::fflush(stdout);
}

void print_growth(const Row& small, const Row& large) {
  const auto exponent = [&](double a, double b) {
    return a > 0 && b > 0 ? std::log(b / a) / std::log(static_cast<double>(large.grains) / small.grains) : 0.0;
  };
  std::printf("| exponent |  |  | %.2f | %.2f | %.2f | %.2f | %.2f | %.2f |  |  |  |  |  |\n",
              exponent(small.triangulate, large.triangulate), exponent(small.geometry, large.geometry),
              exponent(small.merge, large.merge), exponent(small.network, large.network), exponent(small.first, large.first),
              exponent(small.again, large.again));
}

}  // namespace

int main(int count, char** arguments) {
  const int largest = count > 1 ? std::atoi(arguments[1]) : 100000;
  set_threads(1);
  std::printf(
      "Processor seconds on one thread; bytes at the peak, up to the solves by multigrid.\n\n"
      "| packing | grains | tetrahedra | triangulate | geometry | merge | network, unmerged | first solve | re-solve | "
      "iterations | first, factor | "
      "re-solve, factor | bytes/grain | bytes/tetrahedron |\n|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
  for (int k = 2; k < count; ++k) {
    const PackingFile file = read_packing(arguments[k]);
    print("walled", measure({file.centre, file.radius, file.box}));
  }
  Row last;
  for (int grains = 1000; grains <= largest; grains *= 10) {
    const Row row = measure(make_shaken_bed(grains, true));
    print("bed", row);
    if (last.grains > 0) print_growth(last, row);
    last = row;
  }
}
