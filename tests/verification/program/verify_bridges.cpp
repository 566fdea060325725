// Compares liquid bridges with the Young-Laplace equation, the tables and the published fits with the exact solution, and
// writes what came out as CSV files: the tables and figures of docs/validation.md. tools/verify_bridges calls it.
#include <algorithm>
#include <ctime>

#include "bridges/support.hpp"
#include "csv.hpp"
#include "puadem/base/parallel.hpp"
#include "puadem/base/random.hpp"
#include "puadem/bridges/bridge_formulas.hpp"
#include "puadem/bridges/bridges.hpp"

using namespace puadem;
using namespace puadem::verification;
using puadem::test::bridge_ends;
using puadem::test::degrees;

namespace {

constexpr double pi = std::numbers::pi;

const char* name(BridgeControl control) { return control == BridgeControl::suction ? "suction" : "volume"; }

/// Of processor time.
double seconds(const auto& work) {
  const std::clock_t start = std::clock();
  work();
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

/// Radii of a ratio, R* = 1; 0: a plane.
std::array<double, 2> radii(double ratio) {
  return {0.5 * (1.0 + ratio), ratio > 0.0 ? 0.5 * (1.0 + ratio) / ratio : std::numeric_limits<double>::infinity()};
}

/// Closed form beside the integrated meridian, at random gaps of random bridges.
void write_exact(const std::filesystem::path& folder) {
  Csv csv(folder / "bridges_exact.csv", "control,bridges,gap,volume,area,pull");
  for (const auto control : {BridgeControl::suction, BridgeControl::volume}) {
    Random random(3);
    std::array<double, 4> worst{};
    const int n = 300;
    for (int i = 0; i < n; ++i) {
      const auto radius = radii(random.uniform(0.05, 1.0));
      const std::array<BridgeEnd, 2> ends{BridgeEnd{radius[0], random.uniform(0.0, 50 * degrees)},
                                          BridgeEnd{radius[1], random.uniform(0.0, 50 * degrees)}};
      const double amount = control == BridgeControl::suction ? std::pow(10.0, random.uniform(0.0, 3.0))
                                                              : std::pow(10.0, random.uniform(-6.0, -1.5));
      const StableBranch branch = stable_branch(ends, control, amount);
      const BridgeShape shape = *bridge_on(branch, random.uniform() * branch.rupture.gap);
      const double arc = shape.sides[0].arc + shape.sides[1].arc, size = shape.sides[0].contact_radius;
      const auto exact = test::integrate_meridian(ends, shape.suction, shape.sides[0].filling_angle, arc / 2000.5);
      const double area = shape.sides[0].meniscus_area + shape.sides[1].meniscus_area;
      const std::array<double, 4> error{(shape.gap - exact.gap) / size, shape.volume / exact.volume - 1.0,
                                        area / exact.meniscus_area - 1.0, shape.pull / exact.pull[1] - 1.0};
      for (std::size_t k = 0; k < 4; ++k) worst[k] = std::max(worst[k], std::abs(error[k]));
    }
    csv.row(name(control), n, worst[0], worst[1], worst[2], worst[3]);
  }
}

/// Widest gap of a bridge between equal spheres that stays symmetric on the wider circles of both, past its loss of stability.
double turning_point(const StableBranch& branch) {
  double widest = branch.rupture.gap;
  for (int k = 0; k < 300; ++k) {
    const double pull = branch.rupture.pull * (1.0 - k / 600.0);
    double low = least_suction(branch.ends[0], pull), high = low + std::abs(low);
    for (int i = 0; i < 60; ++i) {
      const double middle = 0.5 * (low + high);
      const auto shape = bridge_shape(branch.ends, middle, pull, 1);
      (shape && 2.0 * shape->sides[1].volume < branch.amount ? low : high) = middle;
    }
    const auto shape = bridge_shape(branch.ends, low, pull, 1);
    if (shape) widest = std::max(widest, 2.0 * shape->sides[1].reach);
  }
  return widest;
}

void write_known(const std::filesystem::path& folder) {
  Csv at_volume(folder / "bridges_volume.csv", "angle,volume,pull,suction,filling,reach,willett,lian,turning");
  for (const double angle : {0.0, 20.0, 40.0})
    for (const double volume : {1e-4, 1e-3, 1e-2, 1e-1}) {
      const StableBranch branch = stable_branch(bridge_ends(1, 1, angle * degrees), BridgeControl::volume, volume);
      const BridgeShape contact = *bridge_on(branch, 0.0), &last = branch.rupture;
      const bool slides = std::abs(greatest_pull(branch.ends[0], last.suction) / last.pull - 1.0) < 1e-4;
      at_volume.row(angle, volume, contact.pull, contact.suction, contact.sides[0].filling_angle / degrees, last.gap,
                    willett_reach({1, 1}, angle * degrees, volume), lian_reach(angle * degrees, volume),
                    slides ? turning_point(branch) : last.gap);
    }
  Csv at_suction(folder / "bridges_suction.csv", "suction,pull,volume,filling,reach,rupture_pull,reach_of_its_volume");
  for (const double suction : {1.0, 5.0, 20.0, 100.0, 500.0, 5000.0}) {
    const StableBranch branch = stable_branch(bridge_ends(1, 1, 0), BridgeControl::suction, suction);
    const BridgeShape contact = *bridge_on(branch, 0.0);
    const StableBranch closed = stable_branch(branch.ends, BridgeControl::volume, contact.volume);
    at_suction.row(suction, contact.pull, contact.volume, contact.sides[0].filling_angle / degrees, branch.rupture.gap,
                   branch.rupture.pull, closed.rupture.gap);
  }
  Csv by_ratio(folder / "bridges_ratio.csv", "angle,ratio,reach");
  for (const double angle : {0.0, 20.0, 30.0, 40.0, 60.0})
    for (int k = 0; k <= 60; ++k) {
      const auto radius = radii(1.0 - std::pow(k / 60.0, 1.5));
      const StableBranch branch = stable_branch(bridge_ends(radius[0], radius[1], angle * degrees), BridgeControl::volume, 1e-3);
      by_ratio.row(angle, 1.0 - std::pow(k / 60.0, 1.5), branch.rupture.gap);
    }
}

/// Tables beside the exact solution at random points of their whole range.
void write_tables(const std::filesystem::path& folder) {
  Csv csv(folder / "bridges_tables.csv", "control,angle,seconds,bytes,points,pull_90,pull_98,reach,content,work,most");
  for (const auto control : {BridgeControl::suction, BridgeControl::volume})
    for (const double angle : {0.0, 20.0, 30.0, 40.0, 60.0, 80.0}) {
      BridgeTable table{};
      const double time = seconds([&] { table = make_bridge_table(control, angle * degrees); });
      Random random(17);
      double pull90 = 0.0, pull98 = 0.0, reach = 0.0, content = 0.0, work = 0.0;
      const int n = 400;
      for (int i = 0; i < n; ++i) {
        const auto radius = radii(i % 4 == 0 ? 1.0 : i % 4 == 1 ? random.uniform(0.8, 1.0) : random.uniform());
        const double amount = table.least * std::pow(table.most / table.least, random.uniform());
        const StableBranch branch = stable_branch(bridge_ends(radius[0], radius[1], angle * degrees), control, amount);
        const BridgeCurve curve = bridge_curve(table, radius, amount);
        reach = std::max(reach, std::abs(curve.reach / branch.rupture.gap - 1.0));
        const double whole = free_energy(branch, branch.rupture) - free_energy(branch, *bridge_on(branch, 0.0));
        for (const double share : {0.0, random.uniform(0.0, 0.1), random.uniform(0.0, 0.9), random.uniform(0.9, 0.98), 0.98}) {
          const double gap = share * branch.rupture.gap;
          const BridgeShape shape = *bridge_on(branch, gap);
          double& pull = share < 0.9 ? pull90 : pull98;
          pull = std::max(pull, std::abs(bridge_pull(curve, gap) / shape.pull - 1.0));
          const bool suction = control == BridgeControl::suction;
          const double exact = suction ? shape.volume : shape.suction;
          const double scale = suction ? exact : 2.0 * curve.small.cosine / curve.small.zero_gap(gap);
          content = std::max(content, std::abs(bridge_content(curve, gap) - exact) / scale);
          work = std::max(
              work, std::abs(bridge_work(curve, gap) - free_energy(branch, branch.rupture) + free_energy(branch, shape)) / whole);
        }
      }
      csv.row(name(control), angle, time, table.node.size() * sizeof(double), 5 * n, pull90, pull98, reach, content, work,
              table.most);
    }
}

void write_fits(const std::filesystem::path& folder) {
  Csv csv(folder / "bridges_fits.csv", "angle,ratio,volume,share,willett,soulie,willett_reach,lian_reach");
  Csv curves(folder / "bridges_curves.csv", "volume,gap,exact,table,willett,soulie");
  for (const double angle : {0.0, 20.0, 40.0})
    for (const double ratio : {1.0, 0.5, 0.2})
      for (const double volume : {1e-5, 1e-4, 1e-3, 1e-2, 0.05}) {
        const auto radius = radii(ratio);
        const StableBranch branch =
            stable_branch(bridge_ends(radius[0], radius[1], angle * degrees), BridgeControl::volume, volume);
        for (const double share : {0.0, 0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9}) {
          const double gap = share * branch.rupture.gap, pull = bridge_on(branch, gap)->pull;
          csv.row(angle, ratio, volume, share, willett_pull(radius, angle * degrees, volume, gap) / pull - 1.0,
                  soulie_pull(radius, angle * degrees, volume, gap) / pull - 1.0,
                  willett_reach(radius, angle * degrees, volume) / branch.rupture.gap - 1.0,
                  lian_reach(angle * degrees, volume) / branch.rupture.gap - 1.0);
        }
      }
  const BridgeTable table = make_bridge_table(BridgeControl::volume, 0.0);
  for (const double volume : {1e-4, 1e-3, 1e-2}) {
    const StableBranch branch = stable_branch(bridge_ends(1, 1, 0), BridgeControl::volume, volume);
    const BridgeCurve curve = bridge_curve(table, {1, 1}, volume);
    for (int k = 0; k <= 100; ++k) {
      const double gap = std::min(branch.rupture.gap, curve.reach) * (1.0 - std::pow(1.0 - k / 100.0, 2));
      curves.row(volume, gap, bridge_on(branch, gap)->pull, bridge_pull(curve, gap), willett_pull({1, 1}, 0.0, volume, gap),
                 soulie_pull({1, 1}, 0.0, volume, gap));
    }
  }
}

/// Pull-off of a pair in small steps: the work of the force beside the energy that the model holds.
void write_work(const std::filesystem::path& folder) {
  Csv csv(folder / "bridges_work.csv", "law,ratio,amount,work,energy");
  const double gamma = 0.0728, radius = 1e-3;
  const std::array<std::pair<const char*, BridgeModel>, 4> models{
      {{"table at given suction", bridge_model(gamma, 0.0, BridgeControl::suction)},
       {"table of given volume", bridge_model(gamma, 0.0, BridgeControl::volume)},
       {"Willett", bridge_model(gamma, 0.0, BridgeControl::volume, BridgeModel::Law::willett)},
       {"Soulie", bridge_model(gamma, 0.0, BridgeControl::volume, BridgeModel::Law::soulie)}}};
  for (const auto& [law, model] : models)
    for (const double ratio : {1.0, 3.0})
      for (const double amount :
           model.table.control == BridgeControl::suction ? std::array{1e3, 1e5} : std::array{1e-13, 1e-11}) {
        Bridges b;
        form_bridges(model, {{{0, 1}}, {{radius, ratio * radius}}, {0.0}}, std::array{amount}, BridgeFormation::at_contact, b);
        const double energy = rupture_work(model, b), reach = rupture_distance(model, b, 0);
        const int steps = 20000;
        double work = 0.0;
        for (int i = 0; i < steps; ++i) {
          b.pairs.gap[0] = reach * (i + 0.5) / steps;
          update_forces(model, b);
          work += b.force[0] * reach / steps;
        }
        csv.row(law, ratio, amount, work, energy);
      }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    fmt::print(stderr, "usage: verify_bridges FOLDER\n");
    return 1;
  }
  const std::filesystem::path folder = argv[1];
  std::filesystem::create_directories(folder);
  set_threads(1);
  write_exact(folder);
  write_known(folder);
  write_tables(folder);
  write_fits(folder);
  write_work(folder);
}
