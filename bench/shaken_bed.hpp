#pragma once

#include <sys/resource.h>

#include <cmath>
#include <vector>

#include "puadem/base/random.hpp"
#include "puadem/base/vec3.hpp"
#include "puadem/geometry/domain.hpp"

namespace puadem {

struct ShakenBed {
  std::vector<Vec3> centre;
  std::vector<double> radius;
  Domain box;
};

/// Body-centred cells shaken by a tenth of the spacing, radii 1 : 1.3: a bed of any size, without overlaps, whose
/// triangulation has no ties. Walls below and above.
inline ShakenBed make_shaken_bed(int grains, bool is_periodic_sideways) {
  const int n = static_cast<int>(std::lround(std::cbrt(grains / 2.0)));
  const double edge = 1e-3;
  ShakenBed bed;
  bed.box = {{0, 0, 0}, {n * edge, n * edge, n * edge}, {is_periodic_sideways, is_periodic_sideways, false}};
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

inline double processor_seconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& t) { return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec); };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

}  // namespace puadem
