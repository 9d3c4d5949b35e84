// Every law with a damping per impact: its formula, and its restitution in the kernel at any speed against the closed
// form. Also the accepted range of e, and laws of a user.

#include <set>

#include "host_ref/free_pair.hpp"
#include "host_ref/names.hpp"
#include "kinds.hpp"

namespace impact::host {
namespace {

struct Stated {
  Damping damping;
  double (*damping_ratio)(double);
  double least;             // smallest restitution that a plan accepts
  double at_1, at_5, at_9;  // restitution at e = 0.1, 0.5 and 0.9, of the table in law/per_impact.hpp
};
constexpr Stated laws[] = {{Damping::hunt_crossley, HuntCrossleyPerImpact::damping_ratio, 0.01, 0.516, 0.663, 0.909},
                           {Damping::herbert_mcwhannell, HerbertMcWhannell::damping_ratio, 0.01, 0.491, 0.594, 0.901},
                           {Damping::lee_wang, LeeWang::damping_ratio, 0.01, 0.687, 0.799, 0.952},
                           {Damping::lankarani_nikravesh, LankaraniNikravesh::damping_ratio, 0.01, 0.665, 0.725, 0.913},
                           {Damping::flores, Flores::damping_ratio, 0.0158, 0.069, 0.470, 0.894},
                           {Damping::hu_guo, HuGuo::damping_ratio, 0.0148, 0.074, 0.488, 0.900},
                           {Damping::exact, Exact::damping_ratio, 0.01, 0.100, 0.500, 0.900}};

double true_restitution(double damping_ratio) {
  return restitution({Law::hunt_crossley, 1, damping_ratio, 1, 1}).value();
}

TEST(Laws, AreThoseOfTheTool) {
  size_t known = 0;
  for (const auto& row : dampings)
    if (row.value != Damping::constant && row.name == name_of(row.value)) {  // per-impact is a second name
      ASSERT_LT(known, std::size(laws)) << row.name;
      EXPECT_EQ(laws[known++].damping, row.value) << row.name;
    }
  EXPECT_EQ(known, std::size(laws));
}

TEST(Laws, AreTheirFormulas) {
  for (const Stated& law : laws)
    for (const double e : {0.01, 0.1, 0.3, 0.5, 0.68, 0.9, 0.999, 1 - 1e-9, 1.0}) {
      const double expected = damping_ratio(law.damping, e).value();
      EXPECT_NEAR(law.damping_ratio(e), expected, 1e-14 * (1 + expected)) << name_of(law.damping) << " " << e;
    }
  EXPECT_EQ(Exact::damping_ratio(1), 0);
}

// The tolerance is 1e-15, magnified by the cancellation of the rates' logarithms at small losses.
TEST(Laws, ExactHasTheRestitutionThatIsStated) {
  for (double e = 0.01; e < 1; e += 1e-3) EXPECT_NEAR(true_restitution(Exact::damping_ratio(e)), e, 1e-12);
  static_assert(constant::magnitude(Exact::damping_ratio(0.68) - 0.6956071395) < 1e-10);
}

TEST(Laws, FormulasOfSmallLossesAreNotExact) {
  for (const Stated& law : laws) {
    EXPECT_NEAR(true_restitution(law.damping_ratio(0.1)), law.at_1, 5.1e-4) << name_of(law.damping);
    EXPECT_NEAR(true_restitution(law.damping_ratio(0.5)), law.at_5, 5.1e-4) << name_of(law.damping);
    EXPECT_NEAR(true_restitution(law.damping_ratio(0.9)), law.at_9, 5.1e-4) << name_of(law.damping);
  }
}

// Moment has 20 steps per resolved part of a contact. EnergyConsistent has contacts of 80, 4 and 0.5 steps, and
// Impulsive contacts of a hundredth of a step. The tolerances are those of the README's "Choosing" and the headers,
// plus 2e-5 for 32 bits from e = 0.1 on. At 80 steps EnergyConsistent treats a strongly damped contact as stiff, with
// an error of 6e-4 (stepper/energy/stiff.hpp). A classical scheme reads the speed a step late, which is 1.25
// (pi/20)^2/12.
struct Cell {
  Stepper stepper;
  double steps_per_contact, tolerance;
};
constexpr Cell cells[] = {{Stepper::moment, 20, 2.5e-5}, {Stepper::average, 20, 3e-3},
                          {Stepper::energy, 80, 2e-4},   {Stepper::energy, 4, 1e-3},
                          {Stepper::energy, 0.5, 2e-3},  {Stepper::impulsive, 0.01, 8e-5}};

TEST(Laws, ReboundAsTheirFormulasSayAtAnySpeed) {
  for (const Stated& law : laws)
    for (const double e : {0.1, 0.3, 0.7, 0.95})
      for (const double speed : {0.02, 0.8, 20.0})
        for (const Cell& cell : cells)
          for (const Numeric numeric : every_format) {
            SCOPED_TRACE(testing::Message()
                         << name_of(law.damping) << " " << e << " " << speed << " " << name_of(cell.stepper) << " "
                         << cell.steps_per_contact << " " << name_of(numeric));
            FreePair free;
            free.damping = law.damping;
            free.restitution = e;
            free.speed = speed;
            const double expected = true_restitution(law.damping_ratio(e));
            // The damping stops the ball in about 4 e/(1 + e) of a contact.
            const double detail = cell.stepper == Stepper::moment ? std::min(1.0, 4 * expected / (1 + expected)) : 1;
            free.step = contact_time(impact_of(free)).value() * detail / cell.steps_per_contact;
            if (free.step > 0.1) continue;
            const auto found = rebounds(free, cell.stepper, numeric, simulation_of);
            ASSERT_TRUE(found);
            EXPECT_FALSE(found->has_fault);
            EXPECT_TRUE(found->is_apart);
            EXPECT_LE(larger(std::abs(found->least - expected), std::abs(found->largest - expected)), cell.tolerance);
          }
}

// The kernel's types with a free pair of 1 kg and 0.3 kg, at several shares of the largest speed of one plan.
Scene free_pair(double e) {
  Scene scene = free_scene();
  scene.contact_stiffness = 1e9;
  scene.stops = Stops::right;
  scene.restitution = e;
  return scene;
}
constexpr Bounds bounds{0.1, 2, 5e-4, 1};

template <class ContactLaw, class Stepper, class Format>
using Kernel = Absorber<AtRunTime, ContactLaw, Stepper, NoDrive, Format>;

template <class ContactLaw, class Stepper, class Format> double rebound(const Scene& scene, double step) {
  auto absorber = accepted<Kernel<ContactLaw, Stepper, Format>>(scene, bounds, step);
  bool has_touched = false;
  for (int n = 0; n < 100000; ++n) {
    const double v2_before = absorber.reading().v2;
    absorber.step();
    has_touched = has_touched || absorber.is_touching() || absorber.reading().v2 != v2_before;
    if (has_touched && !absorber.is_touching() && absorber.reading().v2 < absorber.reading().v1) break;
  }
  EXPECT_EQ(absorber.fault(), Fault::none);
  return (absorber.reading().v1 - absorber.reading().v2) / scene.v2;
}

template <class ContactLaw, class Stepper, class Format> void expect_one_restitution(double step, double tolerance) {
  for (const double e : {0.05, 0.5, 0.9})
    for (const double speed : {1.9, 0.3, 0.05}) {
      Scene scene = free_pair(e);
      scene.v2 = speed;
      scene.x2 = scene.clearance / 2 - 1.37 * speed * step;
      EXPECT_NEAR((rebound<ContactLaw, Stepper, Format>(scene, step)), true_restitution(ContactLaw::damping_ratio(e)),
                  tolerance)
          << e << " " << speed;
    }
}

template <class ContactLaw> struct NamedLaw : testing::Test {};
using NamedLaws =
    testing::Types<HuntCrossleyPerImpact, HerbertMcWhannell, LeeWang, LankaraniNikravesh, Flores, HuGuo, Exact>;
template <class... Laws> constexpr size_t count_of(testing::Types<Laws...>) { return sizeof...(Laws); }
static_assert(count_of(NamedLaws{}) == std::size(laws), "a law of the list above is missing here");
TYPED_TEST_SUITE(NamedLaw, NamedLaws);

// Damping slows the ball down to v0/a. In 3 us it then moves by at least 600 LSBs of Fixed32.
TYPED_TEST(NamedLaw, HasOneRestitutionAtAnySpeed) {
  expect_one_restitution<TypeParam, Moment, Float64>(3e-6, 1e-8);
  expect_one_restitution<TypeParam, Moment, Fixed32>(3e-6, 1e-3);
  expect_one_restitution<TypeParam, EnergyConsistent, Float64>(1e-3, 2e-3);
  expect_one_restitution<TypeParam, EnergyConsistent, Fixed32>(1e-3, 2e-3);
  expect_one_restitution<TypeParam, Impulsive, Float64>(1e-3, 1e-12);
  expect_one_restitution<TypeParam, Impulsive, Fixed32>(1e-3, 1e-5);
  expect_one_restitution<TypeParam, Impulsive, Float32Plain>(1e-3, 16 * 0x1p-24);
}

// A light impact without other forces keeps its own damping at 14 steps per contact, although the bounds let the main
// spring press 30 times as hard. It rebounds as at a hundredth of the step.
template <class Stepper> void expect_light_impacts_damped(double tolerance) {
  for (const double speed : {0.1, 0.02, 0.004}) {
    Scene scene;
    scene.drive_amplitude = 0;
    scene.ball_mass = 0.03;
    scene.restitution = 0.2;
    scene.v2 = speed;
    scene.x2 = scene.clearance / 2 - 1.37e-3 * speed;
    const auto ratio = [&](double step) {
      auto absorber = touching(accepted<Kernel<Exact, Stepper, Float64>>(scene, Bounds{}, step));
      while (absorber.is_touching()) absorber.step();
      EXPECT_EQ(absorber.fault(), Fault::none);
      return -absorber.reading().v2 / speed;
    };
    EXPECT_NEAR(ratio(1e-3), ratio(1e-5), tolerance) << speed;
  }
}
TEST(Laws, DampLightImpactsByTheirOwnSpeed) {
  expect_light_impacts_damped<Moment>(1e-3);
  expect_light_impacts_damped<SubsteppedMoment<4>>(1e-3);
  expect_light_impacts_damped<EnergyConsistent>(1e-2);
}

TEST(Laws, AcceptTheRestitutionsOfTheirRangeOnly) {
  for (const Stated& law : laws) {
    FreePair free;
    free.damping = law.damping;
    free.restitution = 0.5;
    for (const Stepper stepper : {Stepper::energy, Stepper::impulsive}) {
      Request request = request_for(free, stepper, Numeric::fixed32, 0);
      request.scene.contact_stiffness = 1e12;
      for (const double e : {law.least, 0.5, 1.0}) {
        request.scene.restitution = e;
        EXPECT_TRUE(simulation_of(request)) << name_of(law.damping) << " " << e;
      }
      for (const double e : {law.least - 1e-4, 1.01, -1.0, std::nan("")}) {
        request.scene.restitution = e;
        const Outcome refused = make_simulation(request);
        ASSERT_FALSE(refused.simulation) << name_of(law.damping) << " " << e;
        EXPECT_EQ(refused.refusal.field, "restitution");
      }
    }
  }
  const auto status_at = [](double e) {
    return Kernel<Flores, Impulsive, Fixed32>::PlanType::make(free_pair(e), bounds, 1e-3).status;
  };
  EXPECT_EQ(status_at(0.0158), PlanStatus::ok);
  EXPECT_EQ(status_at(0.0157), PlanStatus::restitution);
}

struct Mine : HuntCrossleyPerImpact {
  static constexpr double damping_ratio(double e) { return 1 - e; }
};
struct NoNumber : HuntCrossleyPerImpact {
  static constexpr double damping_ratio(double) { return std::numeric_limits<double>::quiet_NaN(); }
};
struct Negative : HuntCrossleyPerImpact {
  static constexpr double damping_ratio(double e) { return e - 2; }
};
struct Renamed : HuntCrossley {};
struct Linear : HookeNewton {};

// A law that derives from another is that law, with every stepper.
template <class Own, class Known, class Stepper> void expect_the_same(double step) {
  for (const double speed : {1.9, 0.05}) {
    Scene scene = free_pair(0.5);
    scene.contact_damping = Own::is_linear ? 4000 : 1e9;
    scene.v2 = speed;
    scene.x2 = scene.clearance / 2 - 1.37 * speed * step;
    EXPECT_EQ((rebound<Own, Stepper, Float64>(scene, step)), (rebound<Known, Stepper, Float64>(scene, step)));
    EXPECT_EQ((rebound<Own, Stepper, Fixed32>(scene, step)), (rebound<Known, Stepper, Fixed32>(scene, step)));
  }
}
TEST(Laws, OfYourOwn) {
  expect_one_restitution<Mine, Moment, Fixed32>(3e-6, 1e-3);
  expect_one_restitution<Mine, EnergyConsistent, Fixed32>(1e-3, 2e-3);
  expect_one_restitution<Mine, Impulsive, Fixed32>(1e-3, 1e-5);
  using NoPlan = Kernel<NoNumber, Impulsive, Fixed32>::PlanType;
  EXPECT_EQ(NoPlan::make(free_pair(0.5), bounds, 1e-3).status, PlanStatus::restitution);
  using NegativePlan = Kernel<Negative, Impulsive, Fixed32>::PlanType;
  EXPECT_EQ(NegativePlan::make(free_pair(0.5), bounds, 1e-3).status, PlanStatus::restitution);

  expect_the_same<Renamed, HuntCrossley, Moment>(3e-6);
  expect_the_same<Renamed, HuntCrossley, SubsteppedMoment<4>>(3e-6);
  expect_the_same<Renamed, HuntCrossley, EnergyConsistent>(1e-3);
  expect_the_same<Renamed, HuntCrossley, Impulsive>(1e-3);
  expect_the_same<Renamed, HuntCrossley, AverageAcceleration>(3e-6);
  expect_the_same<Linear, HookeNewton, Moment>(3e-6);
  expect_the_same<Linear, HookeNewton, EnergyConsistent>(3e-6);
  expect_the_same<Linear, HookeNewton, Impulsive>(1e-3);
}

// A saved state is not restored with a law that has another damping ratio.
TEST(Laws, AreDistinguishedInASavedState) {
  const auto identity_of = [](auto law) {
    return Kernel<decltype(law), Impulsive, Fixed32>::PlanType::make(free_pair(0.5), bounds, 1e-3).identity;
  };
  EXPECT_NE(identity_of(Flores{}), identity_of(HuGuo{}));
  EXPECT_NE(identity_of(Exact{}), identity_of(HuntCrossleyPerImpact{}));
}
template <class... Steppers> std::set<uint32_t> kinds_of() { return {Steppers::kind...}; }
TEST(Laws, SteppersAreDistinguishedInASavedState) {
  const std::set<uint32_t> kinds =
      kinds_of<AverageAcceleration, LinearAcceleration, FoxGoodwin, CentralDifference, Moment, EnergyConsistent,
               Impulsive, SubsteppedMoment<>, SubsteppedMoment<2>, SubsteppedMoment<4>, SubsteppedMoment<8>,
               SubsteppedMoment<16>, SubsteppedMoment<32>, SubsteppedMoment<64>, SubsteppedMoment<128>>();
  EXPECT_EQ(kinds.size(), 15U);
}

}  // namespace
}  // namespace impact::host
