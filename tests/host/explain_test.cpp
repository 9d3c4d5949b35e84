// explain() as a constant expression in firmware. The limits that it returns are accepted.

#include <gtest/gtest.h>

#include <impact/absorber.hpp>
#include <impact/explain.hpp>
#include <string>

namespace impact {
namespace {

using Fixed = Plan<Fixed32, HuntCrossley, Moment, Sine>;

// Of the paper's scene and its bounds, with one value changed.
template <class PlanType>
constexpr Explanation changed(Parameter parameter, double value, double step = 1e-3) {
  Values values{Scene{}, Bounds{}, step};
  *values.find(parameter) = value;
  return explain<PlanType>(values.scene, values.bounds, values.step);
}
template <class PlanType>
constexpr bool accepts(Parameter parameter, double value, double step = 1e-3) {
  Values values{Scene{}, Bounds{}, step};
  *values.find(parameter) = value;
  return PlanType::make(values.scene, values.bounds, values.step).status == PlanStatus::ok;
}

constexpr Explanation too_long = changed<Fixed>(Parameter::step, 20e-3);
static_assert(too_long.parameter == Parameter::step && too_long.value == 20e-3);
// h c/mu = 2.5 where 4 m/s, the spring and the drive press the ball 33.5 mm deep: 2.5 0.2308 kg / (19560 33.5e-3^1.5)
static_assert(too_long.allowed.most > 4.7e-3 && too_long.allowed.most < 5e-3);
static_assert(accepts<Fixed>(Parameter::step, too_long.allowed.least));
static_assert(accepts<Fixed>(Parameter::step, too_long.allowed.most));
static_assert(!accepts<Fixed>(Parameter::step, 1.00001 * too_long.allowed.most));

// A value out of its own range has that range.
constexpr Explanation negative = changed<Fixed>(Parameter::main_mass, -1);
static_assert(negative.parameter == Parameter::main_mass && negative.value == -1);
static_assert(negative.allowed.least == main_mass_range.least && negative.allowed.most == main_mass_range.most);

// A c1 that nobody stated is the paper's with the paper's law and stiffness, and no other's.
template <class Law>
constexpr PlanStatus unstated_at(double stiffness) {
  Scene scene;
  scene.contact_stiffness = stiffness;
  return Plan<Fixed32, Law, Moment, Sine>::make(scene, Bounds{}, 1e-4).status;
}
static_assert(unstated_at<HuntCrossley>(32600) == PlanStatus::ok);
static_assert(unstated_at<HuntCrossley>(32601) == PlanStatus::contact_damping_unstated);
static_assert(unstated_at<HookeNewton>(32600) == PlanStatus::contact_damping_unstated);
static_assert(unstated_at<Hertz>(1e5) == PlanStatus::ok && unstated_at<Exact>(1e5) == PlanStatus::ok);
constexpr Explanation nearly_elastic = changed<Fixed>(Parameter::contact_stiffness, 1e6, 1e-4);
static_assert(nearly_elastic.parameter == Parameter::contact_damping && nearly_elastic.allowed.holds(0.7 * 19560));

// A stop that no ball within the bound of 0.1 m meets: half of the clearance is more than 0.2 m.
constexpr Explanation in_millimetres = changed<Fixed>(Parameter::clearance, 12);
static_assert(in_millimetres.parameter == Parameter::clearance && in_millimetres.allowed.most > 0.3999);
static_assert(accepts<Fixed>(Parameter::clearance, 0.4) && !accepts<Fixed>(Parameter::clearance, 0.401));

// A start beyond a bound: the bound that holds it.
constexpr Explanation beyond = [] {
  Scene scene;
  scene.x1 = scene.x2 = -0.25;
  return explain<Plan<Float64, HuntCrossley, Moment, Sine>>(scene, Bounds{}, 1e-3);
}();
static_assert(beyond.parameter == Parameter::displacement_bound && beyond.value == 0.1);
static_assert(beyond.allowed.least == 0.25 && beyond.allowed.most > 1);  // and no further: a spring of 1.6 m

// A ball that starts deeper in a stop than any motion within the bounds would bring it: there a step may multiply the
// energy, which floating point would not say. 26.2 mm at the bounds of the paper's scene.
constexpr Explanation too_deep = changed<Plan<Float64, HuntCrossley, Moment, Sine>>(Parameter::x2, -0.1);
static_assert(too_deep.parameter == Parameter::x2 && too_deep.value == -0.1);
static_assert(too_deep.allowed.least < -0.036 && too_deep.allowed.least > -0.0363 && too_deep.allowed.most == 0);
static_assert(accepts<Plan<Float64, HuntCrossley, Moment, Sine>>(Parameter::x2, too_deep.allowed.least));
static_assert(!accepts<Plan<Float64, HuntCrossley, Moment, Sine>>(Parameter::x2, 1.00001 * too_deep.allowed.least));
static_assert(changed<Fixed>(Parameter::x1, 0.09).parameter == Parameter::x1);

// A field of which a step is too much beside the bounds: the field, and not the bound that it leaves no room.
template <class Part>
using InField = Plan<Fixed32, HuntCrossley, Moment, Sine, Part>;
constexpr Scene in_gravity(double gravity) {
  Scene scene;
  scene.gravity = gravity;
  return scene;
}
constexpr Bounds shaken_by(double base) {
  Bounds bounds;
  bounds.base_acceleration = base;
  return bounds;
}
constexpr Explanation shaken = explain<InField<BaseAcceleration>>(in_gravity(-9.81), shaken_by(1e6), 1e-3),
                      heavy = explain<InField<Gravity>>(in_gravity(-1e6), Bounds{}, 1e-3);
static_assert(shaken.parameter == Parameter::base_acceleration_bound && shaken.allowed.most < 1e6);
static_assert(InField<BaseAcceleration>::make(in_gravity(-9.81), shaken_by(shaken.allowed.most), 1e-3).status ==
              PlanStatus::ok);
static_assert(heavy.parameter == Parameter::gravity && heavy.allowed.least > -1e6 && heavy.allowed.most == 0);

// No step makes room for a penetration of 10 km beside a vibration of 2 m/s: what is named instead does.
TEST(Explain, NamesABoundThatLeavesNoRoom) {
  Values values{Scene{}, Bounds{}, 1e-3};
  values.bounds.penetration = 1e4;
  const Explanation said = explain<Fixed>(values.scene, values.bounds, values.step);
  EXPECT_FALSE(said.allowed.holds(said.value)) << name_of(said.parameter);
  for (const double limit : {said.allowed.least, said.allowed.most}) {
    *values.find(said.parameter) = limit;
    EXPECT_EQ(Fixed::make(values.scene, values.bounds, values.step).status, PlanStatus::ok)
        << name_of(said.parameter) << " " << limit;
  }
}

// Nothing is a multiple of 0: no clearance in a field, where the ball must not cross it in a step.
TEST(Explain, NamesAClearanceOfNothing) {
  Values values{Scene{}, Bounds{}, 1e-4};
  values.scene.clearance = 0;
  values.scene.gravity = -9.81;
  using Upright = InField<Gravity>;
  const Explanation said = explain<Upright>(values.scene, values.bounds, values.step);
  EXPECT_EQ(said.parameter, Parameter::clearance) << name_of(said.parameter);
  for (const double limit : {said.allowed.least, said.allowed.most}) {
    *values.find(said.parameter) = limit;
    EXPECT_EQ(Upright::make(values.scene, values.bounds, values.step).status, PlanStatus::ok) << limit;
  }
}

TEST(Explain, NamesEveryValueAsItsMember) {
  EXPECT_STREQ(name_of(Parameter::main_mass), "main_mass");
  EXPECT_STREQ(name_of(Parameter::v2), "v2");
  EXPECT_STREQ(name_of(Parameter::force_bound), "force_bound");
  EXPECT_STREQ(name_of(Parameter::step), "step");
}

// Each value far out of its range, below and above: it is the one that is named.
TEST(Explain, NamesTheValueThatIsOutOfItsRange) {
  for (int i = 0; i < static_cast<int>(Parameter::step); ++i) {
    const auto parameter = static_cast<Parameter>(i);
    for (const double value : {-1e30, 1e30, 0.0 / 0.0}) {
      const Explanation said = changed<Fixed>(parameter, value);
      EXPECT_EQ(said.parameter, parameter) << name_of(parameter) << " " << value;
      EXPECT_FALSE(said.allowed.holds(value)) << name_of(parameter) << " " << value;
      EXPECT_LE(said.allowed.least, said.allowed.most) << name_of(parameter) << " " << value;
    }
  }
}

}  // namespace
}  // namespace impact
