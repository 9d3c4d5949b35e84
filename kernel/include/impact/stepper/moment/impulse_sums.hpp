// SPDX-License-Identifier: MIT
#pragma once
// What the contact's impulses in the sub-steps of a step have done so far, accumulated separately for each mass:
//
//     ball        displacement y += w/n                    w: rate, per step
//     main mass   (x, u) by its own exact flow over a sub-step, linear_flow.hpp. The flow's part of u is a sum of its
//                 own, because a sub-step's is below an LSB of u
//
// An impulse is in units of its effect in a sub-step, and the ball has its share of y and w. What the flow adds to u
// has a finer unit. Both masses' displacements reduce the penetration. Derivation: kernel/docs/moment.md.

#include <stddef.h>

#include <impact/law/terms.hpp>
#include <impact/motion/linear_flow.hpp>
#include <impact/numeric/in.hpp>
#include <impact/numeric/units.hpp>
#include <impact/stepper/contact.hpp>
#include <impact/stepper/moment/response.hpp>

namespace impact {

namespace detail {
// Of a power of two.
constexpr int binary_exponent(int n) { return constant::exponent_above(n + 0.5) - 1; }
}  // namespace detail

// For up to `most` sub-steps, a power of two.
template <class Format, int most> struct ImpulseSums {
  using Value = typename Format::Value;
  using Gain = typename Format::Gain;
  using Penetration = impact::Penetration<Value>;
  using Recoil = impact::Recoil<Value>;

  // The main mass's flow over k = 2^i sub-steps, less (1 k/n; 0 1), divided by k/n. u has an acceleration.
  struct Stride {
    Gain part, by_x_to_x, by_u_to_x, by_x_to_u, by_u_to_u;  // part: k/n
  };
  struct Plan {
    int exponent;                                                        // n = 2^exponent
    Stride strides[static_cast<size_t>(detail::binary_exponent(most))];  // over 1, 2, 4, .. sub-steps
    int flow_bits;     // what the flow adds to u is in a unit that is 2^flow_bits as fine as that of u
    int bending_bits;  // from that unit to penetrations
    int moment_bits;   // the impulses' own unit is 2^moment_bits as fine as a step's
    GainOf<Gain, unit::Force, unit::Recoil> by_impulse, by_moment;  // of Hooke-Newton, from forces
    Gain main_x, main_u, main_u_by_moment, ball;                    // the masses' shares in these
    int travel_bits;                                                // from these to penetrations

    // `terms`, `response` and the units `own` are those of a sub-step. `main` has no drive.
    static constexpr Plan make(const ContactTerms& terms, const Scene& main, const MomentResponse& response,
                               const UnitExponents& unit, const UnitExponents& own) {
      const double n = terms.parts, part = terms.step, mobility = response.mobility(terms),
                   of_force = terms.force_unit * part * part * mobility;
      Plan plan{};
      plan.exponent = detail::binary_exponent(terms.parts);
      const double h = n * part, by_moment = n * response.hg1 / mobility,
                   by_flow = (1.5 * main.main_stiffness * h + main.main_damping) * h / main.main_mass,
                   largest = constant::larger(constant::magnitude(by_moment), by_flow);
      plan.flow_bits = -Format::exponent_of(constant::smaller(1, constant::larger(1.01 * largest, 0x1p-16)));
      for (int i = 0; i < plan.exponent; ++i) {
        const double k = constant::power_of_two(i);
        const LinearFlow over = exact_flow(main, k * part);
        plan.strides[i] = {Format::gain(k / n, 0, 0), Format::gain(over.e11 * n / k, 0, 0),
                           Format::gain(over.e12 - 1, 0, 0),
                           Format::gain(over.e21 * (n / k) * (n / k), 0, -plan.flow_bits),
                           Format::gain(over.e22 * n / k, 0, -plan.flow_bits)};
      }
      plan.moment_bits = unit.recoil - own.recoil;
      if (terms.is_linear) {
        plan.by_impulse = Scaled<Format>{unit}(n * of_force);
        plan.by_moment = Scaled<Format>{own}(of_force);
      }
      plan.main_x = Format::gain(response.gx / mobility, 0, 0);
      plan.main_u = Format::gain(response.g0 / mobility, 0, 0);
      plan.main_u_by_moment = Format::gain(by_moment, 0, -plan.flow_bits);
      plan.ball = Format::gain(1 / (terms.ball_mass * mobility), 0, 0);
      plan.travel_bits = unit.penetration - unit.recoil;
      plan.bending_bits = plan.travel_bits + plan.flow_bits < 31 ? plan.travel_bits + plan.flow_bits : 31;
      return plan;
    }
  };

  typename Format::Sum x, y, by_flow;  // by_flow: what spring and damper have changed of the main mass's rate
  Recoil w, main_share;                // of w

  constexpr Recoil u() const { return main_share + Recoil(by_flow.value()); }
  // Returns the acceleration by spring and damper, in its finer unit.
  [[gnu::always_inline]] constexpr Recoil advance(const Plan& plan, int stride) {
    const Stride& flow = plan.strides[stride];
    const Recoil at(x.value()), rate = u();
    const int bits = plan.exponent - stride;
    x.add(rate + flow.by_x_to_x * at + flow.by_u_to_x * rate, bits, flow.part);
    const Recoil acceleration = flow.by_x_to_u * at + flow.by_u_to_u * rate;
    by_flow.add(acceleration, bits + plan.flow_bits, flow.part);
    y.add(w, bits, flow.part);
    return acceleration;
  }
  [[gnu::always_inline]] constexpr void add(const Plan& plan, const Impulse<Force<Value>>& by) {
    add_changes(plan, plan.by_impulse * by.j0, plan.by_moment * by.j1);
  }
  [[gnu::always_inline]] constexpr void add(const Plan& plan, const Impulse<Recoil>& by) {
    add_changes(plan, Recoil(Format::times(by.j0, 1 << (plan.exponent - plan.moment_bits))), by.j1);
  }
  // Of dry friction: what it takes of the rate, and of the penetration. Returns the change of w, which rounds.
  constexpr Recoil take(const Plan& plan, Penetration j0, Penetration j1) {
    const Recoil impulse(Format::moved(j0, -plan.travel_bits)), moment(Format::moved(j1, -plan.travel_bits));
    x.add(plan.main_x * moment, 0);
    by_flow.add(plan.main_u_by_moment * moment, plan.flow_bits);
    y.add(moment, 0);
    const Recoil before = w;
    change(plan, impulse);
    return w - before;
  }
  // What the main spring has done to a displacement that grew with the square of the time. `aged`: that displacement
  // times the part of the step in which it grew.
  constexpr void pull(const Plan& plan, Penetration aged) {
    const Recoil moved(plan.main_x * Recoil(Format::moved(aged, -plan.travel_bits)));
    const Recoil acceleration(plan.strides[0].by_x_to_u * moved);
    by_flow.add(Recoil(Format::value(acceleration * Format::short_constant(1.0 / 3))), plan.flow_bits);
  }
  // To the coordinates of the other stop.
  [[gnu::always_inline]] constexpr void cross() {
    x.negate();
    by_flow.negate();
    y.negate();
    w = -w;
    main_share = -main_share;
  }
  // The share of both in the penetration and in its rate.
  [[gnu::always_inline]] constexpr Penetration displacement(const Plan& plan) const {
    return travel(plan, Recoil(x.value()) + plan.ball * Recoil(y.value()));
  }
  [[gnu::always_inline]] constexpr Penetration rate(const Plan& plan) const {
    return travel(plan, u() + plan.ball * w);
  }
  static constexpr Penetration travel(const Plan& plan, Recoil by) {
    return Penetration(Format::moved(by, plan.travel_bits));
  }
  // Of the rate of penetration, by that acceleration.
  static constexpr Penetration bending(const Plan& plan, Recoil acceleration) {
    return Penetration(Format::moved(acceleration, plan.bending_bits));
  }

 private:
  [[gnu::always_inline]] constexpr void add_changes(const Plan& plan, Recoil j0, Recoil j1) {
    x.add(plan.main_x * j1, plan.moment_bits);
    by_flow.add(plan.main_u_by_moment * j1, plan.moment_bits + plan.flow_bits);
    y.add(j1, plan.moment_bits);
    change(plan, j0);
  }
  [[gnu::always_inline]] constexpr void change(const Plan& plan, Recoil j0) {
    w = w + j0;
    main_share = plan.main_u * w;
  }
};

}  // namespace impact
