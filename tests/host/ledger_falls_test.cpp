// With EnergyConsistent and Impulsive the dissipated energy in the ledger never falls (features.hpp), in random coupled
// scenes. In Fixed32 the ledger is exact with any stepper.

#include "host_ref/coupled_scenes.hpp"
#include "kernel_test.hpp"

namespace impact::host {
namespace {

// The factor of a gain.
template <class Gain> double factor_of(Gain gain) {
  if constexpr (std::is_floating_point_v<Gain>)
    return static_cast<double>(gain);
  else
    return std::ldexp(gain.mantissa, -32 - gain.shift);
}

template <class Format>
constexpr double rounded_by_sum = std::is_same_v<Format, Fixed32>        ? 0
                                  : std::is_same_v<Format, Float64>      ? 0x1p-53
                                  : std::is_same_v<Format, Float32Plain> ? 0x1p-24
                                                                         : 0x1p-47;  // in two floats

// The amount by which rounding in a step may lower the ledger of EnergyConsistent, in its own unit. G is the change of
// penetration per unit of force, f the force, w the displacement. D = w + G f is the displacement without the force, p
// that by spring and drive, s the stored energy. The sum of four allowances:
//
// Relative: a share of (|D| + |p|)^2/G and of s at both ends. In Fixed32 four numbers round down by 2^-31 of a unit of
// eight times the largest length: 4 * 64 * 2^-31. In floating point there are sixteen operations.
//
// Sum: the addition to the dissipated energy, which rounds only in floating point.
//
// Left over: f times the residual w - (d1 - d0) of a resolved contact's equation, if its sum has fallen. Over a whole
// contact it is a loss (kernel/docs/energy.md).
//
// LSB: four LSBs of a length, or of a response to a force if that is coarser. Hooke-Newton's own equation (1 + G (1/2 +
// C)) f = ... adds three (stepper/energy/linear.hpp).
struct Allowance : SilentFeature {
  static constexpr uint32_t kind = 99;
  static constexpr bool is_bound = true;

  template <class Format> struct State {
    double allowed, stored_before, depth_before;
    double left_over, most_left_over;
  };

  template <class Plan, class State, class Step>
  static void after_contact(const Plan& plan, State& state, const Step& step) {
    using Format = typename Plan::FormatType;
    constexpr bool is_fixed = std::is_same_v<Format, Fixed32>, is_double = std::is_same_v<Format, Float64>;
    constexpr double relative = is_fixed ? 0x1p-23 : is_double ? 0x1p-49 : 0x1p-20, sum = rounded_by_sum<Format>;
    const double lsb = is_fixed ? std::ldexp(1, -31 + larger(0, -plan.contact.response.travel_bits)) : 0;
    const double force = plan.units.fraction(step.force.j0), displacement = plan.units.fraction(step.displacement),
                 stored = plan.units.fraction(step.stored),
                 response =
                     std::ldexp(0.5 / factor_of(plan.contact.response.force.own), -plan.contact.response.travel_bits),
                 back = response * force, free = displacement + back,
                 press = free - plan.units.fraction(step.rate_at_start), length = std::abs(free) + std::abs(press);
    state.allowed += sum * std::abs(state.dissipated.total());
    state.allowed += relative * (length * length / response + state.stored_before + stored) +
                     4 * lsb * ((length + std::abs(back)) / response + std::abs(displacement));
    if constexpr (Plan::LawType::is_linear)
      state.allowed += 3 * lsb * std::abs(displacement) / factor_of(plan.contact.solved);
    if constexpr (!Plan::LawType::is_linear) {
      const double depth = plan.units.fraction(state.contact.penetration);
      if (!plan.contact.response.is_sudden)
        state.left_over += force * (step.begins ? -back : displacement - (depth - state.depth_before));
      state.most_left_over = larger(state.most_left_over, state.left_over);
      state.depth_before = depth;
    }
    state.stored_before = stored;
  }
};

// All random scenes of coupled_scenes.hpp, except those that samples drive.
constexpr unsigned scenes_an_edge = 300;

template <class Kernel, class Use> int each_scene(const Use& use, Tension tension = Tension::clamp) {
  int accepted = 0;
  for (const Edge edge : every_edge)
    for (unsigned index = 0; index < scenes_an_edge; ++index) {
      CoupledScene found = coupled_scene(Kernel::ContactLaw::law, edge, index);
      if (found.request.drive == DriveKind::sampled) continue;
      if (found.request.drive == DriveKind::none) found.request.scene.drive_pulsation = 0;
      found.request.scene.tension = tension;
      const Kernel kernel(Kernel::PlanType::make(found.request.scene, *found.request.bounds, found.request.step));
      if (kernel.fault() == Fault::plan) continue;
      ++accepted;
      use(found, kernel);
    }
  return accepted;
}

template <class Format> class EnergyLedgerIn : public testing::Test {};
TYPED_TEST_SUITE(EnergyLedgerIn, EveryFormat);

template <class Format, class ContactLaw> void expect_no_fall_with_energy_consistent(Tension tension = Tension::clamp) {
  using Kernel = Absorber<AtRunTime, ContactLaw, EnergyConsistent, Sine, Format, EnergyLedger, Allowance>;
  double worst = 0;
  const int accepted = each_scene<Kernel>(
      [&](const CoupledScene& found, Kernel kernel) {
        double most = 0;
        for (long i = 0; i < found.steps; ++i) {
          kernel.step();
          const auto& state = kernel.state();
          const double now = state.dissipated.total(), fall = most - now;
          const double allowed = state.allowed + state.most_left_over - state.left_over;
          ASSERT_LE(fall, allowed) << "step " << i << ", " << text_of(found.request);
          if (fall > 0) worst = larger(worst, fall / allowed);
          most = larger(most, now);
        }
      },
      tension);
  std::printf("  %d scenes, falls by %.2g of what is allowed\n", accepted, worst);
  EXPECT_GT(accepted, 100);
}
TYPED_TEST(EnergyLedgerIn, EnergyConsistentNeverFalls) {
  expect_no_fall_with_energy_consistent<TypeParam, HookeNewton>();
  // A stop that may pull has the difference of two large forces, of which a float keeps few bits.
  if constexpr (std::is_same_v<TypeParam, Float64>)
    expect_no_fall_with_energy_consistent<TypeParam, HookeNewton>(Tension::allow);
  expect_no_fall_with_energy_consistent<TypeParam, Hertz>();
  expect_no_fall_with_energy_consistent<TypeParam, HuntCrossley>();
  expect_no_fall_with_energy_consistent<TypeParam, Exact>();
}

// The sum is one number and never falls, since no term is negative.
template <class Format, class ContactLaw> void expect_no_fall_with_impulsive() {
  using Kernel = Absorber<AtRunTime, ContactLaw, Impulsive, Sine, Format, EnergyLedger>;
  const int accepted = each_scene<Kernel>([](const CoupledScene& found, Kernel kernel) {
    double most = 0;
    for (long i = 0; i < found.steps; ++i) {
      kernel.step();
      const double now = kernel.state().dissipated.total();
      ASSERT_GE(now, most * (std::is_same_v<Format, Float32> ? 1 - rounded_by_sum<Format> : 1))
          << i << ", " << text_of(found.request);
      most = now;
    }
  });
  EXPECT_GT(accepted, 100);
}
TYPED_TEST(EnergyLedgerIn, ImpulsiveNeverFalls) {
  expect_no_fall_with_impulsive<TypeParam, HookeNewton>();
  expect_no_fall_with_impulsive<TypeParam, HuntCrossley>();
  expect_no_fall_with_impulsive<TypeParam, Exact>();
}

// The sum of the energies that features see, in double. In Fixed32 it equals the ledger with any stepper.
struct InDouble : SilentFeature {
  static constexpr uint32_t kind = 98;
  static constexpr bool is_bound = true;

  template <class Format> struct State { double sum, size, rate_before, stored_before; };

  template <class Plan, class State, class Step>
  static void after_contact(const Plan& plan, State& state, const Step& step) {
    const auto number = [&plan](auto x) { return plan.units.fraction(x); };
    const double force = number(step.force.j0), rate = number(step.rate), stored = number(step.stored),
                 before = step.begins ? number(step.rate_at_start) : state.rate_before;
    constexpr ContactTraits traits = Plan::ContactType::traits;
    const double work = traits.starts_from_rate     ? number(step.work)  // of the step's contacts
                        : traits.knows_displacement ? force * number(step.displacement)
                                                    : force * rate - (rate - before) * number(step.force.j1);
    state.sum += work - (stored - state.stored_before);
    state.size += std::abs(force * rate) + std::abs(work) + stored;
    state.rate_before = rate;
    state.stored_before = stored;
  }
};
template <class Stepper, class ContactLaw> void expect_nothing_rounded() {
  using Kernel = Absorber<AtRunTime, ContactLaw, Stepper, Sine, Fixed32, EnergyLedger, InDouble>;
  const int accepted = each_scene<Kernel>([](const CoupledScene& found, const Kernel& kernel) {
    const auto state = after_steps(kernel, found.steps).state();
    EXPECT_NEAR(state.dissipated.total(), state.sum, 0x1p-53 * static_cast<double>(found.steps) * state.size)
        << text_of(found.request);
  });
  EXPECT_GT(accepted, 50);
}
TEST(EnergyLedger, RoundsNothingInFixed32) {
  expect_nothing_rounded<Moment, HookeNewton>();
  expect_nothing_rounded<Moment, HuntCrossley>();
  expect_nothing_rounded<SubsteppedMoment<4>, HuntCrossley>();
  expect_nothing_rounded<EnergyConsistent, HookeNewton>();
  expect_nothing_rounded<EnergyConsistent, Hertz>();
  expect_nothing_rounded<Impulsive, Exact>();
  expect_nothing_rounded<AverageAcceleration, HookeNewton>();
}

// A ball starts inside its stop, and the law loses nothing. What the ledger then has, as a share of what is stored.
template <class Stepper, class Format>
Absorber<AtRunTime, Hertz, Stepper, NoDrive, Format, EnergyLedger> inside_stop() {
  Scene scene = elastic_scene();
  scene.x2 = scene.clearance / 2 + 0.005;
  return accepted<Absorber<AtRunTime, Hertz, Stepper, NoDrive, Format, EnergyLedger>>(scene, Bounds{}, 1e-4);
}
template <class Kernel> double share_of_stored(const Kernel& kernel) {
  return dissipated_by(kernel) / stored_at(Scene{}, 0.005);
}

// The energy stored at the start is released. The ledger is of second order, over 300 steps of contact.
template <class Stepper, class Format> void expect_stored_start_counted(double tolerance) {
  auto kernel = inside_stop<Stepper, Format>();
  ASSERT_TRUE(kernel.is_touching());
  while (kernel.is_touching()) kernel.step();
  EXPECT_NEAR(share_of_stored(kernel), 0, tolerance);
}
TEST(EnergyLedger, CountsAStartInsideAStopAsStored) {
  expect_stored_start_counted<Moment, Float64>(1e-4);
  expect_stored_start_counted<Moment, Fixed32>(1e-4);
  expect_stored_start_counted<SubsteppedMoment<4>, Float64>(1e-4);
  expect_stored_start_counted<EnergyConsistent, Float64>(1e-4);
  expect_stored_start_counted<EnergyConsistent, Fixed32>(1e-4);
  expect_stored_start_counted<AverageAcceleration, Float64>(1e-2);
}

// Energy that a correction removes from a stop counts as dissipated.
template <class Stepper, class Format> void expect_correction_counted() {
  auto kernel = inside_stop<Stepper, Format>();
  kernel.correct(Format::value(Format::sample(0.006 / kernel.displacement_unit())), {});
  ASSERT_FALSE(kernel.is_touching());
  EXPECT_NEAR(share_of_stored(kernel), 1, 1e-6);
}
TEST(EnergyLedger, CountsWhatACorrectionTakesOutOfAStop) {
  expect_correction_counted<Moment, Float64>();
  expect_correction_counted<Moment, Fixed32>();
  expect_correction_counted<EnergyConsistent, Float32>();
  expect_correction_counted<EnergyConsistent, Fixed32>();
}

}  // namespace
}  // namespace impact::host
