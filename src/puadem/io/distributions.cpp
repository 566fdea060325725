#include "puadem/io/distributions.hpp"

namespace puadem {
namespace {

constexpr int pore_bins = 20;    // per unit of R_i / <r>, which spans about 0.2 to 2
constexpr int throat_bins = 50;  // per unit of R_ij / <r>, which spans about 0.1 to 1

}  // namespace

double mean_radius(const Particles& particles) {
  if (particles.radius.empty()) return 0.0;
  double sum = 0.0;
  for (const double r : particles.radius) sum += r;
  return sum / particles.size();
}

RadiusDistributions radius_distributions(const State& state) {
  const double scale = mean_radius(state.particles);
  if (scale == 0.0) return {};
  std::vector<double> pore, throat;
  for (const double r : state.network.pore_radius) pore.push_back(r / scale);
  for (const double r : state.network.throat_radius)
    if (r > 0.0) throat.push_back(r / scale);
  return {histogram(pore, pore_bins), histogram(throat, throat_bins)};
}

}  // namespace puadem
