// The reference against closed forms and itself, and the measures of error. accuracy_test.cpp compares it with the
// kernel, and textbook_newmark_test.cpp with other integrations.

#include "against_reference.hpp"
#include "paper_runs.hpp"

namespace impact::host {
namespace {

struct Variant {
  const char* name;
  Law law;
  Tension tension;
};
constexpr Variant variants[] = {{"hooke-newton, clamped", Law::hooke_newton, Tension::clamp},
                                {"hooke-newton, tension allowed", Law::hooke_newton, Tension::allow},
                                {"hertz, clamped", Law::hertz, Tension::clamp},
                                {"hertz, tension allowed", Law::hertz, Tension::allow},
                                {"hunt-crossley, clamped", Law::hunt_crossley, Tension::clamp},
                                {"hunt-crossley, tension allowed", Law::hunt_crossley, Tension::allow}};

Case paper_case(const Variant& variant) { return {variant.law, paper_scene(variant.law, variant.tension)}; }

// A pair without spring, damper or drive. The ball starts 10 mm from its only stop, at `side`, and approaches it at 0.8
// m/s.
Case free_pair(const Variant& variant, int side) {
  Case run = paper_case(variant);
  run.drive = DriveKind::none;
  run.scene.main_stiffness = run.scene.main_damping = 0;
  run.scene.v2 = 0.8 * side;
  run.scene.stops = side > 0 ? Stops::right : Stops::left;
  return run;
}

// x1 of a main mass whose ball never touches.
double lone_x1(Case run, double t) {
  run.scene.clearance = 1e6;
  return reference_at(run, t).x1;
}

TEST(ReferenceFlight, DampedVibration) {
  for (const double c : {0.0, 0.01, 20.0, 2 * std::sqrt(1000.0), 200.0}) {  // undamped to overdamped
    Case run;
    run.drive = DriveKind::none;
    run.scene.main_damping = c;
    run.scene.x1 = 0.01;
    run.scene.v1 = 0.3;
    const double decay = c / 2, t = 0.7, square = 1000 - decay * decay;
    const double w = std::sqrt(std::abs(square)), slope = run.scene.v1 + decay * run.scene.x1;
    const bool critical = std::abs(square) < 1e-9;
    const double cosine = critical ? 1 : square > 0 ? std::cos(w * t) : std::cosh(w * t);
    const double sine = critical ? t : (square > 0 ? std::sin(w * t) : std::sinh(w * t)) / w;
    // The closed form rounds by 1e-15: its terms are below 0.02 m and its argument is below 32.
    EXPECT_NEAR(lone_x1(run, t), std::exp(-decay * t) * (run.scene.x1 * cosine + slope * sine), 1e-15) << c;
  }
}

TEST(ReferenceFlight, ResonanceWithoutDamping) {
  Case run;
  run.scene.main_damping = 0;
  const double w = run.scene.drive_pulsation = std::sqrt(1000.0), t = 3;
  // The equation is x1'' + w^2 x1 = (F0/M) sin w t, from rest. The rounding of w moves the phase of 95 rad by 1e-14.
  EXPECT_NEAR(lone_x1(run, t), 10 / (2 * w * w) * (std::sin(w * t) - w * t * std::cos(w * t)), 1e-14);
}

TEST(ReferenceFlight, FreeMainMass) {
  Case run;
  run.scene.main_stiffness = run.scene.main_damping = 0;
  EXPECT_NEAR(lone_x1(run, 2), 10.0 / 40 * (2 - std::sin(80.0) / 40), 1e-15);
}

TEST(ReferenceFlight, DriveOfNoPulsationIsNone) {
  Case run;
  run.scene.drive_pulsation = 0;
  EXPECT_EQ(lone_x1(run, 1), 0);
}

TEST(ReferenceFlight, SampledDriveIsLinearBetweenSamples) {
  Case run;
  run.drive = DriveKind::sampled;
  run.samples = {0, 6, 0};
  run.sample_step = 0.5;
  run.scene.main_stiffness = run.scene.main_damping = 0;
  run.scene.main_mass = 2;
  EXPECT_NEAR(lone_x1(run, 0.5), 0.125, 1e-16);     // (1/M) 12 t^3 / 6
  EXPECT_NEAR(lone_x1(run, 1), 0.75, 1e-15);        // then 0.75 m/s, and a force that falls from 6 N
  EXPECT_NEAR(lone_x1(run, 4), 0.75 + 4.5, 1e-14);  // then 1.5 m/s
  EXPECT_DOUBLE_EQ(drive_force(run, 0.75), 3);
  EXPECT_DOUBLE_EQ(drive_force(run, 9), 0);
}

void expect_single_impact(const Case& run, int side) {
  const Impact impact{run.law,          run.scene.contact_stiffness, run.scene.contact_damping, 0.3 / 1.3, 0.8,
                      run.scene.tension};
  const double duration = contact_time(impact).value(), start = 0.01 / 0.8;
  constexpr double tolerance = 1e-11;

  const Sample after = reference_at(run, start + 2 * duration);
  const double rebound = -side * (after.v2 - after.v1);
  EXPECT_NEAR(rebound / 0.8 / *restitution(impact), 1, tolerance);
  EXPECT_NEAR(after.energy_dissipated, *energy_lost(impact), tolerance * 0.3 / 1.3 * 0.32);
  EXPECT_NEAR(after.peak_force / *peak_force(impact), 1, tolerance);
  EXPECT_EQ(after.impacts, 1);
  EXPECT_EQ(after.contact_force, 0);
  EXPECT_NEAR(after.v1 + 0.3 * after.v2, 0.3 * 0.8 * side, 1e-15);  // momentum is conserved

  const double late = start + 2 * duration;
  const double deepest = end_of(start, late, [&](double t) {
    const Sample s = reference_at(run, t);
    return s.t <= start || side * (s.v2 - s.v1) > 0;
  });
  EXPECT_NEAR(reference_at(run, deepest).penetration / *peak_penetration(impact), 1, tolerance);
  const double separation =
      end_of(start, late, [&](double t) { return t <= start || reference_at(run, t).contact_force != 0; });
  EXPECT_NEAR((separation - start) / duration, 1, tolerance + 4e-18 / duration);  // the resolution of t in double
}

TEST(ReferenceImpact, AgreesWithClosedForms) {
  for (const Variant& variant : variants) {
    SCOPED_TRACE(variant.name);
    for (const int side : {-1, 1}) expect_single_impact(free_pair(variant, side), side);
    for (const double stiffness : {1e8, 1e10, 1e12}) {
      SCOPED_TRACE(stiffness);
      Case run = free_pair(variant, 1);
      run.scene.contact_stiffness = stiffness;
      const Impact impact{run.law, stiffness, 0, 0.3 / 1.3, 0.8, run.scene.tension};
      run.scene.contact_damping = contact_damping(impact, 0.7).value_or(0);
      expect_single_impact(run, 1);
    }
  }
  Case overdamped = free_pair(variants[0], 1);  // separates at zero force
  overdamped.scene.contact_damping = 1000;      // zeta = 5.8
  expect_single_impact(overdamped, 1);
}

TEST(ReferenceImpact, DampingPerImpactKeepsTheRestitution) {
  for (const double speed : {0.1, 0.8, 3.0}) {
    Case run = free_pair(variants[4], 1);
    run.damping_ratio = 3 * (1 - 0.68) / 2;
    run.scene.contact_damping = 0;
    run.scene.v2 = speed;
    const Sample after = reference_at(run, 1);
    EXPECT_NEAR((after.v1 - after.v2) / speed, 0.7561486807, 5e-11) << speed;  // ten digits
  }
}

TEST(ReferenceImpact, StartsInsideAStop) {
  const double depth = 4e-3, mu = 0.3 / 1.3;
  for (const int side : {-1, 1}) {
    Case run = free_pair(variants[2], side);
    run.scene.v2 = 0;
    run.scene.x2 = side * (0.01 + depth);
    const Sample after = reference_at(run, 0.1);
    EXPECT_NEAR(-side * (after.v2 - after.v1), std::sqrt(0.8 * 32600 * std::pow(depth, 2.5) / mu), 1e-13);
    EXPECT_EQ(after.impacts, 0);
  }
  // If the ball leaves faster than k1/c1, a clamped Hunt-Crossley stop exerts no force. The unclamped law pulls.
  Case run = free_pair(variants[4], 1);
  run.scene.x2 = 0.01 + depth;
  run.scene.v2 = -2;  // k1 / c1 = 1.67 m/s
  EXPECT_EQ(reference_at(run, 0.1).v2, -2);
  EXPECT_EQ(reference_at(run, 0).contact_force, 0);
  run.scene.tension = Tension::allow;
  const Sample late = reference_at(run, 0.1);
  EXPECT_GT(late.v2, -2);
  EXPECT_LT(late.v2 - late.v1, -32600.0 / 19560);
  EXPECT_LT(reference_at(run, 0).contact_force, 0);
}

// The ball is at rest. The main mass oscillates as 10 mm (1 + excess) sin w0 t, so only the excess makes it touch.
TEST(ReferenceContact, GrazingIsNotMissed) {
  for (const Variant& variant : variants)
    for (const double excess : {-1e-12, 1e-12, 1e-9, 1e-6}) {
      Case run = free_pair(variant, 1);
      run.scene.main_stiffness = 1000;
      run.scene.stops = Stops::both;
      run.scene.v2 = 0;
      run.scene.v1 = 0.01 * std::sqrt(1000.0) * (1 + excess);
      EXPECT_EQ(reference_at(run, 0.08).impacts, excess > 0 ? 1 : 0) << variant.name << ", " << excess;
    }
}

TEST(ReferenceContact, StopsThatAreNotThereAreNotHit) {
  Case run = free_pair(variants[4], 1);
  run.scene.stops = Stops::left;
  EXPECT_EQ(reference_at(run, 1).impacts, 0);
  EXPECT_NEAR(reference_at(run, 1).penetration, -0.81, 1e-15);
  run.scene.stops = Stops::right;
  EXPECT_EQ(reference_at(run, 1).impacts, 1);
}

// A constant force drives the left stop into the ball, whose bounces decay. In the end both masses have the same
// acceleration, and the contact force is m F/(M + m).
TEST(ReferenceContact, BouncingSettles) {
  for (const Variant& variant : variants) {
    if (variant.law == Law::hertz) continue;
    for (const double stiffness : {32600.0, 1e7}) {
      Case run = free_pair(variant, -1);
      run.drive = DriveKind::sampled;
      run.samples = {13};
      run.sample_step = 1;
      run.scene.v2 = 0;
      run.scene.contact_stiffness = stiffness;
      if (variant.law == Law::hunt_crossley) run.scene.contact_damping = 0.5 * stiffness;
      if (variant.law == Law::hooke_newton) run.scene.contact_damping = 0.1 * std::sqrt(stiffness);
      const Sample end = reference_at(run, 6);
      EXPECT_NEAR(end.contact_force, 3, 1e-4) << variant.name;
      EXPECT_GT(end.impacts, 1) << variant.name;
    }
  }
}

TEST(ReferenceContact, EnergyIsAccountedFor) {
  for (const Variant& variant : variants) {
    Case run = paper_case(variant);
    run.scene.main_damping = 0;
    run.scene.v1 = 0.2;
    Reference reference(run);
    const double given = mechanical_energy(run.scene, reference.sample());
    for (double t = 0.01; t < 5; t += 0.01) {
      reference.advance(t);
      const Sample s = reference.sample();
      if (s.penetration > 0) continue;
      // The tolerance is the rounding of doubles of a few joules.
      EXPECT_NEAR(mechanical_energy(run.scene, s) + s.energy_dissipated, given + s.drive_work, 1e-14)
          << variant.name << " at " << t;
    }
  }
}

TEST(ReferenceTrajectory, AgreesWithItselfAtTwoTolerances) {
  for (const Variant& variant : variants) {
    const Trajectory trajectory = reference_trajectory(paper_case(variant), 1e-3, 1);
    EXPECT_LT(trajectory.error_estimate, 1e-9) << variant.name;
    std::printf("  %-31s error estimate over 1 s: %.1e m\n", variant.name, trajectory.error_estimate);
  }
}

TEST(ReferenceTrajectory, DoesNotDependOnWhereItIsSampled) {
  for (const Variant& variant : variants) {
    const Case run = paper_case(variant);
    Reference sampled(run);
    for (int i = 1; i <= 10000; ++i) sampled.advance(i * 1e-4);
    EXPECT_DOUBLE_EQ(sampled.sample().x1, reference_at(run, 1).x1) << variant.name;
  }
}

TEST(ErrorMeasures, PointByPoint) {
  Samples reference(4), method(4), rounded(4);
  for (size_t i = 0; i < 4; ++i) {
    reference[i].t = method[i].t = rounded[i].t = static_cast<double>(i);
    method[i].x1 = 0.25 * static_cast<double>(i);
    rounded[i].x1 = i == 2 ? -1 : method[i].x1;
  }
  const ErrorParts parts = error_parts(reference, method, rounded);
  EXPECT_EQ(parts.method, 0.75);
  EXPECT_EQ(parts.rounding, 1.5);
  EXPECT_EQ(parts.total, 1);
  rounded[1].x1 = std::nan("");
  EXPECT_TRUE(std::isnan(largest_difference(reference, rounded)));
}

}  // namespace
}  // namespace impact::host
