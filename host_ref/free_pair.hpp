#pragma once
// One impact of two free masses by the kernel, at 64 phases of the instant of impact within the step: the range of its
// restitution, which is to be the law's own, and with it the energy that the contact creates.

#include <functional>

#include "host_ref/closed_form.hpp"
#include "host_ref/simulation.hpp"

namespace impact::host {

constexpr int phases_of_impact = 64;

struct FreePair {
  Law law = Law::hunt_crossley;
  double contact_stiffness = 32600.0;  // k1, N/m (Hooke-Newton) or N/m^(3/2)
  double restitution = 0.68;           // of the law, exactly, or stated to `damping`; of no effect under Hertz
  double speed = 0.8;                  // m/s: the ball's, towards the right stop of a main mass at rest
  double main_mass = 1, ball_mass = 0.3;
  double clearance = 0.02;  // m
  double step = 1e-4;       // h, s
  Stops stops = Stops::right;
  Damping damping = Damping::constant;
};

// Rebound speed over approach speed, which is taken as `blown_up` where it is more or no number at all; negative where
// the ball goes on into the stop.
constexpr double blown_up = 1e9;

struct Rebounds {
  double least = blown_up, largest = -blown_up;
  double phase_of_largest = 0;
  bool has_fault = false, is_apart = true;  // in any run; in the end of every run

  // Over the energy of relative motion before.
  double energy_gain() const {
    const double size = largest > -least ? largest : -least;
    return size * size - 1;
  }
};

Impact impact_of(const FreePair& free);

// Reaches the stop 1 + phase steps after the start. The bounds hold the motion at any phase, until it is apart again.
Request request_for(const FreePair& free, Stepper stepper, Numeric numeric, double phase);

// Over all phases; none where `make` refuses the request.
using MakeSimulation = std::function<std::unique_ptr<Simulation>(const Request&)>;
std::optional<Rebounds> rebounds(const FreePair& free, Stepper stepper, Numeric numeric, const MakeSimulation& make);
// The same of a request of one's own, which reaches the right stop one step after the start, over so many steps.
std::optional<Rebounds> rebounds(Request request, long steps, const MakeSimulation& make);

// The yardstick: the classical Runge-Kutta method in double (textbook_newmark.hpp), whatever stepper and format a
// request names. It has no plan and refuses nothing.
std::unique_ptr<Simulation> runge_kutta(const Request& request);

}  // namespace impact::host
