// Stops from soft to steel, against the reference, which locates every touch by itself: the stepper that the rule takes
// keeps one bound of the error whatever the stiffness, for each law and format.

#include <gtest/gtest.h>

#include <cmath>
#include <impact/absorber.hpp>
#include <impact/choice.hpp>
#include <impact/law/per_impact.hpp>

#include "host_ref/extremes.hpp"
#include "host_ref/reference.hpp"

namespace impact {
namespace {

constexpr Bounds bounds{0.05, 1.5};

host::Case scene_of(Law law, double stiffness) {
  host::Case run;
  run.law = law;
  run.scene.main_damping = 0.5;
  run.scene.drive_pulsation = 36;
  run.scene.contact_stiffness = stiffness;
  run.scene.contact_damping = 0;
  return run;
}
// e = 0.68 at 0.8 m/s, and a damping ratio of 0.12.
host::Case hunt_crossley(double stiffness) {
  host::Case run = scene_of(Law::hunt_crossley, stiffness);
  run.scene.contact_damping = 0.8695 * stiffness;
  return run;
}
host::Case hooke_newton(double stiffness) {
  host::Case run = scene_of(Law::hooke_newton, stiffness);
  run.scene.contact_damping = 0.24 * std::sqrt(stiffness * 0.3 / 1.3);
  return run;
}
host::Case per_impact(double stiffness) {
  host::Case run = scene_of(Law::hunt_crossley, stiffness);
  run.scene.restitution = 0.7;
  run.damping_ratio = Exact::damping_ratio(0.7);
  return run;
}

template <class Format, class ContactLaw, class Stepper>
double error(const host::Case& run, double h, double duration) {
  using Driven = Absorber<AtRunTime, ContactLaw, Stepper, Sine, Format>;
  const auto plan = Driven::PlanType::make(run.scene, bounds, h);
  EXPECT_EQ(plan.status, PlanStatus::ok) << run.scene.contact_stiffness << " at " << h;
  Driven absorber(plan);
  host::Reference reference(run);
  double worst = 0;
  for (int n = 1; n * h <= duration * (1 + 1e-12); ++n) {
    absorber.step();
    reference.advance(n * h);
    worst = host::larger(worst, std::abs(absorber.reading().x1 - reference.sample().x1));
  }
  EXPECT_EQ(absorber.fault(), Fault::none);
  return worst;
}
template <class Format, class ContactLaw>
double error_by_rule(const host::Case& run, double h, double duration) {
  const Resolution contact = resolution_of<ContactLaw>(run.scene, bounds);
  const Choice choice = choice_for(contact, h, SubsteppedMoment<>::most);
  if (choice == Choice::moment) return error<Format, ContactLaw, Moment>(run, h, duration);
  EXPECT_EQ(choice, Choice::sub_steps) << run.scene.contact_stiffness << " at " << h;
  return error<Format, ContactLaw, SubsteppedMoment<>>(run, h, duration);
}

constexpr double stiffnesses[] = {3e4, 3e5, 3e6, 1e8, 3e9, 1e11, 1e12}, of_springs[] = {1e3, 1e5, 3e6, 1e8};

// As long as the impacts of Hertz, which loses nothing, do not amplify what is missed by more than ten times.
template <class Format, class ContactLaw, class SceneOf>
void expect_one_bound(const SceneOf& scene_of, double share, double more) {
  const auto expect = [&](double stiffness) {
    const host::Case run = scene_of(stiffness);
    EXPECT_LT((error_by_rule<Format, ContactLaw>(run, 1e-3, 0.4)), share * 1e-6 + more) << stiffness;
    EXPECT_LT((error_by_rule<Format, ContactLaw>(run, 1e-4, 0.4)), share * 1e-7 + more) << stiffness;
  };
  if (ContactLaw::is_linear)
    for (const double stiffness : of_springs) expect(stiffness);
  else
    for (const double stiffness : stiffnesses) expect(stiffness);
}

TEST(StiffStop, IsAsExactAsASoftOne) {
  expect_one_bound<Float64, HuntCrossley>(hunt_crossley, 1, 0);
  expect_one_bound<Float64, Exact>(per_impact, 1, 0);
  expect_one_bound<Float64, HookeNewton>(hooke_newton, 1, 0);
  expect_one_bound<Float64, Hertz>([](double k1) { return scene_of(Law::hertz, k1); }, 10, 0);
}
TEST(StiffStop, IsAsExactInFloat) { expect_one_bound<Float32, HuntCrossley>(hunt_crossley, 1, 1e-8); }

TEST(StiffStop, ConvergesToFourthOrder) {
  for (const double stiffness : {1e8, 1e10}) {
    const host::Case run = hunt_crossley(stiffness);
    const double coarse = error<Float64, HuntCrossley, SubsteppedMoment<16>>(run, 1e-4, 0.2),
                 fine = error<Float64, HuntCrossley, SubsteppedMoment<16>>(run, 2.5e-5, 0.2);
    EXPECT_LT(fine, coarse / 100 + 1e-13) << stiffness << ": " << coarse;
  }
}

}  // namespace
}  // namespace impact
