#include "puadem/coupling/checked_network.hpp"

#include <fmt/format.h>

#include <limits>
#include <numeric>

#include "puadem/base/error.hpp"
#include "puadem/network/grain_overlaps.hpp"
#include "puadem/network/network_checks.hpp"
#include "puadem/network/pore_units.hpp"

namespace puadem {

namespace {

constexpr double overlap_tolerance = 0.01;  // of the void: what overlaps may falsify before it is worth a word
constexpr std::size_t faults_shown = 5;

}  // namespace

PoreNetwork checked_network(const Case& c, const State& state, const Observer& observer, bool merged) {
  require(state.particles.size() > 0,
          "this stage needs a packing: put a stage of kind 'compact' before it or name a packing file in grains.file");
  const auto& [centre, radius] = std::tie(state.particles.position, state.particles.radius);
  NetworkOptions options = c.pores;
  options.contact_angle = c.fluids.contact_angle;
  if (!merged) {
    options.merge_criterion = MergeCriterion::entry_ratio;
    options.merge_ratio = std::numeric_limits<double>::infinity();
  }
  PoreNetwork network = build_pore_network(centre, radius, state.domain, options);

  const std::vector<std::string> faults = find_network_faults(network, centre, radius, state.domain);
  if (!faults.empty()) {
    std::string text = "the packing makes no sound network:";
    for (std::size_t k = 0; k < std::min(faults.size(), faults_shown); ++k) text += "\n  " + faults[k];
    if (faults.size() > faults_shown) text += fmt::format("\n  and {} more", faults.size() - faults_shown);
    throw InputError(text);
  }

  const double space = std::accumulate(network.pore_volume.begin(), network.pore_volume.end(), 0.0);
  const GrainOverlaps overlaps = find_overlaps(network.triangulation, centre, radius, state.domain);
  if (overlaps.volume > overlap_tolerance * space && observer.message)
    observer.message(fmt::format("warning: overlaps of grains count twice and take {:.2g} % from the void; {}",
                                 100.0 * overlaps.volume / (space + overlaps.volume), deepest_in_words(overlaps)));
  return network;
}

}  // namespace puadem
