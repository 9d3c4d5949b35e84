// The cost of the kernel's steps with a sine drive, in the number format IMPACT_NUMERIC, for every stepper, also with a
// damping per impact. With IMPACT_WITH_PARTS there are weight, a base that shakes and friction instead.
// tests/target/step_cost.cpp has those with a budget.

#include "configurations.hpp"
#include "step_cost.hpp"

namespace impact::target {
namespace {

template <class Configuration, class... Listed> constexpr bool is_among(List<Listed...>) {
  return (is_same(Configuration::label.text, Listed::label.text) || ...);
}

template <class Law, class Newmark, class... Parts>
void print_unless_budgeted(Configuration<Law, Newmark, IMPACT_NUMERIC, Sine, Parts...> configuration) {
  using Measured = decltype(configuration);
  if constexpr (!is_among<Measured>(Budgeted{} + BudgetedWithParts{} + BudgetedWithFriction{}))
    print_costs<Measured>(Measured::label.text);
}
template <class OtherDrive> void print_unless_budgeted(OtherDrive) {}

#ifdef IMPACT_WITH_PARTS
template <class... Parts>
using With = List<Configuration<HuntCrossley, Moment, IMPACT_NUMERIC, Sine, Parts...>,
                  Configuration<HuntCrossley, SubsteppedMoment<4>, IMPACT_NUMERIC, Sine, Parts...>,
                  Configuration<HuntCrossley, EnergyConsistent, IMPACT_NUMERIC, Sine, Parts...>,
                  Configuration<HuntCrossley, Impulsive, IMPACT_NUMERIC, Sine, Parts...>>;
constexpr auto configurations = With<Gravity>{} + With<BaseAcceleration>{} + With<DryFriction>{} +
                                With<Gravity, DryFriction>{} + With<BaseAcceleration, DryFriction>{};
#else
constexpr auto configurations = all_configurations<IMPACT_NUMERIC>() + with_damping_per_impact<IMPACT_NUMERIC>();
#endif

}  // namespace
}  // namespace impact::target

int main() {
  using namespace impact::target;
  for_each(configurations, [](auto configuration) { print_unless_budgeted(configuration); });
  return 0;
}
