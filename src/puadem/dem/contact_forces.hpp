#pragma once

#include "puadem/dem/grain_system.hpp"

namespace puadem {

/// Forces of all contacts at the present places, written to the slots; the shear history advances by the
/// displacement of the last step (theory 2.1 to 2.8). Images must be up to date. Sets force and
/// stiffness of the walls. The same bits on any number of threads and however the list is sorted.
void update_contact_forces(GrainSystem& system);

/// Sum of the slots of record k, ordered by identity of the partner: force [N] and the sum of moments,
/// -R of which is the torque.
/// Rows end with that many spare entries, so that a sum can ask for slots ahead of time.
inline constexpr int rows_ahead = 48;
struct SlotSum {
  Lanes force;
  Lanes moment;
};
PUADEM_INLINE SlotSum sum_slots(const ContactSlot* slot, const int* row, int begin, int end) {
  SlotSum sum{};
  for (int e = begin; e < end; ++e) {
    __builtin_prefetch(slot + (row[e + rows_ahead] >> 1));
    const ContactSlot& s = slot[row[e] >> 1];
    const Lanes sign = broadcast((row[e] & 1) != 0 ? 1.0 : -1.0);
    sum.force += sign * s.force;
    sum.moment += s.moment;
  }
  return sum;
}

}  // namespace puadem
