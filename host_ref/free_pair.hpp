#pragma once
// One impact of two free masses by the kernel, with the touch at 64 instants within a step. The result is the range of
// its restitution, which should be that of the law, and the energy that the contact creates.

#include <functional>

#include "host_ref/closed_form.hpp"
#include "host_ref/simulation.hpp"

namespace impact::host {

constexpr int phases_of_impact = 64;

struct FreePair {
  Law law = Law::hunt_crossley;
  double contact_stiffness = 32600.0;  // k1, N/m (Hooke-Newton) or N/m^(3/2)
  double restitution = 0.68;           // exact for the law, or the parameter of `damping`; Hertz ignores it
  double speed = 0.8;                  // m/s, of the ball towards the right stop; the main mass is at rest
  double main_mass = 1, ball_mass = 0.3;
  double clearance = 0.02;  // m
  double step = 1e-4;       // h, s
  Stops stops = Stops::right;
  Damping damping = Damping::constant;
};

// Rebound speed over approach speed. A larger value and a NaN become `blown_up`. It is negative if the ball goes on
// into the stop.
constexpr double blown_up = 1e9;

struct Rebounds {
  double least = blown_up, largest = -blown_up;
  double phase_of_largest = 0;
  bool has_fault = false, is_apart = true;  // a fault in any run; no contact at the end of every run

  // Relative to the energy of the relative motion before the impact.
  double energy_gain() const {
    const double size = largest > -least ? largest : -least;
    return size * size - 1;
  }
};

Impact impact_of(const FreePair& free);

// The ball reaches the stop 1 + phase steps after the start. The motion stays within the bounds at any phase.
Request request_for(const FreePair& free, Stepper stepper, Numeric numeric, double phase);

// The result over all phases, or none if `make` refuses the request.
using MakeSimulation = std::function<std::unique_ptr<Simulation>(const Request&)>;
std::optional<Rebounds> rebounds(const FreePair& free, Stepper stepper, Numeric numeric, const MakeSimulation& make);
// The same for a given request, whose ball reaches the right stop one step after the start, over `steps` steps.
std::optional<Rebounds> rebounds(Request request, long steps, const MakeSimulation& make);

// The same by the classical Runge-Kutta method in double (textbook_newmark.hpp), for comparison. It ignores the
// request's stepper and format. It has no plan and refuses nothing.
std::unique_ptr<Simulation> runge_kutta(const Request& request);

}  // namespace impact::host
