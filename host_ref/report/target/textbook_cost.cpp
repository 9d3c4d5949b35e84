// The baselines' steps. The library's sine and power are newlib's.

#include <host_ref/report/textbook_methods.hpp>

#include "configurations.hpp"
#include "step_cost.hpp"

extern "C" int* __errno() {
  static int error;
  return &error;
}

namespace impact::report {
namespace {

template <template <class, class, Law, class> class Method, class ContactLaw, class Power> struct Baseline {
  using Kernel = target::Configuration<ContactLaw, AverageAcceleration, Float32Plain, Sine>;
  template <int microseconds>
  using Absorber = Method<float, typename Kernel::template Rig<microseconds>, ContactLaw::law, Power>;
  static void sample(uint32_t) {}
  template <class Model> static void advance(Model& model) { model.step(); }
};
template <template <class, class, Law, class> class Method, class ContactLaw, class Power>
void print_method(const char* label) {
  target::print_costs<Baseline<Method, ContactLaw, Power>>(label);
}

}  // namespace
}  // namespace impact::report

int main() {
  using namespace impact;
  using namespace impact::report;
  print_method<TextbookNewmark, HookeNewton, LibraryPower>("hooke-newton,textbook-newmark,float32-plain,sine");
  print_method<TextbookRk4, HookeNewton, LibraryPower>("hooke-newton,textbook-rk4,float32-plain,sine");
  print_method<TunedRk4, HookeNewton, LibraryRoot>("hooke-newton,tuned-rk4,float32-plain,sine");
  print_method<TextbookNewmark, Hertz, LibraryPower>("hertz,textbook-newmark,float32-plain,sine");
  print_method<TextbookNewmark, Hertz, LibraryRoot>("hertz,textbook-newmark-sqrt,float32-plain,sine");
  print_method<TextbookRk4, Hertz, LibraryPower>("hertz,textbook-rk4,float32-plain,sine");
  print_method<TextbookRk4, Hertz, LibraryRoot>("hertz,textbook-rk4-sqrt,float32-plain,sine");
  print_method<TextbookRk4, Hertz, KernelLookup>("hertz,textbook-rk4-lookup,float32-plain,sine");
  print_method<TunedRk4, Hertz, LibraryRoot>("hertz,tuned-rk4,float32-plain,sine");
  print_method<TextbookNewmark, HuntCrossley, LibraryPower>("hunt-crossley,textbook-newmark,float32-plain,sine");
  print_method<TextbookNewmark, HuntCrossley, LibraryRoot>("hunt-crossley,textbook-newmark-sqrt,float32-plain,sine");
  print_method<TextbookRk4, HuntCrossley, LibraryPower>("hunt-crossley,textbook-rk4,float32-plain,sine");
  print_method<TextbookRk4, HuntCrossley, LibraryRoot>("hunt-crossley,textbook-rk4-sqrt,float32-plain,sine");
  print_method<TextbookRk4, HuntCrossley, KernelLookup>("hunt-crossley,textbook-rk4-lookup,float32-plain,sine");
  print_method<TunedRk4, HuntCrossley, LibraryRoot>("hunt-crossley,tuned-rk4,float32-plain,sine");
  return 0;
}
