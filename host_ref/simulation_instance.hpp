#pragma once
// The kernel behind the run-time interface under one law in one format, with every stepper and drive. A source file for
// each pair, written by CMakeLists.txt, instantiates plan_with_law, so that they compile side by side.

#include "host_ref/simulation_of.hpp"

namespace impact::host {

template <class Format, class ContactLaw>
Planned plan_with_law(const Request& request, const Bounds& bounds) {
  switch (request.stepper) {
    case Stepper::average:
      return plan_with_drive<Format, ContactLaw, AverageAcceleration>(request, bounds);
    case Stepper::linear:
      return plan_with_drive<Format, ContactLaw, LinearAcceleration>(request, bounds);
    case Stepper::fox_goodwin:
      return plan_with_drive<Format, ContactLaw, FoxGoodwin>(request, bounds);
    case Stepper::central:
      return plan_with_drive<Format, ContactLaw, CentralDifference>(request, bounds);
    case Stepper::moment_4:
      return plan_with_drive<Format, ContactLaw, SubsteppedMoment<4>>(request, bounds);
    case Stepper::moment_8:
      return plan_with_drive<Format, ContactLaw, SubsteppedMoment<8>>(request, bounds);
    case Stepper::moment_n:
      return plan_with_drive<Format, ContactLaw, SubsteppedMoment<>>(request, bounds);
    case Stepper::energy:
      return plan_with_drive<Format, ContactLaw, EnergyConsistent>(request, bounds);
    case Stepper::impulsive:
      return plan_with_drive<Format, ContactLaw, Impulsive>(request, bounds);
    case Stepper::moment:
      return plan_with_drive<Format, ContactLaw, Moment>(request, bounds);
    case Stepper::automatic:
      break;
  }
  std::abort();  // refused, or chosen, before
}

}  // namespace impact::host
