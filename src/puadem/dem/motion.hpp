#pragma once

#include "puadem/dem/grain_system.hpp"

namespace puadem {

/// Brings list, images and contact forces to the present places, without moving anything: what a step
/// begins with. The velocities are those of the half step that led here; with grains at rest it is a
/// static evaluation. Nothing happens where the forces are those of the present places already.
void evaluate_forces(GrainSystem& system);

/// One leap-frog step of `time_step` under the forces last evaluated (theory 2.9, 2.10), then the walls
/// and the box move.
void move_grains(GrainSystem& system);

/// Forces, then motion, `steps` times.
/// @throws NumericalError  a grain too fast, too far inside another one, or outside the box
void advance_grains(GrainSystem& system, long steps);

/// What bounds the time step.
struct TimeStepLimit {
  double critical = 0.0;  ///< [s]; infinite without a contact
  int grain = -1;         ///< identity of the grain that binds
  bool rotation = false;  ///< its spin binds, not its translation
};

/// Critical time step from translation and rotation of every grain in its contacts, theory 2.11.
TimeStepLimit critical_time_step(const GrainSystem& system);

/// Gives the box another rate of strain. With `strain_with_box` every grain takes the change of the
/// homogeneous velocity field at its place; walls that stand for upper faces move with the box.
void set_box_rate(GrainSystem& system, const Vec3& rate);

/// Sets the velocity of every servo wall from its force, theory 2.12.
void steer_walls(GrainSystem& system);

}  // namespace puadem
