#pragma once
// The kernel behind one run-time interface: the tool, the tests and the report choose law, stepper and number format by
// name; what steps is the same template that a firmware image compiles, with its plan made at run time.

#include <cmath>
#include <impact/scene.hpp>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host_ref/closed_form.hpp"
#include "host_ref/extremes.hpp"
#include "host_ref/paper_scene.hpp"

namespace impact::host {

enum class Stepper { average, linear, fox_goodwin, central, moment, moment_4, moment_8, energy, impulsive, automatic };
enum class Numeric { float32, float32_plain, fixed32, float64 };
enum class DriveKind { none, sine, sampled };

struct Request {
  Law law = Law::hunt_crossley;
  Stepper stepper = Stepper::automatic;
  Numeric numeric = Numeric::float64;
  DriveKind drive = DriveKind::sine;
  Damping damping = Damping::constant;  // of Hunt-Crossley; all but constant by Scene::restitution
  Scene scene = paper_scene(Law::hunt_crossley);
  bool damping_is_by_restitution = false;  // Scene::contact_damping is what --restitution asks for
  double step = 1e-4;                      // h, s
  std::optional<Bounds> bounds{};          // when absent, they are looked for: see below
  bool measures_bounds = false;            // looked for by a run, in every format
  double duration = 1.0;                   // s, used only to find bounds
  std::vector<double> samples{};           // drive samples, N, used only to find bounds
  bool is_shaken = false;                  // the base accelerates:
  std::vector<double> base_samples{};      // m/s^2, used only to find bounds
  bool counts_drive_work = true;           // for Sample::drive_work
};
long step_count(const Request& request);  // duration / step to the nearest whole number

// Gravity, friction or a base that accelerates: with Moment, its sub-steps, EnergyConsistent and Impulsive. The others
// refuse it by name.
inline bool has_parts(const Request& request) {
  const Scene& scene = request.scene;
  return scene.gravity < 0 || scene.gravity > 0 || scene.ball_friction > 0 || request.is_shaken;
}

// One row of output, SI units.
struct Sample {
  double t = 0, x1 = 0, v1 = 0, x2 = 0, v2 = 0;
  double penetration = 0;          // negative while apart, m
  double contact_force = 0;        // >= 0 when tension is clamped, N
  double energy_dissipated = 0;    // by contact since the start, J
  double energy_stored = 0;        // by contact now, J
  double drive_work = 0;           // by the drive since the start, J, where it is counted
  double friction_dissipated = 0;  // by dry friction since the start, J
  long impacts = 0;                // contacts begun since the start
  double impact_speed = 0;         // rate of penetration at which the last one began, m/s
  double peak_force = 0;           // largest contact force since the start, N
};

// The largest magnitudes of either mass, m and m/s, and of the penetration.
struct Reached {
  double displacement = 0, speed = 0, penetration = 0;

  void see(double x1, double v1, double x2, double v2, double depth) {
    displacement = larger(displacement, larger(std::abs(x1), std::abs(x2)));
    speed = larger(speed, larger(std::abs(v1), std::abs(v2)));
    penetration = larger(penetration, depth);
  }
};

// The samples of the next steps, where n have been made; nullptr where there are none. One of them, or 0.
inline const double* samples_after(long n, const std::vector<double>& samples) {
  return samples.empty() ? nullptr : samples.data() + n;
}
inline double sample_at(long n, const std::vector<double>& samples) {
  return samples.empty() ? 0 : samples[static_cast<size_t>(n)];
}

class Simulation {
 public:
  virtual ~Simulation() = default;
  // Advances by h; `force` and `base` (its acceleration) are the samples at the end of the step.
  virtual void step(double force, double base = 0) = 0;
  virtual Sample sample() const = 0;      // the state now
  virtual const char* fault() const = 0;  // nullptr, or why the state is no longer to be trusted

  // As many steps at once, with x1 at the end of each; `forces` and `base` may be null. Stops behind a step that raises
  // a fault, and returns how many raised none.
  virtual long run(long steps, const double* forces, double* x1, const double* base = nullptr);
  // As many steps, whatever faults they raise: what the state reaches now and at the end of each.
  virtual Reached reached_in(long steps, const double* forces, const double* base);
};

// A request that the kernel cannot plan, with the field at fault ("contact-stiffness", as the tool's option), its value
// and what is allowed.
struct Refusal {
  std::string field, value, allowed;
};

// Either a simulation or the reason why there is none.
struct Outcome {
  std::unique_ptr<Simulation> simulation;
  Refusal refusal;
  Request made;             // as it was planned: its stepper and bounds are those of the plan
  std::string description;  // what the plan's rule chose, or what to beware of; one line or nothing
};

// Bounds that are absent are those that the drive and the start can reach by an estimate, which is far too much near
// resonance: where they decide something (a stepper other than Moment, a plan that is refused, or fixed32's formats),
// and where it is asked, they are half as much again as what a float64 run of `duration` reaches.
Outcome make_simulation(const Request& request);

// The law's own, at an impact of this speed of two free masses.
double restitution_at(const Request& request, double speed);

// What of that can be told without a run: its field is empty where nothing speaks against the request.
Refusal refusal_before_a_run(const Request& request);

// The longest of 1, 2 and 5 times a power of ten at which the plan's rule takes Moment with a restitution within
// automatic_error of the law's, and the motion is shown: a hundred steps in `duration`, thirty in a period of drive and
// main mass, four in a flight across the clearance. From 0.01 ms to 5 ms; 0.1 ms where none does.
constexpr double automatic_error = 1e-5;
double automatic_step(const Request& request);

std::optional<Law> law_named(std::string_view name);          // hooke-newton, hertz, hunt-crossley
std::optional<Stepper> stepper_named(std::string_view name);  // auto, average, linear, fox-goodwin, central, moment,
                                                              // moment-4, moment-8, energy, impulsive
std::optional<Numeric> numeric_named(std::string_view name);  // float32, float32-plain, fixed32, float64
std::string_view name_of(Law law);
std::string_view name_of(Damping damping);
std::string_view name_of(Stepper stepper);
std::string_view name_of(Numeric numeric);

}  // namespace impact::host
