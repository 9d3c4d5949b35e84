// Any scene, bounds and step, under every law, in one number format (IMPACT_NUMERIC). An accepted plan is stepped with
// any drive, from saved states of any bytes, through changes of plan. States stay finite and in range, the first fault
// stays, and no sanitizer reports anything. From an absorber's own state nothing wraps in Fixed32, except in a step
// that raises a fault.

#include <cstdio>
#include <cstdlib>
#include <impact/absorber.hpp>

#include "bytes.hpp"

void impact::host::note_broken(const char* condition) {
  if (broken.count++ == 0) broken.condition = condition;
}

namespace impact::fuzz {
namespace {

using Numeric = IMPACT_NUMERIC;

void expect(bool condition, const char* what) {
  if (condition) return;
  std::fprintf(stderr, "kernel_fuzz: not so: %s\n", what);
  std::abort();
}

// The last number decides most about a scene, so that a change of one byte changes one property.
template <class Kernel> Scene scene_from(Bytes& bytes) {
  Scene scene;
  const uint16_t changed = bytes.bits<uint16_t>();
  int bit = 0;
#define IMPACT_DRAW(name, least, most, ...) \
  if (changed >> bit++ & 1) scene.name = bytes.number({least, most});
  IMPACT_MACHINE_VALUES(IMPACT_DRAW)
#undef IMPACT_DRAW
  if (changed >> 13 & 1) scene.restitution = bytes.number(restitution_range);
  if (Kernel::Field::is_field && changed >> 14 & 1) scene.gravity = bytes.number(gravity_range);
  if (Kernel::Friction::is_friction && changed >> 15 & 1) scene.ball_friction = bytes.number(ball_friction_range);
  const uint8_t kinds = bytes.byte();
  scene.stops = static_cast<Stops>(kinds % 3);
  scene.tension = kinds & 128 ? Tension::allow : Tension::clamp;
  return scene;
}

template <class Kernel> Bounds bounds_from(Bytes& bytes) {
  Bounds bounds;
  const uint8_t changed = bytes.byte();
  if (changed & 1) bounds.displacement = bytes.number(bound_range);
  if (changed & 2) bounds.speed = bytes.number(bound_range);
  if (changed & 4) bounds.penetration = bytes.number(bound_range);
  if (changed & 8) bounds.force = bytes.number(force_bound_range);
  if constexpr (Kernel::Field::is_sampled)
    bounds.base_acceleration = changed & 16 ? bytes.number(base_acceleration_bound_range) : 10;
  return bounds;
}

// True if no step changes a rate by more than both masses' bounds. Otherwise single terms of a rate may wrap modulo
// 2^32, like their sum.
bool is_within_steps(const Scene& scene, const Bounds& bounds, double h) {
  const double drive = std::fmax(scene.drive_amplitude, bounds.force),
               field = std::fabs(scene.gravity) + bounds.base_acceleration + scene.ball_friction / scene.ball_mass;
  return h * (largest_acceleration(scene, bounds, drive) + field) <= 2 * bounds.speed;
}

template <class Absorber> void check(const Absorber& absorber) {
  const auto now = absorber.reading();
  expect(std::isfinite(now.x1) && std::isfinite(now.v1) && std::isfinite(now.x2) && std::isfinite(now.v2),
         "the state is finite");
  typename Numeric::Value read[] = {absorber.velocity(), absorber.ball_velocity(), absorber.displacement()};
  asm volatile("" : : "r"(read) : "memory");  // the sanitizers check these computations
  if (absorber.fault() == Fault::none) {
    const auto& units = absorber.plan.units;
    auto state = absorber.state();
    // The next step checks what friction has done by the end of this one.
    if constexpr (Absorber::Friction::is_friction) state.dx1 = state.dx2 = {};
    expect(units.is_within(state.x1, units.limits.main) && units.is_within(state.x2, units.limits.ball) &&
               units.is_within(state.dx1, units.limits.displacement) &&
               units.is_within(state.dx2, units.limits.displacement),
           "the state is in range");
  }
}

// Checks the steps since the last call.
template <class Absorber> void check_wraps(const Absorber& absorber) {
  if (absorber.fault() == Fault::none) expect(host::broken.count == 0, host::broken.condition);
  host::broken.count = 0;
}

using Value = typename Numeric::Value;

template <class Absorber> void step(Absorber& absorber, Value force, Value base) {
  if constexpr (Absorber::Drive::is_sampled && Absorber::Field::is_sampled)
    absorber.step(force, base);
  else if constexpr (Absorber::Drive::is_sampled)
    absorber.step(force);
  else if constexpr (Absorber::Field::is_sampled)
    absorber.step(base);
  else
    absorber.step();
}

template <class Absorber> void run(Absorber& absorber, Bytes& bytes, int steps, bool is_own) {
  Fault first = absorber.fault();
  Value sample{}, base{};
  for (int n = 0; n < steps; ++n) {
    if (!bytes.is_empty()) {
      const uint8_t kind = bytes.byte();
      Value& drawn = Absorber::Field::is_sampled && kind % 2 == 1 ? base : sample;
      if (kind < 64)
        drawn = bytes.bits<Value>();
      else
        drawn = Numeric::sample(kind - 160);
      if (kind >= 64 && kind < 80) absorber.correct(bytes.bits<Value>(), bytes.bits<Value>());
    }
    step(absorber, sample, base);
    if (is_own) check_wraps(absorber);
    check(absorber);
    if (first != Fault::none) expect(absorber.fault() == first, "the first fault sticks");
    first = absorber.fault();
  }
}

template <class Law, class Stepper, class Drive, class... Features> void kernel(Bytes& bytes) {
  using Kernel = Absorber<AtRunTime, Law, Stepper, Drive, Numeric, Features...>;
  using Plan = typename Kernel::PlanType;
  Scene scene = scene_from<Kernel>(bytes);
  const Bounds bounds = bounds_from<Kernel>(bytes);
  if (scene.clearance > largest_clearance(bounds)) scene.stops = Stops::none;
  const double h = bytes.number({1e-7, 0.1});
  host::broken.count = 0;
  const Plan plan = Plan::make(scene, bounds, h);
  if (plan.status != PlanStatus::ok) return;
  Kernel absorber(plan);
  check_wraps(absorber);
  check(absorber);
  const uint8_t what = bytes.byte();
  bool is_own = is_within_steps(scene, bounds, h);
  if (what & 1) {
    typename Kernel::Saved saved = absorber.save();
    saved.state = bytes.bits<typename Kernel::State>();
    is_own = !absorber.restore(saved) && is_own;
    host::broken.count = 0;  // a rejected state from outside may wrap
    check(absorber);
  }
  if (what & 2) {
    Scene other = scene_from<Kernel>(bytes);
    other.clearance = scene.clearance;
    other.stops = scene.stops;
    const Plan next = Plan::make(other, bounds, h);
    is_own = is_own && is_within_steps(other, bounds, h);
    for (int n = 0; n < 20; ++n) {
      step(absorber, {}, {});
      absorber.retune(n % 2 == 0 ? next : plan);
      if (is_own) check_wraps(absorber);
      check(absorber);
    }
  }
  run(absorber, bytes, 1000, is_own);
  absorber.clear_fault();
  run(absorber, bytes, 20, false);
  absorber.reset();
  expect(absorber.fault() == Fault::none, "a reset clears the fault");
  check(absorber);
}

using Run = void (*)(Bytes&);
template <class Law>
constexpr Run without_parts[] = {kernel<Law, Moment, Sampled>,
                                 kernel<Law, Moment, Sine, EnergyLedger, ImpactLog, ContactForce, Snapshots>,
                                 kernel<Law, EnergyConsistent, Sine>, kernel<Law, AverageAcceleration, Sampled>};
// Weight, a base that shakes, friction.
template <class Law>
constexpr Run with_parts[] = {
    kernel<Law, Moment, Sampled, BaseAcceleration, DryFriction>,
    kernel<Law, Moment, Sine, Gravity, DryFriction, EnergyLedger, ImpactLog, ContactForce, Snapshots>,
    kernel<Law, EnergyConsistent, Sine, BaseAcceleration, DryFriction>,
    kernel<Law, Impulsive, NoDrive, BaseAcceleration, DryFriction, EnergyLedger>,
    kernel<Law, AverageAcceleration, Sine, Gravity, DryFriction>};

template <class Law> void with_law(Bytes& bytes) {
  const uint8_t kind = bytes.byte();
  // The highest kinds, so that the kept inputs mean what they did.
  if (kind >= 240) return kernel<Law, SubsteppedMoment<8>, Sampled, Gravity, DryFriction>(bytes);
  (kind >= 128 ? with_parts<Law>[kind % 5] : without_parts<Law>[kind % 4])(bytes);
}
constexpr Run with_laws[] = {with_law<HookeNewton>, with_law<Hertz>, with_law<HuntCrossley>, with_law<Flores>};

}  // namespace
}  // namespace impact::fuzz

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  impact::fuzz::Bytes bytes(data, size);
  impact::fuzz::with_laws[bytes.below(4)](bytes);
  return 0;
}
