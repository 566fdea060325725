#pragma once

#include <concepts>
#include <cstdint>
#include <string_view>
#include <variant>

#include "puadem/geometry/throat_section.hpp"

namespace puadem {

/// How the entry radius of a throat was found (theory 3.4).
enum class EntryKind : std::uint8_t {
  meniscus,   ///< the law has a solution: corner menisci and a front in balance
  wide_edge,  ///< a solution, but a meniscus reaches past the edge of the facet
  half_gap,   ///< no solution: half the gap of the widest edge
  inscribed,  ///< the inscribed circle decides
  closed,     ///< the grains leave no gap: never entered
};

struct Entry {
  double radius = 0.0;  ///< r*, radius of curvature at entry: p_e = gamma / r* [m]; 0: never entered
  EntryKind kind = EntryKind::closed;
};

/// A throat law: the radius of curvature at which the non-wetting fluid enters a section.
template <class Law>
concept ThroatEntryLaw = requires(const Law law, const ThroatSection& section, double contact_angle) {
  { law.entry(section, contact_angle) } -> std::same_as<Entry>;
  { Law::name } -> std::convertible_to<std::string_view>;
};

/// Mayer-Stowe-Princen: work of the front against the corner menisci it leaves behind (theory 3.4).
struct MayerStowePrincen {
  static constexpr std::string_view name = "mayer-stowe-princen";
  Entry entry(const ThroatSection& section, double contact_angle) const;
};

/// Haines: the inscribed circle, p_e = 2 gamma cos(theta) / r_in.
struct Haines {
  static constexpr std::string_view name = "haines";
  Entry entry(const ThroatSection& section, double contact_angle) const;
};

/// Every law a case file can name. A new law is one struct above and one word here.
using EntryLaw = std::variant<MayerStowePrincen, Haines>;

/// Radius of curvature at which the corner menisci of an open throat meet and close it: snap-off
/// pressure p_so = gamma / r_so (theory 3.5) [m].
double snap_off_radius(const ThroatSection& section, double contact_angle);

}  // namespace puadem
