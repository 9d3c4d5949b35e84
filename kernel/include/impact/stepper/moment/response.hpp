// SPDX-License-Identifier: MIT
#pragma once
// The response of both masses to an impulse J0 and a moment J1 of the contact force within a step, the main mass on its
// spring and damper, to first order in c h/M and k h^2/M: v1 for a force that is linear in time, and x1 for a constant
// one (of a force that grows from 0, c h/(4 M) and k h^2/(20 M) stand in gx).
//
//     x1 += gx J1                 gx = (1 - c h/(3 M) - k h^2/(12 M)) / M
//     v1 += g0 J0 + g1 J1         g0 = (1 + k h^2/(12 M)) / M        g1 = -(c/M + k h/(2 M)) / M

#include <impact/law/terms.hpp>
#include <impact/motion/linear_flow.hpp>
#include <impact/numeric/units.hpp>
#include <impact/stepper/response.hpp>

namespace impact {

struct MomentResponse {
  double gx, g0, hg1;  // 1/kg

  explicit constexpr MomentResponse(const ContactTerms& terms)
      : gx((1 - terms.main_damping * terms.step / (3 * terms.main_mass) - square_pulsation_step(terms) / 12) /
           terms.main_mass),
        g0((1 + square_pulsation_step(terms) / 12) / terms.main_mass),
        hg1(-(terms.main_damping * terms.step / terms.main_mass + square_pulsation_step(terms) / 2) / terms.main_mass) {
  }

  template <class Format>
  constexpr Response<typename Format::Gain> gains(const ContactTerms& terms, const LinearFlow& flow,
                                                  const UnitExponents& unit) const {
    const double scale = terms.force_unit * terms.step * terms.step, ball = scale / terms.ball_mass;
    return {{Format::gain(scale * gx, 0, unit.push), Format::gain(scale * flow.e12 * g0, 0, unit.push),
             Format::gain(scale * (flow.e12 * hg1 + flow.e11 * gx), 0, unit.push), Format::gain(ball, 0, unit.push),
             Format::gain(ball, 0, unit.push)},
            Format::gain(ball + scale * gx, 0, unit.penetration),
            Format::gain(ball + scale * g0, 0, unit.penetration),
            Format::gain(scale * hg1, 0, unit.penetration)};
  }
  // The change of penetration by a moment.
  constexpr double mobility(const ContactTerms& terms) const { return 1 / terms.ball_mass + gx; }
  // For impulses that count as what they do to the penetration.
  template <class Format>
  constexpr SharedResponse<typename Format::Weight> shared(const ContactTerms& terms, const LinearFlow& flow,
                                                           const UnitExponents& unit) const {
    const double scale = 1 / mobility(terms), ball = scale / terms.ball_mass;
    return {Format::weight(-ball, 0, 0),
            Format::weight(constant::smaller(scale * flow.e12 * g0, largest_share), 0, 0),
            Format::weight(scale * (flow.e12 * hg1 + flow.e11 * gx), 0, 0),
            Format::weight(1, unit.recoil, unit.penetration),
            Format::weight(ball + scale * g0, unit.recoil, unit.penetration),
            Format::weight(scale * hg1, unit.recoil, unit.penetration)};
  }

 private:
  static constexpr double square_pulsation_step(const ContactTerms& terms) {
    return terms.main_stiffness * terms.step * terms.step / terms.main_mass;
  }
};

}  // namespace impact
