#pragma once
// The kernel with an interface at run time. The tool, the tests and the report choose law, stepper and number format
// from lists. The kernel is the same template that a firmware image compiles. Its plan is made at run time.

#include <cmath>
#include <cstdlib>
#include <impact/scene.hpp>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host_ref/closed_form.hpp"
#include "host_ref/extremes.hpp"
#include "host_ref/paper_scene.hpp"

namespace impact::host {

// The laws, the steppers and the formats, each in one list: enumerator, the tool's name, the kernel's type. The
// classical steppers, with pointwise contact, come first.
#define IMPACT_LAWS(X)                         \
  X(hooke_newton, "hooke-newton", HookeNewton) \
  X(hertz, "hertz", Hertz)                     \
  X(hunt_crossley, "hunt-crossley", HuntCrossley)
#define IMPACT_STEPPERS(X)                     \
  X(average, "average", AverageAcceleration)   \
  X(linear, "linear", LinearAcceleration)      \
  X(fox_goodwin, "fox-goodwin", FoxGoodwin)    \
  X(central, "central", CentralDifference)     \
  X(moment, "moment", Moment)                  \
  X(moment_4, "moment-4", SubsteppedMoment<4>) \
  X(moment_8, "moment-8", SubsteppedMoment<8>) \
  X(moment_n, "moment-n", SubsteppedMoment<>)  \
  X(energy, "energy", EnergyConsistent)        \
  X(impulsive, "impulsive", Impulsive)
#define IMPACT_FORMATS(X)                         \
  X(float32, "float32", Float32)                  \
  X(float32_plain, "float32-plain", Float32Plain) \
  X(fixed32, "fixed32", Fixed32)                  \
  X(float64, "float64", Float64)
#define IMPACT_ENUMERATOR(value, name, Type) value,

enum class Stepper { IMPACT_STEPPERS(IMPACT_ENUMERATOR) automatic };
constexpr bool is_classical(Stepper stepper) { return stepper <= Stepper::central; }
enum class Numeric { IMPACT_FORMATS(IMPACT_ENUMERATOR) };
enum class DriveKind { none, sine, sampled };

inline constexpr double open_bound = std::numeric_limits<double>::quiet_NaN();
inline constexpr Bounds open_bounds{open_bound, open_bound, open_bound, open_bound, open_bound};

struct Request {
  Law law = Law::hunt_crossley;
  Stepper stepper = Stepper::automatic;
  Numeric numeric = Numeric::float64;
  DriveKind drive = DriveKind::sine;
  Damping damping = Damping::constant;  // of Hunt-Crossley; all others follow from Scene::restitution
  Scene scene = paper_scene(Law::hunt_crossley);
  bool damping_is_by_restitution = false;  // Scene::contact_damping is found from --restitution
  double step = 1e-4;                      // h, s
  std::optional<Bounds> bounds{};          // an absent or NaN bound is open: make_simulation finds it
  double duration = 1.0;                   // s, of the whole run
  std::vector<double> samples{};           // drive samples, N, one a step
  bool is_shaken = false;                  // the base accelerates:
  std::vector<double> base_samples{};      // m/s^2, one a step
  bool counts_drive_work = true;           // for Sample::drive_work
};
bool has_open_bounds(const Request& request);  // true if a run must find a bound
long step_count(const Request& request);       // duration / step to the nearest whole number

// True if the request has gravity, friction or a base that accelerates. Moment, its sub-steps, EnergyConsistent and
// Impulsive support these parts. The other steppers reject them, and the refusal names the part.
bool has_parts(const Request& request);

// One row of output, SI units.
struct Sample {
  double t = 0, x1 = 0, v1 = 0, x2 = 0, v2 = 0;
  double penetration = 0;          // negative while apart, m
  double contact_force = 0;        // N, >= 0 if tension is clamped
  double energy_dissipated = 0;    // by contact since the start, J
  double energy_stored = 0;        // by contact now, J
  double drive_work = 0;           // by the drive since the start, J, if it is counted
  double friction_dissipated = 0;  // by dry friction since the start, J
  long impacts = 0;                // the number of contacts that began since the start
  double impact_speed = 0;         // rate of penetration at which the last one began, m/s
  double peak_force = 0;           // largest contact force since the start, N
};

// The largest magnitudes of either mass, m and m/s, of the penetration and of the speed at which a contact began.
struct Reached {
  double displacement = 0, speed = 0, penetration = 0, impact_speed = 0;

  void see(double x1, double v1, double x2, double v2, double depth, double impact = 0) {
    impact_speed = larger(impact_speed, impact);
    displacement = larger(displacement, larger(std::abs(x1), std::abs(x2)));
    speed = larger(speed, larger(std::abs(v1), std::abs(v2)));
    penetration = larger(penetration, depth);
  }
  // True if all values are within the bounds. A penetration bound of 0 does not count. False if any value is a NaN.
  bool is_within(const Bounds& bounds) const {
    return displacement <= bounds.displacement && speed <= bounds.speed &&
           (bounds.penetration == 0 || penetration <= bounds.penetration);
  }
};

// The samples of the `count` steps after step n, or nullptr if the run has none.
inline const double* samples_after(long n, long count, const std::vector<double>& samples) {
  if (samples.empty()) return nullptr;
  if (samples.size() < static_cast<size_t>(n + count)) std::abort();  // never a step without a sample
  return samples.data() + n;
}
inline double sample_at(long n, const std::vector<double>& samples) {
  return samples.empty() ? 0 : samples.at(static_cast<size_t>(n));
}

inline constexpr std::string_view displacement_fault = "a displacement beyond its bound",
                                  speed_fault = "a speed beyond its bound",
                                  penetration_fault = "a penetration beyond its bound";

class Simulation {
 public:
  virtual ~Simulation() = default;
  // Advances by h; `force` and `base` (its acceleration) are the samples at the end of the step.
  virtual void step(double force, double base = 0) = 0;
  virtual Sample sample() const = 0;  // now, as a user reads it
  // The same with the motion that a step changes (energies.hpp).
  virtual Sample state() const { return sample(); }
  virtual const char* fault() const = 0;  // nullptr, or the reason why the state is no longer valid

  // The kernel only. run(steps, forces, x1, base) makes several steps and stores x1 at the end of each. `forces` and
  // `base` may be null. Stops after a step that raises a fault. Returns the number of steps without a fault.
  virtual long run(long, const double*, double*, const double* = nullptr) { std::abort(); }
  // The kernel only. reached_in(steps, forces, base, bounds) has the largest values now and at the steps' ends. Stops
  // after a step that raises a fault or passes a bound.
  virtual Reached reached_in(long, const double*, const double*, const Bounds&) { std::abort(); }
};

// The reason why the kernel cannot plan a request: the tool's option at fault, such as "contact-stiffness", its value,
// and what is allowed.
struct Refusal {
  std::string field, value, allowed;
};

// Either a simulation or the reason why there is none.
struct Outcome {
  std::unique_ptr<Simulation> simulation;
  Refusal refusal;
  Request made;             // the request with the stepper and the bounds of the plan
  std::string description;  // the choice of the rule, or a warning; at most one line
};

// Makes a plan and a simulation. An open bound becomes 1.5 times the largest value of a float64 run of `duration`. That
// run must stay within the bounds of its own plan.
Outcome make_simulation(const Request& request);
// The same simulation, or null if the request is refused. The reason is not sought, for which many plans are made.
std::unique_ptr<Simulation> simulation_of(const Request& request);

// The request for another attempt with twice the bounds, if the run has passed a bound that was found, else nothing. A
// motion over many impacts is chaotic, so formats may reach different values.
std::optional<Request> widened(const Request& asked, const Outcome& outcome);

// The restitution of the law for an impact of two free masses at this speed.
double restitution_at(const Request& made, double speed);

// The refusals that are possible without a run. The field is empty if the request may be accepted.
Refusal refusal_before_a_run(const Request& request);

// The step that the tool chooses, from 0.01 ms to 5 ms. It is the longest of 1, 2 and 5 times a power of ten for which
// the rule takes Moment, if no sub-steps are allowed, and the restitution is within automatic_error of the law's. There
// are at least 100 steps in `duration`, 30 in a period of drive and main mass, and four in a flight across the
// clearance. If no step has all this, it is 0.1 ms.
constexpr double automatic_error = 1e-5;
double automatic_step(const Request& request);

std::string_view name_of(Law law);
std::string_view name_of(Damping damping);
std::string_view name_of(Stepper stepper);
std::string_view name_of(Numeric numeric);

}  // namespace impact::host
