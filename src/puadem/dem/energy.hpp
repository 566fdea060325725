#pragma once

#include "puadem/dem/grain_system.hpp"

namespace puadem {

/// Where the energy of a system is, and where it went since the book was opened [J], theory 2.16.
struct Energies {
  double kinetic = 0.0;     ///< of translation (relative to a box that grains strain with) and rotation at the present places
  double normal = 0.0;      ///< stored in normal springs
  double shear = 0.0;       ///< stored in shear springs; linear law only, the incremental Mindlin law has no potential
  double friction = 0.0;    ///< lost in sliding; linear law only
  double shear_work = 0.0;  ///< all that shear springs and sliders took up: shear + friction for the linear law
  double roll_work = 0.0;   ///< all that rolling and twisting resistance took up
  double viscous = 0.0;
  double damping = 0.0;
  double bridges = 0.0;  ///< of the surfaces of liquid bridges, over that of ruptured ones; negative
  double wetting = 0.0;  ///< given off where liquid formed bridges or moved between them
  double input = 0.0;    ///< work of walls, of the straining box, of gravity and external forces

  double stored() const { return kinetic + normal + bridges; }
  double taken() const { return shear_work + roll_work + viscous + damping + wetting; }
};

/// Opens the book: energies from here on. Forces must be those of the present places.
void open_energy_book(GrainSystem& system);

/// Power that the box spends on contacts across its periodic faces at a velocity `box_rate` of its upper corner [W].
double image_power(const GrainSystem& system, const Vec3& box_rate);

/// @pre the forces are those of the present places
Energies energies(const GrainSystem& system);

}  // namespace puadem
