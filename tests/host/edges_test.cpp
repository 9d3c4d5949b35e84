// Special cases: symmetry, no clearance, a start inside a stop, a restored state, a fast sine.

#include "paper_runs.hpp"

namespace impact::host {
namespace {

// Left and right are exchanged. In floating point all bits are the same, since it rounds symmetrically. Fixed point
// rounds down on both sides, so two runs differ by at most twice what accuracy_test.cpp allows, and after stiff impacts
// by a micrometre.
TEST(Edges, LeftIsTheMirrorImageOfRight) {
  int run = 0;
  for (const double stiffer : {1.0, 3e3, 3e7})
    for (const auto& [law, stepper, numeric, damping] :
         kinds({Stepper::automatic, Stepper::moment, Stepper::average, Stepper::energy, Stepper::impulsive},
               Damping::exact)) {
      SCOPED_TRACE(testing::Message() << stiffer << " " << name_of(law) << " " << name_of(stepper) << " "
                                      << name_of(numeric) << " " << name_of(damping));
      Request right = paper_request(law, stepper, 1e-3);
      right.numeric = numeric;
      right.damping = damping;
      right.drive = DriveKind::sampled;
      right.samples = sampled_sine(1e-3, 0.5);
      right.bounds = Bounds{0.5, 2, 0.0156, 20};
      right.scene.restitution = 0.68;
      right.scene.contact_stiffness *= stiffer;
      right.scene.contact_damping *= law == Law::hooke_newton ? std::sqrt(stiffer) : stiffer;
      right.scene.x1 = 1e-3;
      right.scene.v1 = -0.1;
      right.scene.x2 = -3e-3;
      right.scene.v2 = 0.4;
      const bool multiplies_energy = stepper == Stepper::average && stiffer > 1;
      if (multiplies_energy || !simulation_of(right)) continue;
      ++run;
      for (const Stops stops : {Stops::both, Stops::right}) {
        right.scene.stops = stops;
        Request left = right;
        left.scene.stops = stops == Stops::right ? Stops::left : stops;
        for (double* x : {&left.scene.x1, &left.scene.v1, &left.scene.x2, &left.scene.v2}) *x = -*x;
        for (double& force : left.samples) force = -force;
        const Samples a = kernel_samples(right, 1e-3, 0.5), b = kernel_samples(left, 1e-3, 0.5);
        EXPECT_GT(a.back().impacts, 0);
        EXPECT_EQ(a.back().impacts, b.back().impacts);
        for (size_t i = 0; i < a.size(); ++i) {
          if (numeric == Numeric::fixed32) {
            EXPECT_NEAR(a[i].x1, -b[i].x1, stiffer > 1 ? 1e-6 : law == Law::hooke_newton ? 3.2e-7 : 3.2e-8) << i;
          } else {
            expect_near(a[i], {a[i].t, -b[i].x1, -b[i].v1, -b[i].x2, -b[i].v2}, 0, 0);
            EXPECT_EQ(a[i].energy_dissipated, b[i].energy_dissipated);
          }
        }
      }
    }
  EXPECT_GE(run, 156);
}

// The ball is always in one of the stops. In a step in which it changes from one to the other, the kernel resolves only
// one contact. Hooke-Newton's force jumps there, which causes an error of second order. Float32Plain has too few digits
// to show it.
TEST(Edges, WithoutClearanceTheBallGoesFromStopToStop) {
  for (const Law law : every_law)
    for (const Numeric numeric : {Numeric::float64, Numeric::float32, Numeric::fixed32}) {
      const auto error = [&](double step) {
        Request request = paper_request(law, Stepper::moment, step);
        request.numeric = numeric;
        request.scene.clearance = 0;
        request.scene.v2 = 0.2;
        request.bounds = Bounds{0.0625, 4, 0.0156, 10};
        return error_of(request, 2e-3, 0.2);
      };
      const double coarse = error(2e-4), fine = error(2e-5);
      EXPECT_LT(fine, std::max(coarse / 100 * 1.5, 1e-9)) << name_of(law) << " " << name_of(numeric);
      EXPECT_LT(coarse, 1e-6) << name_of(law) << " " << name_of(numeric);
    }
}

TEST(Edges, ABallMayStartInsideAStop) {
  for (const Law law : every_law)
    for (const Tension tension : {Tension::clamp, Tension::allow})
      for (const double side : {1.0, -1.0}) {
        Request request = paper_request(law, Stepper::moment, 1e-4, tension);
        request.scene.x2 = side * (0.01 + 1e-3);
        request.scene.v2 = side * 0.3;
        const Samples kernel = kernel_samples(request, 1e-3, 0.05), reference = reference_samples(request, 1e-3, 0.05);
        EXPECT_NEAR(kernel.front().contact_force, reference.front().contact_force, 1e-12);  // forces are 1 N and more
        // Over this first contact of 80 steps, an error of 1e-8 in the restitution moves x1 by some 1e-10 m.
        EXPECT_LT(largest_difference(kernel, reference), 1e-10) << name_of(law);
      }
}

// The paper's scene, for Impulsive with a stiff stop.
template <class ContactLaw, class Stepper> struct Rig {
  static constexpr Scene scene = [] {
    constexpr bool is_stiff = std::is_same_v<Stepper, Impulsive>;
    Scene made;
    if (is_stiff) made.contact_stiffness = 1e10;
    if (ContactLaw::is_linear) made.contact_damping = 20.81;
    if (ContactLaw::is_damped_per_impact)
      made.restitution = 0.68;
    else if (is_stiff)
      made.contact_damping = 19560;
    return made;
  }();
  static constexpr Bounds bounds{0.0625, 2, 0.0156, 10};
  static constexpr double step = 1e-3;
};
template <class Format, class ContactLaw, class Stepper, class... Features>
using Kernel = Absorber<Rig<ContactLaw, Stepper>, ContactLaw, Stepper, Sine, Format, Features...>;

template <class Kernel> struct States : testing::Test {};
using Kernels = testing::Types<Kernel<Fixed32, HuntCrossley, Moment>, Kernel<Float32, HuntCrossley, Moment>,
                               Kernel<Fixed32, HookeNewton, Moment>, Kernel<Fixed32, Hertz, AverageAcceleration>,
                               Kernel<Float32Plain, HuntCrossley, FoxGoodwin, EnergyLedger, ImpactLog>,
                               Kernel<Fixed32, HuntCrossleyPerImpact, Moment, EnergyLedger, ImpactLog>,
                               Kernel<Fixed32, HuntCrossley, Impulsive, EnergyLedger, ImpactLog>,
                               Kernel<Float32, HuntCrossleyPerImpact, Impulsive>,
                               Kernel<Float32Plain, HuntCrossley, Impulsive>, Kernel<Float64, HuntCrossley, Impulsive>>;
TYPED_TEST_SUITE(States, Kernels);

// States at any instant of the first half second, which has impacts, are restored.
TYPED_TEST(States, RestoreAndResetReproduceTheMotion) {
  TypeParam original;
  for (int n = 0; n < 500; ++n) {
    TypeParam other;
    other.step();
    ASSERT_TRUE(other.restore(original.save()));
    TypeParam ahead = original;
    for (int i = 0; i < 20; ++i) {
      ahead.step();
      other.step();
      expect_near(ahead.reading(), other.reading(), 0, 0);
    }
    ASSERT_FALSE(this->HasFailure()) << n;
    original.step();
  }
  TypeParam fresh;
  original.reset();
  for (int n = 0; n < 500; ++n) {
    expect_near(original.reading(), fresh.reading(), 0, 0);
    ASSERT_FALSE(this->HasFailure()) << n;
    original.step();
    fresh.step();
  }
}

// A change of plan keeps a fast sine's phase. It is the sum of two terms, each up to five times as large. In Fixed32
// they used to wrap above 2.1 rad per step. Each of the 28 changes may round the displacement per step by 2^-27 of F0
// h^2/M, or at most 5e-5 of that over 200 steps. Every state is restored, up to the fastest sine that a plan accepts,
// whose slope is nearly twice the sine.
TEST(Edges, AFastSineKeepsItsPhaseThroughAChangeOfPlan) {
  const double h = 1e-3;
  Scene scene;
  scene.stops = Stops::none;
  scene.drive_amplitude = 1000;
  using Tunable = Absorber<AtRunTime, HuntCrossley, Moment, Sine, Fixed32>;
  for (const double turn : {1.99, 2.05, 2.2, 2.4, 2.6, 2.8, 2.95}) {
    scene.drive_pulsation = turn / h;
    auto steady = accepted<Tunable>(scene, Bounds{}, h), changed = steady;
    for (int n = 0; n < 200; ++n) {
      steady.step();
      ASSERT_TRUE(steady.restore(steady.save())) << turn << ", step " << n;
      changed.step();
      if (n % 7 == 3) changed.retune(changed.plan);
      ASSERT_NEAR(changed.reading().x1, steady.reading().x1, 1e-4 * scene.drive_amplitude * h * h / scene.main_mass)
          << turn << ", step " << n;
    }
  }
}

// The tool derives the bounds from the samples: by an estimate, in Fixed32 by a run.
TEST(Edges, ASampleThatIsNoNumberIsRefused) {
  for (const Numeric numeric : every_format) {
    Request request = paper_request(Law::hunt_crossley, Stepper::moment, 1e-3);
    request.numeric = numeric;
    request.drive = DriveKind::sampled;
    request.duration = 0.5;
    request.samples = sampled_sine(1e-3, 0.5);
    request.bounds.reset();
    EXPECT_NE(make_simulation(request).simulation, nullptr) << name_of(numeric);
    request.samples[7] = std::nan("");
    const Outcome refused = make_simulation(request);
    EXPECT_EQ(refused.simulation, nullptr) << name_of(numeric);
    EXPECT_EQ(refused.refusal.field, "bound-force") << name_of(numeric);
  }
}

// Two features of a user have members with the same names as each other, the library's features and the state.
template <uint32_t number> struct Counter : SilentFeature {
  static constexpr uint32_t kind = 1000 + number;
  static constexpr bool is_bound = false;
  template <class Format> struct State { uint32_t steps, impacts, stored, contact_force, drive; };
  template <class Plan, class State> static constexpr void after_step(const Plan&, State& state) {
    auto& own = record_in<Counter, Plan>(state);
    own.steps += number;
    own.drive = own.steps;
  }
};

TEST(Features, MayNameTheirMembersAlike) {
  Kernel<Fixed32, HuntCrossley, Moment> alone;
  Kernel<Fixed32, HuntCrossley, Moment, Counter<1>, Snapshots, ContactForce, Counter<2>, EnergyLedger, ImpactLog>
      absorber;
  using PlanType = decltype(absorber)::PlanType;
  for (int n = 0; n < 1000; ++n) alone.step(), absorber.step();
  EXPECT_EQ((record_in<Counter<1>, PlanType>(absorber.state()).drive), 1000u);
  EXPECT_EQ((record_in<Counter<2>, PlanType>(absorber.state()).steps), 2000u);
  EXPECT_EQ(absorber.snapshot().steps, 1000u);
  EXPECT_EQ(absorber.displacement().raw, alone.displacement().raw);
}

}  // namespace
}  // namespace impact::host
