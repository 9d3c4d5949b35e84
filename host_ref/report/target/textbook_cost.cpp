// The baselines' steps. The library's sine and power are newlib's.

#include <host_ref/report/textbook_methods.hpp>

#include "configurations.hpp"
#include "method_cost.hpp"

extern "C" int* __errno() {
  static int error;
  return &error;
}

namespace impact::report {
namespace {

template <template <class, class, Law, class> class Method, class ContactLaw, class Power>
void print_method(const char* label) {
  using Configuration = target::Configuration<ContactLaw, AverageAcceleration, Float32Plain, Sine>;
  print_cost<Method<float, typename Configuration::template Rig<1000>, ContactLaw::law, Power>,
             Method<float, typename Configuration::template Rig<100>, ContactLaw::law, Power>>(label);
}

}  // namespace
}  // namespace impact::report

int main() {
  using namespace impact;
  using namespace impact::report;
  print_method<TextbookNewmark, HookeNewton, LibraryPower>("hooke-newton,textbook-newmark,float32-plain,sine");
  print_method<TextbookRk4, HookeNewton, LibraryPower>("hooke-newton,textbook-rk4,float32-plain,sine");
  print_method<TextbookNewmark, Hertz, LibraryPower>("hertz,textbook-newmark,float32-plain,sine");
  print_method<TextbookNewmark, Hertz, LibraryRoot>("hertz,textbook-newmark-sqrt,float32-plain,sine");
  print_method<TextbookRk4, Hertz, LibraryPower>("hertz,textbook-rk4,float32-plain,sine");
  print_method<TextbookRk4, Hertz, LibraryRoot>("hertz,textbook-rk4-sqrt,float32-plain,sine");
  print_method<TextbookRk4, Hertz, KernelLookup>("hertz,textbook-rk4-lookup,float32-plain,sine");
  print_method<TextbookNewmark, HuntCrossley, LibraryPower>("hunt-crossley,textbook-newmark,float32-plain,sine");
  print_method<TextbookNewmark, HuntCrossley, LibraryRoot>("hunt-crossley,textbook-newmark-sqrt,float32-plain,sine");
  print_method<TextbookRk4, HuntCrossley, LibraryPower>("hunt-crossley,textbook-rk4,float32-plain,sine");
  print_method<TextbookRk4, HuntCrossley, LibraryRoot>("hunt-crossley,textbook-rk4-sqrt,float32-plain,sine");
  print_method<TextbookRk4, HuntCrossley, KernelLookup>("hunt-crossley,textbook-rk4-lookup,float32-plain,sine");
  return 0;
}
