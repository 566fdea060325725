#include "puadem/network/merging.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "puadem/base/error.hpp"
#include "puadem/base/parallel.hpp"
#include "puadem/network/pore_shape.hpp"

namespace puadem {

namespace {

using Shift = std::array<std::int8_t, 3>;

Shift combine(const Shift& a, const Shift& b, const Shift& minus) {
  Shift result;
  for (std::size_t k = 0; k < 3; ++k) result[k] = static_cast<std::int8_t>(a[k] + b[k] - minus[k]);
  return result;
}

/// Do these faces hold two opposite ones?
bool span_box(unsigned faces) { return (faces & faces >> 1U & 0b010101U) != 0U; }

/// Units while they grow. A unit chains its cells and lists every facet that touches it from either side.
struct Units {
  struct List {
    std::size_t start = 0;
    int size = 0;
  };

  std::span<const Facet> facets;
  std::vector<int> unit;          // of each cell
  std::vector<Shift> cell_shift;  // of each cell in its unit's frame
  std::vector<int> next_cell;     // of each cell, in its unit; -1 ends the chain, which begins with cell u of unit u
  std::vector<int> last_cell;     // of each unit
  std::vector<int> cells;         // of each unit: their number
  std::vector<int> listed;        // facets of all units, ascending in each; a merged unit's follow at the end
  std::vector<List> facet_list;   // of each unit, in `listed`
  std::vector<double> volume, radius;
  std::vector<int> wall_faces, faces;

  std::span<const int> facets_of(int u) const {
    const List& list = facet_list[to_size(u)];
    return std::span(listed).subspan(list.start, to_size(list.size));
  }
  int across(int u, const Facet& f) const {
    const int a = unit[to_size(f.cell)], b = unit[to_size(f.neighbour)];
    return a == u ? b : a;
  }
  /// A facet inside one unit; one that leads to the unit's own image is a throat still.
  bool is_inside(const Facet& f) const {
    return unit[to_size(f.cell)] == unit[to_size(f.neighbour)] &&
           combine(cell_shift[to_size(f.cell)], f.shift, cell_shift[to_size(f.neighbour)]) == Shift{};
  }
};

struct Worst {
  float ratio = -1.0F;  // single: facets around one wide gap tie, whatever the rounding of their images
  int facet = -1;
};

class Merger {
 public:
  Merger(int cells, std::span<const Facet> facets, std::span<const double> cell_void, std::span<const int> cell_faces,
         std::span<const double> wide, std::span<const double> void_area, const MergeOptions& options, const StartingUnits& start)
      : wide_(wide),
        void_area_(void_area),
        options_(options),
        kind_(start.kind.begin(), start.kind.end()),
        walls_(options.walls.begin(), options.walls.end()) {
    units_.facets = facets;
    units_.unit.resize(to_size(cells));
    std::iota(units_.unit.begin(), units_.unit.end(), 0);
    units_.last_cell = units_.unit;
    units_.next_cell.assign(to_size(cells), -1);
    units_.cells.assign(to_size(cells), 1);
    units_.cell_shift.resize(to_size(cells));
    units_.volume.assign(cell_void.begin(), cell_void.end());
    units_.faces.assign(cell_faces.begin(), cell_faces.end());
    units_.wall_faces = units_.faces;
    units_.radius.resize(to_size(cells));
    list_facets(cells);
    // Void of a cell that is flat or filled by overlapping grains: nil beside the mean cell.
    const double mean = std::accumulate(cell_void.begin(), cell_void.end(), 0.0) / std::max(cells, 1);
    ensure(mean > 0.0, "the packing has no void at all: the grains overlap too far");
    nil_volume_ = 1e-9 * mean;
    small_volume_ = 0.05 * mean;
    for (int c = 0; c < cells; ++c) {
      update_radius(c);
      forced_ += is_nil(c);
    }
    if (!start.unit.empty()) join_start(start);
  }

  MergedCells merge() {
    const int cells = size_of(units_.unit);
    worst_.resize(to_size(cells));
    std::vector<int> dirty(to_size(cells));
    std::iota(dirty.begin(), dirty.end(), 0);
    while (!dirty.empty()) {
      parallel_for(size_of(dirty), [&](int k) { worst_[to_size(dirty[to_size(k)])] = find_worst(dirty[to_size(k)]); });
      dirty = merge_mutual_worst(dirty);
    }
    return result();
  }

 private:
  void list_facets(int cells) {
    units_.facet_list.resize(to_size(cells));
    for (const Facet& f : units_.facets) {
      ++units_.facet_list[to_size(f.cell)].size;
      if (f.neighbour != f.cell) ++units_.facet_list[to_size(f.neighbour)].size;
      --units_.wall_faces[to_size(f.cell)];
      --units_.wall_faces[to_size(f.neighbour)];
    }
    std::size_t end = 0;
    for (auto& list : units_.facet_list) {
      list.start = end;
      end += to_size(list.size);
      list.size = 0;
    }
    units_.listed.reserve(2 * end);
    units_.listed.resize(end);
    const auto append = [&](int cell, int facet) {
      auto& list = units_.facet_list[to_size(cell)];
      units_.listed[list.start + to_size(list.size++)] = facet;
    };
    for (int f = 0; f < size_of(units_.facets); ++f) {
      const auto& [a, b, shift, opposite] = units_.facets[to_size(f)];
      append(a, f);
      if (b != a) append(b, f);
    }
  }

  void join_start(const StartingUnits& start) {
    std::vector<int> holding;  // by the single cells, before any of them has grown
    for (int f = 0; f < size_of(units_.facets); ++f) {
      const auto& [a, b, shift, opposite] = units_.facets[to_size(f)];
      if (a == b || start.unit[to_size(a)] < 0 || start.unit[to_size(a)] != start.unit[to_size(b)]) continue;
      if (combine(start.cell_shift[to_size(a)], shift, start.cell_shift[to_size(b)]) != Shift{}) continue;
      if (ratio(a, b, f) >= start.keep) holding.push_back(f);
    }
    for (const int f : holding)
      if (units_.unit[to_size(units_.facets[to_size(f)].cell)] != units_.unit[to_size(units_.facets[to_size(f)].neighbour)])
        merge_over(f);
  }

  /// A unit too small to be a pore of its own does not hold back: it joins one of a higher kind.
  bool may_merge(int u, int v) const {
    if (kind_.empty() || kind_[to_size(u)] == kind_[to_size(v)]) return true;
    const int lower = kind_[to_size(u)] < kind_[to_size(v)] ? u : v;
    return units_.volume[to_size(lower)] < small_volume_;
  }

  /// A pore that reached from wall to wall would join what may be two reservoirs.
  bool would_span(int u, int v) const {
    return !walls_.empty() && span_box(static_cast<unsigned>(walls_[to_size(u)] | walls_[to_size(v)]));
  }

  int joined_kind(int keep, int gone) const {
    const int a = kind_[to_size(keep)], b = kind_[to_size(gone)];
    return is_nil(keep) ? b : is_nil(gone) ? a : std::max(a, b);
  }

  bool is_nil(int u) const { return units_.volume[to_size(u)] <= nil_volume_; }

  void update_radius(int u) {
    units_.radius[to_size(u)] =
        is_nil(u) ? 0.0
                  : inscribed_radius_coefficient(units_.faces[to_size(u)], options_.shape) * std::cbrt(units_.volume[to_size(u)]);
  }

  double ratio(int u, int v, int facet) const {
    const double smaller = std::min(units_.radius[to_size(u)], units_.radius[to_size(v)]);
    if (!(smaller > 0.0)) return std::numeric_limits<double>::infinity();
    return options_.rank.empty() ? wide_[to_size(facet)] / smaller : options_.rank[to_size(facet)];
  }

  Worst find_worst(int u) const {
    Worst worst;
    for (const int f : units_.facets_of(u)) {
      const int v = units_.across(u, units_.facets[to_size(f)]);
      if (v == u || would_span(u, v)) continue;
      const double r = ratio(u, v, f);
      const bool must = std::isinf(r);
      if (!must &&
          (!may_merge(u, v) || r <= options_.ratio || units_.cells[to_size(u)] + units_.cells[to_size(v)] > options_.limit))
        continue;
      const auto rank = static_cast<float>(r);
      if (rank < worst.ratio) continue;
      if (rank == worst.ratio) {  // facets come in ascending order
        if (void_area_[to_size(f)] <= void_area_[to_size(worst.facet)]) continue;
      }
      worst = {rank, f};
    }
    return worst;
  }

  /// Merges over every facet that is the worst of both its units; returns the units to look at again.
  std::vector<int> merge_mutual_worst(const std::vector<int>& dirty) {
    std::vector<int> chosen;
    for (const int u : dirty) {
      const int f = worst_[to_size(u)].facet;
      if (f >= 0 && worst_[to_size(units_.across(u, units_.facets[to_size(f)]))].facet == f) chosen.push_back(f);
    }
    std::sort(chosen.begin(), chosen.end());
    chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
    std::vector<int> merged;
    for (const int f : chosen) merged.push_back(merge_over(f));

    std::vector<int> again;
    for (const int u : merged) {
      again.push_back(u);
      for (const int f : units_.facets_of(u)) again.push_back(units_.across(u, units_.facets[to_size(f)]));
    }
    std::sort(again.begin(), again.end());
    again.erase(std::unique(again.begin(), again.end()), again.end());
    return again;
  }

  int merge_over(int facet) {
    const Facet& f = units_.facets[to_size(facet)];
    int keep = units_.unit[to_size(f.cell)], gone = units_.unit[to_size(f.neighbour)];
    // Moves the frame of the vanishing unit so that the two cells of the facet lie side by side.
    Shift move = combine(units_.cell_shift[to_size(f.cell)], f.shift, units_.cell_shift[to_size(f.neighbour)]);
    if (gone < keep) {
      std::swap(keep, gone);
      for (auto& s : move) s = static_cast<std::int8_t>(-s);
    }
    for (int c = gone; c >= 0; c = units_.next_cell[to_size(c)]) {
      units_.unit[to_size(c)] = keep;
      for (std::size_t k = 0; k < 3; ++k)
        units_.cell_shift[to_size(c)][k] = static_cast<std::int8_t>(units_.cell_shift[to_size(c)][k] + move[k]);
    }
    if (!kind_.empty()) kind_[to_size(keep)] = joined_kind(keep, gone);
    if (!walls_.empty()) walls_[to_size(keep)] |= walls_[to_size(gone)];
    units_.next_cell[to_size(units_.last_cell[to_size(keep)])] = gone;
    units_.last_cell[to_size(keep)] = units_.last_cell[to_size(gone)];
    units_.cells[to_size(keep)] += units_.cells[to_size(gone)];
    units_.volume[to_size(keep)] += units_.volume[to_size(gone)];
    units_.wall_faces[to_size(keep)] += units_.wall_faces[to_size(gone)];
    join_lists(keep, gone);
    int bounding = units_.wall_faces[to_size(keep)];
    for (const int k : units_.facets_of(keep))  // a facet to the unit's own image bounds it on two sides
      bounding += units_.across(keep, units_.facets[to_size(k)]) == keep ? 2 : 1;
    units_.faces[to_size(keep)] = bounding;
    update_radius(keep);
    return keep;
  }

  /// The facets that bound the joined unit take the place of both lists.
  void join_lists(int keep, int gone) {
    auto &a = units_.facet_list[to_size(keep)], &b = units_.facet_list[to_size(gone)];
    const std::size_t start = units_.listed.size();
    units_.listed.resize(start + to_size(a.size + b.size));
    const auto at = [&](std::size_t k) { return units_.listed.begin() + static_cast<std::ptrdiff_t>(k); };
    auto end = std::set_union(at(a.start), at(a.start) + a.size, at(b.start), at(b.start) + b.size, at(start));
    end = std::remove_if(at(start), end, [&](int k) { return units_.is_inside(units_.facets[to_size(k)]); });
    a = {start, static_cast<int>(end - at(start))};
    b = {};
    units_.listed.erase(end, units_.listed.end());
  }

  MergedCells result() const {
    MergedCells merged;
    merged.forced = forced_;
    merged.unit.resize(units_.unit.size());
    merged.cell_shift = units_.cell_shift;
    std::vector<int> number(units_.unit.size(), -1);
    for (int c = 0; c < size_of(units_.unit); ++c) {
      const int u = units_.unit[to_size(c)];
      if (number[to_size(u)] < 0) {
        ensure(!is_nil(u),
               "the pore of tetrahedron {} has no void and no neighbour to join: the grains around it overlap too far", c);
        number[to_size(u)] = merged.units++;
      }
      merged.unit[to_size(c)] = number[to_size(u)];
    }
    return merged;
  }

  Units units_;
  std::span<const double> wide_, void_area_;
  MergeOptions options_;
  std::vector<int> kind_;            // of each unit
  std::vector<std::uint8_t> walls_;  // that each unit touches, bit f for face f
  double nil_volume_ = 0.0, small_volume_ = 0.0;
  int forced_ = 0;
  std::vector<Worst> worst_;
};

}  // namespace

MergedCells merge_cells(int cells, std::span<const Facet> facets, std::span<const double> cell_void,
                        std::span<const int> cell_faces, std::span<const double> wide, std::span<const double> void_area,
                        const MergeOptions& options, const StartingUnits& start) {
  return Merger(cells, facets, cell_void, cell_faces, wide, void_area, options, start).merge();
}

}  // namespace puadem
