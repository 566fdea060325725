#include "puadem/coupling/pore_space.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "puadem/base/histogram.hpp"
#include "puadem/coupling/moving_pores.hpp"
#include "puadem/dem/grain_statistics.hpp"

namespace puadem {

namespace {

constexpr double wet_saturation = 0.5;  // of a block, above which it counts as wet
constexpr double worth_a_middle = 0.1;  // of saturation, between its least and greatest

PoreSizes sizes_of(const std::vector<double>& values, int classes_per_unit, std::vector<double>& density) {
  PoreSizes sizes;
  sizes.samples = size_of(values);
  sizes.density_begin = size_of(density);
  if (values.empty()) return sizes;
  const double n = static_cast<double>(values.size());
  for (const double v : values) sizes.mean += v / n;
  for (const double v : values) sizes.deviation += (v - sizes.mean) * (v - sizes.mean) / n;
  sizes.deviation = std::sqrt(sizes.deviation);
  const NormalMixture mixture = fit_normal_mixture(values);
  sizes.parts = size_of(mixture.parts);
  std::ranges::copy(mixture.parts, sizes.part.begin());
  const std::vector<Bin> bins = histogram(values, classes_per_unit);
  sizes.classes = size_of(bins);
  sizes.first_class = static_cast<int>(std::lround(bins.front().low * classes_per_unit));
  for (const Bin& bin : bins) density.push_back(bin.density);
  return sizes;
}

std::vector<double> over(std::span<const double> radii, double scale) {
  std::vector<double> scaled;
  for (const double r : radii)
    if (r > 0.0) scaled.push_back(r / scale);  // throats without a gap have none
  return scaled;
}

void add_blocks(const State& state, const TwoPhaseModel& model, const CellGeometry& cells, const UnsaturatedProgress& at,
                UnsaturatedRecord& record) {
  const Particles& grains = state.particles;
  const Domain& domain = state.grains->domain;
  if (record.local.empty()) record.blocks = block_counts(domain, grains.size());
  const std::vector<double> porosity = block_porosities(grains.position, grains.radius, domain, record.blocks);
  std::vector<std::uint8_t> is_counted(to_size(state.network.pores()));
  for (int p = 0; p < state.network.pores(); ++p) is_counted[to_size(p)] = model.is_counted(p);
  const std::vector<double> saturations = block_saturations(
      state.network, cells, saturation(state.network, state.unsaturated->flow), is_counted, domain, record.blocks);
  std::vector<LocalBlock> blocks(porosity.size());
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    blocks[b].porosity = porosity[b];
    blocks[b].saturation = saturations[b];
  }
  add_grains(grains.position, displacements(at.first_centre, at.first_domain, grains.position, domain).beyond_box, domain,
             record.blocks, blocks);
  record.local.insert(record.local.end(), blocks.begin(), blocks.end());
}

std::optional<double> mean_where(const LocalChange& c, bool is_wet) {
  double sum = 0.0;
  int n = 0;
  for (std::size_t b = 0; b < c.saturation.size(); ++b)
    if ((c.saturation[b] > wet_saturation) == is_wet) {
      sum += c.porosity_change[b];
      ++n;
    }
  return n > 0 ? std::optional(sum / n) : std::nullopt;
}

}  // namespace

CellGeometry present_cells(const State& state) {
  const Domain& domain = state.grains->domain;
  const std::vector<Vec3> centre = followed_centres(state.unsaturated->place, state.particles, domain);
  return measure_cells(state.network.triangulation, PackingSites(centre, state.particles.radius, domain));
}

std::vector<double> unit_porosities(const PoreNetwork& network, const CellGeometry& cells) {
  std::vector<double> porosity(to_size(network.pores()));
  for (int p = 0; p < network.pores(); ++p) {
    double space = 0.0, whole = 0.0;
    for (const int c : network.pore_tetrahedra[p]) {
      space += cells.void_volume[to_size(c)];
      whole += cells.volume[to_size(c)];
    }
    porosity[to_size(p)] = space / whole;
  }
  return porosity;
}

void record_pore_space(const TwoPhaseModel& model, State& state) {
  auto& at = std::get<UnsaturatedProgress>(state.position.progress);
  UnsaturatedRecord& record = state.unsaturated_flows.back();
  collect_places(*state.grains, state.particles);
  if (record.pore_space.empty()) {
    at.first_centre = state.particles.position;
    at.first_domain = state.grains->domain;
  }
  const CellGeometry cells = present_cells(state);
  const double scale = statistics_of(state.particles.radius).mean_radius;
  const auto [pores, throats, units] = pore_space_classes;
  PoreSpaceRow& row = record.pore_space.emplace_back();
  row.pore_radius = sizes_of(over(state.network.pore_radius, scale), pores, record.pore_density);
  row.throat_radius = sizes_of(over(state.network.throat_radius, scale), throats, record.pore_density);
  row.porosity = sizes_of(unit_porosities(state.network, cells), units, record.pore_density);
  add_blocks(state, model, cells, at, record);
}

std::optional<Displacements> displacements_of(const State& state) {
  const auto* at = std::get_if<UnsaturatedProgress>(&state.position.progress);
  if (at == nullptr || at->first_centre.empty()) return std::nullopt;
  return displacements(at->first_centre, at->first_domain, state.particles.position, state.grains->domain);
}

std::vector<int> telling_rows(const UnsaturatedRecord& record) {
  const auto [least, most] = std::ranges::minmax(record.rows, {}, &UnsaturatedRow::saturation);
  const double middle = 0.5 * (least.saturation + most.saturation);
  std::vector<int> rows{0};
  if (most.saturation - least.saturation > worth_a_middle) {
    const auto nearest =
        std::ranges::min_element(record.rows, {}, [=](const UnsaturatedRow& r) { return std::abs(r.saturation - middle); });
    rows.push_back(static_cast<int>(nearest - record.rows.begin()));
  }
  rows.push_back(size_of(record.rows) - 1);
  rows.erase(std::ranges::unique(rows).begin(), rows.end());
  return rows;
}

std::span<const LocalBlock> blocks_of(const UnsaturatedRecord& record, int row) {
  const auto n = to_size(record.blocks[0] * record.blocks[1] * record.blocks[2]);
  return std::span(record.local).subspan(to_size(row) * n, n);
}

LocalChange local_change(const UnsaturatedRecord& record, int row) {
  LocalChange change;
  const auto first = blocks_of(record, 0), now = blocks_of(record, row);
  for (std::size_t b = 0; b < now.size(); ++b) {
    change.saturation.push_back(now[b].saturation);
    change.porosity_change.push_back(now[b].porosity - first[b].porosity);
  }
  change.wet = mean_where(change, true);
  change.dry = mean_where(change, false);
  change.correlation = rank_correlation(change.saturation, change.porosity_change);
  return change;
}

void describe_pore_space(const UnsaturatedRecord& record, RunResults& results) {
  const auto set = [&](std::string_view name, std::optional<double> value) {
    if (value) results.scalars[fmt::format("{}_{}", record.stage, name)] = *value;
  };
  for (const auto& [when, row] : {std::pair{"start", record.pore_space.front()}, std::pair{"end", record.pore_space.back()}}) {
    set(fmt::format("pore_radius_mean_{}", when), row.pore_radius.mean);
    set(fmt::format("throat_radius_mean_{}", when), row.throat_radius.mean);
    set(fmt::format("unit_porosity_mean_{}", when), row.porosity.mean);
  }
  const std::vector<int> rows = telling_rows(record);
  for (std::size_t k = 1; k < rows.size(); ++k) {
    const std::string_view when = k + 1 == rows.size() ? "end" : "middle";
    const LocalChange change = local_change(record, rows[k]);
    set(fmt::format("porosity_change_wet_{}", when), change.wet);
    set(fmt::format("porosity_change_dry_{}", when), change.dry);
    set(fmt::format("porosity_change_correlation_{}", when), change.correlation);
  }
}

}  // namespace puadem
