// SPDX-License-Identifier: MIT
#pragma once
// The deepest penetration, m, that any state within the bounds can lead to, in the coupled machine. With V = 2
// Bounds::speed, mu the reduced mass and W(d) the energy that the law stores, the least of three balances:
//
//     energy of the machine       W <= (M + m) v^2/2 + k x^2/2 + 2 F x + 2 (M + m) a x
//     of the relative motion      W <= mu V^2/2 + P d                        P = mu (k x + c v + F)/M
//     momentum of the ball        W <= W0 + m V^2 + (m a + R) d
//
// v, x and F are the bounds of speed, displacement and drive, a is that of a field, and R the ball's dry friction. One
// per cent is added for rounding. Bounds::penetration, if stated, limits it further. Derivation: docs/contact.md.

#include <impact/numeric/constant_math.hpp>
#include <impact/scene.hpp>

namespace impact {

namespace detail {

// The root d of W(d) = energy + press d, by Newton's method from above: W is convex, and the sum of the roots for each
// part alone is above the root and less than twice it.
constexpr double depth_of(double stiffness, double energy, double press, bool is_linear) {
  const double scale = is_linear ? stiffness / 2 : 0.4 * stiffness;
  const auto root_of_order = [](double x, double order) { return x > 0 ? constant::power(x, 1 / order) : 0; };
  double d = is_linear ? constant::square_root(energy / scale) + press / scale
                       : root_of_order(energy / scale, 2.5) + root_of_order(press / scale, 1.5);
  for (int pass = 0; pass < 6; ++pass) {
    const double shape = is_linear ? d : d * constant::square_root(d),
                 slope = scale * shape * (is_linear ? 2 : 2.5) - press;
    if (!(slope > 0)) break;  // d is 0, or its power is below the smallest double
    d -= (scale * shape * d - energy - press * d) / slope;
  }
  return d;
}

}  // namespace detail

// The main mass's largest acceleration without contact, with a force of `drive` newtons, m/s^2.
constexpr double largest_acceleration(const Scene& scene, const Bounds& bounds, double drive) {
  return (scene.main_stiffness * bounds.displacement + scene.main_damping * bounds.speed + drive) / scene.main_mass;
}

// Of the ball at the start.
constexpr double initial_penetration(const Scene& scene) {
  if (scene.stops == Stops::none) return -scene.clearance;
  const double right = scene.x2 - scene.x1, apart = scene.stops == Stops::right  ? right
                                                    : scene.stops == Stops::left ? -right
                                                                                 : constant::magnitude(right);
  return apart - scene.clearance / 2;
}

// `damping` is a for Hunt-Crossley, or 0; `start` the depth at which the ball starts, or 0. The relative motion is that
// of a step which follows the law; the others hold whatever the force does.
constexpr double deepest_penetration(const Scene& scene, const Bounds& bounds, bool is_linear, double damping,
                                     double start, bool follows_law = true) {
  const double main = scene.main_mass, ball = scene.ball_mass, mu = 1 / (1 / main + 1 / ball);
  const double v = bounds.speed, x = bounds.displacement;
  const double drive = constant::larger(scene.drive_amplitude, bounds.force);
  const double field = constant::magnitude(scene.gravity) + bounds.base_acceleration;
  const double k1 = scene.contact_stiffness;
  const double stored = k1 * start * start * (is_linear ? 0.5 : 0.4 * constant::square_root(start));
  const double whole =
      stored + (main + ball) * (v * v / 2 + 2 * field * x) + scene.main_stiffness * x * x / 2 + 2 * drive * x;
  const double press = mu * largest_acceleration(scene, bounds, drive);
  const double kept =
      damping > 1e-3 ? 2 * (damping - constant::logarithm_of_one_plus(damping)) / (damping * damping) : 1;
  const double of_the_whole = detail::depth_of(k1, whole, 0, is_linear),
               of_the_approach = detail::depth_of(k1, stored + kept * 2 * mu * v * v, press, is_linear),
               by_impulse =
                   detail::depth_of(k1, stored + 4 * ball * v * v, ball * field + scene.ball_friction, is_linear);
  const double of_any_force = constant::smaller(of_the_whole, by_impulse),
               depth = 1.01 * (follows_law ? constant::smaller(of_any_force, of_the_approach) : of_any_force);
  return bounds.penetration > 0 ? constant::smaller(depth, bounds.penetration) : depth;
}

}  // namespace impact
