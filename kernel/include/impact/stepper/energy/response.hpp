// SPDX-License-Identifier: MIT
#pragma once
// The exact response of both masses to a contact force that is constant over the step; and the positive root of the
// quadratics that such a force leads to.

#include <impact/motion/linear_flow.hpp>
#include <impact/numeric/formula.hpp>
#include <impact/stepper/treatment.hpp>

namespace impact {

// The ball's displacement grows by half as much as its displacement per step.
template <class Gain>
struct ConstantForceGains {
  static constexpr bool is_shared = false;
  Gain x1, dx1, dx2;
  Gain penetration, rate, rate_by_moment;

  template <class Units, class State, class Felt>
  [[gnu::always_inline]] constexpr void answer(const Units& units, State& state, const Felt& impulse) const {
    units.push(state.x1, x1 * impulse.j0);
    units.push(state.dx1, dx1 * impulse.j0);
    const auto ball = dx2 * -impulse.j0;
    units.push(state.x2, half(ball));
    units.push(state.dx2, ball);
  }
};

struct ConstantForceResponse {
  double x1, dx1, x2, dx2;  // m/N

  constexpr ConstantForceResponse(const ContactTerms& terms, const LinearFlow& flow)
      : x1(flow.b0 + flow.b1),
        dx1(flow.e12 * (flow.c0 + flow.c1) + flow.e11 * x1),
        x2(terms.step * terms.step / (2 * terms.ball_mass)),
        dx2(2 * x2),
        rate_(flow.c0 + flow.c1 + dx2) {}

  constexpr double penetration() const { return x1 + x2; }

  template <class Format>
  constexpr ConstantForceGains<typename Format::Gain> gains(double force_unit, const UnitExponents& unit) const {
    return {Format::gain(force_unit * x1, 0, unit.push),
            Format::gain(force_unit * dx1, 0, unit.push),
            Format::gain(force_unit * dx2, 0, unit.push),
            Format::gain(force_unit * penetration(), 0, unit.penetration),
            Format::gain(force_unit * rate_, 0, unit.penetration),
            Format::gain(0, 0, 0)};
  }

 private:
  double rate_;
};

// x >= 0 with x^2 + 2 b x = y z, for y z >= 0, in a unit of its own, so that the squares keep their places.
template <class Format>
constexpr typename Format::Value positive_root(typename Format::Value b, typename Format::Value y,
                                               typename Format::Value z) {
  const auto unit = Format::own_unit(Format::spare_places(b, y, z));
  const auto squares = square(unit.own(b)) + without_sign(unit.own(y)) * without_sign(unit.own(z));
  return unit.common(Format::value(Format::root_of_product(squares)) - unit.own(b));
}

}  // namespace impact
