// Runs the verification cases of the grain engine and writes what came out as CSV files: the figures and the table
// of docs/verification_grains.md. tools/verify_grains calls it.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "puadem/dem/motion.hpp"
#include "verification/chung_ooi.hpp"
#include "verification/gas.hpp"
#include "verification/program/csv.hpp"
#include "verification/triaxial.hpp"

using namespace puadem;
using namespace puadem::verification;

namespace {

constexpr int steps = 2000;
constexpr auto linear = ContactOptions::Law::linear_spring, hertz = ContactOptions::Law::hertz_mindlin;

const char* name_of(ContactOptions::Law law) { return law == linear ? "linear" : "Hertz"; }

/// The table: what was asked, the exact answer, ours.
struct Table {
  Csv csv;
  void line(const std::string& test, const std::string& quantity, const std::string& unit, double exact, double ours,
            double scale) {
    csv.row(test, quantity, unit, exact, ours, std::abs(ours - exact) / std::abs(scale));
  }
};

/// A sphere of 1 mm pressed 1 um into a plane: of its own constants, and one that does not yield.
void pressed_spheres(Table& table) {
  const Material m{.density = 2500, .youngs_modulus = 1e8, .poisson_ratio = 0.3};
  const double radius = 1e-3, overlap = 1e-6;
  Domain box;
  box.upper = {1e-2, 1e-2, 1e-2};
  const Particles p = make_particles(std::vector<Vec3>{{5e-3, 5e-3, radius - overlap}}, std::vector<double>{radius}, m);
  const double rigid = 4.0 / 3.0 * 1e8 / (1 - 0.09) * std::sqrt(radius) * std::pow(overlap, 1.5);
  for (const bool yields : {true, false}) {
    ContactOptions contact;
    contact.wall_elasticity = yields ? ContactOptions::WallElasticity::material : ContactOptions::WallElasticity::rigid;
    GrainSystem s = make_grain_system(p, box, std::span(&m, 1), contact, {});
    evaluate_forces(s);
    const double exact = yields ? rigid / 2 : rigid;
    table.line("–", yields ? "sphere pressed into a plane of its own constants" : "sphere pressed into a rigid plane", "mN",
               1e3 * exact, -1e3 * s.walls[4].force.z, 1e3 * exact);
  }
}

void elastic_impacts(const std::filesystem::path& folder, Table& table) {
  Csv course(folder / "normal.csv", "test,material,time_us,overlap_um,force_kN");
  const auto run = [&](const std::string& test, const Impact& impact) {
    const Rebound ours = collide(impact, steps), exact = hertz_impact(impact);
    const std::string name = impact.solid.name;
    table.line(test, name + ": deepest overlap", "um", 1e6 * exact.deepest, 1e6 * ours.deepest, 1e6 * exact.deepest);
    table.line(test, name + ": largest force", "kN", 1e-3 * exact.largest, 1e-3 * ours.largest, 1e-3 * exact.largest);
    table.line(test, name + ": time of contact", "us", 1e6 * exact.duration, 1e6 * ours.duration, 1e6 * exact.duration);
    table.line(test, name + ": rebound speed", "m/s", exact.ball.up, ours.ball.up, exact.ball.up);
    for (std::size_t k = 0; k < ours.course.size(); k += 20) {
      const auto& m = ours.course[k];
      course.row(test, name, 1e6 * m.time, 1e6 * m.overlap, 1e-3 * m.force);
    }
  };
  for (const Impact& impact : test_1()) run("1", impact);
  for (const Impact& impact : test_2()) run("2", impact);
  for (const Solid& solid : solids_of_test_3()) run("3", test_3(solid, 1.0));
}

void restitutions(const std::filesystem::path& folder, Table& table) {
  Csv csv(folder / "restitution.csv", "material,asked,got");
  for (const Solid& solid : solids_of_test_3())
    for (int k = 1; k <= 10; ++k) {
      const double e = 0.1 * k, got = collide(test_3(solid, e), steps).ball.up / 3.9;
      csv.row(solid.name, e, got);
      if (k % 2 == 0) table.line("3", solid.name + ": restitution", "-", e, got, 1.0);
    }
  Csv order(folder / "restitution_order.csv", "law,asked,steps,median_error,worst_error");
  for (const auto law : {linear, hertz})
    for (const double e : {0.95, 0.9, 0.7, 0.5, 0.3})
      for (const int n : {25, 50, 100, 200, 400}) {
        const Impact impact{
            .solid = {"soft", 1e8, 0.3, 2500}, .radius = 1e-3, .ball = {.up = -1}, .restitution = e, .partner = {}};
        const RestitutionError error = restitution_error(impact, n, law);
        order.row(name_of(law), e, n, error.median, error.worst);
      }
}

/// Largest difference from the integrated equations and, where the contact slides throughout, from the closed
/// form, as shares of the speed of approach.
struct Worst {
  double integrated = 0.0, sliding = 0.0;
};

void compare(const Impact& impact, const Rebound& ours, Worst& worst) {
  const double speed = approach_speed(impact);
  const auto distance = [&](const Rebound& other) {
    return std::max(std::abs(ours.ball.along - other.ball.along), impact.radius * std::abs(ours.ball.spin - other.ball.spin)) /
           speed;
  };
  worst.integrated = std::max(worst.integrated, distance(integrate(impact)));
  const double slip = std::abs(slip_speed(impact, impact.ball, impact.partner ? impact.partner->ball : Ball{}));
  if (slip > 5.5 * impact.friction * (1 + impact.restitution) * speed)
    worst.sliding = std::max(worst.sliding, distance(slide_throughout(impact)));
}

void book(Table& table, const std::string& test, const std::string& name, const Worst& worst) {
  table.line(test, name + ": all velocities against the integrated equations", "v_n", 0.0, worst.integrated, 1.0);
  table.line(test, name + ": velocities after sliding throughout against the closed form", "v_n", 0.0, worst.sliding, 1.0);
}

void oblique_impacts(const std::filesystem::path& folder, Table& table) {
  Csv csv(folder / "oblique_4.csv", "degrees,restitution_t,spin,rebound_degrees,integrated_t,sliding_t");
  Worst worst;
  for (int degrees = 1; degrees < 90; ++degrees) {
    const Impact impact = test_4(degrees);
    const Rebound r = collide(impact, steps);
    compare(impact, r, worst);
    const double along = impact.ball.along;
    csv.row(degrees, r.ball.along / along, -r.ball.spin,
            std::atan(slip_speed(impact, r.ball, {}) / r.ball.up) * 180 / std::numbers::pi, integrate(impact).ball.along / along,
            slide_throughout(impact).ball.along / along);
  }
  book(table, "4", "aluminium oxide at 1 to 89 degrees", worst);

  Csv five(folder / "oblique_5.csv", "material,incident,recoil,spin,recoil_integrated,spin_integrated,spin_sliding");
  for (const Solid& solid : solids_of_test_5()) {
    Worst largest;
    for (int k = 1; k <= 60; ++k) {
      const Impact impact = test_5(solid, 0.35 * k);
      const Rebound r = collide(impact, steps), q = integrate(impact);
      compare(impact, r, largest);
      const double scale = impact.friction * 5.0;
      five.row(solid.name, impact.ball.along / scale, slip_speed(impact, r.ball, {}) / (impact.friction * r.ball.up),
               -impact.radius * r.ball.spin / scale, slip_speed(impact, q.ball, {}) / (impact.friction * q.ball.up),
               -impact.radius * q.ball.spin / scale, -impact.radius * slide_throughout(impact).ball.spin / scale);
    }
    book(table, "5", solid.name, largest);
  }
}

void spinning_impacts(const std::filesystem::path& folder, Table& table) {
  Csv csv(folder / "spin_6_8.csv", "series,spin,sliding_number,beta,incident,recoil,beta_integrated,beta_sliding");
  const auto sweep = [&](const std::string& test, const std::string& series, const auto& impact_at) {
    Worst worst;
    for (int k = 0; k <= 60; ++k) {
      const Impact impact = impact_at(0.15 * std::pow(150.0, k / 60.0));
      const Rebound r = collide(impact, steps), q = integrate(impact), slide = slide_throughout(impact);
      compare(impact, r, worst);
      const double before = slip_speed(impact, impact.ball, impact.partner ? impact.partner->ball : Ball{});
      const auto slip = [&](const Rebound& rebound) { return slip_speed(impact, rebound.ball, rebound.partner); };
      csv.row(series, impact.ball.spin, 3.5 * impact.friction * (1 + impact.restitution) * 0.2 / std::abs(before),
              -slip(r) / before, -before / 0.2, -slip(r) / r.ball.up, -slip(q) / before, -slip(slide) / before);
    }
    book(table, test, series, worst);
  };
  for (const Solid& solid : solids_of_test_6()) sweep("6", solid.name, [&](double spin) { return test_6(solid, spin); });
  sweep("8", "stiff partner", [](double spin) { return test_8(spin, true); });
  sweep("8", "partner of the same stiffness", [](double spin) { return test_8(spin, false); });

  Csv seven(folder / "spin_7.csv", "material,spin,spin_after,along_after");
  for (const Solid& solid : solids_of_test_7()) {
    double worst = 0.0;
    for (int k = 0; k <= 20; ++k) {
      const double spin = 0.15 * std::pow(150.0, k / 20.0);
      const Rebound r = collide(test_7(solid, spin), steps);
      seven.row(solid.name, spin, r.ball.spin, r.ball.along);
      worst = std::max({worst, std::abs(r.ball.spin / spin - 1), std::abs(r.ball.along) / 0.2});
    }
    table.line("7", solid.name + ": change of spin and of velocity along the surface", "-", 0.0, worst, 1.0);
  }
}

void energy(const std::filesystem::path& folder) {
  Csv order(folder / "gas_order.csv", "law,steps,error");
  for (const auto law : {linear, hertz})
    for (const int n : {20, 40, 80, 160, 320})
      order.row(name_of(law), n,
                run_gas({.law = law, .grains_across = 8, .steps = 100 * n, .steps_per_contact = 1.0 * n}).largest_error);
  Csv gas(folder / "gas.csv", "law,grains,steps,steps_per_contact,error");
  for (const auto law : {linear, hertz})
    gas.row(name_of(law), 1000, 100000, 160, run_gas({.law = law, .steps_per_contact = 160}).largest_error);
  Csv csv(folder / "triaxial_energy.csv",
          "law,drive,grains,steps,strain,input,kinetic,normal,shear,friction,shear_work,damping,residual");
  const auto run = [&](const char* drive, const TriaxialSetUp& set_up) {
    const TriaxialBalance b = run_triaxial(set_up);
    const Energies &a = b.start, &e = b.end;
    csv.row(name_of(set_up.law), drive, set_up.count, b.steps, set_up.axial_strain, e.input, e.kinetic - a.kinetic,
            e.normal - a.normal, e.shear - a.shear, e.friction - a.friction, e.shear_work - a.shear_work, e.damping - a.damping,
            b.residual());
  };
  for (const auto law : {linear, hertz}) {
    run("periodic box", {.law = law});
    run("walls and grains following the box", {.law = law, .is_periodic = false});
    run("walls alone", {.law = law, .is_periodic = false, .grains_follow_box = false});
  }
}

void dense_and_loose(const std::filesystem::path& folder) {
  Csv csv(folder / "triaxial.csv", "series,axial_strain,ratio,volumetric,void_ratio,lateral_Pa,unbalanced,coordination");
  Csv ends(folder / "triaxial_ends.csv", "series,grains,steps,residual");
  for (const auto& [name, friction] : {std::pair{"dense", 0.0}, std::pair{"loose", 0.5}}) {
    const TriaxialSetUp set_up{
        .law = hertz, .count = 4000, .axial_strain = 0.5, .compaction_friction = friction, .step_share = 0.4};
    const TriaxialBalance b = run_triaxial(set_up);
    for (const ProgramRow& r : b.rows)
      csv.row(name, r.strain.z, r.deviator / r.mean, r.volumetric, (1 + b.void_ratio) * std::exp(-r.volumetric) - 1,
              0.5 * (r.stress.x + r.stress.y), r.unbalanced, r.coordination);
    ends.row(name, set_up.count, b.steps, b.residual());
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    fmt::print(stderr, "usage: verify_grains FOLDER\n");
    return 1;
  }
  const std::filesystem::path folder = argv[1];
  std::filesystem::create_directories(folder);
  Table table{Csv(folder / "table.csv", "test,quantity,unit,exact,ours,error")};
  pressed_spheres(table);
  elastic_impacts(folder, table);
  restitutions(folder, table);
  oblique_impacts(folder, table);
  spinning_impacts(folder, table);
  energy(folder);
  dense_and_loose(folder);
}
