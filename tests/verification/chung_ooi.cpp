#include "chung_ooi.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "puadem/dem/contacts.hpp"
#include "puadem/dem/motion.hpp"

namespace puadem::verification {

namespace {

constexpr double pi = std::numbers::pi;

/// What the two bodies have in common.
struct Pair {
  double youngs, shear;  ///< E*, G* [Pa]
  double radius, mass;   ///< R* [m], m* [kg]
};

Pair pair_of(const Impact& impact) {
  const auto softness = [](const Solid& s) { return (1 - s.poisson * s.poisson) / s.youngs; };
  const auto shear_softness = [](const Solid& s) { return 2 * (2 - s.poisson) * (1 + s.poisson) / s.youngs; };
  const double mass = mass_of(impact.solid, impact.radius);
  if (!impact.partner) return {1 / softness(impact.solid), 1 / shear_softness(impact.solid), impact.radius, mass};
  const Impact::Partner& other = *impact.partner;
  const double other_mass = mass_of(other.solid, other.radius);
  return {.youngs = 1 / (softness(impact.solid) + softness(other.solid)),
          .shear = 1 / (shear_softness(impact.solid) + shear_softness(other.solid)),
          .radius = impact.radius * other.radius / (impact.radius + other.radius),
          .mass = mass * other_mass / (mass + other_mass)};
}

/// Velocities after a normal and a tangential impulse on the ball [N s], opposite on its partner.
void apply(const Impact& impact, double normal, double tangential, Rebound& rebound) {
  const double mass = mass_of(impact.solid, impact.radius);
  rebound.ball = {impact.ball.up + normal / mass, impact.ball.along + tangential / mass,
                  impact.ball.spin - 2.5 * tangential / (mass * impact.radius)};
  if (!impact.partner) return;
  const Impact::Partner& other = *impact.partner;
  const double other_mass = mass_of(other.solid, other.radius);
  rebound.partner = {other.ball.up - normal / other_mass, other.ball.along - tangential / other_mass,
                     other.ball.spin - 2.5 * tangential / (other_mass * other.radius)};
}

Material material_of(const Solid& solid, double friction) {
  return {.name = solid.name,
          .density = solid.density,
          .youngs_modulus = solid.youngs,
          .poisson_ratio = solid.poisson,
          .friction_angle = std::atan(friction)};
}

GrainSystem set_up(const Impact& impact, ContactOptions::Law law) {
  const bool alone = !impact.partner;
  std::vector<Material> materials{material_of(impact.solid, impact.friction)};
  std::vector<Vec3> position{{0, 0, impact.radius}};
  std::vector<double> radius{impact.radius};
  if (!alone) {
    materials.push_back(material_of(impact.partner->solid, impact.friction));
    position.push_back({0, 0, -impact.partner->radius});
    radius.push_back(impact.partner->radius);
  }
  Particles p = make_particles(position, radius, materials[0]);
  const auto set = [&](std::size_t k, const Solid& solid, const Ball& ball) {
    p.mass[k] = mass_of(solid, radius[k]);
    p.inertia[k] = 0.4 * p.mass[k] * radius[k] * radius[k];
    p.material[k] = static_cast<int>(k);
    p.velocity[k] = {ball.along, 0, ball.up};
    p.angular_velocity[k] = {0, ball.spin, 0};
  };
  set(0, impact.solid, impact.ball);
  if (!alone) set(1, impact.partner->solid, impact.partner->ball);

  ContactOptions contact;
  contact.law = law;
  contact.wall_friction = impact.friction;
  contact.wall_elasticity = ContactOptions::WallElasticity::rigid;
  if (impact.restitution < 1.0) contact.restitution = impact.restitution;
  const double width = 10 * *std::max_element(radius.begin(), radius.end());
  Domain box;
  box.lower = {-width, -width, alone ? 0.0 : -width};
  box.upper = {width, width, width};
  GrainSystem s = make_grain_system(p, box, materials, contact, {});
  std::erase_if(s.walls, [&](const Wall& wall) { return !alone || wall.face != 4; });
  return s;
}

}  // namespace

double mass_of(const Solid& solid, double radius) { return 4.0 / 3.0 * pi * radius * radius * radius * solid.density; }

double approach_speed(const Impact& impact) { return (impact.partner ? impact.partner->ball.up : 0.0) - impact.ball.up; }

double slip_speed(const Impact& impact, const Ball& ball, const Ball& partner) {
  const double below = impact.partner ? partner.along + impact.partner->radius * partner.spin : 0.0;
  return ball.along - impact.radius * ball.spin - below;
}

Rebound collide(const Impact& impact, int steps, ContactOptions::Law law, double phase) {
  GrainSystem s = set_up(impact, law);
  const Pair pair = pair_of(impact);
  const double stiffness = 2 * impact.solid.youngs * pair.radius;  // k_n of the linear law for one solid, theory 2.5
  const double contact_time =
      law == ContactOptions::Law::hertz_mindlin ? hertz_impact(impact).duration : pi * std::sqrt(pair.mass / stiffness);
  s.time_step = contact_time / steps;
  s.record[0].place[2] += phase * s.time_step * approach_speed(impact);
  Rebound r;
  for (int step = 0;; ++step) {
    evaluate_forces(s);
    const std::vector<Contact> contacts = contacts_of(s);
    Vec3 place[2]{{}, {0, 0, 0}};
    for (int k = 0; k < s.owned; ++k) place[s.identity[to_size(k)]] = vec3(s.record[to_size(k)].place);
    const double overlap =
        impact.partner ? impact.radius + impact.partner->radius - norm(place[0] - place[1]) : impact.radius - place[0].z;
    const double now = step * s.time_step;
    if (step < phase) {
      move_grains(s);
      continue;
    }
    if (r.deepest > 0.0 && overlap <= 0.0) {
      const Rebound::Moment& last = r.course.back();
      r.duration = last.time + s.time_step * last.overlap / (last.overlap - overlap);
      break;
    }
    r.course.push_back({now, overlap, contacts.empty() ? 0.0 : contacts[0].normal_force});
    r.deepest = std::max(r.deepest, overlap);
    r.largest = std::max(r.largest, r.course.back().force);
    move_grains(s);
  }
  for (int k = 0; k < s.owned; ++k) {
    const GrainRecord& g = s.record[to_size(k)];
    (s.identity[to_size(k)] == 0 ? r.ball : r.partner) = {g.drift[2], g.drift[0], g.spin[1]};
  }
  return r;
}

RestitutionError restitution_error(const Impact& impact, int steps, ContactOptions::Law law) {
  constexpr int phases = 41;
  std::vector<double> error;
  for (int k = 0; k < phases; ++k) {
    const Rebound r = collide(impact, steps, law, static_cast<double>(k) / phases);
    error.push_back(std::abs((r.ball.up - r.partner.up) / approach_speed(impact) - impact.restitution));
  }
  std::sort(error.begin(), error.end());
  return {error[phases / 2], error.back()};
}

Rebound hertz_impact(const Impact& impact) {
  const Pair pair = pair_of(impact);
  const double speed = approach_speed(impact), stiffness = 4.0 / 3.0 * pair.youngs * std::sqrt(pair.radius);
  Rebound r;
  r.deepest = std::pow(5 * pair.mass * speed * speed / (4 * stiffness), 0.4);
  r.largest = stiffness * std::pow(r.deepest, 1.5);
  r.duration = 2 * std::sqrt(pi) * std::tgamma(1.4) / std::tgamma(0.9) * r.deepest / speed;
  apply(impact, 2 * pair.mass * speed, 0.0, r);
  return r;
}

Rebound integrate(const Impact& impact, int steps) {
  const Pair pair = pair_of(impact);
  const double log_e = std::log(impact.restitution), beta = -log_e / std::hypot(pi, log_e);
  const double dt = hertz_impact(impact).duration / steps;
  struct State {
    double overlap, rate, slip_rate, shear;
  };
  const auto normal_force = [&](double overlap) { return 4.0 / 3.0 * pair.youngs * std::sqrt(pair.radius * overlap) * overlap; };
  const auto advance = [&](const State& from, const State& at, double step) {
    const double overlap = std::max(at.overlap, 0.0), contact_radius = std::sqrt(pair.radius * overlap);
    const double viscosity = 2 * std::sqrt(5.0 / 6.0) * beta * std::sqrt(pair.mass * 2 * pair.youngs * contact_radius);
    State next{from.overlap + step * at.rate, from.rate - step * (normal_force(overlap) + viscosity * at.rate) / pair.mass,
               from.slip_rate + step * 3.5 * at.shear / pair.mass,
               from.shear - step * 8 * pair.shear * contact_radius * at.slip_rate};
    const double limit = impact.friction * normal_force(std::max(next.overlap, 0.0));
    next.shear = std::clamp(next.shear, -limit, limit);
    return next;
  };
  const double slip = slip_speed(impact, impact.ball, impact.partner ? impact.partner->ball : Ball{});
  State now{0.0, approach_speed(impact), slip, 0.0};
  const State start = now;
  Rebound r;
  for (int step = 0; step == 0 || now.overlap > 0.0; ++step) {
    now = advance(now, advance(now, now, 0.5 * dt), dt);
    r.deepest = std::max(r.deepest, now.overlap);
    r.duration = (step + 1) * dt;
  }
  apply(impact, pair.mass * (start.rate - now.rate), pair.mass * (now.slip_rate - start.slip_rate) / 3.5, r);
  return r;
}

Rebound slide_throughout(const Impact& impact) {
  const double normal = pair_of(impact).mass * (1 + impact.restitution) * approach_speed(impact);
  const double slip = slip_speed(impact, impact.ball, impact.partner ? impact.partner->ball : Ball{});
  Rebound r;
  apply(impact, normal, -std::copysign(impact.friction * normal, slip), r);
  return r;
}

namespace {

const Solid al_alloy{"aluminium alloy", 70e9, 0.33, 2700};

}  // namespace

std::vector<Impact> test_1() {
  std::vector<Impact> impacts;
  for (const Solid& solid : {Solid{"glass", 48e9, 0.2, 2800}, Solid{"limestone", 20e9, 0.25, 2500}})
    impacts.push_back({.solid = solid, .radius = 0.01, .ball = {.up = -10}, .partner = Impact::Partner{solid, 0.01, {.up = 10}}});
  return impacts;
}

std::vector<Impact> test_2() {
  return {{.solid = {"aluminium alloy", 70e9, 0.3, 2699}, .radius = 0.1, .ball = {.up = -0.2}, .partner = {}},
          {.solid = {"magnesium alloy", 40e9, 0.35, 1800}, .radius = 0.1, .ball = {.up = -0.2}, .partner = {}}};
}

std::vector<Solid> solids_of_test_3() { return {{"aluminium oxide", 380e9, 0.23, 4000}, {"cast iron", 100e9, 0.25, 7000}}; }

Impact test_3(const Solid& solid, double restitution) {
  return {.solid = solid, .radius = 2.5e-3, .ball = {.up = -3.9}, .restitution = restitution, .partner = {}};
}

Impact test_4(double degrees) {
  const double angle = degrees * pi / 180;
  return {.solid = {"aluminium oxide", 380e9, 0.23, 4000},
          .radius = 2.5e-3,
          .ball = {.up = -3.9 * std::cos(angle), .along = 3.9 * std::sin(angle)},
          .friction = 0.092,
          .restitution = 0.98,
          .partner = {}};
}

std::vector<Solid> solids_of_test_5() { return {{"steel", 208e9, 0.3, 7850}, {"polyethylene", 1e9, 0.4, 1400}}; }

Impact test_5(const Solid& solid, double along) {
  return {.solid = solid, .radius = 1e-5, .ball = {.up = -5, .along = along}, .friction = 0.3, .partner = {}};
}

std::vector<Solid> solids_of_test_6() { return {al_alloy, {"nylon", 2.5e9, 0.4, 1000}}; }

Impact test_6(const Solid& solid, double spin) {
  return {.solid = solid, .radius = 0.1, .ball = {.up = -0.2, .spin = spin}, .friction = 0.4, .restitution = 0.5, .partner = {}};
}

std::vector<Solid> solids_of_test_7() { return {al_alloy, {"copper", 120e9, 0.35, 8900}}; }

Impact test_7(const Solid& solid, double spin) {
  return {.solid = solid,
          .radius = 0.1,
          .ball = {.up = -0.2, .spin = spin},
          .friction = 0.4,
          .restitution = 0.5,
          .partner = Impact::Partner{solid, 0.1, {.up = 0.2, .spin = -spin}}};
}

Impact test_8(double spin, bool is_stiff) {
  Solid heavy = al_alloy;
  heavy.density *= 1000;
  if (is_stiff) heavy.youngs *= 1000;
  return {.solid = al_alloy,
          .radius = 0.1,
          .ball = {.up = -0.2, .spin = spin},
          .friction = 0.4,
          .restitution = 0.5,
          .partner = Impact::Partner{heavy, 0.5, {}}};
}

}  // namespace puadem::verification
