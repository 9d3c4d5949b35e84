// Tests of EnergyConsistent in one impact of two free masses, at 64 phases of the impact within the step. It has the
// law's restitution even with few steps per contact, and gains no energy.

#include "against_reference.hpp"
#include "host_ref/free_pair.hpp"
#include "kinds.hpp"

namespace impact::host {
namespace {

constexpr double speed = 0.8;  // m/s

// At 64 phases of the impact within the step, the rebounds are e at least `below` and `above` of it.
void expect_rebounds(Law law, Numeric numeric, double e, double steps_per_contact, double below, double above) {
  SCOPED_TRACE(testing::Message() << name_of(numeric) << ", " << e << " at " << steps_per_contact);
  FreePair free;
  free.law = law;
  free.restitution = e;
  free.speed = speed;
  free.clearance = 0.5;  // room for the rebound
  free.step = contact_time(impact_of(free)).value() / steps_per_contact;
  // A power law's contact time falls with k1^(2/5), and its restitution depends only on c1/k1. The stiffness is scaled
  // from that for steps of 1 ms.
  if (law != Law::hooke_newton) {
    free.contact_stiffness *= std::pow(free.step / 1e-3, 2.5);
    free.step = 1e-3;
  }
  const auto found = rebounds(free, Stepper::energy, numeric, simulation_of);
  ASSERT_TRUE(found) << "refused";
  EXPECT_FALSE(found->has_fault);
  EXPECT_TRUE(found->is_apart);
  EXPECT_GT(found->least, e - below);
  EXPECT_LT(found->largest, e + above);
}

// The error that stepper/energy/power.hpp states for a resolved contact.
double resolved_error(double steps) { return steps < 20 ? 0 : 100 / std::pow(steps, 4); }

constexpr double steps_per_contact[] = {0.003, 0.1, 0.7, 1.3, 2.5, 5, 10, 40};

// The step conserves Hunt-Crossley's first integral at any number of steps. The approximation k has an error of at most
// 6e-4 (stepper/energy/stiff.hpp).
TEST(EnergyConsistent, HuntCrossleyReboundsAsTheLawAtAnyStiffness) {
  for (Numeric numeric : every_format)
    for (double e : {0.05, 0.1, 0.2, 0.5, 0.7, 0.95})
      for (double steps : steps_per_contact) expect_rebounds(Law::hunt_crossley, numeric, e, steps, 6e-4, 6e-4);
}

// A resolved contact evaluates the force once, at a predicted end, and adds the first term of the correction's series.
TEST(EnergyConsistent, ResolvedContactIsOfFourthOrder) {
  for (double steps : {30, 60, 120, 240}) {
    for (double e : {0.2, 0.5, 0.7, 0.95}) {
      // At e = 0.2 only the longest contact is resolved.
      const double error = resolved_error(steps) + (e < 0.5 ? 4e-5 * e : 0);
      expect_rebounds(Law::hunt_crossley, Numeric::float64, e, steps, error, error);
    }
    expect_rebounds(Law::hertz, Numeric::float64, 1, steps, resolved_error(steps), 1e-12);
  }
}

// The elastic work equals the change of the stored energy, so only rounding remains. Float32Plain rounds positions to
// 2^-25 of half the clearance, which is 3e-6 of the peak penetration at 10 steps.
TEST(EnergyConsistent, HertzReboundsElasticallyAtAnyStiffness) {
  for (double steps : steps_per_contact) {
    const double resolved = resolved_error(steps);
    expect_rebounds(Law::hertz, Numeric::float64, 1, steps, 1e-12 + resolved, 1e-12);
    expect_rebounds(Law::hertz, Numeric::float32, 1, steps, 5e-5 + resolved, 5e-6);
    expect_rebounds(Law::hertz, Numeric::float32_plain, 1, steps, 5e-5 + resolved, 5e-5);
    expect_rebounds(Law::hertz, Numeric::fixed32, 1, steps, 5e-5 + resolved, 5e-6);
  }
}

// Plans are accepted up to h c1/mu = 2, where the damper alone stops the ball in one step. At 3.8 the error was up to
// 0.33, at some phases.
TEST(EnergyConsistent, HookeNewtonReboundsAsTheLawAtEveryPhase) {
  FreePair free;
  free.law = Law::hooke_newton;
  free.clearance = 0.5;
  const double mu = free.main_mass * free.ball_mass / (free.main_mass + free.ball_mass), pi = 3.141592653589793;
  for (const double steps : {1.5, 2.0, 3.0, 5.0, 10.0, 20.0})
    for (const double damping : {0.1, 0.5, 1.0, 1.5, 1.999, 2.001, 3.8}) {
      free.contact_stiffness = mu * std::pow(pi / (steps * free.step), 2);
      free.restitution =
          restitution({free.law, free.contact_stiffness, damping * mu / free.step, mu, free.speed}).value();
      for (const Numeric numeric : every_format) {
        const auto found = rebounds(free, Stepper::energy, numeric, simulation_of);
        EXPECT_EQ(found.has_value(), damping < 2) << steps << ' ' << damping;
        if (!found) continue;
        const double error = 0.6 / (steps * steps) + 1e-4;
        EXPECT_GT(found->least, free.restitution - error) << name_of(numeric) << ' ' << steps << ' ' << damping;
        EXPECT_LT(found->largest, free.restitution + error) << name_of(numeric) << ' ' << steps << ' ' << damping;
      }
    }
}

// The damping is so strong (k1/c1 = 0.05 m/s) that a braking main mass retreats from the ball inside the stop, without
// a force. The stop returns before the ball is out. There are 25 impacts in 3 s, of some hundred steps each.
TEST(EnergyConsistent, DissipatesInAStronglyDampedStopWhatTheReferenceDoes) {
  Request request;
  request.stepper = Stepper::energy;
  request.bounds = Bounds{0.2, 4, 0, 10};
  Scene& scene = request.scene;
  scene.contact_stiffness = 2e5;
  scene.contact_damping = 4e6;
  scene.main_damping = 0.5;
  scene.drive_pulsation = 25;
  const Sample exact = reference_at({Law::hunt_crossley, scene}, 3);
  for (const Numeric numeric : {Numeric::float64, Numeric::fixed32})
    for (const double step : {1e-3, 5e-4, 1e-4}) {
      request.numeric = numeric;
      request.step = step;
      const auto simulation = simulation_of(request);
      ASSERT_NE(simulation, nullptr);
      for (long i = std::lround(3 / step); i > 0; --i) simulation->step(0);
      EXPECT_EQ(simulation->fault(), nullptr);
      const Sample now = simulation->sample();
      EXPECT_LE(std::abs(now.impacts - exact.impacts), 2);  // a ball that grazes its stop may touch it a second time
      EXPECT_NEAR(now.energy_dissipated, exact.energy_dissipated, 0.01 * exact.energy_dissipated) << step;
    }
}

// A contact may begin at any depth in the stop, and restart in each step. It used to gain up to 8.4e-5 of the energy.
// In Fixed32 an LSB of a rate is below 2^-29 of the fastest approach.
TEST(EnergyConsistent, AContactThatBeginsInsideItsStopGainsNothing) {
  constexpr double step = 1e-3, fastest = 0.8, mass = 1, reduced = mass / 2;
  const auto expect_no_gain = [&](auto format, double steps, double rounding, bool is_corrected) {
    using Kernel = Absorber<AtRunTime, Hertz, EnergyConsistent, NoDrive, decltype(format)>;
    Scene scene = elastic_scene();
    scene.main_mass = scene.ball_mass = mass;
    scene.stops = Stops::right;
    const double deepest = set_contact_time(scene, false, steps * step, fastest);
    int apart = 0;
    for (int i = 1; i < 60; ++i)
      for (int j = -19; j < 20; ++j) {
        const double depth = deepest * i / 60, rate = fastest * j / 20;
        const double energy = reduced * rate * rate / 2 + stored_at(scene, depth);
        if (energy > reduced * fastest * fastest / 2) continue;
        scene.x2 = scene.clearance / 2 + depth;
        scene.v2 = rate / 2;
        scene.v1 = -scene.v2;
        auto absorber = accepted<Kernel>(scene, {0.1, 1.001 * fastest / 2, 0, 0}, step);
        for (int n = 0; n < 3 * steps && absorber.is_touching(); ++n) {
          absorber.step();
          if (is_corrected) absorber.correct({}, {});
        }
        ASSERT_EQ(absorber.fault(), Fault::none);
        apart += !absorber.is_touching();
        const auto end = absorber.reading();
        const double left = reduced * (end.v2 - end.v1) * (end.v2 - end.v1) / 2;
        ASSERT_LE(left, energy + rounding * reduced * fastest * fastest / 2) << depth << ' ' << rate;
      }
    EXPECT_GT(apart, 1000);
  };
  for (const double steps : {22.6, 40.0, 80.0})
    for (const bool is_corrected : {false, true}) {
      expect_no_gain(Float64{}, steps, 1e-12, is_corrected);
      expect_no_gain(Fixed32{}, steps, 1e-6, is_corrected);
    }
}

// A single step of a stiff contact, over all proportions of G, C, d0, D and a. Half of the cases have a = 0. The work
// of the force is never less than the stored energy. Up to x = 0.98 the loss has the error of k, 0.36 % of the loss.
// For a = 0 Hunt-Crossley's first integral is conserved.
template <class Format, class ContactLaw> void expect_passive(uint32_t seed, double rounding, double lsb = 0) {
  using Contact = StiffContact<Format, ContactLaw>;
  using Units = typename Format::Units;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  const auto any = [&](double decades) { return std::pow(10, -decades * unit(random)); };
  int stays = 0, leaves = 0;
  for (int i = 0; i < 200000; ++i) {
    const double compliance = 1e8 * any(16);
    const double damping = ContactLaw::is_damped ? 1e4 * any(8) : 0;
    const int exponent = Format::exponent_of(std::fmax(damping, 1));
    const auto plan = Contact::Plan::make(compliance, Format::gain(0.5, 0, 0), {}, exponent);
    const bool is_inside = unit(random) < 0.6;
    const double size = 0.25 * any(sizeof(typename Format::Value) == 4 ? 2 : 6);
    const auto travel = Format::sample(size * (is_inside ? 2 * unit(random) - 1 : any(6)));
    const auto before = Format::sample(is_inside ? size * any(6) : -Units::fraction(travel) * unit(random));
    const auto rate = is_inside ? Format::sample(size * any(6)) : decltype(travel){};
    const auto press =
        unit(random) < 0.5 ? decltype(travel){} : Format::sample(size * any(6) * (unit(random) < 0.3 ? -1 : 1));
    const Contact step{
        plan, {Format::gain(damping, 0, exponent)}, is_inside, rate, before, travel, before + travel, press, {}};
    const auto end = step.end();
    const double D = Units::fraction(travel), b = Units::fraction(end.recoil), V0 = Units::fraction(rate),
                 V1 = Units::fraction(end.rate), scale = D * D / 4 + V0 * V0;
    const double lost = b * (D - b) + V0 * V0 - V1 * V1;
    ASSERT_GE(lost, -rounding * scale - lsb * std::sqrt(scale))
        << D << ' ' << V0 << ' ' << compliance << ' ' << damping;
    V1 > 0 ? ++stays : ++leaves;
    if (sizeof(typename Format::Value) == 4 || damping * D < -0.5 || b == 0) continue;
    const double a = Units::fraction(press), slowed = 1 + damping * (D - b), u = damping * b / slowed;
    const double x = std::clamp(damping * (b - a) / slowed, 0.0, u);
    if (damping * (std::fabs(D) + V0) > 50 || damping * (std::fabs(D) + V0) < 1e-3 || x > 0.98) continue;
    if (V1 == 0 && a != 0) continue;
    const double moved_back = x > 1e-4 ? (std::atanh(x) / x - 1) / damping : 0;
    const double exact = b * (D - b) - u / damping * (D - b - moved_back);
    EXPECT_NEAR(lost, exact, 0.004 * exact + 3e-4 * scale) << D << ' ' << V0 << ' ' << V1 << ' ' << damping;
  }
  EXPECT_GT(stays, 20000);
  EXPECT_GT(leaves, 20000);
}
// In Fixed32 the energies are 2^-8 or more in LSBs of 2^-30. The LSB of b and V1 is 2^-31.
TEST(StiffContact, MakesNoEnergy) {
  expect_passive<Float64, Hertz>(1, 1e-15);
  expect_passive<Float64, HuntCrossley>(2, 1e-15);
  expect_passive<Float32, Hertz>(3, 8 * 0x1p-24);
  expect_passive<Float32, HuntCrossley>(4, 8 * 0x1p-24);
  expect_passive<Fixed32, Hertz>(5, 0x1p-22, 0x1p-30);
  expect_passive<Fixed32, HuntCrossley>(6, 0x1p-22, 0x1p-30);
}

// A slow impact of half a step. In Fixed32 the correction used to wrap at one phase in ten, and the restitution was off
// by up to 0.145. A damping per impact has the error of a constant one, at most 6e-4.
TEST(StiffContact, ReboundsAsTheLawWhereItsCorrectionIsLargest) {
  constexpr double step = 1e-3, steps = 0.514455085, fastest = 1, approach = 0.0906947003;  // s, m/s
  Scene scene = elastic_scene();
  scene.clearance = 0;
  scene.main_mass = scene.ball_mass = 1;
  scene.restitution = 0.463068888;
  scene.contact_stiffness = 0.625 * fastest * fastest / std::pow(steps * step * fastest / 2.943, 2.5);
  scene.stops = Stops::right;
  scene.v2 = approach / 2;
  scene.v1 = -scene.v2;
  const auto expect_restitution = [&](auto format) {
    using Kernel = Absorber<AtRunTime, Exact, EnergyConsistent, NoDrive, decltype(format)>;
    for (int phase = 0; phase < 2000; ++phase) {
      scene.x2 = -approach * step * (phase + 0.5) / 2000;
      const auto end = after_steps(accepted<Kernel>(scene, {0.08, 0.50005, 0, 0}, step), 60).reading();
      ASSERT_NEAR((end.v1 - end.v2) / approach, scene.restitution, 6e-4) << phase;
    }
  };
  expect_restitution(Fixed32{});
  expect_restitution(Float64{});
}

// The same correction in a narrow cavity without a drive used to gain 4.85 times the energy in one step.
TEST(StiffContact, GainsNothingInADampedContactOfAFewSteps) {
  constexpr Scene scene =
      scene_of(27.415092347813175, 1219650523.9345512, 0, 76.282718275205667, 8.5267284239877246e-06,
               6811284358575.1875, 117341754011253.94, 0, 0, 0, 0, 7.1089095454039102e-06, 0.031563988715661039);
  constexpr Bounds bounds{2.8653570087306848e-05, 0.075555806012189711, 0, 0};
  const auto expect_no_gain = [&](auto format) {
    using Kernel = Absorber<AtRunTime, HuntCrossley, EnergyConsistent, NoDrive, decltype(format)>;
    auto absorber = accepted<Kernel>(scene, bounds, 0.00012085388687798424);
    const double at_start = energy_with_stop(scene, absorber.reading());
    for (int n = 0; n < 100; ++n) {
      absorber.step();
      ASSERT_LE(energy_with_stop(scene, absorber.reading()), at_start * (1 + 1e-4)) << n;
    }
    EXPECT_EQ(absorber.fault(), Fault::none);
  };
  expect_no_gain(Fixed32{});
  expect_no_gain(Float64{});
}

// The average delay of the ball's separation over 64 phases, in steps, after that of the law's elastic contact of
// `steps_of_contact`.
double delay_of(double steps_of_contact) {
  using Contact = StiffContact<Float64, Hertz>;
  constexpr double displacement = 1e-3;  // per step
  // The peak penetration. V there is displacement/2.
  const double peak = steps_of_contact * displacement / 2.9432;
  const auto plan = Contact::Plan::make(2.5 * displacement * displacement / 4 / std::pow(peak, 2.5), 1, 0, 0);
  double late = 0;
  for (int phase = 0; phase < 64; ++phase) {
    double d = -displacement * (phase + 0.5) / 64, w = displacement, rate = 0;
    const double impact = -d / displacement;
    int steps = 0;
    do {
      const auto end = Contact{plan, 0, rate > 0, rate, d, w, d + w, 0, 0}.end();
      w -= 2 * end.recoil, d = end.penetration, rate = end.rate, ++steps;
    } while (rate > 0 && steps < 1000);
    EXPECT_NEAR(w, -displacement, 1e-14);
    late += (steps + d / displacement - impact - steps_of_contact) / 64;
  }
  return late;
}
TEST(StiffContact, LastsAsLongAsTheLaws) {
  for (const double steps : {1e-3, 0.01, 0.1, 0.3, 1.0, 2.0, 3.0}) {
    EXPECT_GT(delay_of(steps), 0) << steps;
    EXPECT_LT(delay_of(steps), 1) << steps;
  }
  for (const double steps : {5.0, 7.0, 10.0, 14.0, 20.0}) EXPECT_NEAR(delay_of(steps), 0, 0.1) << steps;
}

}  // namespace
}  // namespace impact::host
