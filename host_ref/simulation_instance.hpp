#pragma once
// The kernel behind the run-time interface under one law in one format, with every stepper and drive; with Parts with
// weight, a base that accelerates and dry friction, of which values of 0 make the bits of an absorber that names none.
// Source files that CMakeLists.txt writes instantiate plan_with_law, so that they compile side by side.

#include "host_ref/any_field.hpp"
#include "host_ref/simulation_of.hpp"

namespace impact::host {

template <class Format, class ContactLaw, class... Parts>
Planned plan_with_law(const Request& request, const Bounds& bounds) {
  const auto by = [&](auto stepper) {
    return plan_with_drive<Format, ContactLaw, decltype(stepper), Parts...>(request, bounds);
  };
  switch (request.stepper) {
    case Stepper::moment:
      return by(Moment{});
    case Stepper::moment_4:
      return by(SubsteppedMoment<4>{});
    case Stepper::moment_8:
      return by(SubsteppedMoment<8>{});
    case Stepper::moment_n:
      return by(SubsteppedMoment<>{});
    case Stepper::energy:
      return by(EnergyConsistent{});
    case Stepper::impulsive:
      return by(Impulsive{});
    default:
      break;
  }
  if constexpr (sizeof...(Parts) == 0) switch (request.stepper) {
      case Stepper::average:
        return by(AverageAcceleration{});
      case Stepper::linear:
        return by(LinearAcceleration{});
      case Stepper::fox_goodwin:
        return by(FoxGoodwin{});
      case Stepper::central:
        return by(CentralDifference{});
      default:
        break;
    }
  std::abort();  // refused, or chosen, before
}

}  // namespace impact::host
