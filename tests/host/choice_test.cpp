// The plan's rule (choice.hpp) at its limits, and the ranges of the steppers with the longest accepted step. In one
// impact of two free masses, the rule's stepper gains no energy. Its restitution is within 1 % of the law's and within
// the stepper's stated error.

#include <impact/choice.hpp>

#include "host_ref/free_pair.hpp"
#include "host_ref/settled.hpp"
#include "kinds.hpp"

namespace impact::host {
namespace {

constexpr double speed = 0.8;               // m/s, of the impact, and twice Bounds::speed
constexpr Bounds bounds{0.5, 0.4, 0.4, 1};  // wide enough for a contact of any restitution here

Request pair_of(Law law, double e, Tension tension = Tension::clamp) {
  Request request;
  request.law = law;
  request.drive = DriveKind::none;
  request.bounds = bounds;
  const Impact impact{law, 32600, 0, 0.3 / 1.3, speed, tension};
  Scene& scene = request.scene;
  scene.main_stiffness = scene.main_damping = scene.drive_amplitude = scene.drive_pulsation = 0;
  // Equal masses, so that neither leaves the bounds after its rebound, with the paper's reduced mass.
  scene.main_mass = scene.ball_mass = 0.6 / 1.3;
  scene.tension = tension;
  scene.stops = Stops::right;
  scene.contact_damping = law == Law::hertz ? 0 : contact_damping(impact, e).value();
  scene.clearance = 0.2;
  return request;
}

struct Contact {
  Law law;
  double e;
  Tension tension = Tension::clamp;
};
const std::vector<Contact> contacts = [] {
  std::vector<Contact> all = {{Law::hertz, 1}};
  for (const double e : {0.05, 0.1, 0.3, 0.5, 0.7, 0.95, 0.999}) all.push_back({Law::hunt_crossley, e});
  for (const double e : {0.05, 0.3, 0.7, 0.999}) all.push_back({Law::hooke_newton, e});
  for (const double e : {0.05, 0.7}) all.push_back({Law::hooke_newton, e, Tension::allow});
  return all;
}();
std::string name_of(const Contact& contact) {
  return std::string(host::name_of(contact.law)) + " " + std::to_string(contact.e) +
         (contact.tension == Tension::allow ? " tension" : "");
}

// The rebounds at 64 phases of the impact within the step.
Rebounds rebounds(Request request) {
  request.scene.v1 = -speed / 2;
  request.scene.v2 = speed / 2;
  request.scene.x2 = request.scene.clearance / 2 - speed * request.step * (1 + 0.5 / phases_of_impact);
  const long steps = std::lround(4 * resolution(request).contact_time / request.step) + 20;
  const auto found = rebounds(request, steps, simulation_of);
  EXPECT_TRUE(found) << "refused";
  if (!found) return {};
  EXPECT_TRUE(found->is_apart);
  return *found;
}

// Multiply a limit to get a value just inside and just outside a range.
constexpr double just_below = 1 - 1e-9, just_above = 1 + 1e-9;

// If sub-steps are allowed, the rule chooses Moment from twenty steps on, but neither with friction nor where other
// forces may draw a ball off a strongly damped stop.
TEST(Choice, IsMomentFromEightStepsOn) {
  for (const Contact& contact : contacts) {
    const Resolution r = resolution(pair_of(contact.law, contact.e, contact.tension));
    EXPECT_EQ(choice_for(r, just_below * r.shortest_part / 8, 1), Choice::moment) << name_of(contact);
    EXPECT_NE(choice_for(r, just_above * r.shortest_part / 8, 1), Choice::moment) << name_of(contact);
    EXPECT_EQ(choice_for(r, just_below * r.shortest_part / 20, SubsteppedMoment<>::most),
              !r.is_linear && contact.e < 1.0 / 3 ? Choice::sub_steps : Choice::moment)
        << name_of(contact);
    EXPECT_NE(choice_for(r, just_above * r.shortest_part / 20, SubsteppedMoment<>::most), Choice::moment)
        << name_of(contact);
    Resolution rubbed = r;
    rubbed.has_friction = true;
    EXPECT_NE(choice_for(rubbed, r.shortest_part / 40, SubsteppedMoment<>::most), Choice::moment) << name_of(contact);
    EXPECT_EQ(choice_for(rubbed, r.shortest_part / 40, 1), Choice::moment) << name_of(contact);
  }
}

// With sub-steps, a contact has 20 of them, up to the allowed number.
TEST(Choice, IsSubSteppedBelowElseImpulsiveWhileTheMainMassHardlyMoves) {
  Resolution r = resolution(pair_of(Law::hunt_crossley, 0.7));
  r.main_phase = 0.05;
  EXPECT_EQ(choice_for(r, r.shortest_part, SubsteppedMoment<>::most), Choice::sub_steps);
  EXPECT_EQ(choice_for(r, r.shortest_part, 1), Choice::impulsive);
  EXPECT_EQ(SubsteppedMoment<>::parts_for(r, just_below * 0.8 * r.shortest_part), 16);
  EXPECT_EQ(SubsteppedMoment<>::parts_for(r, just_above * 0.8 * r.shortest_part), 32);
  EXPECT_EQ(choice_for(r, just_below * 0.8 * r.shortest_part, 16), Choice::sub_steps);
  EXPECT_EQ(choice_for(r, just_above * 0.8 * r.shortest_part, 16), Choice::impulsive);
  EXPECT_EQ(choice_for(r, just_below * 64 * r.shortest_part, SubsteppedMoment<>::most), Choice::sub_steps);

  r.main_phase = 0.0501;
  EXPECT_EQ(choice_for(r, just_below * 0.8 * r.shortest_part, 1), Choice::sub_steps);
  EXPECT_EQ(choice_for(r, just_above * 0.8 * r.shortest_part, 1), Choice::energy);
}

// At 8 steps Moment may gain 2e-5 of the energy, as much as a restitution of 1 - 1e-5 loses.
TEST(Choice, IsEnergyWhereHookeNewtonLosesLessThanMomentMayGain) {
  Resolution r = resolution(pair_of(Law::hooke_newton, 0.7));
  r.restitution = 1 - 0.9e-5;
  EXPECT_EQ(choice_for(r, r.shortest_part / 8, 1), Choice::energy);
  r.restitution = 1 - 1.1e-5;
  EXPECT_EQ(choice_for(r, just_below * r.shortest_part / 8, 1), Choice::moment);
  r.restitution = 1;
  EXPECT_EQ(choice_for(r, r.shortest_part / 1000, 1), Choice::energy);
}

template <int microseconds> struct RigOf {
  static constexpr Scene scene{};
  static constexpr Bounds bounds{};
  static constexpr double step = microseconds * 1e-6;
};
using Rig = RigOf<100>;
using SlowRig = RigOf<3300>;
using SlowestRig = RigOf<30000>;
static_assert(std::is_same_v<Absorber<Rig, HuntCrossley, Chosen<>, Sine, Fixed32>::Stepper, Moment>);
static_assert(std::is_same_v<Absorber<SlowRig, HuntCrossley, Chosen<>, Sine, Fixed32>::Stepper, SubsteppedMoment<>>);
static_assert(std::is_same_v<Absorber<SlowestRig, HuntCrossley, Chosen<>, Sine, Fixed32>::Stepper, EnergyConsistent>);

// With AtRunTime, the rig with the stiffest scene determines the stepper.
static_assert(std::is_same_v<Absorber<AtRunTime, HuntCrossley, Chosen<SlowRig, HuntCrossley>, Sine, Fixed32>::Stepper,
                             SubsteppedMoment<>>);

// A rejected stepper names a longest step. That step is accepted, and a slightly longer one is not.
TEST(Choice, ARejectedStepperNamesAnAcceptedStep) {
  for (const Contact& contact : contacts)
    for (const Stepper stepper : {Stepper::moment, Stepper::moment_4, Stepper::moment_8, Stepper::energy}) {
      Request request = pair_of(contact.law, contact.e, contact.tension);
      request.stepper = stepper;
      const Resolution r = resolution(request);
      const Range steps = stepper == Stepper::moment     ? Moment::steps(r)
                          : stepper == Stepper::moment_4 ? SubsteppedMoment<4>::steps(r)
                          : stepper == Stepper::moment_8 ? SubsteppedMoment<8>::steps(r)
                                                         : EnergyConsistent::steps(r);
      if (steps.most >= longest_step(request.scene, Moment::longest_phase)) continue;
      request.step = just_above * steps.most;
      const Outcome refused = make_simulation(request);
      EXPECT_EQ(refused.simulation, nullptr) << name_of(contact);
      EXPECT_EQ(refused.refusal.field, "step");
      const std::string from = "1e-09 to ";
      ASSERT_EQ(refused.refusal.allowed.substr(0, from.size()), from) << name_of(contact);
      const double most = std::stod(refused.refusal.allowed.substr(from.size()));
      EXPECT_LE(most, steps.most) << name_of(contact);
      EXPECT_GT(most, (1 - 2e-5) * steps.most) << name_of(contact) << ": six digits, rounded down";
      request.step = most;
      EXPECT_NE(make_simulation(request).simulation, nullptr) << name_of(contact);
    }
}

// Impulsive is rejected at any step if the main mass oscillates by a quarter of a radian during a contact.
TEST(Choice, ImpulsiveIsRefusedForALongContact) {
  Request request = pair_of(Law::hertz, 1);
  request.stepper = Stepper::impulsive;
  request.step = 1e-3;
  const double time = resolution(request).contact_time;
  const auto stiffness_for = [time, mass = request.scene.main_mass](double phase) {
    return mass * phase * phase / (time * time);
  };
  request.scene.main_stiffness = just_above * stiffness_for(Impulsive::longest_main_phase);
  const Outcome refused = make_simulation(request);
  EXPECT_EQ(refused.simulation, nullptr);
  EXPECT_EQ(refused.refusal.field, "newmark");
  EXPECT_EQ(refused.refusal.value, "impulsive");
  request.scene.main_stiffness = just_below * just_below * stiffness_for(Impulsive::longest_main_phase);
  EXPECT_NE(make_simulation(request).simulation, nullptr);
}

// From the fewest accepted steps on, only Hooke-Newton without damping gains energy. The restitution is always within
// the stepper's stated error, and from eight steps on within a hundredth of the law's. Sub-steps count as steps.
TEST(Choice, MomentKeepsWhatItStates) {
  int accepted = 0;
  for (const Contact& contact : contacts)
    for (const auto& [stepper, parts] : {std::pair(Stepper::moment, 1), {Stepper::moment_4, 4}, {Stepper::moment_8, 8}})
      for (const double steps : {5.0, 5.7, 6.5, 8.0, 10.0, 13.0, 20.0, 40.0}) {
        Request request = pair_of(contact.law, contact.e, contact.tension);
        request.stepper = stepper;
        const Resolution r = resolution(request);
        request.step = just_below * parts * r.shortest_part / steps;
        // For e = 0.05 and 0.1, few steps do not resolve the damping.
        if (!Moment::steps(r).holds(request.step / parts)) continue;
        ++accepted;
        const Rebounds found = rebounds(request);
        const double error = larger(found.largest - contact.e, contact.e - found.least);
        const double stated = Moment::restitution_error(r, request.step / parts) + 1e-12;
        const std::string which = name_of(contact) + " at " + std::to_string(steps) + " of " + std::to_string(parts);
        EXPECT_LE(error, stated) << which;
        if (steps >= 8) {
          EXPECT_LE(error, 0.01 * contact.e) << which;
        }
        const double of_spring = contact.law == Law::hooke_newton ? 1e-5 * std::pow(8 / steps, 6) : 0;
        EXPECT_LE(found.largest * found.largest, 1 + std::max(of_spring - (1 - contact.e * contact.e), 0.0) + 1e-12)
            << which;
      }
  EXPECT_GE(accepted, 320);  // of 336
}

}  // namespace
}  // namespace impact::host
