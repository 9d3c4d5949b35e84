// The cost of the kernel's steps under a sine drive in one number format, IMPACT_NUMERIC, of every stepper or of
// IMPACT_NEWMARK only. Those that have a budget are left to tests/target/step_cost.cpp.

#include "configurations.hpp"
#include "step_cost.hpp"

namespace impact::target {
namespace {

template <class Configuration, class... Listed>
constexpr bool is_among(List<Listed...>) {
  return ((Configuration::label == Listed::label.text) || ...);
}

#ifdef IMPACT_NEWMARK
template <class Newmark>
constexpr bool is_wanted = false;
template <>
constexpr bool is_wanted<IMPACT_NEWMARK> = true;
#else
template <class Newmark>
constexpr bool is_wanted = true;
#endif

template <class Law, class Newmark>
void print_unless_budgeted(Configuration<Law, Newmark, IMPACT_NUMERIC, Sine> configuration) {
  using Measured = decltype(configuration);
  if constexpr (is_wanted<Newmark> && !is_among<Measured>(Budgeted{})) print_costs<Measured>(Measured::label.text);
}
template <class OtherDrive>
void print_unless_budgeted(OtherDrive) {}

}  // namespace
}  // namespace impact::target

int main() {
  using namespace impact::target;
  for_each(all_configurations<IMPACT_NUMERIC>(), [](auto configuration) { print_unless_budgeted(configuration); });
  return 0;
}
