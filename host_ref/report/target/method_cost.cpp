// The kernel's steps under a sine drive in one number format, IMPACT_NUMERIC.

#include "method_cost.hpp"

#include "configurations.hpp"

namespace impact::report {
namespace {

template <class Law, class... Newmarks>
void print_costs(target::List<Newmarks...>) {
  (print_cost<typename target::Configuration<Law, Newmarks, IMPACT_NUMERIC, Sine>::template Absorber<1000>,
              typename target::Configuration<Law, Newmarks, IMPACT_NUMERIC, Sine>::template Absorber<100>>(
       target::make_label<Law, Newmarks, IMPACT_NUMERIC, Sine>().text),
   ...);
}

}  // namespace
}  // namespace impact::report

int main() {
  using namespace impact;
  using Newmarks = target::List<Moment, AverageAcceleration, LinearAcceleration, FoxGoodwin, CentralDifference>;
  report::print_costs<HookeNewton>(Newmarks{});
  report::print_costs<Hertz>(Newmarks{});
  report::print_costs<HuntCrossley>(Newmarks{});
  return 0;
}
