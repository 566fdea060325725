#pragma once

#include <span>

#include "puadem/base/vec3.hpp"
#include "puadem/geometry/domain.hpp"

namespace puadem {

/// Volume of the part of a sphere that lies inside the box, in closed form (theory 2.14). Faces of
/// periodic axes do not bound: there the whole sphere counts.
/// @param centre  [m]
/// @param radius  [m], > 0
/// @return [m3]
double sphere_volume_in_box(const Vec3& centre, double radius, const Domain& box);

/// Void share of the box: one minus the volume of the spheres inside over that of the box. Overlaps of
/// spheres are counted twice.
double porosity_of(std::span<const Vec3> centre, std::span<const double> radius, const Domain& box);

/// The part of a box farther than `margin` from every wall; periodic axes keep their width.
/// @throws InputError  nothing is left
Domain core_of(const Domain& box, double margin);

}  // namespace puadem
