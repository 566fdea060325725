#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "puadem/base/vec3.hpp"
#include "puadem/dem/grain_system.hpp"
#include "puadem/geometry/packing_sites.hpp"
#include "puadem/network/pore_network.hpp"

namespace puadem {

/// How grains and walls around a throat share what acts on its void: the drag of the fluid in it, or the tension of a
/// meniscus that hangs in it (theory 7.1).
enum class ThroatShare : std::uint8_t {
  surface,       ///< by the solid surface in the throat's domain, as a viscous fluid would
  contact_line,  ///< by the solid around the throat's section, where menisci hang
};

/// Areas through which the pressures of pores push grains and walls. They follow from positions alone and serve any
/// pressures.
struct PushedAreas {
  /// Per throat and vertex: area of its sector in the facet and its share of the void, which add to the whole facet [m2].
  std::vector<std::array<double, 3>> throat;
  /// Of that the share of the void: with `ThroatShare::contact_line` what menisci make of a jump of pressure [m2].
  std::vector<std::array<double, 3>> throat_void;
  std::vector<std::array<int, 3>> bearer;  ///< per throat and vertex: `Vertex::index`
  struct Patch {
    int pore, face;
    double area;  ///< of a pore on a wall of the box [m2]
  };
  std::vector<Patch> wall;
};

/// @param sites    of the grains as they stand
/// @param no_slip  faces of the box that hold the fluid and bear a share of it
PushedAreas pushed_areas(const PoreNetwork& network, const PackingSites& sites, ThroatShare share,
                         const std::array<bool, 6>& no_slip);

/// What a fluid does to grains and walls.
struct FluidForces {
  std::vector<Vec3> grain;     ///< [N]
  std::array<Vec3, 6> wall{};  ///< per face of the box [N]
};

/// Forces of the pressures in the pores (theory 7.1). Over a periodic box they add to nothing, over a walled one with
/// its walls, for any pressures whatever; a pressure gradient pushes the grains with its product with the volume of
/// grains and pores together. Weight of the fluid does not belong here: solve for the piezometric pressure and add
/// `buoyancy`.
///
/// @param pressure  per pore [Pa]
/// @param jump      by which the pressure rises over a period of each axis [Pa]
/// @param grains    their number
FluidForces pressure_forces(const PoreNetwork& network, const PushedAreas& areas, std::span<const double> pressure,
                            const Vec3& jump, int grains);

/// Adds Archimedes' force, - density g V_k f_k. Exact for grains in one fluid; with f_k between 0 and 1 an approximation.
///
/// @param wetted  part of each grain's surface that the fluid covers [-]; empty: all of it
void add_buoyancy(std::span<const double> radius, double density, const Vec3& gravity, std::span<const double> wetted,
                  std::span<Vec3> force);

/// Grains and walls feel the forces until others are frozen or they are released.
void freeze_forces(const FluidForces& forces, GrainSystem& grains);
void release_forces(GrainSystem& grains);

}  // namespace puadem
