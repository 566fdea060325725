#pragma once

#include <array>
#include <string_view>

#include "puadem/base/vec3.hpp"

namespace puadem {

/// The six faces of the box: face 2 * axis is the lower side of an axis, 2 * axis + 1 the upper side.
inline constexpr std::array<std::string_view, 6> face_names{"left", "right", "front", "back", "bottom", "top"};

constexpr int axis_of(int face) { return face / 2; }
constexpr bool is_upper(int face) { return face % 2 == 1; }
constexpr int opposite(int face) { return face ^ 1; }

/// Outward unit normal of a face.
constexpr Vec3 outward_normal(int face) {
  Vec3 n;
  n[axis_of(face)] = is_upper(face) ? 1.0 : -1.0;
  return n;
}

/// An axis-aligned box [m]. A face is a wall unless its axis is periodic.
struct Domain {
  Vec3 lower{0, 0, 0};
  Vec3 upper{1, 1, 1};
  std::array<bool, 3> periodic{false, false, false};

  constexpr Vec3 size() const { return upper - lower; }
  constexpr double volume() const { return size().x * size().y * size().z; }
  constexpr bool is_wall(int face) const { return !periodic[static_cast<unsigned>(axis_of(face))]; }
  /// Coordinate of a face along its axis [m].
  constexpr double face_position(int face) const { return is_upper(face) ? upper[axis_of(face)] : lower[axis_of(face)]; }
  constexpr bool operator==(const Domain&) const = default;
};

}  // namespace puadem
