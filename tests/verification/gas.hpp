#pragma once

#include "puadem/dem/contact_law.hpp"

namespace puadem::verification {

/// Elastic grains without friction that fly about in a box, periodic along x and y, with walls along z.
struct GasSetUp {
  ContactOptions::Law law = ContactOptions::Law::hertz_mindlin;
  int grains_across = 10;
  long steps = 100000;
  double steps_per_contact = 100;  ///< time step, in parts of the time of a head-on contact at the mean speed
};

struct GasRun {
  double largest_error = 0.0;  ///< of kinetic and stored energy, as a share of the energy at the start
  double end_error = 0.0;
  double largest_stored = 0.0;  ///< largest share that springs held
};

GasRun run_gas(const GasSetUp& set_up);

}  // namespace puadem::verification
