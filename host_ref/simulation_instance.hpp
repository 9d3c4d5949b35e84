#pragma once
// The kernel behind the run-time interface, for one law and one format, with every stepper and drive. It has weight, a
// base that accelerates and dry friction, with every stepper except the classical ones. If their values are 0, the bits
// are those of a kernel without these parts. EnergyConsistent, whose stiff contacts round otherwise in a field, has a
// kernel for each. CMakeLists.txt writes source files that instantiate plan_with_law, so that they compile in parallel.

#include "host_ref/any_field.hpp"
#include "host_ref/simulation_of.hpp"

namespace impact::host {

#if defined(IMPACT_PLAIN_KERNELS)  // as most firmware has it, for the report, which measures its time
template <class Format, class ContactLaw, bool, class Stepper>
Planned plan_with_stepper(Stepper, const Request& request, const Bounds& bounds) {
  if (request.drive != DriveKind::sine) std::abort();
  return plan_for<Format, ContactLaw, Stepper, Sine>(request, bounds);
}
#else
// A request without a drive has samples of 0. If Bounds::force is stated, the plan still reserves room for it.
template <class Format, class ContactLaw, bool is_plain, class Stepper>
Planned plan_with_stepper(Stepper, Request request, Bounds bounds) {
  constexpr bool has_both = std::is_same_v<Stepper, EnergyConsistent>;
  if (request.drive != DriveKind::sine) request.scene.drive_pulsation = 0;
  if (request.drive == DriveKind::none) {
    request.scene.drive_amplitude = larger(request.scene.drive_amplitude, bounds.force);
    bounds.force = 0;
  }
  if constexpr (is_plain || has_both)
    if (is_plain || !has_parts(request)) return plan_for<Format, ContactLaw, Stepper, AnyDrive>(request, bounds);
  if constexpr (!is_plain)
    return plan_for<Format, ContactLaw, Stepper, AnyDrive, AnyField, DryFriction>(request, bounds);
  std::abort();
}
#endif

template <class Format, class ContactLaw> Planned plan_with_law(const Request& request, const Bounds& bounds) {
  switch (request.stepper) {
#define IMPACT_PLAN(value, name, Type) \
  case Stepper::value:                 \
    return plan_with_stepper<Format, ContactLaw, is_classical(Stepper::value)>(serving(Type{}), request, bounds);
    IMPACT_STEPPERS(IMPACT_PLAN)
    case Stepper::automatic:
      break;
  }
  std::abort();  // chosen before
}

}  // namespace impact::host
