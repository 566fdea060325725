#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "puadem/dem/tensor.hpp"
#include "puadem/geometry/domain.hpp"
#include "puadem/io/report_data.hpp"

namespace puadem {
namespace {

using nlohmann::json;

std::string area(double value) { return fmt::format("{:.4g} m²", value); }

/// Rows [what, value] of one stage.
json rows_of(const PermeabilityResult& r) {
  const Permeability& k = r.permeability;
  json rows = json::array();
  if (k.is_complete()) {
    const Vec3 principal = principal_values(k.tensor);
    rows.push_back({"Mean permeability", area(k.mean())});
    rows.push_back({"Principal values", fmt::format("{:.4g}, {:.4g}, {:.4g} m²", principal.x, principal.y, principal.z)});
  }
  for (int axis = 0; axis < 3; ++axis)
    if (k.measured[to_size(axis)]) rows.push_back({fmt::format("Along {}", "xyz"[axis]), area(k.tensor[to_size(axis)][axis])});
  if (const auto reference = r.kozeny_carman()) {
    rows.push_back({"After Kozeny and Carman", fmt::format("{}, ratio {:.3f}", area(*reference), k.mean() / *reference)});
    rows.push_back(
        {"Over the square of the Sauter radius",
         fmt::format("{:.4g}, R = {}", k.mean() / (*r.sauter_radius * *r.sauter_radius), in_print(*r.sauter_radius, "m"))});
  }
  rows.push_back({"Porosity", fmt::format("{:.4f}", r.porosity)});
  rows.push_back(
      {"Darcy velocity", fmt::format("{:.4g} m/s from the {} at {}, viscosity {}", r.darcy_velocity, face_names[to_size(r.inlet)],
                                     in_print(r.pressure_drop, "Pa"), in_print(r.viscosity, "Pa s"))});
  rows.push_back(
      {"Pressure off the straight line", fmt::format("{:.2f} % of the drop, root mean square", 100.0 * r.linear_error)});
  rows.push_back({"Solved by", fmt::format("{}, {} unknowns{}", k.is_factorised ? "Cholesky factors" : "multigrid", k.unknowns,
                                           k.iterations > 0 ? fmt::format(", {} iterations", k.iterations) : "")});
  rows.push_back({"Largest imbalance of a pore",
                  fmt::format("{:.1e} of the largest flow, {:.1e} by the pressures alone", k.imbalance, k.carried)});
  rows.push_back({"Throats closed, joined", fmt::format("{}, {} of {}", r.closed_throats, k.joined, r.throats)});
  if (k.limited_low + k.limited_high > 0)
    rows.push_back({"Conductances raised, lowered to the limits", fmt::format("{}, {}", k.limited_low, k.limited_high)});
  return rows;
}

json profile_of(const PermeabilityResult& r) {
  json place = json::array(), pressure = json::array(), linear = json::array();
  for (const PressureLayer& layer : r.profile) {
    place.push_back(layer.place);
    pressure.push_back(layer.pressure);
    linear.push_back(layer.linear);
  }
  return {{"place", std::move(place)}, {"pressure", std::move(pressure)}, {"linear", std::move(linear)}};
}

}  // namespace

json permeability_json(const State& state) {
  json stages = json::array();
  for (const PermeabilityResult& r : state.permeability)
    stages.push_back({{"name", r.stage},
                      {"axis", std::string(1, "xyz"[axis_of(r.inlet)])},
                      {"drop", r.pressure_drop},
                      {"length", state.domain.size()[axis_of(r.inlet)]},
                      {"inlet_is_upper", is_upper(r.inlet)},
                      {"linear_error", r.linear_error},
                      {"rows", rows_of(r)},
                      {"profile", profile_of(r)}});
  return stages;
}

}  // namespace puadem
