#pragma once

#include "puadem/coupling/permeability_result.hpp"
#include "puadem/coupling/state.hpp"
#include "puadem/flow/fluids.hpp"
#include "puadem/io/vtk_writer.hpp"

namespace puadem {

/// Grains as points with `radius` [m] and `material`; where the grain engine runs also `speed` [m/s], `mean_stress` and
/// `deviatoric_stress` on the power cell [Pa], `contacts` (walls included) and `cell_volume` [m3]; where two fluids push them
/// the vectors `fluid_force` and, of it, `tension_force`, what menisci in throats make [N], and `displacement` since the first
/// row of the stage under way [m].
VtkPolyData grain_fields(const State& state);

/// Contacts as lines from centre to centre, or from the foot on a wall: `normal_force` and `shear_force` [N], `wall`
/// (1 against a wall); `radius` on the points grows with the root of the normal force, the mean force having a
/// third of the mean grain radius, for tubes. @pre the state has the grain engine
VtkPolyData contact_fields(const State& state);

/// Liquid bridges as lines from centre to centre, or to the foot on a wall: `force` of attraction [N], `volume` [m3],
/// `capillary_pressure` [Pa], `gap` [m], negative in contact, and `wall`; `radius` on the points is that of a sphere of the
/// bridge's volume, for tubes. @pre the grains have bridges
VtkPolyData bridge_fields(const State& state);

/// Pores as points at their centres with `radius` [m], `volume` [m3], `saturation` [-] (1 before the
/// first equilibrium), `faces` and `wall` (1 at a wall of the box); in stages "unsaturated-flow" also `porosity`, void of the
/// unit over the volume of its cells [-].
VtkPolyData pore_fields(const State& state);

/// Throats as lines between the centres of their pores: `radius` [m] on the points, so that tubes have
/// the right width; `entry_pressure` [Pa] (infinite where never entered), `open` and `wall` on the
/// lines, `open` being 1 where the non-wetting fluid passes. A throat across a periodic face ends at the image of its second
/// pore.
VtkPolyData throat_fields(const State& state, const Fluids& fluids);

/// Pores of a driven fluid as points: `radius` [m], `volume` [m3], `pressure` [Pa].
VtkPolyData flow_pore_fields(const DrivenFlow& flow);

/// Its throats as lines: `radius` [m] on the points; on the lines `flow` [m3/s] along the line, and `flux` [m/s], a vector
/// along it, the flow over the void section; both 0 where pores are joined without resistance.
VtkPolyData flow_throat_fields(const DrivenFlow& flow, const Domain& domain);

/// Writes what a file as a whole knows: `capillary_pressure` [Pa] and `saturation` of the equilibrium.
void add_equilibrium(VtkPolyData& data, const RetentionRow& row);

}  // namespace puadem
