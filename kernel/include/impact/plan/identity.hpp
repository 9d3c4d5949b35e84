// SPDX-License-Identifier: MIT
#pragma once
// Fingerprints of scene, state and contact, which saved states and changes of plan compare.

#include <impact/law/terms.hpp>
#include <impact/numeric/fingerprint.hpp>
#include <impact/numeric/units.hpp>
#include <impact/scene.hpp>
#include <impact/values.hpp>

namespace impact {

#define IMPACT_VALUE(name, ...) scene.name,
#define IMPACT_BOUND(name, ...) bounds.name,
constexpr Fingerprint fingerprint_of(const Scene& scene, const Bounds& bounds, double step, double damping_ratio,
                                     double longest_phase) {
  const double numbers[] = {IMPACT_MACHINE_VALUES(IMPACT_VALUE) damping_ratio, IMPACT_MACHINE_BOUNDS(IMPACT_BOUND) step,
                            longest_phase};
  Fingerprint fingerprint{};
  for (double number : numbers) fingerprint.add_number(number);
  fingerprint.add(static_cast<uint32_t>(scene.stops));
  fingerprint.add(static_cast<uint32_t>(scene.tension));
  return fingerprint;
}
// Includes the values of a rig that its plan does not read.
constexpr uint32_t fingerprint_of_rig(const Scene& scene, const Bounds& bounds, double step) {
  const double numbers[] = {IMPACT_LAW_VALUES(IMPACT_VALUE) IMPACT_PART_VALUES(IMPACT_VALUE)
                                IMPACT_PART_BOUNDS(IMPACT_BOUND)};
  Fingerprint fingerprint = fingerprint_of(scene, bounds, step, 0, 0);
  for (double number : numbers) fingerprint.add_number(number);
  return fingerprint.value;
}
#undef IMPACT_VALUE
#undef IMPACT_BOUND
// Everything that determines the units of a state. Samples of a base are in units of their bound, their immediate share
// in gravity's unit.
template <class Field>
constexpr Fingerprint fingerprint_of_state(const Scene& scene, const Bounds& bounds, double h,
                                           const UnitExponents& unit) {
  const double numbers[] = {bounds.displacement, bounds.speed, bounds.penetration, bounds.force, h, scene.clearance};
  Fingerprint fingerprint{};
  for (double number : numbers) fingerprint.add_number(number);
  fingerprint.add(static_cast<uint32_t>(scene.stops));
  fingerprint.add(static_cast<uint32_t>(unit.position));
  if constexpr (Field::is_sampled) {
    fingerprint.add_number(bounds.base_acceleration);
    fingerprint.add_number(scene.gravity);
  }
  return fingerprint;
}
// The parameters and units of an ongoing contact. With EnergyConsistent a resolved contact stores other numbers than a
// stiff one (is_sudden), which also depends on the pressing forces.
constexpr Fingerprint fingerprint_of_contact(const ContactTerms& terms, const UnitExponents& unit,
                                             const UnitExponents& own, bool is_sudden) {
  const double numbers[] = {terms.ball_mass, terms.main_mass,    terms.main_stiffness, terms.main_damping,
                            terms.stiffness, terms.damping_time, terms.deepest};
  Fingerprint fingerprint{};
  for (double number : numbers) fingerprint.add_number(number);
  const int units[] = {unit.penetration, own.penetration, own.recoil, unit.force};
  for (int exponent : units) fingerprint.add(static_cast<uint32_t>(exponent));
  fingerprint.add(is_sudden);
  return fingerprint;
}

}  // namespace impact
