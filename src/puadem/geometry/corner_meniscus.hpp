#pragma once

#include "puadem/geometry/throat_section.hpp"

namespace puadem {

/// One corner (arc) meniscus of radius r in a crevice of a section, and the wetting fluid behind it
/// (theory 3.4). Negative values are meant: a meniscus wider than its crevice reaches past the edge of
/// the facet.
struct CornerMeniscus {
  double area = 0.0;          ///< of the wetting fluid [m2]
  double angle = 0.0;         ///< opening of the arc [rad]; its length is r times this
  double wetted_first = 0.0;  ///< solid wetted on side k [m]
  double wetted_next = 0.0;   ///< solid wetted on the next side [m]
};

/// Meniscus of curvature radius r > 0 in crevice k at contact angle theta [rad]. It exists for
/// 2 r cos(theta) >= gap; in a corner of two walls for theta < pi/2 - half_angle, else it is empty.
CornerMeniscus corner_meniscus(const ThroatSection& section, int k, double r, double contact_angle);

/// All menisci of one radius together.
struct SectionMenisci {
  double wetting_area = 0.0;     ///< sum of the corners [m2]
  double meniscus_length = 0.0;  ///< L_nw [m]
  double dry_length = 0.0;       ///< L_ns: solid that the non-wetting fluid touches [m]
  double least_area = 0.0;       ///< smallest of the corner areas; negative: past the edge of the facet [m2]
};
SectionMenisci section_menisci(const ThroatSection& section, double r, double contact_angle);

}  // namespace puadem
