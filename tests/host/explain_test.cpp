// explain() is a constant expression in firmware, and the first explanation here is one. A plan accepts the limits that
// it returns.

#include <gtest/gtest.h>

#include <impact/absorber.hpp>
#include <impact/explain.hpp>

namespace impact {
namespace {

using Fixed = Plan<Fixed32, HuntCrossley, Moment, Sine>;

// The explanation for the paper's scene and its bounds, with one value changed.
template <class PlanType> constexpr Explanation changed(Parameter parameter, double value, double step = 1e-3) {
  Values values{Scene{}, Bounds{}, step};
  *values.find(parameter) = value;
  return explain<PlanType>(values.scene, values.bounds, values.step);
}
template <class PlanType> constexpr bool accepts(Parameter parameter, double value, double step = 1e-3) {
  Values values{Scene{}, Bounds{}, step};
  *values.find(parameter) = value;
  return PlanType::make(values.scene, values.bounds, values.step).status == PlanStatus::ok;
}

constexpr Explanation too_long = changed<Fixed>(Parameter::step, 20e-3);
static_assert(too_long.parameter == Parameter::step && too_long.value == 20e-3);
// h c/mu = 2.5 at 33.5 mm, the deepest penetration by 4 m/s, spring and drive: h = 2.5 0.2308 kg/(19560 33.5e-3^1.5).
static_assert(too_long.allowed.most > 4.7e-3 && too_long.allowed.most < 5e-3);
static_assert(accepts<Fixed>(Parameter::step, too_long.allowed.least));
static_assert(accepts<Fixed>(Parameter::step, too_long.allowed.most));
static_assert(!accepts<Fixed>(Parameter::step, 1.00001 * too_long.allowed.most));
// What is accepted needs no change.
constexpr Explanation suits = changed<Fixed>(Parameter::step, 1e-3);
static_assert(suits.parameter == Parameter::step && suits.allowed.holds(suits.value));

// An unstated damping is the paper's c1, and valid only with the paper's law and stiffness.
template <class Law> PlanStatus unstated_at(double stiffness) {
  Scene scene;
  scene.contact_stiffness = stiffness;
  return Plan<Fixed32, Law, Moment, Sine>::make(scene, Bounds{}, 1e-4).status;
}
TEST(Explain, NamesADampingThatIsUnstated) {
  EXPECT_EQ(unstated_at<HuntCrossley>(32600), PlanStatus::ok);
  EXPECT_EQ(unstated_at<HuntCrossley>(32601), PlanStatus::contact_damping_unstated);
  EXPECT_EQ(unstated_at<HookeNewton>(32600), PlanStatus::contact_damping_unstated);
  EXPECT_EQ(unstated_at<Hertz>(1e5), PlanStatus::ok);
  EXPECT_EQ(unstated_at<Exact>(1e5), PlanStatus::ok);
  const Explanation nearly_elastic = changed<Fixed>(Parameter::contact_stiffness, 1e6, 1e-4);
  EXPECT_EQ(nearly_elastic.parameter, Parameter::contact_damping);
  EXPECT_TRUE(nearly_elastic.allowed.holds(0.7 * 19560));
}

// With the bound of 0.1 m no ball reaches a stop if half of the clearance is above 0.2 m.
TEST(Explain, NamesAClearanceInMillimetres) {
  const Explanation in_millimetres = changed<Fixed>(Parameter::clearance, 12);
  EXPECT_EQ(in_millimetres.parameter, Parameter::clearance);
  EXPECT_GT(in_millimetres.allowed.most, 0.3999);
  EXPECT_TRUE(accepts<Fixed>(Parameter::clearance, 0.4));
  EXPECT_FALSE(accepts<Fixed>(Parameter::clearance, 0.401));
}

using Double = Plan<Float64, HuntCrossley, Moment, Sine>;

// A start beyond a bound names that bound.
TEST(Explain, NamesTheBoundThatAStartExceeds) {
  Scene scene;
  scene.x1 = scene.x2 = -0.25;
  const Explanation beyond = explain<Double>(scene, Bounds{}, 1e-3);
  EXPECT_EQ(beyond.parameter, Parameter::displacement_bound);
  EXPECT_EQ(beyond.value, 0.1);
  EXPECT_EQ(beyond.allowed.least, 0.25);
  EXPECT_GT(beyond.allowed.most, 1);  // up to 1.6 m by the spring
}

// A ball that starts deeper in a stop than any motion within the bounds, which is 26.2 mm in the paper's scene. A step
// there may multiply the energy, and floating point would raise no fault.
TEST(Explain, NamesAStartThatIsTooDeep) {
  const Explanation too_deep = changed<Double>(Parameter::x2, -0.1);
  EXPECT_EQ(too_deep.parameter, Parameter::x2);
  EXPECT_EQ(too_deep.value, -0.1);
  EXPECT_NEAR(too_deep.allowed.least, -0.03615, 0.00015);
  EXPECT_EQ(too_deep.allowed.most, 0);
  EXPECT_TRUE(accepts<Double>(Parameter::x2, too_deep.allowed.least));
  EXPECT_FALSE(accepts<Double>(Parameter::x2, 1.00001 * too_deep.allowed.least));
  EXPECT_EQ(changed<Fixed>(Parameter::x1, 0.09).parameter, Parameter::x1);
}

// If a field's effect in a step is too large for the bounds, the field is named.
template <class Part> using InField = Plan<Fixed32, HuntCrossley, Moment, Sine, Part>;
TEST(Explain, NamesAFieldThatIsTooStrong) {
  using Shaken = InField<BaseAcceleration>;
  Scene scene;
  scene.gravity = -9.81;
  Bounds bounds;
  bounds.base_acceleration = 1e6;
  const Explanation shaken = explain<Shaken>(scene, bounds, 1e-3);
  EXPECT_EQ(shaken.parameter, Parameter::base_acceleration_bound);
  EXPECT_LT(shaken.allowed.most, 1e6);
  bounds.base_acceleration = shaken.allowed.most;
  EXPECT_EQ(Shaken::make(scene, bounds, 1e-3).status, PlanStatus::ok);
  scene.gravity = -1e6;
  const Explanation heavy = explain<InField<Gravity>>(scene, Bounds{}, 1e-3);
  EXPECT_EQ(heavy.parameter, Parameter::gravity);
  EXPECT_GT(heavy.allowed.least, -1e6);
  EXPECT_EQ(heavy.allowed.most, 0);
}

template <class PlanType> Explanation explanation_with_accepted_limits(Values values) {
  const Explanation said = explain<PlanType>(values.scene, values.bounds, values.step);
  for (const double limit : {said.allowed.least, said.allowed.most}) {
    *values.find(said.parameter) = limit;
    EXPECT_EQ(PlanType::make(values.scene, values.bounds, values.step).status, PlanStatus::ok)
        << name_of(said.parameter) << " " << limit;
  }
  return said;
}

// No step has room for a penetration of 10 km beside a vibration of 2 m/s, with a stepper that reads this bound. The
// explanation names another value, whose limits are accepted.
TEST(Explain, NamesABoundThatLeavesNoRoom) {
  using Classical = Absorber<AtRunTime, HuntCrossley, AverageAcceleration, Sine, Fixed32>::PlanType;
  Values values{Scene{}, Bounds{}, 1e-3};
  values.bounds.penetration = 1e4;
  const Explanation said = explanation_with_accepted_limits<Classical>(values);
  EXPECT_FALSE(said.allowed.holds(said.value)) << name_of(said.parameter);
}

// A limit of a value of 0 is not a multiple of it: a clearance of 0 in a field, which the ball must not cross in a
// step.
TEST(Explain, NamesAClearanceOfNothing) {
  Values values{Scene{}, Bounds{}, 1e-4};
  values.scene.clearance = 0;
  values.scene.gravity = -9.81;
  const Explanation said = explanation_with_accepted_limits<InField<Gravity>>(values);
  EXPECT_EQ(said.parameter, Parameter::clearance) << name_of(said.parameter);
}

TEST(Explain, NamesEveryValueAsItsMember) {
  EXPECT_STREQ(name_of(Parameter::main_mass), "main_mass");
  EXPECT_STREQ(name_of(Parameter::v2), "v2");
  EXPECT_STREQ(name_of(Parameter::force_bound), "force_bound");
  EXPECT_STREQ(name_of(Parameter::step), "step");
}

// For a value outside its own range, that range is the allowed one.
TEST(Explain, NamesTheValueThatIsOutOfItsRange) {
  for (int i = 0; i < static_cast<int>(Parameter::step); ++i) {
    const auto parameter = static_cast<Parameter>(i);
    for (const double value : {-1e30, range_of(parameter).least - 1, 1.1 * range_of(parameter).most, 0.0 / 0.0}) {
      const Explanation said = changed<Fixed>(parameter, value);
      EXPECT_EQ(said.parameter, parameter) << name_of(parameter) << " " << value;
      EXPECT_TRUE(said.value == value || value != value) << name_of(parameter) << " " << value;
      const double least = parameter == Parameter::drive_pulsation ? 0x1p-24 / 1e-3 : range_of(parameter).least;
      EXPECT_EQ(said.allowed.least, least) << name_of(parameter) << " " << value;
      EXPECT_EQ(said.allowed.most, range_of(parameter).most) << name_of(parameter) << " " << value;
    }
  }
}

}  // namespace
}  // namespace impact
