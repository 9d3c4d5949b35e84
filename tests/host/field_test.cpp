// Weight and a shaken base: the reference against closed forms, and the kernel against both.

#include "against_reference.hpp"

namespace impact {
namespace {

constexpr double weight = 9.81;  // m/s^2

// A ball that falls onto a main mass too heavy to move.
Scene on_the_ground() {
  Scene scene;
  scene.main_mass = 1e6;
  scene.main_stiffness = 1e12;
  scene.drive_amplitude = 0;
  scene.gravity = -weight;
  scene.stops = Stops::left;
  scene.clearance = 0.1;
  scene.x1 = scene.x2 = -scene.main_mass * weight / scene.main_stiffness;
  scene.contact_stiffness = 1e12;
  scene.contact_damping = 0;
  return scene;
}

// The largest heights above the stop between impacts, and the middle instants of the impacts.
struct Bounces {
  std::vector<double> heights, instants;
  double last_speed = 0, entered = 0;
  bool was_inside = false;

  void see(double t, double height, double speed) {
    const bool inside = height <= 0;
    if (!inside && last_speed > 0 && speed <= 0) heights.push_back(height);
    if (!inside && was_inside) instants.push_back((entered + t) / 2);
    if (inside && !was_inside) entered = t;
    was_inside = inside;
    last_speed = speed;
  }
  void expect_heights(double e, double tolerance) const {
    ASSERT_GE(heights.size(), 2u);
    EXPECT_NEAR(heights[0], 0.05 * e * e, tolerance) << e;
    EXPECT_NEAR(heights[1], 0.05 * e * e * e * e, tolerance) << e;
  }
};

// A ball falls from 50 mm. After n impacts it rises to h0 e^(2n), and from impact to impact it flies for 2 e^n sqrt(2
// h0/g). Each contact adds its own time, some 0.03 ms. The samples are 0.01 ms apart.
TEST(Field, BallBouncesInTheReferenceAsInClosedForm) {
  for (const double e : {1.0, 0.7}) {
    const Law law = e < 1 ? Law::hunt_crossley : Law::hertz;
    const double damping_ratio = e < 1 ? Exact::damping_ratio(e) : 0;
    host::Reference reference({law, on_the_ground(), host::DriveKind::none, {}, 0, damping_ratio});
    Bounces bounces;
    const double step = 1e-5;
    for (int n = 1; n <= 60000; ++n) {
      reference.advance(n * step);
      const host::Sample now = reference.sample();
      bounces.see(now.t, now.x2 - now.x1 + 0.05, now.v2 - now.v1);
    }
    bounces.expect_heights(e, 1e-5);
    ASSERT_GE(bounces.instants.size(), 3u);
    const double flight = 2 * e * std::sqrt(2 * 0.05 / weight);
    EXPECT_NEAR(bounces.instants[1] - bounces.instants[0], flight, 6e-5) << e;
    EXPECT_NEAR(bounces.instants[2] - bounces.instants[1], e * flight, 6e-5) << e;
  }
}

template <class Format> class FieldIn : public testing::Test {};
using Formats = testing::Types<Float64, Float32, Fixed32>;
TYPED_TEST_SUITE(FieldIn, Formats);

// Impulsive contacts take no time.
TYPED_TEST(FieldIn, BallBouncesInTheKernelAsInClosedForm) {
  for (const double e : {1.0, 0.7}) {
    Scene scene = on_the_ground();
    scene.restitution = e;
    const double step = 1e-4;
    auto absorber = accepted<Absorber<AtRunTime, Exact, Impulsive, NoDrive, TypeParam, Gravity>>(scene, {0.12}, step);
    Bounces bounces;
    for (int n = 1; n <= 6000; ++n) {
      absorber.step();
      const auto now = absorber.reading();
      bounces.see(n * step, now.x2 - now.x1 + 0.05, now.v2 - now.v1);
    }
    EXPECT_EQ(absorber.fault(), Fault::none);
    // The phase of an impact within its step changes the height by up to half a step's displacement.
    bounces.expect_heights(e, 3e-5);
  }
}

// An upright rig with 1 mm of travel to each side.
Scene narrow_and_damped() {
  Scene scene;
  scene.gravity = weight;
  scene.drive_amplitude = 0;
  scene.main_damping = 2;
  scene.clearance = 0.002;
  return scene;
}

// Places the ball at rest on its stop and the main mass in its equilibrium.
void place_at_rest(Scene& scene, double penetration) {
  scene.x1 = (scene.main_mass + scene.ball_mass) * weight / scene.main_stiffness;
  scene.x2 = scene.x1 + scene.clearance / 2 + penetration;
}
constexpr Bounds bounds_at_rest{0.05, 0.3};

template <class Law> double static_penetration(const Scene& scene) {
  const double ratio = scene.ball_mass * weight / scene.contact_stiffness;
  return Law::is_linear ? ratio : std::pow(ratio, 2.0 / 3);
}

// The penetration stays at (m g/k1)^(2/3), or m g/k1, for 10 s. The error is the rounding of a penetration of 2 mm and
// of its rate.
template <class Law, class Stepper, class Format> void expect_rest(double tolerance, int lead) {
  Scene scene = narrow_and_damped();
  if (Law::is_linear) scene.contact_damping = 5;
  const double penetration = static_penetration<Law>(scene);
  place_at_rest(scene, penetration);
  using Weighted = Absorber<AtRunTime, Law, Stepper, NoDrive, Format, Gravity>;
  auto absorber = after_steps(accepted<Weighted>(scene, bounds_at_rest, 1e-4), lead);
  for (int n = 0; n < 100000; ++n) {
    absorber.step();
    const auto now = absorber.reading();
    ASSERT_LT(std::abs(depth_of(scene, now) - penetration), tolerance) << n;
    ASSERT_LT(std::abs(now.v2 - now.v1), tolerance / 1e-4) << n;
    ASSERT_LT(std::abs(now.x1 - scene.x1), 10 * tolerance) << n;
  }
  EXPECT_EQ(absorber.fault(), Fault::none);
}
template <class Law, class Stepper> void expect_rest_in_every_format(int lead = 0, double in_fixed32 = 2e-8) {
  expect_rest<Law, Stepper, Float64>(1e-9, lead);
  expect_rest<Law, Stepper, Fixed32>(in_fixed32, lead);
  expect_rest<Law, Stepper, Float32>(2e-8, lead);
}
// The classical schemes do not apply the initial force of a contact that exists at the start. Their first step has an
// error of h^2/4 of the load's acceleration. They have 30 s to settle.
TEST(Field, BallRestsAtItsStaticPenetration) {
  expect_rest_in_every_format<HuntCrossley, Moment>();
  // An LSB of a sub-step's impulse is 5.7e-14 m and moves the equilibrium by 4^2/(h omega)^2 of that. With (h omega)^2
  // = 9.5e-5 this is 9.6e-9 m. J0 rounds four products.
  expect_rest_in_every_format<HuntCrossley, SubsteppedMoment<4>>(0, 4e-8);
  expect_rest_in_every_format<HuntCrossley, EnergyConsistent>();
  expect_rest_in_every_format<HuntCrossley, AverageAcceleration>(300000);
  expect_rest_in_every_format<HookeNewton, Moment>();
  expect_rest_in_every_format<HookeNewton, SubsteppedMoment<4>>();
  expect_rest_in_every_format<HookeNewton, EnergyConsistent>();
  expect_rest_in_every_format<HookeNewton, AverageAcceleration>(300000);
}

// A ball at rest on a stop with this damping, c1/k1, in s/m. Its penetration is off by at most `worst` of itself in any
// step, and by `mean` on average.
template <class Law, class Stepper, class Format>
void expect_rest_on(double stiffness, double damping, int steps, bool is_corrected, double worst, double mean) {
  Scene scene = narrow_and_damped();
  scene.contact_stiffness = stiffness;
  scene.contact_damping = Law::is_damped ? damping * stiffness : 0;
  const double penetration = static_penetration<Law>(scene);
  place_at_rest(scene, penetration);
  auto absorber = accepted<Absorber<AtRunTime, Law, Stepper, NoDrive, Format, Gravity>>(scene, bounds_at_rest, 1e-4);
  if constexpr (std::is_same_v<Stepper, EnergyConsistent>) {
    ASSERT_TRUE(absorber.plan.contact.response.is_sudden);
  }
  double sum = 0;
  for (int n = 0; n < steps; ++n) {
    absorber.step();
    if (is_corrected) absorber.correct({}, {});
    const double off = depth_of(scene, absorber.reading()) / penetration - 1;
    ASSERT_LE(std::abs(off), worst) << stiffness << (is_corrected ? ", corrected" : "") << ", step " << n;
    sum += off;
  }
  EXPECT_LE(std::abs(sum / steps), mean) << stiffness;
  EXPECT_EQ(absorber.fault(), Fault::none);
}

// A contact that begins inside the stop starts with its load, so nothing oscillates. Corrections of 0 in every step do
// not change the equilibrium. Damping changes the load by h c/(3 M) = 7e-5 in a step, which is its error. With h omega
// = 0.08 and 0.16 the contact moves by (h omega)^2 of that, 2e-6.
TEST(Field, NothingOscillatesAtTheStartOrUnderZeroCorrections) {
  for (const double stiffness : {1e7, 8e7})
    for (const bool is_corrected : {false, true}) {
      const auto expect = [=](auto stepper, auto format) {
        expect_rest_on<HuntCrossley, decltype(stepper), decltype(format)>(stiffness, 0.2, 10000, is_corrected, 2e-6,
                                                                          2e-6);
      };
      expect(Moment{}, Float64{});
      expect(Moment{}, Float32{});
      expect(Moment{}, Fixed32{});
      expect(SubsteppedMoment<4>{}, Float64{});
    }
}

// Under weight a strongly damped contact takes hundreds of steps. The step is the longest in which EnergyConsistent
// evaluates its force once. A ball that starts 1 % too deep settles. From h c/mu = 1/4 on, it would oscillate from step
// to step (kernel/docs/energy.md).
TEST(Field, StronglyDampedContactSettles) {
  using Absorber = Absorber<AtRunTime, HuntCrossley, EnergyConsistent, NoDrive, Float64, Gravity>;
  constexpr Bounds bounds{0.0145, 0.003};  // slightly above the equilibrium
  for (const double ratio : {1e1, 1e2, 1e3, 1e4}) {
    Scene scene = narrow_and_damped();
    scene.contact_stiffness = 3e6;
    scene.contact_damping = ratio * scene.contact_stiffness;
    const double penetration = static_penetration<HuntCrossley>(scene);
    place_at_rest(scene, 1.01 * penetration);
    double step = 1e-3;
    auto plan = Absorber::PlanType::make(scene, bounds, step);
    while (plan.status != PlanStatus::ok || plan.contact.response.is_sudden)
      plan = Absorber::PlanType::make(scene, bounds, step *= 0.98);
    auto absorber = after_steps(Absorber(plan), 20000);
    const auto depth = [&] { return depth_of(scene, absorber.reading()); };
    for (int n = 0; n < 100; ++n) {
      const double before = depth();
      absorber.step();
      ASSERT_LE(std::abs(depth() - before), 1e-4 * penetration) << ratio << ", step " << step;
    }
  }
}

// A stiff contact under weight, with bounds of 30 to 140 times what the motion reaches. The weight's change of speed in
// a step is large compared with the rate. A position correction for which no energy was available used to gain up to
// 3.3 % of the energy.
TEST(Field, AStiffContactUnderWeightGainsNothingInWideBounds) {
  struct Found {
    Scene scene;
    Stops stops;
    double gravity, displacement, speed, step;
  };
  constexpr Found all[] = {
      {scene_of(3.31277166, 475669.021, 0, 997.690323, 0.515134469, 2.33231644e9, 80099333.4, 0, 40, 0, 0, -0.257659799,
                0),
       Stops::left, -0.294260834, 7.75670419, 7.49232826, 0.000695971205},
      {scene_of(101.344053, 51088435.2, 0, 10664.0672, 0.000315976613, 4.98328793e11, 0, 0, 40, 2.8035319e-07,
                8.145691e-05, 0.000158762112, 0),
       Stops::right, 0.0124289864, 0.0162863564, 0.136607487, 0.00096865881},
      {scene_of(70.8979058, 2.23883002e10, 0, 439.833595, 0.00277456099, 5.03494916e14, 0, 0, 40, 0, 0, 0.00138979751,
                0),
       Stops::right, 1138.47275, 0.0430428545, 13.5371907, 1.56920922e-05},
      {scene_of(7.25252815, 8.7154845e9, 0, 1.26685424, 0.0159141774, 1.09433016e12, 0, 0, 40, 0, 0, 0.00796140225, 0),
       Stops::right, 3696.08542, 0.239065377, 9.01041463, 2.06046969e-05}};
  for (const Found& found : all) {
    Scene scene = found.scene;
    scene.stops = found.stops;
    scene.gravity = found.gravity;
    using Kernel = Absorber<AtRunTime, HuntCrossley, EnergyConsistent, NoDrive, Float64, Gravity>;
    auto absorber = accepted<Kernel>(scene, {found.displacement, found.speed, 0, 0}, found.step);
    const double at_start = energy_with_weight(scene, scene) + stored_at(scene, depth_of(scene, scene));
    const double size = scene.main_stiffness * scene.x1 * scene.x1 / 2 + std::abs(at_start) * 1e-9;
    double most = 0, gain = -1e300;
    for (int n = 0; n < 2000; ++n) {
      absorber.step();
      const auto now = absorber.reading();
      most =
          larger(most, scene.gravity * (scene.main_mass * (now.x1 - scene.x1) + scene.ball_mass * (now.x2 - scene.x2)));
      if (absorber.is_touching() || depth_of(scene, now) > 0) continue;
      gain = larger(gain, energy_with_weight(scene, now) - at_start);
    }
    EXPECT_LE(gain, 1e-6 * (most + size)) << scene.main_mass;
  }
}

// EnergyConsistent solves a contact in closed form if the step does not resolve it, here with h omega from 0.3 to 3.
// Its penetration is a power 4/5 with an error of 4.4e-5, plus that of a position correction.
TEST(Field, BallRestsAtItsStaticPenetrationInAStiffContact) {
  for (const double stiffness : {1e9, 1e10, 1e11, 1e12}) {
    const auto expect = [=](auto law, auto format) {
      expect_rest_on<decltype(law), EnergyConsistent, decltype(format)>(stiffness, 2, 50000, false, 3e-3, 1.5e-4);
    };
    expect(Hertz{}, Float64{});
    expect(HuntCrossley{}, Float64{});
    expect(HuntCrossley{}, Float32{});
    expect(HuntCrossley{}, Fixed32{});
  }
}

// With Impulsive, the ball comes to rest at the stop's face or up to V tc/pi inside it, for any phase of its last
// impacts. V = (2/pi) (1 + m/M) a tc is the lowest speed at which an impact lifts the ball out
// (kernel/docs/impulsive.md).
TYPED_TEST(FieldIn, BallSettlesOnAnImpulsiveStop) {
  const double pi = 3.141592653589793;
  Random random;
  int accepted = 0;
  for (int i = 0; i < 40; ++i) {
    Scene scene = narrow_and_damped();
    scene.clearance = random.wide(1e-3, 1e-2);
    scene.ball_mass = random.wide(0.1, 3);
    scene.restitution = random.between(0.15, 0.6);
    scene.contact_stiffness = random.wide(3e9, 1e11);
    scene.gravity = random.wide(1, weight);
    scene.x1 = scene.x2 = (scene.main_mass + scene.ball_mass) * scene.gravity / scene.main_stiffness;
    host::Impact slowest{Law::hunt_crossley, scene.contact_stiffness, 0,
                         1 / (1 / scene.main_mass + 1 / scene.ball_mass), 1e-3};
    double time = 0;
    for (int pass = 0; pass < 100; ++pass) {
      slowest.contact_damping = host::contact_damping(slowest, scene.restitution).value();
      time = host::contact_time(slowest).value();
      slowest.speed = 2 / pi * (1 + scene.ball_mass / scene.main_mass) * scene.gravity * time;
    }
    const double depth = slowest.speed * time / pi;
    using Absorber = Absorber<AtRunTime, Exact, Impulsive, NoDrive, TypeParam, Gravity>;
    const auto plan = Absorber::PlanType::make(scene, {0.1, 0.5}, 1e-4);
    if (plan.status == PlanStatus::contact_time) continue;  // the field changes the speed too much during a contact
    ASSERT_EQ(plan.status, PlanStatus::ok);
    ++accepted;
    auto absorber = after_steps(Absorber(plan), 100000);
    for (int n = 0; n < 1000; ++n) {
      absorber.step();
      const auto now = absorber.reading();
      const double inside = now.x2 - now.x1 - scene.clearance / 2;
      ASSERT_GT(inside, -1e-8) << i << ' ' << n;
      ASSERT_LT(inside, depth + 1e-8) << i << ' ' << n;
      ASSERT_LT(std::abs(now.v2 - now.v1), 1e-5) << i << ' ' << n;
    }
    EXPECT_EQ(absorber.fault(), Fault::none);
  }
  EXPECT_GE(accepted, 30);
}

// A main mass on a spring and a damper moves up and down with the ball on its stop, until both rest. The stop's force
// does no work, for any damping and any mass of the ball. The masses stay together, since they start an eighth of the
// static displacement away from rest. Energies are relative to the weight's work over the static displacement. The
// tolerance is 40 LSBs of a double, for a sum of five terms, or one LSB of a float. In Fixed32 an LSB of a position is
// 2^-33 m. Both weights, spring and damper each round by the spring's force for an LSB, which does work over a step's
// displacement.
TYPED_TEST(FieldIn, BallOnAnImpulsiveStopMovesAlongWithoutGain) {
  constexpr bool is_double = impact::is_double<TypeParam>;
  const double h = 1e-3;
  for (const double turn : {0.05, 0.2, 0.49})
    for (const double damping : {0.001, 0.01, 0.1, 0.9})
      for (const double ratio : {0.3, 3.0, 30.0})
        for (const double away : {0.875, 1.125})
          for (const bool is_corrected : {false, true}) {
            SCOPED_TRACE(testing::Message()
                         << turn << " " << damping << " " << ratio << " " << away << " " << is_corrected);
            Scene scene;
            scene.drive_amplitude = scene.drive_pulsation = 0;
            scene.main_mass = 1;
            scene.ball_mass = ratio;
            scene.main_stiffness = turn * turn / (h * h);
            scene.main_damping = damping / h;
            scene.contact_stiffness = 1e16;
            scene.contact_damping = 0;
            scene.gravity = weight;
            const double sag = (1 + ratio) * weight / scene.main_stiffness;
            scene.x1 = away * sag;
            scene.x2 = scene.x1 + scene.clearance / 2;
            using Absorber = Absorber<AtRunTime, Hertz, Impulsive, NoDrive, TypeParam, Gravity>;
            auto absorber = after_steps(accepted<Absorber>(scene, {2 * sag + 0.05, 3, 0, 0}, h), 4);
            const double swing = (1 + ratio) * weight * sag;
            const auto energy = [&] {
              const auto now = absorber.reading();
              return ((now.v1 * now.v1 + ratio * now.v2 * now.v2 + scene.main_stiffness * now.x1 * now.x1) / 2 -
                      weight * (now.x1 + ratio * (now.x2 - scene.clearance / 2))) /
                     swing;
            };
            double before = energy(), gain = 0;
            for (int n = 0; n < 2000; ++n) {
              absorber.step();
              if (is_corrected) absorber.correct({}, {});
              const double now = energy();
              gain = larger(gain, now - before);
              before = now;
            }
            const double displacement = sag / 8 * turn / std::sqrt(1 + ratio), lsb = 4 * scene.main_stiffness * 0x1p-33;
            const double of_forces = std::is_same_v<TypeParam, Fixed32> ? lsb * displacement / swing : 0;
            EXPECT_LE(gain, (is_double ? 40 * 0x1p-52 : 0x1p-24) + of_forces);
            const auto now = absorber.reading();
            EXPECT_NEAR(now.x2 - now.x1, scene.clearance / 2, is_double ? 1e-15 : 1e-9);
            const bool has_come_to_rest = damping == 0.1 && ratio < 30;
            if (has_come_to_rest) {
              EXPECT_NEAR(now.x1, sag, is_double ? 1e-10 * sag : 0x1p-22 * sag + 4 * 0x1p-33);
            }
            EXPECT_EQ(absorber.fault(), Fault::none);
          }
}

// An observer corrects the main mass in every step, by 0 or by alternating displacements. A ball at rest on either stop
// stays in one contact and sinks by no more than the rounding of positions. If a correction exceeds the weight's change
// of speed in a step, the ball bounces with the law's restitution.
TYPED_TEST(FieldIn, CorrectedBallStaysOnAnImpulsiveStop) {
  using Absorber = Absorber<AtRunTime, Exact, Impulsive, NoDrive, TypeParam, Gravity, ImpactLog>;
  const double h = 1e-3, restitution = 0.3;
  const double rounding = std::is_same_v<TypeParam, Float64> ? 1e-15 : 1e-9;
  for (const bool left : {false, true})
    for (const double by : {0.0, 1e-7, 1e-5}) {
      SCOPED_TRACE(testing::Message() << left << " " << by);
      const double side = left ? -1 : 1;
      Scene scene;
      scene.drive_amplitude = scene.drive_pulsation = 0;
      scene.main_stiffness = 2500;
      scene.main_damping = 20;
      scene.contact_stiffness = 1e16;
      scene.restitution = restitution;
      scene.gravity = side * weight;
      scene.x1 = side * (scene.main_mass + scene.ball_mass) * weight / scene.main_stiffness;
      scene.x2 = scene.x1 + side * scene.clearance / 2;
      auto absorber = after_steps(accepted<Absorber>(scene, {0.1, 1, 0, 0}, h), 4);
      const auto native = [](double x, double unit) { return TypeParam::sample(x / unit); };
      const uint32_t impacts = absorber.state().impacts;
      double deepest = 0;
      for (int n = 0; n < 20000; ++n) {
        absorber.step();
        absorber.correct(native(n % 2 == 0 ? by : -by, absorber.displacement_unit()), {});
        const auto now = absorber.reading();
        deepest = larger(deepest, side * (now.x2 - now.x1) - scene.clearance / 2);
        ASSERT_TRUE(by > 0 || absorber.is_touching()) << n;
      }
      EXPECT_LE(deepest, rounding);
      if (by > 0) continue;
      EXPECT_EQ(absorber.state().impacts, impacts);
      const double speed = 0.2;
      absorber.correct({}, native(-side * speed, absorber.velocity_unit()));
      absorber.step();
      const auto now = absorber.reading();
      // Within the step, the weight changes the rate by up to (1 + m/M) g h.
      EXPECT_NEAR(side * (now.v2 - now.v1), -restitution * speed, 2 * weight * h);
    }
}

// With Impulsive no step increases the energy of masses, main spring, weight and constant drive, except for rounding.
// The limit is relative to the largest kinetic energy so far. Rounding matters most with balls of 1e-3 or 1e3 main
// masses.
TEST(Field, ImpulsiveStopsMakeNoEnergyInAnyStep) {
  using Absorber = Absorber<AtRunTime, Hertz, Impulsive, Sampled, Float64, Gravity>;
  Random random;
  const auto any = [&random](double most) { return random.between(-most, most); };
  const double h = 1e-3;
  int accepted = 0, impacts = 0;
  for (int n = 0; n < 20000; ++n) {
    Scene scene;
    scene.drive_amplitude = scene.drive_pulsation = scene.contact_damping = 0;
    scene.main_mass = 1;
    scene.ball_mass = random.wide(1e-3, 1e3);
    const double mu = scene.ball_mass / (1 + scene.ball_mass), turn = random.wide(1e-3, 0.99);
    scene.main_stiffness = turn * turn / (h * h);
    scene.main_damping = random.wide(1e-3, 0.9) / h;
    scene.contact_stiffness = 1.25 * mu * std::pow(2.943 / (random.wide(0.02, 20) * h), 2.5);
    scene.clearance = random.wide(1, 50) * h;
    scene.stops = n % 3 == 0 ? Stops::both : n % 3 == 1 ? Stops::left : Stops::right;
    scene.v1 = any(1);
    scene.v2 = any(1);
    scene.x1 = any(1) * h / turn;
    scene.x2 = scene.x1 + any(0.499) * scene.clearance;
    scene.gravity = any(1) < 0 ? random.wide(1e-4, 100) : -random.wide(1e-4, 100);
    const double force = any(1) * scene.main_stiffness * h / turn;
    const Bounds bounds{
        2 * (std::abs(scene.x1) + 5 * h / turn + std::abs(force) / scene.main_stiffness) + 2 * scene.clearance,
        2 + 2 * std::abs(force) * h, 0, std::abs(force) + 1};
    Absorber absorber(Absorber::PlanType::make(scene, bounds, h));
    if (absorber.fault() == Fault::plan) continue;
    ++accepted;
    double before = 0, most = 0;
    bool touched = false;
    for (int step = 0; step < 60; ++step) {
      absorber.step(force);
      if (absorber.fault() != Fault::none) break;  // the ball has passed its bound
      const auto now = motion_of_state(absorber);
      const double energy = energy_with_weight(scene, now) - force * now.x1,
                   strain = scene.main_stiffness * now.x1 * now.x1 / 2;
      most = larger(most, kinetic_energy(scene, now));
      // In the first step the force rises linearly from 0.
      ASSERT_TRUE(step < 2 || energy - before <= 1e-10 * most + 1e-13 * (strain + std::abs(force * now.x1)))
          << n << ", step " << step << ": " << energy - before;
      before = energy;
      impacts += absorber.is_touching() && !touched;
      touched = absorber.is_touching();
    }
  }
  EXPECT_GE(accepted, 8000);
  EXPECT_GE(impacts, 5000);
}

// The damper takes little energy in a step in which an elastic impact stops the main mass early. There the error of the
// impact's response counts most. The limit is that of docs/impulsive.md.
TEST(Field, ImpulsiveImpactThatStopsADampedMassGainsLittle) {
  using Absorber = Absorber<AtRunTime, Hertz, Impulsive, NoDrive, Float64>;
  Random random;
  const double h = 1e-3;
  double most = 0;
  for (int n = 0; n < 100000; ++n) {
    const double damping = random.between(1e-3, 0.1), turn = random.between(0, 0.99);  // c h/M, w0 h
    Scene scene;
    scene.drive_amplitude = scene.contact_damping = 0;
    scene.main_mass = 1;
    scene.main_stiffness = turn * turn / (h * h);
    scene.main_damping = damping / h;
    scene.ball_mass = random.wide(0.1, 30);
    scene.contact_stiffness = 1e14;
    scene.clearance = random.wide(1e-5, 1e-2);
    scene.x1 = n % 2 == 0 ? 0 : random.between(-1e-3, 1e-3);
    scene.x2 = scene.x1 + random.between(-0.5, 0.5) * scene.clearance;
    scene.v1 = random.between(-1, 1);
    scene.v2 = scene.v1 * (1 - 1 / scene.ball_mass) / 2 * random.between(0.98, 1.02);
    Absorber absorber(Absorber::PlanType::make(scene, {1, 20, 0, 1}, h));
    if (absorber.fault() == Fault::plan) continue;
    const double before = energy_with_weight(scene, absorber.reading());
    absorber.step();
    const double gain = energy_with_weight(scene, absorber.reading()) / before - 1;
    ASSERT_LE(gain, std::pow(damping, 3)) << n << ", c h/M " << damping << ", w0 h " << turn;
    most = larger(most, gain);
  }
  EXPECT_GE(most, 1e-5);  // such steps were found
}

struct Fields {
  double gravity;
  bool is_shaken;
};

// The largest difference of a displacement from the reference over 0.4 s. An accelerometer of the base has a reading
// every 2 ms.
template <class Law, class Stepper, class Format> double error(const Fields& fields, double step) {
  constexpr double duration = 0.4, interval = 2e-3;
  host::Case run = hanging_case(Law::law, fields.gravity);
  using Weighted = Absorber<AtRunTime, Law, Stepper, Sine, Format, Gravity>;
  if (!fields.is_shaken) return differences<Weighted>(run, {0.2, 3}, step, duration, interval).largest();
  run.base_step = interval;
  for (int n = 0; n * interval < duration + interval; ++n)
    run.base_samples.push_back(12 * std::sin(0.1 * n) + 3 * std::sin(0.342 * n));
  using Shaken = Absorber<AtRunTime, Law, Stepper, Sine, Format, BaseAcceleration>;
  return differences<Shaken>(run, {0.2, 3, 0, 10, 20}, step, duration, interval).largest();
}

constexpr Fields every_field[] = {{-weight, false}, {0, true}, {-weight, true}};

// The orders are those without a field: fourth or second. In 32 bits the error falls to that of rounding.
TEST(Field, KernelKeepsItsOrderInAField) {
  for (const Fields& fields : every_field) {
    const auto falls = [&](double coarse, double fine, double least) {
      EXPECT_GT(std::log2(coarse / fine) / 2, least)
          << fields.gravity << fields.is_shaken << ' ' << coarse << ' ' << fine;
    };
    using M = Moment;
    using E = EnergyConsistent;
    falls(error<HuntCrossley, M, Float64>(fields, 1e-3), error<HuntCrossley, M, Float64>(fields, 2.5e-4), 3.5);
    falls(error<HookeNewton, M, Float64>(fields, 1e-3), error<HookeNewton, M, Float64>(fields, 2.5e-4), 2);
    // With weight and base together the order is 1.49.
    falls(error<HuntCrossley, E, Float64>(fields, 1e-3), error<HuntCrossley, E, Float64>(fields, 2.5e-4), 1.4);
    falls(error<HuntCrossley, AverageAcceleration, Float64>(fields, 1e-3),
          error<HuntCrossley, AverageAcceleration, Float64>(fields, 2.5e-4), 1.5);
    EXPECT_LT((error<HuntCrossley, SubsteppedMoment<4>, Float64>(fields, 1e-3)), 2e-9);
    EXPECT_LT((error<HuntCrossley, M, Float64>(fields, 1e-3)), 5e-8);
    EXPECT_LT((error<HuntCrossley, M, Fixed32>(fields, 2.5e-4)), 2e-7);
    EXPECT_LT((error<HuntCrossley, M, Float32>(fields, 2.5e-4)), 2e-7);
    EXPECT_LT((error<HuntCrossley, M, Float32Plain>(fields, 2.5e-4)), 1e-5);
  }
}

}  // namespace
}  // namespace impact
