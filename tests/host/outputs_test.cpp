// Calls between two steps, in native numbers: outputs, converters, corrections and snapshots. Also a rejected plan, and
// a state saved by another absorber.

#include <cstring>

#include "host_ref/paper_scene.hpp"
#include "kernel_test.hpp"

namespace impact {
namespace {

constexpr double h = 1e-4;

template <class Value> double si(Value x, double unit) {
  if constexpr (std::is_convertible_v<Value, double>)
    return static_cast<double>(x) * unit;
  else
    return x.raw * 0x1p-31 * unit;
}
// An LSB of a number of this size. In Fixed32 it depends only on the unit.
template <class Format> double lsb_of(double size, double unit) {
  if constexpr (std::is_same_v<Format, Fixed32>)
    return unit * 0x1p-31;
  else
    return size * static_cast<double>(std::numeric_limits<typename Format::Value>::epsilon());
}

template <class Format, class ContactLaw, class Stepper, class Drive>
using Observed = Absorber<AtRunTime, ContactLaw, Stepper, Drive, Format, ContactForce, Snapshots>;
template <class Format>
using ObservedIn = testing::Types<
    Observed<Format, HuntCrossley, Moment, Sine>, Observed<Format, HuntCrossley, Moment, Sampled>,
    Observed<Format, HookeNewton, Moment, Sine>, Observed<Format, Hertz, SubsteppedMoment<4>, Sine>,
    Observed<Format, HuntCrossley, EnergyConsistent, Sine>, Observed<Format, HookeNewton, EnergyConsistent, NoDrive>,
    Observed<Format, HuntCrossley, AverageAcceleration, Sine>, Observed<Format, HuntCrossleyPerImpact, Moment, Sine>,
    Observed<Format, HuntCrossley, Impulsive, Sine>>;

// Impulsive has a stiff stop. Without a drive the main mass starts elsewhere and moves.
template <class Kernel> Kernel observed() {
  Scene scene = paper_scene(Kernel::ContactLaw::law);
  if (Kernel::Contact::traits.is_instantaneous) scene.contact_stiffness = 1e9;
  scene.restitution = 0.7;
  auto kernel = accepted<Kernel>(scene, Bounds{}, h);
  if constexpr (std::is_same_v<typename Kernel::Drive, NoDrive>)
    kernel.correct(Kernel::Format::sample(0.02 / kernel.displacement_unit()),
                   Kernel::Format::sample(1.0 / kernel.velocity_unit()));
  return kernel;
}
template <class Kernel> void drive(Kernel& kernel, int n) { step_with(kernel, 8 * std::sin(0.004 * n)); }

template <class Kernel> struct Outputs : testing::Test {};
TYPED_TEST_SUITE_P(Outputs);

// reading() converts the whole state to double. A native number is within some LSBs of it.
TYPED_TEST_P(Outputs, EqualTheReadingInTheirUnits) {
  using Format = typename TypeParam::Format;
  auto kernel = observed<TypeParam>();
  int touched = 0;
  for (int n = 0; n < 20000; ++n) {
    drive(kernel, n);
    const auto now = kernel.reading();
    const double lsb = lsb_of<Format>(0.1, kernel.displacement_unit());
    ASSERT_NEAR(si(kernel.displacement(), kernel.displacement_unit()), now.x1, lsb) << n;
    ASSERT_NEAR(si(kernel.ball_displacement(), kernel.displacement_unit()), now.x2, lsb) << n;
    // The unit of rates within a step is that of penetrations, here 2^-5 m.
    const double rate_lsb = lsb_of<Format>(2, 0x1p-5 / h);
    ASSERT_NEAR(si(kernel.velocity(), kernel.velocity_unit()), now.v1, 3 * rate_lsb) << n;
    ASSERT_NEAR(si(kernel.ball_velocity(), kernel.velocity_unit()), now.v2, 3 * rate_lsb) << n;
    const auto seen = kernel.snapshot();
    ASSERT_TRUE(seen.is_whole);
    ASSERT_EQ(seen.steps, static_cast<uint32_t>(n + 1));
    ASSERT_EQ(si(seen.displacement, 1), si(kernel.displacement(), 1));
    ASSERT_EQ(si(seen.velocity, 1), si(kernel.velocity(), 1));
    ASSERT_EQ(si(seen.ball_displacement, 1), si(kernel.ball_displacement(), 1));
    ASSERT_EQ(si(seen.ball_velocity, 1), si(kernel.ball_velocity(), 1));
    ASSERT_EQ(si(seen.contact_force, 1), si(kernel.contact_force(), 1));
    ASSERT_EQ(seen.is_touching, kernel.is_touching());
    touched += kernel.is_touching();
  }
  EXPECT_GT(touched, 10);
  EXPECT_EQ(kernel.fault(), Fault::none);
}

// Only the contact force acts on the ball, so its sum is the ball's change of momentum.
TYPED_TEST_P(Outputs, ContactForceIsTheBallsChangeOfMomentum) {
  using Format = typename TypeParam::Format;
  auto kernel = observed<TypeParam>();
  const double m = Scene{}.ball_mass;
  double momentum = 0, largest = 0;
  int touched = 0;
  for (int n = 0; n < 20000; ++n) {
    drive(kernel, n);
    // For Impulsive this is the impulse divided by the step.
    const double force = kernel.plan.units.fraction(kernel.state().force) * kernel.plan.force_scale;
    if constexpr (!TypeParam::Contact::traits.is_instantaneous) {
      ASSERT_NEAR(si(kernel.contact_force(), kernel.force_unit()), force, std::abs(force) * 0x1p-22);
    }
    momentum -= force * h;
    largest = larger(largest, std::abs(force));
    touched += force != 0;
    if (kernel.is_touching() || force != 0) continue;
    // Each step in contact rounds its force and the ball's velocity to some LSBs.
    const double lsb = lsb_of<Format>(largest, kernel.force_unit()) * h, rate_lsb = lsb_of<Format>(2, 0x1p-5 / h) * m;
    ASSERT_NEAR(kernel.reading().v2 * m, momentum, 4 * (lsb + rate_lsb) * std::sqrt(1.0 + touched)) << n;
  }
  EXPECT_GT(largest, 1);
}

REGISTER_TYPED_TEST_SUITE_P(Outputs, EqualTheReadingInTheirUnits, ContactForceIsTheBallsChangeOfMomentum);
INSTANTIATE_TYPED_TEST_SUITE_P(InFixed32, Outputs, ObservedIn<Fixed32>);
INSTANTIATE_TYPED_TEST_SUITE_P(InFloat32, Outputs, ObservedIn<Float32>);
INSTANTIATE_TYPED_TEST_SUITE_P(InFloat32Plain, Outputs, ObservedIn<Float32Plain>);
INSTANTIATE_TYPED_TEST_SUITE_P(InFloat64, Outputs, ObservedIn<Float64>);

template <class Format> struct Formats : testing::Test {};
TYPED_TEST_SUITE(Formats, EveryFormat);

// A correction adds to the state. The motion then is that of a scene that starts in the corrected state.
TYPED_TEST(Formats, ACorrectionAddsToDisplacementAndVelocity) {
  using Kernel = Absorber<AtRunTime, HuntCrossley, Moment, Sine, TypeParam>;
  Scene there;
  there.x1 = 0.003;
  there.v1 = -0.4;
  Kernel kernel(Kernel::PlanType::make(Scene{}, Bounds{}, h)), heir(Kernel::PlanType::make(there, Bounds{}, h));
  const double xu = kernel.displacement_unit(), vu = kernel.velocity_unit();
  kernel.correct(TypeParam::sample(0.003 / xu), TypeParam::sample(-0.4 / vu));
  const double lsb = lsb_of<TypeParam>(0.4, 0x1p-5 / h), x_lsb = lsb_of<TypeParam>(0.003, xu);
  for (int n = 0; n < 100; ++n) {
    EXPECT_NEAR(kernel.reading().x1, heir.reading().x1, x_lsb + n * h * 4 * lsb) << n;
    EXPECT_NEAR(kernel.reading().v1, heir.reading().v1, 4 * lsb * (1 + 0.1 * n)) << n;
    kernel.step();
    heir.step();
  }
  EXPECT_EQ(kernel.fault(), Fault::none);
}

TYPED_TEST(Formats, ACorrectionOutOfRangeIsClampedWithAFault) {
  using Kernel = Absorber<AtRunTime, HuntCrossley, Moment, Sine, TypeParam>;
  using Value = typename TypeParam::Value;
  const auto fresh = accepted<Kernel>(Scene{}, Bounds{}, h);
  Value far{}, none{};
  if constexpr (std::is_same_v<TypeParam, Fixed32>)
    far = {INT32_MIN};
  else
    far = static_cast<Value>(-1e30);
  for (const bool is_velocity : {false, true}) {
    Kernel kernel = fresh;
    for (int n = 0; n < 1000; ++n) {
      kernel.correct(is_velocity ? none : far, is_velocity ? far : none);
      ASSERT_TRUE(std::isfinite(kernel.reading().x1) && std::isfinite(kernel.reading().v1));
      kernel.step();
      ASSERT_LE(kernel.reading().x1, 0);
    }
    EXPECT_EQ(kernel.fault(), is_velocity ? Fault::speed : Fault::displacement);
  }
  if constexpr (!std::is_same_v<TypeParam, Fixed32>) {
    Kernel kernel = after_steps(fresh, 100);
    const auto before = kernel.reading();
    kernel.correct(std::numeric_limits<Value>::quiet_NaN(), none);
    EXPECT_EQ(kernel.reading().x1, before.x1);
    EXPECT_EQ(kernel.fault(), Fault::displacement);
  }
}

// The plan is a constant, so the compiler computes the first snapshot. The ball leaves so fast that the stop would have
// to pull, and the contact ends at once.
template <class Law_> struct SentAway {
  static constexpr Scene scene = [] {
    Scene made;
    made.contact_damping = Law_::is_linear ? 20.81 : Scene{}.contact_damping;
    made.x2 = 0.0101;
    made.v2 = -1.5;
    return made;
  }();
  static constexpr Bounds bounds{};
  static constexpr double step = 1e-4;
};
template <class ContactLaw, class Format, class... Steppers> void expect_first_snapshots() {
  const auto one = [](auto absorber) {
    const auto first = absorber.snapshot();
    EXPECT_TRUE(first.is_whole);
    EXPECT_EQ(first.is_touching, absorber.is_touching());
    EXPECT_EQ(si(first.ball_velocity, 1), si(absorber.ball_velocity(), 1));
    EXPECT_EQ(si(first.velocity, 1), si(absorber.velocity(), 1));
    absorber.reset();
    EXPECT_EQ(absorber.snapshot().is_touching, first.is_touching);
  };
  (one(Absorber<SentAway<ContactLaw>, ContactLaw, Steppers, Sine, Format, Snapshots>()), ...);
}
TYPED_TEST(Formats, TheFirstSnapshotIsTheStart) {
  expect_first_snapshots<HuntCrossley, TypeParam, Moment, SubsteppedMoment<4>, EnergyConsistent, AverageAcceleration,
                         LinearAcceleration, FoxGoodwin, CentralDifference>();
  expect_first_snapshots<HookeNewton, TypeParam, Moment, SubsteppedMoment<4>, EnergyConsistent, AverageAcceleration,
                         LinearAcceleration, FoxGoodwin, CentralDifference>();
}

TYPED_TEST(Formats, AnAbsorberFromARejectedPlanStaysAtRest) {
  using Kernel = Absorber<AtRunTime, HuntCrossley, Moment, Sine, TypeParam, ContactForce, Snapshots, EnergyLedger>;
  Scene scene;
  scene.main_mass = -1;
  scene.x1 = 0.01;
  Kernel kernel(Kernel::PlanType::make(scene, Bounds{}, h));
  EXPECT_EQ(kernel.fault(), Fault::plan);
  kernel.clear_fault();
  for (int n = 0; n < 100; ++n) kernel.step();
  kernel.correct(TypeParam::sample(0.3), TypeParam::sample(0.3));
  kernel.reset();
  expect_near(kernel.reading(), {}, 0, 0);
  EXPECT_EQ(si(kernel.displacement(), 1), 0);
  EXPECT_EQ(si(kernel.velocity(), 1), 0);
  EXPECT_EQ(kernel.fault(), Fault::plan);
  EXPECT_EQ(kernel.snapshot().fault, Fault::plan);
  EXPECT_FALSE(kernel.restore(kernel.save()));
  EXPECT_FALSE(kernel.retune(Kernel::PlanType::make(Scene{}, Bounds{}, h)));
}

TYPED_TEST(Formats, CountsOutAreTheNearestAndClampedAtTheEnds) {
  constexpr double unit = std::is_same_v<TypeParam, Fixed32> ? 0.25 : 1;
  for (const double full_scale : {0.05, 0.1, -0.07})
    for (const int32_t bits : {8, 12, 16}) {
      const int32_t zero = 1 << (bits - 1), most = (1 << bits) - 1;
      const detail::CountsOut<TypeParam> to_counts({zero, zero / full_scale, 0, most}, unit);
      for (int n = -1000; n <= 1000; ++n) {
        const auto x = TypeParam::sample((n * 0.11e-3 + 1e-9) / unit);
        const double exact = zero + si(x, unit) * zero / full_scale;
        ASSERT_NEAR(to_counts.of(x), std::clamp<double>(exact, 0, most), 0.5 + 1e-2) << n;
      }
    }
  const detail::CountsOut<TypeParam> whole({0, -0x1p31, -INT32_MAX, INT32_MAX}, 1);
  EXPECT_NEAR(whole.of(TypeParam::sample(0.5)), -(1 << 30), 128);
}

TYPED_TEST(Formats, CountsInAreSamples) {
  constexpr double unit = std::is_same_v<TypeParam, Fixed32> ? 10 : 1;
  for (const double full_scale : {10.0, 8.0, -12.5})
    for (const int32_t bits : {8, 12, 16, 24}) {
      const int32_t zero = 1 << (bits - 1);
      const detail::CountsIn<TypeParam> from_counts({zero, zero / full_scale, 0, 2 * zero - 1}, unit);
      for (int32_t n = 0; n <= 4096; ++n) {
        const auto counts = static_cast<int32_t>(static_cast<int64_t>(n) * (2 * zero - 1) / 4096);
        double exact = (counts - zero) * full_scale / zero;
        // Values are clamped to the last whole count below the unit.
        const double most = (std::ceil(unit * zero / std::abs(full_scale)) - 1) * std::abs(full_scale) / zero;
        if (std::is_same_v<TypeParam, Fixed32>) exact = std::clamp(exact, -most, most);
        const double lsb = std::is_same_v<TypeParam, Fixed32> ? 10 * 0x1p-29 : std::abs(exact) * 0x1p-22;
        ASSERT_NEAR(si(from_counts.of(counts), unit), exact, lsb) << n << " of " << bits << " bits";
      }
      for (const int32_t wild : {INT32_MIN, INT32_MAX})
        ASSERT_GT(std::abs(si(from_counts.of(wild), unit)), std::min(std::abs(full_scale), unit) * 0.99);
    }
}

// The unit is slightly above a whole count. The rounded product of that count must not change its sign.
TEST(FromCountsInFixed32, KeepTheSignAtTheUnit) {
  for (const double per_unit : {2199.0000011817065, 98525.00006975689, 336723.00039717258, 557301916.26383638})
    for (const double direction : {1.0, -1.0}) {
      const detail::CountsIn<Fixed32> from_counts({0, direction * per_unit, 0, 0}, 1);
      EXPECT_GT(direction * from_counts.of(INT32_MAX).raw, 0.999 * 0x1p31) << per_unit;
      EXPECT_LT(direction * from_counts.of(-INT32_MAX).raw, -0.999 * 0x1p31) << per_unit;
    }
}

TYPED_TEST(Formats, SamplesFromNewtons) {
  using Kernel = Absorber<AtRunTime, HuntCrossley, Moment, Sampled, TypeParam>;
  const auto kernel = accepted<Kernel>(Scene{}, {0.1, 2, 0, 12}, h);
  for (const double newtons : {-12.0, -3.3, 0.0, 1e-3, 5.5}) {
    EXPECT_NEAR(si(kernel.sample_of(newtons), kernel.sample_unit()), newtons, 12 * 0x1p-23);
    EXPECT_NEAR(si(kernel.sample_of(static_cast<float>(newtons)), kernel.sample_unit()), newtons, 12 * 0x1p-22);
  }
}

template <class From, class To> bool takes_over(const From& from, To to) {
  const auto sent = from.save();
  typename To::Saved received{};
  std::memcpy(&received, &sent, std::min(sizeof sent, sizeof received));
  return to.restore(received);
}
template <class Kernel> Kernel run() {
  Scene scene;
  scene.restitution = 0.7;
  return after_steps(accepted<Kernel>(scene, Bounds{}, h), 5000);
}
template <class Format, class Stepper, class... Features>
using Saver = Absorber<AtRunTime, HuntCrossley, Stepper, Sine, Format, Features...>;

TEST(Restoring, RefusesAnotherListOfFeatures) {
  const auto plain = run<Saver<Fixed32, Moment>>();
  const auto logged = run<Saver<Fixed32, Moment, ImpactLog>>();
  const auto ledgered = run<Saver<Fixed32, Moment, EnergyLedger>>();
  const auto both = run<Saver<Fixed32, Moment, EnergyLedger, ImpactLog>>();
  const auto other_order = run<Saver<Fixed32, Moment, ImpactLog, EnergyLedger>>();
  EXPECT_TRUE(takes_over(plain, plain) && takes_over(logged, logged) && takes_over(both, both));
  EXPECT_FALSE(takes_over(logged, plain) || takes_over(plain, logged));
  EXPECT_FALSE(takes_over(ledgered, plain) || takes_over(plain, ledgered));
  EXPECT_FALSE(takes_over(ledgered, logged) || takes_over(logged, ledgered));
  EXPECT_FALSE(takes_over(both, other_order) || takes_over(both, logged));
}

TEST(Restoring, RefusesAnotherBeta) {
  const auto average = run<Saver<Fixed32, Pointwise<1, 4>>>();
  EXPECT_TRUE(takes_over(average, average));
  EXPECT_FALSE(takes_over(average, run<Saver<Fixed32, Pointwise<1, 3>>>()));
}

// Every state of a run with corrections is restored. A contact whose numbers contradict each other is rejected.
template <class Kernel> void restore_at_every_step() {
  Scene scene;
  scene.ball_friction = 0.2;
  auto kernel = accepted<Kernel>(scene, {}, h), other = kernel;
  const auto dx = Kernel::Format::sample(1e-6 / kernel.displacement_unit());
  int contacts = 0;
  for (int n = 0; n < 20000; ++n) {
    kernel.step();
    if (n % 16 == 0) kernel.correct(n % 32 ? dx : -dx, {});
    const auto saved = kernel.save();
    ASSERT_TRUE(other.restore(saved)) << n;
    if (!kernel.is_touching()) continue;
    auto shallow = saved, rootless = saved;
    shallow.state.contact.penetration = {};
    rootless.state.contact.root = {};
    ASSERT_FALSE(other.restore(shallow) || other.restore(rootless)) << n;
    ++contacts;
  }
  EXPECT_GT(contacts, 500);
}
TYPED_TEST(Formats, RestoresEveryStateButNoInconsistentContact) {
  restore_at_every_step<Absorber<AtRunTime, HuntCrossley, Moment, Sine, TypeParam, DryFriction, EnergyLedger>>();
  restore_at_every_step<Absorber<AtRunTime, Hertz, SubsteppedMoment<4>, Sine, TypeParam, DryFriction>>();
  restore_at_every_step<Absorber<AtRunTime, HuntCrossley, EnergyConsistent, Sine, TypeParam, DryFriction>>();
}

TEST(Restoring, RefusesALedgerFarFromItsMainMass) {
  auto kernel = run<Saver<Fixed32, Moment, EnergyLedger>>();
  auto saved = kernel.save();
  saved.state.x1.raw = -(INT64_C(1) << 61);
  saved.state.x1_before.raw = (INT64_C(1) << 62) - 1;
  EXPECT_FALSE(kernel.restore(saved));
}

}  // namespace
}  // namespace impact
