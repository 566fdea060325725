#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "puadem/base/vec3.hpp"
#include "puadem/geometry/domain.hpp"

namespace puadem {

/// Spheres in a box, as a packing file holds them.
struct PackingFile {
  Domain box;                         ///< lower corner at the origin, no periodic direction
  std::vector<Vec3> centre;           ///< [m]
  std::vector<double> radius;         ///< [m]
  std::vector<std::string> warnings;  ///< what is allowed but hardly meant
};

/// Reads a packing: a line `# box lx ly lz`, then one sphere `x,y,z,r` a line, all in metres. Other lines
/// that begin with '#' are comments; a first line `x,y,z,r` is a heading.
///
/// @throws InputError naming the lines of every fault: no box, a wrong number of columns, a text that is
///         no finite number, a radius that is not positive, a centre outside the box, two spheres at one
///         place, a sphere inside another, an overlap deeper than half the smaller radius
PackingFile read_packing(const std::filesystem::path& path);

/// The same for a text that is in memory; `name` stands for the file in messages.
PackingFile parse_packing(std::string_view text, const std::string& name);

/// Packing file as text. Every number reads back to the same bits. The lower corner of the box becomes
/// the origin.
std::string packing_text(std::span<const Vec3> centre, std::span<const double> radius, const Domain& box);

/// Writes a packing file, whole or not at all. @throws InputError
void write_packing(const std::filesystem::path& path, std::span<const Vec3> centre, std::span<const double> radius,
                   const Domain& box);

/// Two spheres that cannot both be in a packing.
struct BadPair {
  int first = 0, second = 0;  ///< first < second
  enum class Kind { same_place, inside, deep_overlap } kind = Kind::same_place;
  double overlap = 0.0;  ///< r_i + r_j - distance [m]
};

/// All pairs whose overlap exceeds half the smaller radius, ordered by index; linear in the number of
/// spheres for any ratio of sizes as long as few overlap.
std::vector<BadPair> find_bad_pairs(std::span<const Vec3> centre, std::span<const double> radius, const Domain& box);

}  // namespace puadem
