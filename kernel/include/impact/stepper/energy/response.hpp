// SPDX-License-Identifier: MIT
#pragma once
// The exact response of both masses to a contact force that is constant over the step; and the positive root of the
// quadratics that such a force leads to.

#include <impact/law/terms.hpp>
#include <impact/motion/linear_flow.hpp>
#include <impact/numeric/formula.hpp>
#include <impact/numeric/units.hpp>
#include <impact/stepper/contact.hpp>
#include <impact/stepper/response.hpp>

namespace impact {

// The response to j0, twice the change of the displacement between the masses by a constant force. The ball has its
// share of it, and the main mass the rest; spring and damper slightly reduce dx1 meanwhile. The ball ends where the
// penetration is smaller by j1. A position correction makes j1 differ from j0/2: it moves only the ball and changes no
// rate. In a stiff contact the correction is the reaction's shift.
template <class Format> struct ConstantForceGains {
  using Value = typename Format::Value;

  GainOf<typename Format::Weight, unit::Push, unit::Push> ball, dx1;
  GainOf<typename Format::ClampedGain, unit::Push, unit::Force> force;  // from twice the displacement
  int travel_bits;
  bool is_sudden;  // a stiff contact

  constexpr Penetration<Value> travel(Push<Value> displacement) const {
    return Penetration<Value>(Format::moved(displacement, travel_bits));
  }

  template <class Units, class State>
  [[gnu::always_inline]] constexpr void apply(const Units& units, State& state,
                                              const Reaction<Format, Push<Value>>& reaction, bool left) const {
    const auto impulse = mirrored(reaction.main, left);
    const auto ball_part = ball * impulse.j0, main_part = impulse.j0 - ball_part;
    units.push(state.x1, half(main_part));
    units.push(state.dx1, dx1 * impulse.j0);
    units.push(state.x2, Format::value(half(main_part)) - impulse.j1);
    units.push(state.dx2, -ball_part);
    if (is_sudden) units.displace(state.x2, -mirrored(reaction.shift, left));
  }
  // For features, which compute the work from force and displacement.
  [[gnu::always_inline]] constexpr void record(Reaction<Format, Push<Value>>& reaction, typename Format::Energy stored,
                                               Penetration<Value> displacement) const {
    const Force<Value> own_force = force * reaction.main.j0;
    reaction.record.force = {own_force, Format::value(half(own_force))};
    reaction.record.stored = stored;
    reaction.record.displacement = displacement;
  }
};

constexpr ContactTraits constant_force_traits() {
  ContactTraits traits;
  traits.puts_back = traits.knows_displacement = true;
  return traits;
}

struct ConstantForceResponse {
  double x1, dx1, x2, dx2;  // m/N

  constexpr ConstantForceResponse(const ContactTerms& terms, const LinearFlow& flow)
      : x1(terms.main_yield),
        dx1(flow.e12 * (flow.c0 + flow.c1) + flow.e11 * x1),
        x2(terms.step * terms.step / (2 * terms.ball_mass)),
        dx2(2 * x2) {}

  // Twice the response to a force, m.
  constexpr double impulse() const { return 2 * (x1 + x2); }

  template <class Format>
  constexpr ConstantForceGains<Format> gains(double force_unit, const UnitExponents& unit,
                                             bool is_stiff = false) const {
    const Scaled<Format> gain{unit};
    return {gain(dx2 / impulse()), gain(constant::smaller(dx1 / impulse(), largest_share)),
            gain(1 / (impulse() * force_unit)), unit.penetration - unit.push, is_stiff};
  }
};

// x >= 0 with x^2 + 2 b x = y z, for y z >= 0, in a unit of its own, so that the squares keep their bits.
template <class Format>
constexpr typename Format::Value positive_root(typename Format::Value b, typename Format::Value y,
                                               typename Format::Value z) {
  const auto unit = Format::own_unit(Format::spare_bits(b, y, z));
  const auto squares = square(unit.own(b)) + without_sign(unit.own(y)) * without_sign(unit.own(z));
  return unit.common(Format::value(Format::root_of_product(squares)) - unit.own(b));
}

}  // namespace impact
