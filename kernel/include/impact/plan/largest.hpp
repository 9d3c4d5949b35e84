// SPDX-License-Identifier: MIT
#pragma once
// The largest values that the numbers of a step reach within the bounds. They determine the units of a plan
// (plan/making.hpp, docs/fixed_point.md). All are in SI units; rates and increments are times h and h^2, in m.

#include <impact/numeric/constant_math.hpp>
#include <impact/numeric/units.hpp>
#include <impact/plan/basis.hpp>
#include <impact/scene.hpp>

namespace impact {

[[gnu::cold]] constexpr UnitBounds largest_numbers(const PlanKind& kind, const PlanBasis& basis) {
  using constant::larger;
  const Scene& scene = basis.scene;
  const Bounds& bounds = basis.bounds;
  const ContactTerms& terms = basis.terms;
  const double h = terms.step;
  UnitBounds largest{};
  largest.gap = scene.stops == Stops::none ? 0 : scene.clearance / 2;
  largest.amplitude = bounds.speed / constant::square_root(larger(scene.main_stiffness / scene.main_mass, 1e-30));
  largest.position = bounds.displacement;
  largest.displacement_at_bound = bounds.speed * h;
  // With the change of h v by spring, damper and drive in half a step, and with the half of friction's impulse that
  // acts in the coming step.
  largest.displacement = largest.displacement_at_bound + h * h / 2 * terms.pressing;
  largest.displacement += basis.friction_displacement / 2;
  // If the ball can cross the clearance in a step, it may be up to two steps' displacement inside the stop when a
  // contact begins.
  const double displacement = terms.largest_rate * h * (terms.crosses() && !kind.contact.crosses_cavity ? 2 : 1);
  // Free flight from a state in contact ends deeper than the contact allows. With (d/D)^2 + (d'/V)^2 <= 1 (power
  // laws: (d/D)^(5/2)) it ends at most (D^2 + (5/4) (h V)^2)^(1/2) deep.
  const double longer = larger(terms.largest_penetration, displacement), depth = terms.largest_penetration / longer,
               flown = displacement / longer;
  const double of_flight = longer * constant::square_root(depth * depth + 1.25 * flown * flown);
  largest.penetration = of_flight;
  // Sub-steps see the flight between two states within the limit, which may be deeper by h^2 a/8.
  if (kind.contact.starts_from_rate)
    largest.penetration = larger(largest.penetration, limit_of(terms.largest_penetration) + h * h / 8 * terms.pressing);
  // In a step an impact changes the sliding rate by at most twice the largest rate, and friction by at most that
  // rate.
  const double largest_change = scene.ball_friction > 0 ? 4 * terms.largest_rate * h : 0;
  largest.penetration = larger(largest.penetration, largest_change);
  // A contact reads the rate of free flight at the step's end. Sub-steps also read their change of it.
  if (kind.contact.reads_rate)
    largest.penetration = larger(largest.penetration, (kind.contact.starts_from_rate ? 2.02 : 1.01) * h *
                                                          (terms.largest_rate + h * terms.pressing));
  const double in_field = h * h * terms.field;
  largest.displacement_at_bound += in_field;
  largest.displacement += in_field;
  // A force at the step's end also acts in the coming step, by at most half of its effect in a step.
  if (kind.contact.keeps_force) {
    UnitBounds of_forces = largest;
    kind.room(terms, of_forces);
    largest.displacement += of_forces.push / 2;
  }
  // In a sampled field the state is a position minus up to h^2 a/6 (motion/field.hpp).
  const double offset = kind.samples_field ? h * h * terms.field / 6 : 0;
  largest.limits.main = limit_of(bounds.displacement + offset);
  largest.limits.displacement = limit_of(largest.displacement);
  largest.limits.speed = limit_of(bounds.speed * h);
  // A displacement may just have passed its limit, since the check comes afterwards.
  const double spring = scene.main_stiffness * (largest.limits.main + 2 * largest.limits.displacement),
               damper = scene.main_damping * 2 * largest.limits.displacement / h;
  largest.increment = h * h * (2 * larger(scene.drive_amplitude, bounds.force) + spring + damper) / scene.main_mass +
                      2 * h * h * terms.field;
  largest.is_lightly_damped = 8 * basis.flow.damping() <= basis.flow.stiffness();
  kind.room(terms, largest);
  // The contact may have lowered it. Friction compares the displacements of both masses.
  if (largest_change > 0)
    largest.penetration = larger(largest.penetration, larger(largest_change, 2 * largest.limits.displacement));
  // The ball may start at any depth. Other steppers reject a deep start.
  if (kind.contact.is_instantaneous)
    largest.penetration = larger(largest.penetration, initial_penetration(scene) + displacement);
  // With Impulsive and with a force at the step's end, free flight may end deeper than the other bounds allow.
  const bool is_stated = bounds.penetration > 0 && (kind.contact.keeps_force || terms.deepest >= bounds.penetration),
             is_of_flight = (kind.contact.keeps_force || largest.is_as_deep_as_flight) && !is_stated;
  largest.limits.penetration = limit_of(kind.contact.is_instantaneous ? largest.penetration
                                        : is_of_flight ? constant::smaller(of_flight, largest.penetration)
                                                       : terms.largest_penetration);
  // Between two stops the ball is limited by them.
  const bool is_between = scene.stops == Stops::both;
  largest.limits.ball = largest.limits.main;
  if (is_between)
    largest.limits.ball +=
        largest.gap + larger(limit_of(largest.penetration), largest.limits.penetration) + largest.limits.displacement;
  largest.apart = (is_between ? largest.limits.ball : 2 * largest.limits.main) + 2 * largest.limits.displacement;
  // The unit of penetrations must also have room for rates, even of a state that has just passed its limits. `ahead`
  // is the largest difference between a displacement of the coming step and a speed.
  const LinearFlow& flow = basis.flow;
  const double ahead = constant::magnitude(1 / flow.e12 - 1) * largest.limits.displacement +
                       constant::magnitude(flow.e11 / flow.e12) * (largest.limits.main + largest.limits.displacement) +
                       h * h * (larger(scene.drive_amplitude, bounds.force) / scene.main_mass + terms.field);
  largest.penetration = larger(largest.penetration, larger(ahead, 2 * largest.limits.displacement));
  return largest;
}

}  // namespace impact
