#include "puadem/flow/throat_films.hpp"

#include <algorithm>
#include <cmath>

#include "puadem/geometry/corner_meniscus.hpp"

namespace puadem {

namespace {

constexpr double usual_wetting = 0.04, usual_exponent = 3.0;

/// Wetting fluid in the corners of a section at one radius of curvature.
struct Corners {
  double area = 0.0;     ///< [m2]
  double wetted = 0.0;   ///< solid behind the menisci [m]
  double menisci = 0.0;  ///< their length [m]
  int without = 0;       ///< crevices too wide for a meniscus, or whose meniscus reaches past the facet
};

Corners corners_at(const ThroatSection& section, double r, double contact_angle) {
  Corners sum;
  for (int k = 0; k < section.sides; ++k) {
    const bool stands = 2.0 * r * std::cos(contact_angle) >= section.crevice[to_size(k)].gap;
    const CornerMeniscus m = stands ? corner_meniscus(section, k, r, contact_angle) : CornerMeniscus{};
    if (m.area <= 0.0) {
      ++sum.without;
      continue;
    }
    sum.area += m.area;
    sum.wetted += m.wetted_first + m.wetted_next;
    sum.menisci += r * m.angle;
  }
  return sum;
}

/// A R_h^2 over that of the whole section, R_h = A / L.
double share(double area, double perimeter, const ThroatSection& section) {
  const double area_ratio = area / section.void_area, perimeter_ratio = perimeter / section.solid_perimeter();
  return area_ratio * area_ratio * area_ratio / (perimeter_ratio * perimeter_ratio);
}

}  // namespace

ThroatFilms usual_throat_films(const PoreNetwork& network) {
  const std::size_t throats = to_size(network.throats());
  return {std::vector(throats, usual_wetting), std::vector(throats, usual_exponent), std::vector(throats, 1.0),
          network.throats()};
}

ThroatFilms throat_films(const PoreNetwork& network, const PackingSites& sites_of, double contact_angle) {
  constexpr double second_radius = 1.0 / 3.0;  // of the entry radius; the exponent is taken between the two
  ThroatFilms films = usual_throat_films(network);
  std::vector<std::uint8_t> is_usual(to_size(network.throats()));
  parallel_for(network.throats(), [&](int index) {
    const std::size_t t = to_size(index);
    const double r = network.throat_entry_radius[t];
    if (r <= 0.0) return;
    const ThroatSection section = throat_section(sites_of(network.throat_vertices(index)));
    const Corners entry = corners_at(section, r, contact_angle);
    is_usual[t] = entry.area <= 0.0 || entry.area >= section.void_area;
    if (is_usual[t]) return;
    const double perimeter = section.solid_perimeter();
    films.wetting_at_entry[t] = std::min(share(entry.area, entry.wetted, section), 1.0);
    // No part of a section carries more than the whole, which bounds the estimate by hydraulic radii.
    films.nonwetting[t] = std::min(share(section.void_area - entry.area, perimeter - entry.wetted + entry.menisci, section), 1.0);
    const Corners later = corners_at(section, second_radius * r, contact_angle);
    if (later.without == entry.without)
      films.exponent[t] =
          std::log(share(later.area, later.wetted, section) / films.wetting_at_entry[t]) / std::log(second_radius);
  });
  films.without_menisci = 0;
  for (const std::uint8_t usual : is_usual) films.without_menisci += usual;
  return films;
}

}  // namespace puadem
