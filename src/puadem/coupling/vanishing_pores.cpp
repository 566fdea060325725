#include "puadem/coupling/vanishing_pores.hpp"

namespace puadem {

namespace {

constexpr double least = 0.02;  // of its volume that a pore is left with while the flow follows

}  // namespace

std::vector<BorrowedRoom> borrow_room(const PoreNetwork& network, const TwoPhaseModel& model, const TwoPhaseState& state,
                                      std::vector<double>& volume) {
  std::vector<BorrowedRoom> borrowed;
  for (int p = 0; p < network.pores(); ++p) {
    const auto i = to_size(p);
    const double missing = least * network.pore_volume[i] - volume[i];
    if (!(missing > 0.0)) continue;
    int from = -1;
    const auto is_alike = [&](int q) { return state.nonwetting.holds[to_size(q)] == state.nonwetting.holds[i]; };
    for (const int k : network.pore_throats[p]) {
      const auto [a, b] = network.throat_pores[to_size(k)];
      const int q = a == p ? b : a;
      if (q == p || model.is_counted(q) != model.is_counted(p)) continue;
      if (volume[to_size(q)] - missing < least * network.pore_volume[to_size(q)]) continue;
      if (from < 0 || (is_alike(q) && !is_alike(from)) ||
          (is_alike(q) == is_alike(from) && volume[to_size(q)] > volume[to_size(from)]))
        from = q;
    }
    borrowed.push_back({p, from, missing});
    if (from < 0) return borrowed;
    volume[i] += missing;
    volume[to_size(from)] -= missing;
  }
  return borrowed;
}

void give_back_room(std::span<const BorrowedRoom> borrowed, std::vector<double>& volume, TwoPhaseState& state) {
  for (const auto& [pore, from, room] : borrowed) {
    const auto p = to_size(pore), q = to_size(from);
    volume[p] -= room;
    volume[q] += room;
    const double share = (state.wetting_volume[p] + state.wetting_volume[q]) / (volume[p] + volume[q]);
    state.wetting_volume[p] = share * volume[p];
    state.wetting_volume[q] = share * volume[q];
  }
}

}  // namespace puadem
