#include "puadem/geometry/throat_domain.hpp"

#include <cmath>
#include <limits>

#include "puadem/geometry/cell.hpp"
#include "puadem/geometry/solid_angle.hpp"

namespace puadem {

ThroatDomain throat_domain(const std::array<Site, 3>& sites, const ThroatSection& section, const Vec3& from, const Vec3& to) {
  const Vec3 normal = facet_normal(sites);
  const Vec3& on_facet = sites[first_grain(sites)].centre;
  const double low = dot(normal, from - on_facet), high = dot(normal, to - on_facet);
  const double upwards = high > low ? 1.0 : -1.0;

  ThroatDomain domain;
  domain.length = norm(to - from);
  domain.void_volume = section.facet_area * std::abs(high - low) / 3.0;
  for (unsigned k = 0; k < 3; ++k) {
    const Site& site = sites[k];
    if (site.is_wall) {  // both power centres lie on the wall: a kite, its diagonals the facet's side and the axis
      domain.solid_area[k] = 0.5 * section.side[k].extent * domain.length;
      continue;
    }
    const Vec3 a = edge_from(site, sites[(k + 1) % 3]), b = edge_from(site, sites[(k + 2) % 3]);
    const double angle = upwards * (std::copysign(solid_angle(a, b, to - site.centre), high) -
                                    std::copysign(solid_angle(a, b, from - site.centre), low));
    domain.solid_area[k] = site.radius * site.radius * angle;
    domain.void_volume -= site.radius * domain.solid_area[k] / 3.0;
  }
  return domain;
}

double throat_conductance(const ThroatDomain& domain, double void_area, double solid_area, double grain_size) {
  constexpr double coincident = 1e-9;
  if (domain.length < coincident * grain_size) return std::numeric_limits<double>::infinity();
  if (void_area <= 0.0 || domain.void_volume <= 0.0 || solid_area <= 0.0) return 0.0;
  const double hydraulic_radius = domain.void_volume / solid_area;
  return 0.5 * void_area * hydraulic_radius * hydraulic_radius / domain.length;
}

}  // namespace puadem
