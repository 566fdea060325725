// Cost of the pore network and of one fluid in it, from 1,000 to a million grains on one thread: seconds of each
// stage, bytes, and how both grow. Usage: bench_network_scale [largest number of grains]

#include <sys/resource.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>

#include "puadem/base/random.hpp"
#include "puadem/flow/single_phase_flow.hpp"
#include "puadem/network/merging.hpp"
#include "puadem/network/network_geometry.hpp"
#include "puadem/network/pore_units.hpp"

using namespace puadem;

namespace {

struct Bed {
  std::vector<Vec3> centre;
  std::vector<double> radius;
  Domain box;
};

/// Body-centred cells shaken by a tenth of the spacing, radii 1 : 1.3: a bed of any size, without overlaps, whose
/// triangulation has no ties. Walls below and above, periodic sideways.
Bed make_bed(int grains) {
  const int n = static_cast<int>(std::lround(std::cbrt(grains / 2.0)));
  const double edge = 1e-3;
  Bed bed;
  bed.box = {{0, 0, 0}, {n * edge, n * edge, n * edge}, {true, true, false}};
  Random random(1);
  for (int i = 0; i < 2 * n * n * n; ++i) {
    const int k = i / 2;
    const double corner = 0.25 + 0.5 * (i % 2);
    const auto jitter = [&] { return random.uniform(-0.05, 0.05); };
    const double x = k % n + corner + jitter(), y = k / n % n + corner + jitter(), z = k / (n * n) + corner + jitter();
    bed.centre.push_back(edge * Vec3{x, y, z});
    bed.radius.push_back(edge * random.uniform(0.3, 0.38));
  }
  return bed;
}

double processor_seconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& t) { return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec); };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

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
  int grains = 0, cells = 0, throats = 0, iterations = 0;
  double triangulate = 0, geometry = 0, merge = 0, build = 0, first = 0, again = 0, bytes = 0;
};

Row measure(int grains) {
  const Bed bed = make_bed(grains);
  const double before = peak_bytes();
  Row row;
  row.grains = size_of(bed.radius);
  NetworkOptions options;
  {
    const PackingSites sites_of(bed.centre, bed.radius, bed.box);
    Triangulation triangulation;
    row.triangulate = timed([&] { triangulation = triangulate(bed.centre, bed.radius, bed.box); });
    row.cells = triangulation.cells();
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
    row.merge =
        timed([&] { merge_cells(triangulation.cells(), facets, cells.void_volume, faces, wide, geometry.void_area, {}); });
  }
  options.merge_ratio = std::numeric_limits<double>::infinity();
  PoreNetwork network;
  row.build = timed([&] { network = build_pore_network(bed.centre, bed.radius, bed.box, options); });
  row.throats = network.throats();
  SinglePhaseMemory memory;
  SinglePhaseProblem problem;
  problem.faces[4] = {FaceCondition::Kind::pressure, 1.0};
  problem.faces[5] = {FaceCondition::Kind::pressure, 0.0};
  row.first = timed([&] { row.iterations = solve_single_phase(network, bed.box, problem, memory).solve.iterations; });
  std::swap(problem.faces[4].value, problem.faces[5].value);  // far from the last solution
  row.again = timed([&] { solve_single_phase(network, bed.box, problem, memory); });
  row.bytes = peak_bytes() - before;
  return row;
}

double exponent(double small, double large, double ratio) { return std::log(large / small) / std::log(ratio); }

}  // namespace

int main(int count, char** arguments) {
  const int largest = count > 1 ? std::atoi(arguments[1]) : 100000;
  set_threads(1);
  std::printf("processor seconds on one thread; bytes at the peak\n");
  std::printf("%9s %9s %11s %9s %9s %9s %9s %9s %5s %11s %9s\n", "grains", "cells", "triangulate", "geometry", "merge", "network",
              "solve", "re-solve", "it", "bytes/grain", "B/cell");
  Row last;
  for (int grains = 1000; grains <= largest; grains *= 10) {
    const Row r = measure(grains);
    std::printf("%9d %9d %11.4f %9.4f %9.4f %9.4f %9.4f %9.4f %5d %11.0f %9.0f\n", r.grains, r.cells, r.triangulate, r.geometry,
                r.merge, r.build, r.first, r.again, r.iterations, r.bytes / r.grains, r.bytes / r.cells);
    if (last.grains > 0) {
      const double by = static_cast<double>(r.grains) / last.grains;
      std::printf("%9s %9s %11.2f %9.2f %9.2f %9.2f %9.2f %9.2f\n", "growth", "", exponent(last.triangulate, r.triangulate, by),
                  exponent(last.geometry, r.geometry, by), exponent(last.merge, r.merge, by), exponent(last.build, r.build, by),
                  exponent(last.first, r.first, by), exponent(last.again, r.again, by));
    }
    last = r;
  }
}
