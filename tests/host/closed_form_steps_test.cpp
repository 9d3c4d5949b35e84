// Single steps of a contact against their closed forms, in double. In a long run the method's error hides a wrong or
// missing small term.

#include "kernel_test.hpp"

namespace impact::host {
namespace {

// The relative motion of two free masses at a Hooke-Newton stop: d'' = -w^2 d - 2 z w d', z < 1.
struct Oscillation {
  double pulsation, ratio;  // w, z

  struct State {
    double d, v;
  };
  State after(double t, State at) const {
    const double damped = pulsation * std::sqrt(1 - ratio * ratio), decay = ratio * pulsation;
    const double c = std::cos(damped * t), s = std::sin(damped * t), b = (at.v + decay * at.d) / damped;
    const double factor = std::exp(-decay * t), d = factor * (at.d * c + b * s);
    return {d, factor * (b * damped * c - at.d * damped * s) - decay * d};
  }
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
const std::vector<Oscillation> oscillations = {{310, 0}, {580, 0.1}, {470, 0.5}, {400, 0.9}};

// The plan's eight constants contain the whole series.
TEST(ClosedFormSteps, HookeNewtonInsideAContactIsExact) {
  for (const Oscillation& motion : oscillations)
    for (const double v : {0.5, 0.1, 0.0}) {
      Scene scene = free_pair(motion);
      const Oscillation::State start{1e-3, v};
      scene.x2 = scene.clearance / 2 + start.d;
      scene.v2 = start.v;
      const auto plan = Plan<Float64, HookeNewton, Moment, NoDrive>::make(scene, Bounds{0.1, 1, 0, 1}, h);
      ASSERT_EQ(plan.status, PlanStatus::ok) << motion.pulsation << " " << motion.ratio;
      Absorber<AtRunTime, HookeNewton, Moment, NoDrive, Float64> absorber(plan);
      absorber.step();
      const auto exact = motion.after(h, start);
      ASSERT_GT(exact.d, 0);
      const auto now = absorber.reading();
      EXPECT_NEAR(now.x2 - now.x1 - scene.clearance / 2, exact.d, 1e-14) << motion.ratio << " " << v;
      EXPECT_NEAR(now.v2 - now.v1, exact.v, 1e-11) << motion.ratio << " " << v;
    }
}

// In the step of the touch, the series ends with its fifth term. The error is below twice the sixth.
TEST(ClosedFormSteps, HookeNewtonArrivesWithinTheSixthTermOfItsSeries) {
  constexpr double speed = 0.5;
  for (const Oscillation& motion : oscillations)
    for (const double share : {0.25, 0.5, 0.75, 1.0}) {
      Scene scene = free_pair(motion);
      scene.x2 = scene.clearance / 2 - speed * h * (1 - share);
      scene.v2 = speed;
      const auto plan = Plan<Float64, HookeNewton, Moment, NoDrive>::make(scene, Bounds{0.1, 1, 0, 1}, h);
      ASSERT_EQ(plan.status, PlanStatus::ok);
      Absorber<AtRunTime, HookeNewton, Moment, NoDrive, Float64> absorber(plan);
      absorber.step();
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
      const auto exact = motion.after(t, {0, speed});
      const auto now = absorber.reading();
      EXPECT_NEAR(now.v2 - now.v1, exact.v, bound) << w << " " << motion.ratio << " " << share;
      EXPECT_NEAR(now.x2 - now.x1 - scene.clearance / 2, exact.d, bound * t)
          << w << " " << motion.ratio << " " << share;
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
      const auto plan = Plan<Float64, Hertz, Impulsive, NoDrive>::make(scene, Bounds{0.1, 4, 0, 1}, step);
      ASSERT_EQ(plan.status, PlanStatus::ok);
      Absorber<AtRunTime, Hertz, Impulsive, NoDrive, Float64> absorber(plan);
      absorber.step();
      const double kick = 2 * speed / (1 / scene.main_mass + 1 / scene.ball_mass), v1 = kick / scene.main_mass;
      const double fourth = std::pow(w * t, 4), contact = 1e-6 / t;
      const auto now = absorber.reading();
      EXPECT_NEAR(now.x1, v1 * std::sin(w * t) / w, v1 * t * (fourth / 120 + contact)) << turn << " " << share;
      EXPECT_NEAR(now.v1, v1 * std::cos(w * t), v1 * (fourth / 24 + contact)) << turn << " " << share;
      EXPECT_NEAR(now.v2, speed - kick / scene.ball_mass, 1e-12) << turn << " " << share;
    }
}

// A contact that is pressed far deeper than by an impact. Moment's longest step there is 0.9 rad of the contact's own
// oscillation. A main mass, pressed by its spring at the bound, oscillates against a heavy ball by less than a
// hundredth of the static penetration. Over six periods the error is below 3 % of the amplitude. At 2 rad, which also
// creates no energy, it would be a third. The reference is the leap-frog method with 200 times as many steps and an
// error of (0.74/200)^2/24 rad in each.
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
  const double gap = scene.clearance / 2, k1 = scene.contact_stiffness;
  const double at_rest = std::pow(scene.main_stiffness * scene.x1 / k1, 2.0 / 3);
  scene.x2 = scene.x1 + gap + 1.005 * at_rest;  // slightly off rest, so that it oscillates
  double step = 1e-6, refused = 1e-2;
  for (int i = 0; i < 50; ++i) {
    const double middle = (step + refused) / 2;
    (Kernel::PlanType::make(scene, bounds, middle).status == PlanStatus::ok ? step : refused) = middle;
  }
  Kernel kernel(Kernel::PlanType::make(scene, bounds, step));
  auto exact = kernel.reading();
  const auto kick = [&](double t) {
    const double d = exact.x2 - exact.x1 - gap, force = k1 * d * std::sqrt(d);
    exact.v1 += t * (force - scene.main_stiffness * exact.x1) / scene.main_mass;
    exact.v2 -= t * force / scene.ball_mass;
  };
  constexpr int parts = 200;
  double amplitude = 0, worst = 0;
  for (int n = 0; n < 50; ++n) {
    kernel.step();
    for (int i = 0; i < parts; ++i) {
      kick(step / parts / 2);
      exact.x1 += step / parts * exact.v1;
      exact.x2 += step / parts * exact.v2;
      kick(step / parts / 2);
    }
    const auto now = kernel.reading();
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
