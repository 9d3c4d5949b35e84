#pragma once
// The kernel with weight, a base that accelerates and dry friction behind the run-time interface, as
// simulation_instance.hpp has it without. Values of 0 make the bits of an absorber that does not name the part.

#include "host_ref/any_field.hpp"
#include "host_ref/simulation_of.hpp"

namespace impact::host {

template <class Format, class ContactLaw, class Stepper>
Planned plan_in_field(const Request& request, const Bounds& bounds) {
  return plan_with_drive<Format, ContactLaw, Stepper, AnyField, DryFriction>(request, bounds);
}

template <class Format, class ContactLaw>
Planned plan_with_parts(const Request& request, const Bounds& bounds) {
  switch (request.stepper) {
    case Stepper::moment_4:
      return plan_in_field<Format, ContactLaw, SubsteppedMoment<4>>(request, bounds);
    case Stepper::moment_8:
      return plan_in_field<Format, ContactLaw, SubsteppedMoment<8>>(request, bounds);
    case Stepper::moment_n:
      return plan_in_field<Format, ContactLaw, SubsteppedMoment<>>(request, bounds);
    case Stepper::energy:
      return plan_in_field<Format, ContactLaw, EnergyConsistent>(request, bounds);
    case Stepper::impulsive:
      return plan_in_field<Format, ContactLaw, Impulsive>(request, bounds);
    case Stepper::moment:
      return plan_in_field<Format, ContactLaw, Moment>(request, bounds);
    case Stepper::average:
    case Stepper::linear:
    case Stepper::fox_goodwin:
    case Stepper::central:
    case Stepper::automatic:
      break;
  }
  std::abort();  // refused, or chosen, before
}

}  // namespace impact::host
