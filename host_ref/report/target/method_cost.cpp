// The kernel's steps under a sine drive in one number format, IMPACT_NUMERIC.

#include "method_cost.hpp"

#include "configurations.hpp"

namespace impact::report {
namespace {

template <class Law, class Newmark>
void print_if_sine(target::Configuration<Law, Newmark, IMPACT_NUMERIC, Sine> configuration) {
  using Configuration = decltype(configuration);
  print_cost<typename Configuration::template Absorber<1000>, typename Configuration::template Absorber<100>>(
      Configuration::label.text);
}
template <class Other>
void print_if_sine(Other) {}

}  // namespace
}  // namespace impact::report

int main() {
  using namespace impact;
  target::for_each(target::all_configurations<IMPACT_NUMERIC>(),
                   [](auto configuration) { report::print_if_sine(configuration); });
  return 0;
}
