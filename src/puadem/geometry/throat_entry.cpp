#include "puadem/geometry/throat_entry.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "puadem/geometry/corner_meniscus.hpp"

namespace puadem {

namespace {

/// Half of the widest gap between neighbouring sides, as a radius of curvature [m]; 0 where all touch.
double widest_half_gap(const ThroatSection& section, double contact_angle) {
  double widest = 0.0;
  for (int k = 0; k < section.sides; ++k) widest = std::max(widest, section.crevice[static_cast<unsigned>(k)].gap);
  return widest / (2.0 * std::cos(contact_angle));
}

}  // namespace

Entry Haines::entry(const ThroatSection& section, double contact_angle) const {
  if (section.inscribed_radius <= 0.0) return {};
  return {section.inscribed_radius / (2.0 * std::cos(contact_angle)), EntryKind::inscribed};
}

Entry MayerStowePrincen::entry(const ThroatSection& section, double contact_angle) const {
  if (section.inscribed_radius <= 0.0) return {};
  const double cosine = std::cos(contact_angle);

  // Excess of the front's tension over the pressure at radius r, and its slope A_n / r^2: the menisci are
  // in balance at every r, so only the explicit 1/r of the pressure counts (theory 3.4).
  double slope = 0.0, least_area = 0.0;
  const auto excess = [&](double r) {
    const SectionMenisci m = section_menisci(section, r, contact_angle);
    const double nonwetting_area = section.void_area - m.wetting_area;
    slope = nonwetting_area / (r * r);
    least_area = m.least_area;
    return m.meniscus_length + m.dry_length * cosine - nonwetting_area / r;
  };

  double low = widest_half_gap(section, contact_angle);
  double high = section.inscribed_radius / cosine;
  if (low >= high) return {high, EntryKind::inscribed};
  if (low > 0.0 && excess(low) >= 0.0) return {low, EntryKind::half_gap};

  double r = std::clamp(0.58 * high, low, high);  // near the usual root, 0.571 to 0.589 of the inscribed radius
  for (int iteration = 0; iteration < 100; ++iteration) {
    const double e = excess(r);
    (e > 0.0 ? high : low) = r;
    double next = slope > 0.0 ? r - e / slope : low;
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    const bool settled = std::abs(next - r) <= 1e-14 * r || high - low <= 1e-14 * high;
    r = next;
    if (settled) break;
  }
  if (high == section.inscribed_radius / cosine && r >= high * (1.0 - 1e-12)) return {high, EntryKind::inscribed};
  return {r, least_area < 0.0 ? EntryKind::wide_edge : EntryKind::meniscus};
}

double snap_off_radius(const ThroatSection& section, double contact_angle) {
  // Perfect wetting: the corner menisci meet where they all become the inscribed circle.
  if (section.inscribed_radius <= 0.0 || contact_angle == 0.0) return section.inscribed_radius;

  // Dry length left on the side that closes first.
  const auto least_dry = [&](double r) {
    double least = std::numeric_limits<double>::infinity();
    for (int k = 0; k < section.sides; ++k) {
      const int before = (k + section.sides - 1) % section.sides;
      least = std::min(least, section.solid_length(k) - corner_meniscus(section, before, r, contact_angle).wetted_next -
                                  corner_meniscus(section, k, r, contact_angle).wetted_first);
    }
    return least;
  };
  double low = std::max(widest_half_gap(section, contact_angle), 1e-3 * section.inscribed_radius);
  double high = std::max(2.0 * low, section.inscribed_radius);
  while (least_dry(high) > 0.0) {
    high *= 2.0;
    // Menisci this flat never meet: such a throat does not snap off.
    if (high > 1e4 * section.inscribed_radius) return std::numeric_limits<double>::infinity();
  }
  if (least_dry(low) <= 0.0) return low;
  while (high - low > 1e-13 * high) {
    const double middle = 0.5 * (low + high);
    (least_dry(middle) > 0.0 ? low : high) = middle;
    if (middle == low && middle == high) break;
  }
  return 0.5 * (low + high);
}

}  // namespace puadem
