#pragma once
// The kernel behind the run-time interface, for one law and one format, with every stepper and drive. With Parts it has
// weight, a base that accelerates and dry friction, with every stepper except the classical ones. If their values are
// 0, the bits are those without these parts. CMakeLists.txt writes source files that instantiate plan_with_law, so that
// they compile in parallel.

#include "host_ref/any_field.hpp"
#include "host_ref/simulation_of.hpp"

namespace impact::host {

template <class Format, class ContactLaw, class... Parts>
Planned plan_with_law(const Request& request, const Bounds& bounds) {
  switch (request.stepper) {
#define IMPACT_PLAN(value, name, Type)                                                        \
  case Stepper::value:                                                                        \
    if constexpr (has_kernel(Stepper::value, sizeof...(Parts) > 0))                           \
      return plan_with_drive<Format, ContactLaw, Parts...>(serving(Type{}), request, bounds); \
    break;
    IMPACT_STEPPERS(IMPACT_PLAN)
    case Stepper::automatic:
      break;
  }
  std::abort();  // refused, or chosen, before
}

}  // namespace impact::host
