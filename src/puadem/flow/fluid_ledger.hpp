#pragma once

#include "puadem/base/compensated_sum.hpp"

namespace puadem {

/// Volumes that crossed the border of the counted pores, booked one by one as they move and never
/// read from the state [m3].
struct FluidLedger {
  CompensatedSum wetting_in, wetting_out, nonwetting_in, nonwetting_out;

  /// Books a change of the two volumes of a pore.
  void book(double wetting_change, double nonwetting_change) {
    if (wetting_change > 0.0) wetting_in.add(wetting_change);
    if (wetting_change < 0.0) wetting_out.add(-wetting_change);
    if (nonwetting_change > 0.0) nonwetting_in.add(nonwetting_change);
    if (nonwetting_change < 0.0) nonwetting_out.add(-nonwetting_change);
  }
};

}  // namespace puadem
