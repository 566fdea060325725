#include "puadem/flow/single_phase_flow.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "puadem/base/disjoint_sets.hpp"
#include "puadem/base/error.hpp"

namespace puadem {

namespace {

using Kind = FaceCondition::Kind;

unsigned faces_of_kind(const SinglePhaseProblem& problem, Kind kind) {
  unsigned faces = 0;
  for (int f = 0; f < 6; ++f)
    if (problem.faces[to_size(f)].kind == kind) faces |= 1u << f;
  return faces;
}

void check_problem(const PoreNetwork& network, const Domain& domain, const SinglePhaseProblem& problem) {
  for (int f = 0; f < 6; ++f) {
    if (problem.faces[to_size(f)].kind == Kind::closed) continue;
    const std::string_view name = face_names[to_size(f)];
    require(domain.is_wall(f), "the {} face is periodic: it takes no pressure and no inflow; give a mean gradient instead", name);
    require(std::ranges::any_of(network.pore_walls, [f](std::uint8_t walls) { return walls >> f & 1u; }),
            "no pore touches the {} face, which has a pressure or an inflow", name);
  }
  for (int axis = 0; axis < 3; ++axis)
    require(problem.pressure_gradient[axis] == 0.0 || domain.periodic[to_size(axis)],
            "a mean pressure gradient along {} needs that axis periodic; give pressures to its faces instead", "xyz"[axis]);
  require(problem.viscosity > 0.0, "the viscosity is {} Pa s: it must be > 0", problem.viscosity);
}

/// Conductances within the limits.
std::vector<double> limited(const PoreNetwork& network, const ConductanceLimits& limits, SinglePhaseFlow& flow) {
  std::vector<double> conductance = network.throat_conductance;
  std::vector<double> open;
  for (const double g : conductance)
    if (g > 0.0) open.push_back(g);
  if (open.empty()) return conductance;
  const auto middle = open.begin() + size_of(open) / 2;
  std::nth_element(open.begin(), middle, open.end());
  const double low = limits.low * *middle, high = limits.high * *middle;
  for (double& g : conductance) {
    if (g <= 0.0 || (g >= low && g <= high)) continue;
    ++(g < low ? flow.limited_low : flow.limited_high);
    g = g < low ? low : high;
  }
  return conductance;
}

/// Pressure of each node that a face prescribes.
std::vector<std::optional<double>> prescribed_pressures(const PoreNetwork& network, const SinglePhaseProblem& problem,
                                                        const FlowGraph& graph) {
  std::vector<std::optional<double>> pressure(to_size(graph.nodes()));
  for (int p = 0; p < network.pores(); ++p)
    for (int f = 0; f < 6; ++f) {
      const FaceCondition& face = problem.faces[to_size(f)];
      if (face.kind != Kind::pressure || !(network.pore_walls[to_size(p)] >> f & 1u)) continue;
      auto& node = pressure[to_size(graph.pore_node[to_size(p)])];
      require(
          !node || *node == face.value,
          "pore {} belongs to the {} face at {} Pa and to another boundary at {} Pa: a pore has one pressure; use more grains "
          "between the two",
          p, face_names[to_size(f)], face.value, *node);
      node = face.value;
    }
  return pressure;
}

/// Every connected part of the network needs a pressure somewhere. One part alone may do without: its
/// pressures are then relative to its first node, which is returned; -1: nothing to pin.
int find_pinned_node(const PoreNetwork& network, const FlowGraph& graph, const std::vector<std::optional<double>>& prescribed,
                     bool compressible) {
  if (compressible) return -1;
  DisjointSets parts(graph.nodes());
  for (const auto& [a, b] : graph.link) parts.join(a, b);
  std::vector<char> held(to_size(graph.nodes()), 0);
  for (int n = 0; n < graph.nodes(); ++n)
    if (prescribed[to_size(n)]) held[to_size(parts.find(n))] = 1;
  std::vector<int> floating;  // roots: the lowest node of each part
  bool any_held = false;
  for (int n = 0; n < graph.nodes(); ++n)
    if (parts.find(n) == n) {
      any_held = any_held || held[to_size(n)];
      if (!held[to_size(n)]) floating.push_back(n);
    }
  if (floating.empty()) return -1;
  if (!any_held && floating.size() == 1) return floating.front();
  const int named = floating.back();  // not the part of the first pore, which is seldom the one that is cut off
  int pores = 0;
  for (const int node : graph.pore_node) pores += parts.find(node) == named;
  const int pore = graph.node_pore[to_size(named)];
  const Vec3& c = network.pore_centre[to_size(pore)];
  throw NumericalError(fmt::format(
      "{} of the network {} cut off from every given pressure; the last is a cluster of {} around pore {} at ({:g}, {:g}, "
      "{:g}) m: its pressure is not defined",
      floating.size() == 1 ? "1 part" : fmt::format("{} parts", floating.size()), floating.size() == 1 ? "is" : "are",
      pores == 1 ? "1 pore" : fmt::format("{} pores", pores), pore, c.x, c.y, c.z));
}

/// One solve, from the problem to the flow.
class Solve {
 public:
  Solve(const PoreNetwork& network, const Domain& domain, const SinglePhaseProblem& problem, SinglePhaseMemory& memory)
      : network_(network), period_(domain.size()), problem_(problem), memory_(memory) {
    check_problem(network, domain, problem);
    if (problem.conductance_limits) limited_ = limited(network, *problem.conductance_limits, flow_);
    conductance_ = problem.conductance_limits ? limited_ : network.throat_conductance;
    flow_.joined = static_cast<int>(std::ranges::count_if(conductance_, [](double g) { return std::isinf(g); }));
    make_pattern();
  }

  SinglePhaseFlow run() {
    make_sources();
    make_numbers();
    std::vector<double> pressure = solve_nodes();
    find_flows(pressure);
    return std::move(flow_);
  }

 private:
  FlowGraph& graph() { return memory_.graph; }

  void make_pattern() {
    const unsigned pressure_faces = faces_of_kind(problem_, Kind::pressure), joined_faces = faces_of_kind(problem_, Kind::inflow);
    const auto passes = [](double g) { return g <= 0.0 ? 0 : std::isinf(g) ? 2 : 1; };
    const bool stands = memory_.system && memory_.pressure_faces == pressure_faces && memory_.joined_faces == joined_faces &&
                        size_of(memory_.graph.pore_node) == network_.pores() &&
                        memory_.compressible == problem_.compressibility.has_value() &&
                        std::ranges::equal(memory_.conductance, conductance_, {}, passes, passes);
    if (!stands) memory_.graph = make_flow_graph(network_, conductance_, joined_faces);
    prescribed_ = prescribed_pressures(network_, problem_, graph());
    reference_ = find_reference();
    for (int axis = 0; axis < 3; ++axis)
      ensure(problem_.pressure_gradient[axis] == 0.0 || !graph().short_circuit[to_size(axis)],
             "a path without any resistance crosses the periodic box along {}: no gradient can be held there", "xyz"[axis]);
    if (stands) return;
    const int pinned = find_pinned_node(network_, graph(), prescribed_, problem_.compressibility.has_value());
    memory_.pinned = pinned;
    memory_.unknown.assign(to_size(graph().nodes()), -1);
    int unknowns = 0;
    for (int n = 0; n < graph().nodes(); ++n)
      if (!prescribed_[to_size(n)] && n != pinned) memory_.unknown[to_size(n)] = unknowns++;
    std::vector<std::array<int, 2>> links;
    links.reserve(graph().link.size());
    for (const auto& [a, b] : graph().link)
      if (a != b && memory_.unknown[to_size(a)] >= 0 && memory_.unknown[to_size(b)] >= 0)
        links.push_back({memory_.unknown[to_size(a)], memory_.unknown[to_size(b)]});
    memory_.system.emplace(unknowns, links, memory_.solver);
    memory_.solution.assign(to_size(unknowns), 0.0);
    memory_.conductance.clear();
    memory_.pressure_faces = pressure_faces;
    memory_.joined_faces = joined_faces;
    memory_.compressible = problem_.compressibility.has_value();
  }

  /// Pressures are solved for relative to a given one, so that a high mean costs no digits.
  double find_reference() const {
    for (const auto& p : prescribed_)
      if (p) return *p;
    return problem_.compressibility ? problem_.compressibility->pressure_before.front() : 0.0;
  }

  /// Fluid that enters each node [m3/s].
  void make_sources() {
    source_.assign(to_size(graph().nodes()), 0.0);
    if (!problem_.volume_rate.empty())
      for (int p = 0; p < network_.pores(); ++p)
        source_[to_size(graph().pore_node[to_size(p)])] -= problem_.volume_rate[to_size(p)];
    for (int f = 0; f < 6; ++f) {
      if (problem_.faces[to_size(f)].kind != Kind::inflow) continue;
      const auto at_face = std::ranges::find_if(network_.pore_walls, [f](std::uint8_t walls) { return walls >> f & 1u; });
      source_[to_size(graph().pore_node[to_size(static_cast<int>(at_face - network_.pore_walls.begin()))])] +=
          problem_.faces[to_size(f)].value;
    }
    if (memory_.pinned < 0) return;
    double sum = 0.0, size = 0.0;
    for (const double s : source_) {
      sum += s;
      size += std::abs(s);
    }
    require(
        std::abs(sum) <= 1e-12 * size,
        "{:g} m3/s more fluid enters than leaves a network without any given pressure: give one to a face, or let the fluid be "
        "compressible",
        sum);
  }

  void make_numbers() {
    std::vector<double> diagonal(to_size(memory_.system->unknowns()), 0.0);
    for (int k = 0; k < graph().links(); ++k) {
      const auto [a, b] = graph().link[to_size(k)];
      if (a == b) continue;
      const int u = memory_.unknown[to_size(a)], v = memory_.unknown[to_size(b)];
      const double g = conductance_[to_size(graph().link_throat[to_size(k)])];
      if (u >= 0 && v < 0) diagonal[to_size(u)] += g;
      if (v >= 0 && u < 0) diagonal[to_size(v)] += g;
    }
    if (problem_.compressibility)
      for (int p = 0; p < network_.pores(); ++p) {
        const int u = memory_.unknown[to_size(graph().pore_node[to_size(p)])];
        if (u >= 0) diagonal[to_size(u)] += storage(p);
      }
    if (std::ranges::equal(conductance_, memory_.conductance) && diagonal == memory_.diagonal) return;  // the factor stands
    std::vector<double> link_conductance;
    link_conductance.reserve(graph().link.size());
    for (int k = 0; k < graph().links(); ++k) {
      const auto [a, b] = graph().link[to_size(k)];
      if (a != b && memory_.unknown[to_size(a)] >= 0 && memory_.unknown[to_size(b)] >= 0)
        link_conductance.push_back(conductance_[to_size(graph().link_throat[to_size(k)])]);
    }
    memory_.system->set(link_conductance, diagonal);
    memory_.conductance.assign(conductance_.begin(), conductance_.end());
    memory_.diagonal = std::move(diagonal);
    std::vector<char> is_root(to_size(graph().nodes()));
    for (std::size_t n = 0; n < is_root.size(); ++n) is_root[n] = memory_.unknown[n] < 0;
    memory_.tree = make_flow_tree(graph(), conductance_, is_root);
  }

  /// Viscosity times the volume a pore takes in per pressure and time [m3].
  double storage(int p) const {
    const SlightCompressibility& c = *problem_.compressibility;
    return problem_.viscosity * network_.pore_volume[to_size(p)] / (c.bulk_modulus * c.time_step);
  }

  /// What the mean gradient adds to the pressure at the far end of a link [Pa].
  double jump(int k) const {
    const auto& shift = memory_.graph.link_shift[to_size(k)];
    return dot(problem_.pressure_gradient, Vec3{shift[0] * period_.x, shift[1] * period_.y, shift[2] * period_.z});
  }

  /// Pressure of each node, relative to the reference.
  std::vector<double> solve_nodes() {
    std::vector<double> right(memory_.solution.size(), 0.0), pressure(to_size(graph().nodes()), 0.0);
    for (int n = 0; n < graph().nodes(); ++n) {
      const int u = memory_.unknown[to_size(n)];
      if (u >= 0) right[to_size(u)] += problem_.viscosity * source_[to_size(n)];
      if (u >= 0 && !problem_.guess.empty())
        memory_.solution[to_size(u)] = problem_.guess[to_size(graph().node_pore[to_size(n)])] - reference_;
      if (prescribed_[to_size(n)]) pressure[to_size(n)] = *prescribed_[to_size(n)] - reference_;
    }
    for (int k = 0; k < graph().links(); ++k) {
      const auto [a, b] = graph().link[to_size(k)];
      if (a == b) continue;
      const int u = memory_.unknown[to_size(a)], v = memory_.unknown[to_size(b)];
      const double g = conductance_[to_size(graph().link_throat[to_size(k)])];
      if (u >= 0) right[to_size(u)] += g * (jump(k) + (v < 0 ? pressure[to_size(b)] : 0.0));
      if (v >= 0) right[to_size(v)] += g * (-jump(k) + (u < 0 ? pressure[to_size(a)] : 0.0));
    }
    if (problem_.compressibility)
      for (int p = 0; p < network_.pores(); ++p) {
        const int u = memory_.unknown[to_size(graph().pore_node[to_size(p)])];
        if (u >= 0) right[to_size(u)] += storage(p) * (problem_.compressibility->pressure_before[to_size(p)] - reference_);
      }
    flow_.solve = memory_.system->solve(right, memory_.solution);
    for (int n = 0; n < graph().nodes(); ++n)
      if (const int u = memory_.unknown[to_size(n)]; u >= 0) pressure[to_size(n)] = memory_.solution[to_size(u)];
    return pressure;
  }

  void find_flows(const std::vector<double>& pressure) {
    flow_.throat_flow.assign(to_size(network_.throats()), 0.0);
    for (int k = 0; k < graph().links(); ++k) {
      const auto [a, b] = graph().link[to_size(k)];
      const int t = graph().link_throat[to_size(k)];
      const double drop = pressure[to_size(a)] - pressure[to_size(b)] - jump(k);
      flow_.throat_flow[to_size(t)] = conductance_[to_size(t)] / problem_.viscosity * drop;
    }
    flow_.pressure.resize(to_size(network_.pores()));
    for (int p = 0; p < network_.pores(); ++p) {
      const int n = graph().pore_node[to_size(p)];
      const auto& s = graph().pore_shift[to_size(p)];
      flow_.pressure[to_size(p)] = reference_ + pressure[to_size(n)] -
                                   dot(problem_.pressure_gradient, Vec3{s[0] * period_.x, s[1] * period_.y, s[2] * period_.z});
    }
    balance(pressure);
  }

  /// Carries what rounding and tolerance leave in the pores to where pressures are given.
  void balance(const std::vector<double>& pressure) {
    NodeFlows flows = sum_at_nodes(pressure);
    flow_.carried = flows.imbalance;
    carry_excess(graph(), memory_.tree, flows.net, flow_.throat_flow);
    flows = sum_at_nodes(pressure);
    flow_.imbalance = flows.imbalance;
    balance_faces(flows.net);
  }

  struct NodeFlows {
    std::vector<double> net;  // out less in, storage and sources included [m3/s]
    double imbalance = 0.0;   // largest of them where no pressure is given, over the largest flow through a node
  };

  NodeFlows sum_at_nodes(const std::vector<double>& pressure) {
    NodeFlows flows;
    flows.net.assign(pressure.size(), 0.0);
    std::vector<double> through(pressure.size(), 0.0);
    for (int k = 0; k < graph().links(); ++k) {
      const auto [a, b] = graph().link[to_size(k)];
      const double q = flow_.throat_flow[to_size(graph().link_throat[to_size(k)])];
      flows.net[to_size(a)] += q;
      flows.net[to_size(b)] -= q;
      through[to_size(a)] += 0.5 * std::abs(q);
      through[to_size(b)] += 0.5 * std::abs(q);
    }
    if (problem_.compressibility)
      for (int p = 0; p < network_.pores(); ++p) {
        const auto n = to_size(graph().pore_node[to_size(p)]);
        flows.net[n] +=
            storage(p) / problem_.viscosity * (pressure[n] + reference_ - problem_.compressibility->pressure_before[to_size(p)]);
      }
    double largest = 0.0, worst = 0.0;
    for (std::size_t n = 0; n < flows.net.size(); ++n) {
      flows.net[n] -= source_[n];
      largest = std::max(largest, through[n]);
      if (!prescribed_[n]) worst = std::max(worst, std::abs(flows.net[n]));
    }
    flows.imbalance = largest > 0.0 ? worst / largest : 0.0;
    return flows;
  }

  /// What leaves a pore of given pressure has come in through its face.
  void balance_faces(const std::vector<double>& net) {
    flow_.face_inflow = {};
    std::vector<char> counted(net.size(), 0);
    for (int f = 0; f < 6; ++f) {
      if (problem_.faces[to_size(f)].kind == Kind::inflow) flow_.face_inflow[to_size(f)] = problem_.faces[to_size(f)].value;
      if (problem_.faces[to_size(f)].kind != Kind::pressure) continue;
      for (int p = 0; p < network_.pores(); ++p) {
        const auto n = to_size(graph().pore_node[to_size(p)]);
        if (!(network_.pore_walls[to_size(p)] >> f & 1u) || counted[n]) continue;
        counted[n] = 1;
        flow_.face_inflow[to_size(f)] += net[n];
      }
    }
  }

  const PoreNetwork& network_;
  Vec3 period_;
  const SinglePhaseProblem& problem_;
  SinglePhaseMemory& memory_;
  SinglePhaseFlow flow_;
  std::vector<double> limited_, source_;
  std::span<const double> conductance_;
  std::vector<std::optional<double>> prescribed_;
  double reference_ = 0.0;
};

}  // namespace

SinglePhaseFlow solve_single_phase(const PoreNetwork& network, const Domain& domain, const SinglePhaseProblem& problem,
                                   SinglePhaseMemory& memory) {
  return Solve(network, domain, problem, memory).run();
}

}  // namespace puadem
