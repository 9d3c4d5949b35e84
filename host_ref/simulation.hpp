#pragma once
// The kernel behind one run-time interface: the tool, the tests and the report choose law, stepper and number format by
// name; what steps is the same template that a firmware image compiles, with its plan made at run time.

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

// The steppers and the formats, each in one list: enumerator, the tool's name, the kernel's type. The classical
// steppers, with pointwise contact, come first.
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
  Damping damping = Damping::constant;  // of Hunt-Crossley; all but constant by Scene::restitution
  Scene scene = paper_scene(Law::hunt_crossley);
  bool damping_is_by_restitution = false;  // Scene::contact_damping is found from --restitution
  double step = 1e-4;                      // h, s
  std::optional<Bounds> bounds{};          // what is absent or no number is looked for: see make_simulation
  double duration = 1.0;                   // s, used only to find bounds
  std::vector<double> samples{};           // drive samples, N, used only to find bounds
  bool is_shaken = false;                  // the base accelerates:
  std::vector<double> base_samples{};      // m/s^2, used only to find bounds
  bool counts_drive_work = true;           // for Sample::drive_work
};
bool has_open_bounds(const Request& request);  // that a run is to find
long step_count(const Request& request);       // duration / step to the nearest whole number

// Gravity, friction or a base that accelerates: with Moment, its sub-steps, EnergyConsistent and Impulsive. The others
// reject it with the name.
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

// The largest magnitudes of either mass, m and m/s, of the penetration and of the speed at which a contact began.
struct Reached {
  double displacement = 0, speed = 0, penetration = 0, impact_speed = 0;

  void see(double x1, double v1, double x2, double v2, double depth, double impact = 0) {
    impact_speed = larger(impact_speed, impact);
    displacement = larger(displacement, larger(std::abs(x1), std::abs(x2)));
    speed = larger(speed, larger(std::abs(v1), std::abs(v2)));
    penetration = larger(penetration, depth);
  }
  // A penetration's bound of 0 is none. False for what is no number.
  bool is_within(const Bounds& bounds) const {
    return displacement <= bounds.displacement && speed <= bounds.speed &&
           (bounds.penetration == 0 || penetration <= bounds.penetration);
  }
};

// The samples of the next `count` steps, where n have been made; nullptr where there are none. One of them, or 0.
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
  virtual Sample sample() const = 0;      // the state now
  virtual const char* fault() const = 0;  // nullptr, or why the state is no longer to be trusted

  // As many steps at once, with x1 at the end of each; `forces` and `base` may be null. Stops behind a step that raises
  // a fault, and returns how many raised none.
  virtual long run(long steps, const double* forces, double* x1, const double* base = nullptr);
  // What the state reaches now and at the end of as many steps, or up to the first that raises a fault or passes a
  // bound.
  virtual Reached reached_in(long steps, const double* forces, const double* base, const Bounds& bounds);
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

// Bounds that are open are half as much again as what a float64 run of `duration` reaches, one that stays within what
// its own plan was judged for.
Outcome make_simulation(const Request& request);

// For another attempt, with bounds twice as wide, where the run has passed one that was found: a motion over many
// impacts is chaotic, and differs from format to format. Nothing where no such bound was passed.
std::optional<Request> widened(const Request& asked, const Outcome& outcome);

// The law's own, at an impact of this speed of two free masses.
double restitution_at(const Request& request, double speed);

// What of that can be told without a run: its field is empty where nothing speaks against the request.
Refusal refusal_before_a_run(const Request& request);

// The longest of 1, 2 and 5 times a power of ten at which the plan's rule takes Moment with a restitution within
// automatic_error of the law's, and the motion is shown: a hundred steps in `duration`, thirty in a period of drive and
// main mass, four in a flight across the clearance. From 0.01 ms to 5 ms; 0.1 ms where none does.
constexpr double automatic_error = 1e-5;
double automatic_step(const Request& request);

std::string_view name_of(Law law);
std::string_view name_of(Damping damping);
std::string_view name_of(Stepper stepper);
std::string_view name_of(Numeric numeric);

}  // namespace impact::host
