#pragma once

#include <optional>
#include <string>
#include <vector>

#include "puadem/dem/contact_law.hpp"

namespace puadem::verification {

// The eight impact tests of Chung and Ooi 2011 (Granular Matter 13, 643, doi 10.1007/s10035-011-0277-0):
// what is asked, the answer of the grain engine, and answers that share no code with it.

/// Constants of a solid.
struct Solid {
  std::string name;
  double youngs = 0.0;   ///< [Pa]
  double poisson = 0.0;  ///< [-]
  double density = 0.0;  ///< [kg/m3]
};

/// A sphere in motion: z upwards from the plane or the partner, x along the surface, spin about y.
struct Ball {
  double up = 0.0;     ///< [m/s]
  double along = 0.0;  ///< [m/s]
  double spin = 0.0;   ///< [rad/s]
};

/// A sphere comes down on a plane that does not yield, or on another sphere below it.
struct Impact {
  struct Partner {
    Solid solid;
    double radius = 0.0;  ///< [m]
    Ball ball;
  };
  Solid solid;
  double radius = 0.0;  ///< [m]
  Ball ball;
  double friction = 0.0;     ///< [-]
  double restitution = 1.0;  ///< [-]
  std::optional<Partner> partner;
};

/// What comes of an impact.
struct Rebound {
  struct Moment {
    double time, overlap, force;  ///< [s], [m], normal force [N]
  };
  double deepest = 0.0;   ///< overlap [m]
  double largest = 0.0;   ///< normal force [N]
  double duration = 0.0;  ///< of the contact [s]
  Ball ball, partner;
  std::vector<Moment> course;
};

double mass_of(const Solid& solid, double radius);
double approach_speed(const Impact& impact);
/// Velocity of the lowest point of the sphere over what it touches, along x [m/s].
double slip_speed(const Impact& impact, const Ball& ball, const Ball& partner);

/// By the grain engine, `steps` to the contact time of the elastic impact.
/// @param phase  steps from the start to the touch [-]
Rebound collide(const Impact& impact, int steps, ContactOptions::Law law = ContactOptions::Law::hertz_mindlin,
                double phase = 0.0);

/// Errors of the restitution coefficient over many phases of the touch within a step.
struct RestitutionError {
  double median = 0.0, worst = 0.0;
};
RestitutionError restitution_error(const Impact& impact, int steps, ContactOptions::Law law);

/// Deepest overlap, largest force and duration of the elastic impact in closed form (Timoshenko and Goodier
/// 1970, section 140).
Rebound hertz_impact(const Impact& impact);

/// The equations of Hertz and Mindlin (theory 2.6, 2.8) for overlap and slip at a normal that does not turn,
/// by the midpoint rule in `steps` to the elastic contact time.
Rebound integrate(const Impact& impact, int steps = 20000);

/// Velocities after an impact that slides throughout: the tangential impulse is mu times the normal one.
Rebound slide_throughout(const Impact& impact);

/// The impacts of the tests, as transcribed in the example scripts of Yade (tests 1 to 4), PySPH and Kratos
/// Multiphysics (tests 5 to 8). Test 8: `is_stiff` is its case A, a partner a thousand times stiffer.
std::vector<Impact> test_1();
std::vector<Impact> test_2();
std::vector<Solid> solids_of_test_3();
Impact test_3(const Solid& solid, double restitution);
Impact test_4(double degrees);
std::vector<Solid> solids_of_test_5();
Impact test_5(const Solid& solid, double along);
std::vector<Solid> solids_of_test_6();
Impact test_6(const Solid& solid, double spin);
std::vector<Solid> solids_of_test_7();
Impact test_7(const Solid& solid, double spin);
Impact test_8(double spin, bool is_stiff);

}  // namespace puadem::verification
