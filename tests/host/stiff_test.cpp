// Stops from soft to steel against the reference, which locates every touch. With the rule's stepper each law and
// format has one error bound for any stiffness.

#include <impact/choice.hpp>
#include <impact/law/per_impact.hpp>

#include "against_reference.hpp"

namespace impact {
namespace {

// With one value changed.
Scene driven(double Scene::*changed = nullptr, double to = 0) {
  Scene scene;
  scene.main_damping = 0.5;
  scene.drive_pulsation = 36;
  if (changed) scene.*changed = to;
  return scene;
}
Scene heavy() { return driven(&Scene::ball_mass, 3); }
Scene hanging() { return driven(&Scene::gravity, 9.81); }
// At its largest speed, the ball crosses the cavity in 0.6 ms.
Scene narrow() { return driven(&Scene::clearance, 2e-3); }
// It may cross this one 6 times in a step of 1 ms.
Scene very_narrow() { return driven(&Scene::clearance, 5e-4); }
Scene rubbing(Scene scene, double friction) {
  scene.ball_friction = friction;
  return scene;
}
// At a step of 1 ms this drive is fast, so its second derivative matters in free flight.
Scene fast() {
  Scene scene = driven(&Scene::main_stiffness, 4000);
  scene.drive_pulsation = 72;
  scene.drive_amplitude = 40;
  return scene;
}
Bounds bounds_of(const Scene& scene) {
  return scene.main_stiffness > 1000 || scene.gravity > 0 ? Bounds{0.09, 4} : Bounds{0.05, 1.6};
}

// The damping for e = 0.68 at 0.8 m/s, for a damping ratio of 0.12, and e = 0.7.
template <class ContactLaw> host::Case with_stop(const Scene& scene, double stiffness) {
  host::Case run{ContactLaw::law, scene};
  run.scene.contact_stiffness = stiffness;
  const double reduced = scene.main_mass * scene.ball_mass / (scene.main_mass + scene.ball_mass);
  run.scene.contact_damping = ContactLaw::is_linear ? 0.24 * std::sqrt(stiffness * reduced)
                              : ContactLaw::is_damped && !ContactLaw::is_damped_per_impact ? 0.8695 * stiffness
                                                                                           : 0;
  if constexpr (ContactLaw::is_damped_per_impact) {
    run.scene.restitution = 0.7;
    run.damping_ratio = ContactLaw::damping_ratio(0.7);
  }
  return run;
}

template <class Format, class ContactLaw, class Stepper, class... Parts>
double error(const host::Case& run, double h, double duration) {
  using Driven = Absorber<AtRunTime, ContactLaw, Stepper, Sine, Format, Gravity, Parts...>;
  return differences<Driven>(run, bounds_of(run.scene), h, duration, h).x1;
}
template <class Format, class ContactLaw, class... Parts>
double error_by_rule(const host::Case& run, double h, double duration) {
  const Resolution contact = resolution_of<ContactLaw>(run.scene, bounds_of(run.scene));
  const Choice choice = choice_for(contact, h, SubsteppedMoment<>::most);
  if (choice == Choice::moment) return error<Format, ContactLaw, Moment, Parts...>(run, h, duration);
  EXPECT_EQ(choice, Choice::sub_steps) << run.scene.contact_stiffness << " at " << h;
  return error<Format, ContactLaw, SubsteppedMoment<>, Parts...>(run, h, duration);
}

constexpr double stiffnesses[] = {3e4, 3e5, 3e6, 1e8, 3e9, 1e11, 1e12}, of_springs[] = {1e3, 1e5, 3e6, 1e8, 3e10, 1e12};

// The tolerance is `share` times the limits plus `more` for the format's LSBs.
template <class Format, class ContactLaw> void expect_one_bound(const Scene& scene, double share = 1, double more = 0) {
  const auto expect = [&](double stiffness) {
    const host::Case run = with_stop<ContactLaw>(scene, stiffness);
    EXPECT_LT((error_by_rule<Format, ContactLaw>(run, 1e-3, 0.4)), share * 1e-6 + more) << stiffness;
    EXPECT_LT((error_by_rule<Format, ContactLaw>(run, 1e-4, 0.4)), share * 1e-7 + more) << stiffness;
  };
  if (ContactLaw::is_linear)
    for (const double stiffness : of_springs) expect(stiffness);
  else
    for (const double stiffness : stiffnesses) expect(stiffness);
}

TEST(StiffStop, IsAsExactAsASoftOne) {
  for (const Scene& scene : {driven(), heavy(), hanging(), fast(), narrow()}) {
    SCOPED_TRACE(testing::Message() << scene.ball_mass << " kg, " << scene.main_stiffness << " N/m, " << scene.gravity
                                    << " m/s^2, " << scene.clearance << " m");
    expect_one_bound<Float64, HuntCrossley>(scene);
    expect_one_bound<Float64, Exact>(scene);
    expect_one_bound<Float64, HookeNewton>(scene);
  }
}
TEST(StiffStop, IsAsExactInACavityThatTheBallCrossesSixTimesInAStep) {
  for (const double stiffness : {3e6, 1e8, 3e9}) {
    const host::Case run = with_stop<HuntCrossley>(very_narrow(), stiffness),
                     linear = with_stop<HookeNewton>(very_narrow(), stiffness);
    EXPECT_LT((error_by_rule<Float64, HuntCrossley>(run, 1e-3, 0.4)), 1e-7) << stiffness;
    EXPECT_LT((error_by_rule<Fixed32, HuntCrossley>(run, 1e-3, 0.4)), 1e-6) << stiffness;
    EXPECT_LT((error_by_rule<Float64, HookeNewton>(linear, 1e-3, 0.4)), 1e-9) << stiffness;
    Scene in_field = very_narrow();
    in_field.gravity = 9.81;
    for (const Scene& scene : {in_field, rubbing(very_narrow(), 0.3)}) {
      const host::Case part = with_stop<HuntCrossley>(scene, stiffness);
      EXPECT_LT((error_by_rule<Float64, HuntCrossley, DryFriction>(part, 1e-3, 0.4)), 1e-6) << stiffness;
      EXPECT_LT((error_by_rule<Fixed32, HuntCrossley, DryFriction>(part, 1e-3, 0.4)), 2e-6) << stiffness;
    }
  }
}
// Hertz loses nothing. In these scenes its impacts amplify errors by at most ten.
TEST(StiffStop, IsAsExactWithHertz) {
  for (const Scene& scene : {driven(), heavy(), hanging()}) expect_one_bound<Float64, Hertz>(scene, 10);
}
TEST(StiffStop, IsAsExactInFixedPoint) {
  for (const Scene& scene : {driven(), heavy(), hanging()}) {
    expect_one_bound<Fixed32, HuntCrossley>(scene, 1, 2e-9);
    expect_one_bound<Fixed32, Exact>(scene, 1, 2e-9);
    expect_one_bound<Fixed32, Hertz>(scene, 10, 2e-9);
    expect_one_bound<Fixed32, HookeNewton>(scene, 1, 2e-9);
  }
}
TEST(StiffStop, IsAsExactInFloat) {
  expect_one_bound<Float32, HuntCrossley>(driven(), 1, 1e-8);
  expect_one_bound<Float32, Exact>(driven(), 1, 1e-8);
  expect_one_bound<Float32, HookeNewton>(driven(), 1, 1e-8);
}

// Dry friction reverses at the instant of the impact, or in flight at that of the ball's reversal. The limits are those
// without friction.
template <class Format, class ContactLaw> double error_with_friction(const Scene& scene, double stiffness, double h) {
  return error<Format, ContactLaw, SubsteppedMoment<>, DryFriction>(with_stop<ContactLaw>(scene, stiffness), h, 0.4);
}
template <class Format, class ContactLaw> void expect_one_bound_with_friction(double more = 0) {
  for (const Scene& scene : {rubbing(driven(), 0.5), rubbing(driven(), 2), rubbing(heavy(), 3), rubbing(hanging(), 1)})
    for (const double stiffness : {3e4, 3e6, 3e7, 1e9, 1e12}) {
      if (more > 0 && stiffness > 1e9) continue;
      SCOPED_TRACE(testing::Message() << scene.ball_friction << " N, " << stiffness);
      EXPECT_LT((error_with_friction<Format, ContactLaw>(scene, stiffness, 1e-3)), 1e-6 + more);
      EXPECT_LT((error_with_friction<Format, ContactLaw>(scene, stiffness, 1e-4)), 1e-7 + more);
    }
}
TEST(StiffStop, IsAsExactWithFriction) {
  expect_one_bound_with_friction<Float64, HuntCrossley>();
  expect_one_bound_with_friction<Float64, Exact>();
  expect_one_bound_with_friction<Float64, HookeNewton>();
  for (const double stiffness : {3e4, 3e7, 1e9, 1e12})
    EXPECT_LT((error_with_friction<Float64, HuntCrossley>(rubbing(driven(), 0.5), stiffness, 1e-5)), 2e-8) << stiffness;
}
// Floats round each state.
TEST(StiffStop, IsAsExactWithFrictionInFloat) { expect_one_bound_with_friction<Float32, HuntCrossley>(1e-8); }
// Impulsive takes what happens during an impact to first order in its duration, so most of its error does not depend on
// the step.
template <class ContactLaw> void expect_impulsive_within_what_the_rule_expects() {
  for (const Scene& scene : {driven(), heavy()})
    for (const double stiffness : {1e8, 1e9, 1e10, 1e11, 1e12}) {
      const host::Case run = with_stop<ContactLaw>(scene, stiffness);
      const Resolution contact = resolution_of<ContactLaw>(run.scene, bounds_of(scene));
      if (!Impulsive::is_instant(contact, longest_instant)) continue;
      for (const double h : {2e-3, 1e-3, 1e-4})
        EXPECT_LT((error<Float64, ContactLaw, Impulsive>(run, h, 0.4)), expected_error(Choice::impulsive, contact, h))
            << scene.ball_mass << " kg, " << stiffness << " at " << h;
    }
}
TEST(StiffStop, ImpulsiveMissesNoMoreThanTheRuleExpects) {
  expect_impulsive_within_what_the_rule_expects<HuntCrossley>();
  expect_impulsive_within_what_the_rule_expects<Exact>();
  expect_impulsive_within_what_the_rule_expects<HookeNewton>();
}
// Also at states read during an impact.
TEST(StiffStop, ImpulsiveIsWithinAMicrometreAtASteelStop) {
  for (const double stiffness : {1e9, 1e10, 1e11, 1e12})
    for (const double h : {2e-3, 1e-3, 5e-4, 1e-4})
      EXPECT_LT((error<Float64, HuntCrossley, Impulsive>(with_stop<HuntCrossley>(driven(), stiffness), h, 0.4)), 1e-6)
          << stiffness << " at " << h;
}
TEST(StiffStop, ImpulsiveWithFrictionDoesNotDependOnTheStep) {
  for (const double friction : {0.5, 2.0}) {
    const host::Case run = with_stop<HookeNewton>(rubbing(driven(), friction), 1e12);
    for (const double h : {1e-3, 1e-4})
      EXPECT_LT((error<Float64, HookeNewton, Impulsive, DryFriction>(run, h, 0.4)), 2e-7) << friction << " " << h;
  }
}

// The bound of speed is a hundred times what the masses reach, so the main mass's share of an impulse in one of the
// sub-steps is below an LSB.
TEST(StiffStop, TakesTheMomentumOfALightPressedBallFromTheMainMass) {
  constexpr double force = 0.178, h = 5.94e-4;
  constexpr int steps = 200;
  Scene scene = undriven_scene();
  scene.main_mass = 0.1114;
  scene.main_stiffness = 0.007;
  scene.ball_mass = 0.00189;
  scene.clearance = 7e-4;
  scene.x2 = -scene.clearance / 2;
  scene.contact_stiffness = 1e13;
  scene.contact_damping = 1e14;
  using Pressed = Absorber<AtRunTime, HuntCrossley, SubsteppedMoment<>, Sampled, Fixed32>;
  auto absorber = accepted<Pressed>(scene, {4, 7.85, 0, force}, h);
  for (int i = 0; i < steps; ++i) absorber.step(absorber.sample_of(force));
  const auto at = absorber.reading();
  const double expected = force * (steps - 0.5) * h / (scene.main_mass + scene.ball_mass);
  EXPECT_NEAR(at.v1, expected, 1e-3 * expected);
  // With these bounds the ball's rate varies by 3e-4 m/s around that of the main mass.
  EXPECT_NEAR(at.x2 - at.x1, scene.x2, 3e-4 * h);
}

// The sliding turns in a damped contact, at any phase of a sub-step. The rate is not linear there, and friction changes
// it from the turn on, and with it the damping's push. Otherwise the error of the speed would be of second order.
template <class ContactLaw, class Stepper> double error_after_a_turn(double stiffness) {
  constexpr double h = 1e-3;
  double worst = 0;
  for (int phase = 0; phase < 16; ++phase) {
    Scene scene = rubbing(driven(&Scene::drive_amplitude, 0), 20);
    scene.x2 = 0.499 * scene.clearance;
    scene.v2 = 0.5 + 0.02 * phase;
    host::Case run = with_stop<ContactLaw>(scene, stiffness);
    run.scene.contact_damping *= 2;
    using Turned = Absorber<AtRunTime, ContactLaw, Stepper, NoDrive, Float64, DryFriction>;
    const auto now = after_steps(accepted<Turned>(run.scene, {0.05, 1.6}, h), 8).reading();
    worst = larger(worst, std::abs(now.v2 - reference_at(run, 8 * h).v2));
  }
  return worst;
}
template <class ContactLaw> void expect_third_order_after_a_turn(double stiffness) {
  const double coarse = error_after_a_turn<ContactLaw, SubsteppedMoment<4>>(stiffness),
               fine = error_after_a_turn<ContactLaw, SubsteppedMoment<8>>(stiffness);
  EXPECT_LT(fine, coarse / 6) << coarse;
  EXPECT_LT(fine, 1e-4 * 20 * 1e-3 / 0.3);  // of what friction takes of the ball's speed in a step
}
TEST(StiffStop, ATurnInADampedContactIsOfThirdOrder) {
  expect_third_order_after_a_turn<HuntCrossley>(1e6);
  expect_third_order_after_a_turn<HookeNewton>(3e4);
}

TEST(StiffStop, ConvergesToFourthOrder) {
  for (const double stiffness : {1e8, 1e10}) {
    const host::Case run = with_stop<HuntCrossley>(driven(), stiffness);
    const double coarse = error<Float64, HuntCrossley, SubsteppedMoment<16>>(run, 1e-4, 0.2),
                 fine = error<Float64, HuntCrossley, SubsteppedMoment<16>>(run, 2.5e-5, 0.2);
    EXPECT_LT(fine, coarse / 100 + 1e-13) << stiffness << ": " << coarse;
  }
}
// From 64 sub-steps on their displacements are from rates. What remains is the error of the flight in steps of 4 ms.
TEST(StiffStop, MoreSubStepsThanAContactNeedsAddNoError) {
  const host::Case run = with_stop<HuntCrossley>(driven(), 1e6);
  const double of_flight = error<Float64, HuntCrossley, SubsteppedMoment<32>>(run, 4e-3, 0.4);
  EXPECT_LT((error<Float64, HuntCrossley, SubsteppedMoment<64>>(run, 4e-3, 0.4)), 1.5 * of_flight);
  EXPECT_LT((error<Float64, HuntCrossley, SubsteppedMoment<1024>>(run, 4e-3, 0.4)), 1.5 * of_flight);
}

}  // namespace
}  // namespace impact
