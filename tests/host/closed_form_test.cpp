// One impact of two free masses in closed form: against known values, in its limits, and in the kernel's constants.

#include "against_reference.hpp"
#include "known_impacts.hpp"

namespace impact::host {
namespace {

void expect_ten_digits(std::optional<double> actual, double expected) {
  ASSERT_TRUE(actual.has_value());
  EXPECT_NEAR(*actual / expected, 1, 5e-10);
}

// The impact of all tables: k1 = 32600, M = 1 kg, m = 0.3 kg, v0 = 0.8 m/s.
Impact table_impact(Law law, double damping, Tension tension = Tension::clamp) {
  return {law, 32600, damping, 0.3 / 1.3, 0.8, tension};
}

TEST(ClosedForm, HasTheKnownValues) {
  for (const Known& known : known_impacts) {
    SCOPED_TRACE(known.name);
    const Impact impact = table_impact(known.law, known.damping, known.tension);
    expect_ten_digits(restitution(impact), known.restitution);
    expect_ten_digits(peak_penetration(impact), known.peak_penetration);
    expect_ten_digits(peak_force(impact), known.peak_force);
    expect_ten_digits(contact_time(impact), known.contact_time);
    if (known.lost > 0)
      expect_ten_digits(energy_lost(impact), known.lost);
    else
      EXPECT_EQ(energy_lost(impact).value(), 0);
  }
  for (const auto& [speed, e] : restitutions_by_speed) {
    Impact impact = table_impact(Law::hunt_crossley, 19560);
    impact.speed = speed;
    expect_ten_digits(restitution(impact), e);
  }
}

TEST(ClosedForm, HasTheDampingOfAStatedRestitution) {
  const Impact pulling = table_impact(Law::hooke_newton, 0, Tension::allow),
               hunt_crossley = table_impact(Law::hunt_crossley, 0);
  expect_ten_digits(paper_contact_damping(pulling, 0.68), 21.13670350);
  expect_ten_digits(contact_damping(pulling, 0.68), 21.13670350);
  expect_ten_digits(contact_damping(table_impact(Law::hooke_newton, 0), 0.68), 23.06435307);
  expect_ten_digits(paper_contact_damping(hunt_crossley, 0.68), 19560);
  expect_ten_digits(contact_damping(hunt_crossley, 0.68), 28345.99094);
}

TEST(HookeNewtonClosedForm, CriticalDampingIsContinuous) {
  const double critical = 2 * std::sqrt(32600 * (0.3 / 1.3));
  for (const double distance : {1e-3, 1e-4, 1e-5, 0.0}) {
    const Impact below = table_impact(Law::hooke_newton, critical * (1 - distance));
    const Impact above = table_impact(Law::hooke_newton, critical * (1 + distance));
    // At zeta = 1 the phase at zero force is 2, so e = exp(-2), and |d ln e/d zeta| = 4/3.
    EXPECT_NEAR(std::log(*restitution(below)), -2 + 4.0 / 3 * distance, 2 * distance * distance + 1e-14);
    EXPECT_NEAR(std::log(*restitution(above)), -2 - 4.0 / 3 * distance, 2 * distance * distance + 1e-14);
  }
}

TEST(HookeNewtonClosedForm, OverdampedComesApartOnlyAtZeroForce) {
  const Impact pulling = table_impact(Law::hooke_newton, 1000, Tension::allow);
  EXPECT_FALSE(restitution(pulling).has_value());
  EXPECT_FALSE(contact_time(pulling).has_value());
  EXPECT_FALSE(energy_lost(pulling).has_value());
  const Impact let_go = table_impact(Law::hooke_newton, 1000, Tension::clamp);
  EXPECT_GT(restitution(let_go).value(), 0);
  EXPECT_DOUBLE_EQ(peak_force(let_go).value(), 800);
}

TEST(HuntCrossleyClosedForm, SmallDampingApproachesHertz) {
  const Impact hertz = table_impact(Law::hertz, 0);
  for (const double damping : {0.0, 1e-9, 1e-5, 1e-1, 10.0}) {
    const Impact impact = table_impact(Law::hunt_crossley, damping);
    // The series is e = 1 - 2a/3 + 4a^2/9 - 44a^3/135 + O(a^4). The other values change by at most a, relatively.
    const double a = damping * 0.8 / 32600;
    EXPECT_NEAR(*restitution(impact), 1 - a * (2.0 / 3 - a * (4.0 / 9 - a * 44.0 / 135)), 1e-15 + a * a * a * a);
    EXPECT_NEAR(*contact_time(impact) / *contact_time(hertz), 1, 1e-12 + a);
    EXPECT_NEAR(*peak_force(impact) / *peak_force(hertz), 1, 1e-12 + a);
    EXPECT_NEAR(*peak_penetration(impact) / *peak_penetration(hertz), 1, 1e-12 + a);
  }
}

// Below and above a = 1 different integrals give the contact time.
TEST(HuntCrossleyClosedForm, ContactTimeOfStrongDampingJoinsThatOfWeak) {
  const Impact below{Law::hunt_crossley, 1, 1, 1, 1}, above{Law::hunt_crossley, 1, 1 + 1e-12, 1, 1};
  EXPECT_NEAR(*contact_time(below), *contact_time(above), 4e-12);
}

TEST(ClosedForm, RestitutionAndDampingAreInverse) {
  for (const Law law : {Law::hooke_newton, Law::hunt_crossley})
    for (const Tension tension : {Tension::clamp, Tension::allow})
      for (const double e : {0.999, 0.9, 0.5, 0.2, 0.02}) {
        Impact impact = table_impact(law, 0, tension);
        impact.contact_damping = contact_damping(impact, e).value();
        EXPECT_NEAR(restitution(impact).value(), e, 1e-14) << e;
      }
}

TEST(ClosedForm, ArgumentsOutOfRangeHaveNoValue) {
  for (const Law law : {Law::hooke_newton, Law::hertz, Law::hunt_crossley}) {
    const Impact sound = table_impact(law, 10);
    const auto refused = [](const Impact& impact) {
      return !restitution(impact) && !peak_penetration(impact) && !peak_force(impact) && !contact_time(impact) &&
             !energy_lost(impact);
    };
    EXPECT_FALSE(refused(sound));
    for (const double bad : {0.0, -1.0, std::nan(""), HUGE_VAL})
      for (double Impact::*member : {&Impact::contact_stiffness, &Impact::reduced_mass, &Impact::speed}) {
        Impact impact = sound;
        impact.*member = bad;
        EXPECT_TRUE(refused(impact));
      }
    for (const double bad : {-1.0, std::nan(""), HUGE_VAL}) {
      Impact impact = sound;
      impact.contact_damping = bad;
      EXPECT_TRUE(refused(impact));
    }
    for (const double bad : {0.0, -0.5, 1.1, std::nan("")}) {
      EXPECT_FALSE(contact_damping(sound, bad).has_value());
      EXPECT_FALSE(paper_contact_damping(sound, bad).has_value());
    }
    EXPECT_EQ(contact_damping(sound, 1).value(), 0);
  }
  EXPECT_FALSE(contact_damping(table_impact(Law::hertz, 0), 0.9).has_value());
}

// The constants of a free impact that a plan uses, against the closed forms.

constexpr double ball_mass = 0.3, main_mass = 1;

constexpr ContactTerms terms_of(double stiffness, double damping_time, double ball, double main) {
  ContactTerms terms;
  terms.stiffness = stiffness;
  terms.damping_time = damping_time;
  terms.ball_mass = ball;
  terms.main_mass = main;
  return terms;
}

template <class ContactLaw>
void expect_closed_form(double stiffness, double damping, double speed, Tension tension, double tolerance) {
  const Impact impact{ContactLaw::law, stiffness, damping, ball_mass * main_mass / (ball_mass + main_mass),
                      speed,           tension};
  ContactTerms terms = terms_of(stiffness, damping / stiffness, ball_mass, main_mass);
  terms.clamped = tension == Tension::clamp;
  const FreeImpact found = free_impact<ContactLaw>(terms, speed);
  EXPECT_NEAR(found.restitution, restitution(impact).value(), 1e-12);
  EXPECT_NEAR(found.contact_time / contact_time(impact).value(), 1, tolerance) << stiffness << " " << damping;
  // The ball separates at zero force, at the penetration e V c1/k1.
  const double let_go = ContactLaw::is_linear && terms.clamped ? terms.damping_time : 0;
  EXPECT_NEAR(found.centroid, found.restitution * (found.contact_time + let_go) / (1 + found.restitution),
              1e-12 * found.contact_time);
}

TEST(FreeImpactConstants, Hertz) {
  for (double stiffness : {1e-3, 32600.0, 1e18})
    for (double speed : {1e-6, 0.8, 1e3}) expect_closed_form<Hertz>(stiffness, 0, speed, Tension::clamp, 1e-8);
}

TEST(FreeImpactConstants, HookeNewtonAtAnyDampingRatio) {
  const double critical = 2 * std::sqrt(32600.0 * ball_mass * main_mass / (ball_mass + main_mass));
  for (double zeta : {0.0, 0.01, 0.12, 0.7, 0.99, 1 - 1e-9, 1.0, 1 + 1e-9, 1.01, 1.99, 2.01, 10.0, 1e4})
    expect_closed_form<HookeNewton>(32600, zeta * critical, 0.8, Tension::clamp, 1e-12);
  for (double zeta : {0.0, 0.01, 0.12, 0.7, 0.99})
    expect_closed_form<HookeNewton>(32600, zeta * critical, 0.8, Tension::allow, 1e-12);
}

TEST(FreeImpactConstants, HookeNewtonWithTensionNeverComesApartOverdamped) {
  ContactTerms terms = terms_of(100, 1, 1, 1);
  terms.clamped = false;
  const FreeImpact found = free_impact<HookeNewton>(terms, 1);
  EXPECT_EQ(found.restitution, 0);
  EXPECT_EQ(found.centroid, 0);
  EXPECT_GT(found.contact_time, 1e12);
}

// The tolerances are the quadrature's bounds (free_impact.hpp).
TEST(FreeImpactConstants, HuntCrossley) {
  for (double stiffness : {1e2, 32600.0, 1e15})
    for (double speed : {1e-4, 0.8, 10.0})
      for (double a : {0.0, 1e-12, 1e-8, 1e-3, 0.1, 0.48, 1.0, 3.0, 10.0, 30.0, 100.0})
        expect_closed_form<HuntCrossley>(stiffness, a * stiffness / speed, speed, Tension::clamp, a <= 3 ? 1e-5 : 2e-4);
}

// With very strong damping, the ball creeps out of the peak penetration at the speed k1/c1. The peak is (5 mu/(2 k1
// a))^(2/5) without the logarithm.
TEST(FreeImpactConstants, HuntCrossleyCreeps) {
  for (double a : {100.0, 1e4, 1e9, 1e20}) {
    const ContactTerms terms = terms_of(1, a, 1, 1);
    EXPECT_NEAR(free_impact<HuntCrossley>(terms, 1).restitution * a, 1, 1e-12);
    EXPECT_NEAR(free_impact<HuntCrossley>(terms, 1).contact_time / (a * std::pow(5 * 0.5 / (2 * a), 0.4)), 1, 0.05);
  }
}

// Usable in a constant expression.
constexpr ContactTerms paper_terms = terms_of(32600, 0.6, ball_mass, main_mass);
static_assert(constant::magnitude(free_impact<HuntCrossley>(paper_terms, 0.8).restitution - 0.7561486807) < 1e-10);
static_assert(constant::magnitude(free_impact<HuntCrossley>(paper_terms, 0.8).contact_time - 0.03035344861) < 3e-7);

// The main spring, released from its bound, presses a ball at rest into its stop. The penetration is twice the static
// one for a linear stop, and (5/2)^(2/3) of it for a power law. The closing speed is negligible, and the heavy ball
// hardly moves.
TEST(DeepestPenetration, BoundsAPressedBall) {
  Scene scene = undriven_scene();
  scene.main_mass = 10;
  scene.ball_mass = 1e9;
  scene.main_stiffness = 100;
  scene.contact_stiffness = 1e6;
  const Bounds bounds{0.1, 1e-5, 0, 0};
  const double load = 1 / (1 / scene.main_mass + 1 / scene.ball_mass) * 100 * 0.1 / 10;
  const double linear = 2 * load / scene.contact_stiffness,
               power = std::pow(2.5 * load / scene.contact_stiffness, 2.0 / 3);
  EXPECT_GE(deepest_penetration(scene, bounds, true, 0, 0), linear);
  EXPECT_LE(deepest_penetration(scene, bounds, true, 0, 0), 1.02 * linear);
  EXPECT_GE(deepest_penetration(scene, bounds, false, 0, 0), power);
  EXPECT_LE(deepest_penetration(scene, bounds, false, 0, 0), 1.02 * power);
}

// Single steps of a contact against the reference or closed forms, in double. In a long run the method's error hides a
// wrong or missing small term.

// The relative motion of two free masses at a Hooke-Newton stop: d'' = -w^2 d - 2 z w d', z < 1.
struct Oscillation {
  double pulsation, ratio;  // w, z
};

Scene free_pair(const Oscillation& motion) {
  Scene scene = free_scene();
  const double mu = 1 / (1 / scene.main_mass + 1 / scene.ball_mass);
  scene.contact_stiffness = mu * motion.pulsation * motion.pulsation;
  scene.contact_damping = 2 * mu * motion.ratio * motion.pulsation;
  scene.stops = Stops::right;
  return scene;
}

constexpr double h = 1e-3;
// Contacts near the longest accepted steps: five steps per contact, and ten without damping.
constexpr Oscillation oscillations[] = {{310, 0}, {580, 0.1}, {470, 0.5}, {400, 0.9}};

// Compares one step with the reference. The tolerances are those of penetration and rate.
void expect_one_step(const Scene& scene, double of_depth, double of_rate) {
  using Kernel = Absorber<AtRunTime, HookeNewton, Moment, NoDrive, Float64>;
  const auto found = after_steps(accepted<Kernel>(scene, {0.1, 1, 0, 1}, h), 1).reading();
  const Sample exact = reference_at({Law::hooke_newton, scene, DriveKind::none}, h);
  ASSERT_GT(exact.contact_force, 0);
  EXPECT_NEAR(depth_of(scene, found), exact.penetration, of_depth);
  EXPECT_NEAR(found.v2 - found.v1, exact.v2 - exact.v1, of_rate);
}

// The plan's eight constants contain the whole series.
TEST(ClosedFormSteps, HookeNewtonInsideAContactIsExact) {
  for (const Oscillation& motion : oscillations)
    for (const double v : {0.5, 0.1, 0.0}) {
      SCOPED_TRACE(testing::Message() << motion.ratio << " " << v);
      Scene scene = free_pair(motion);
      scene.x2 = scene.clearance / 2 + 1e-3;
      scene.v2 = v;
      expect_one_step(scene, 1e-14, 1e-11);
    }
}

// In the step of the touch, the series ends with its fifth term. The error is below twice the sixth.
TEST(ClosedFormSteps, HookeNewtonArrivesWithinTheSixthTermOfItsSeries) {
  constexpr double speed = 0.5;
  for (const Oscillation& motion : oscillations)
    for (const double share : {0.25, 0.5, 0.75, 1.0}) {
      SCOPED_TRACE(testing::Message() << motion.ratio << " " << share);
      Scene scene = free_pair(motion);
      scene.x2 = scene.clearance / 2 - speed * h * (1 - share);
      scene.v2 = speed;
      // The derivatives of the acceleration in contact, a = w^2 d + 2 z w d'.
      const double t = share * h, w = motion.pulsation, c = 2 * motion.ratio * w;
      double d[8] = {0, speed}, sixth = 0;
      for (int n = 0; n < 6; ++n) {
        const double a = w * w * d[n] + c * d[n + 1];
        d[n + 2] = -a;
        sixth = std::abs(a);
      }
      // Without damping every other derivative is 0, and the next one bounds the error.
      const double bound = 2 * sixth * std::pow(t, 6) / 720 + 1e-13;
      expect_one_step(scene, bound * t, bound);
    }
}

// An impulsive impact on a main mass at rest. The step neglects (w0 t)^4/120 of the displacement, (w0 t)^4/24 of the
// velocity, and the contact time of 5e-7 s.
TEST(ClosedFormSteps, ImpulsiveSetsAMassSwingingAsInClosedForm) {
  constexpr double step = 1e-2, speed = 1;
  for (const double turn : {0.2, 0.5, 0.8})
    for (const double share : {0.3, 0.6, 0.95}) {
      Scene scene = undriven_scene();
      const double w = turn / step, t = share * step;
      scene.main_stiffness = scene.main_mass * w * w;
      scene.contact_stiffness = 1e17;
      scene.v2 = speed;
      scene.clearance = 0.05;
      scene.x2 = scene.clearance / 2 - speed * (step - t);
      using Kernel = Absorber<AtRunTime, Hertz, Impulsive, NoDrive, Float64>;
      const auto now = after_steps(accepted<Kernel>(scene, {0.1, 4, 0, 1}, step), 1).reading();
      const double kick = 2 * speed / (1 / scene.main_mass + 1 / scene.ball_mass), v1 = kick / scene.main_mass;
      const double fourth = std::pow(w * t, 4), contact = 1e-6 / t;
      EXPECT_NEAR(now.x1, v1 * std::sin(w * t) / w, v1 * t * (fourth / 120 + contact)) << turn << " " << share;
      EXPECT_NEAR(now.v1, v1 * std::cos(w * t), v1 * (fourth / 24 + contact)) << turn << " " << share;
      EXPECT_NEAR(now.v2, speed - kick / scene.ball_mass, 1e-12) << turn << " " << share;
    }
}

// A contact that is pressed far deeper than by an impact. Moment's longest step there is 0.9 rad of the contact's own
// oscillation. A main mass, pressed by its spring at the bound, oscillates against a heavy ball by less than a
// hundredth of the static penetration. Over six periods the error is below 3 % of the amplitude. At 2 rad, which also
// creates no energy, it would be a third.
TEST(LongestStep, APressedContactVibratesAsItShouldAtTheLongestStep) {
  using Kernel = Absorber<AtRunTime, Hertz, Moment, NoDrive, Float64>;
  Scene scene = undriven_scene();
  scene.main_stiffness = 900;
  scene.ball_mass = 1e4;
  scene.clearance = 0.01;
  scene.contact_stiffness = 1e8;
  scene.stops = Stops::right;
  scene.x1 = 0.09;
  const Bounds bounds{0.1, 1e-3, 0, 10};
  const double gap = scene.clearance / 2;
  const double at_rest = std::pow(scene.main_stiffness * scene.x1 / scene.contact_stiffness, 2.0 / 3);
  scene.x2 = scene.x1 + gap + 1.005 * at_rest;  // slightly off rest, so that it oscillates
  const double step = end_of(1e-6, 1e-2, [&](double longer) {
    return Kernel::PlanType::make(scene, bounds, longer).status == PlanStatus::ok;
  });
  auto kernel = accepted<Kernel>(scene, bounds, step);
  Reference reference({Law::hertz, scene, DriveKind::none});
  double amplitude = 0, worst = 0;
  for (int n = 1; n <= 50; ++n) {
    kernel.step();
    reference.advance(n * step);
    const auto now = kernel.reading();
    const Sample exact = reference.sample();
    amplitude = larger(amplitude, std::abs(exact.x2 - exact.x1 - gap - at_rest));
    worst = larger(worst, std::abs((now.x2 - now.x1) - (exact.x2 - exact.x1)));
  }
  EXPECT_EQ(kernel.fault(), Fault::none);
  EXPECT_GT(amplitude, 1e-3 * at_rest);
  EXPECT_LT(amplitude, 2e-2 * at_rest);
  EXPECT_LE(worst, 0.03 * amplitude);
}

}  // namespace
}  // namespace impact::host
