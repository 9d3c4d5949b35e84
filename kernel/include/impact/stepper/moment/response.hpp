// SPDX-License-Identifier: MIT
#pragma once
// The response of both masses to an impulse J0 and a moment J1 of the contact force within a step of length h, the main
// mass on its spring and damper: v1 exactly for a force that is linear in time, and x1 for a constant one. Derivation:
// kernel/docs/moment.md.
//
//     x1 += gx J1        v1 += g0 J0 + g1 J1

#include <impact/law/terms.hpp>
#include <impact/motion/linear_flow.hpp>
#include <impact/numeric/units.hpp>
#include <impact/stepper/response.hpp>

namespace impact {

constexpr ContactTraits moment_traits(bool reads_rate, bool sees_change) {
  ContactTraits traits;
  traits.crosses_cavity = true;
  traits.reads_rate = reads_rate;
  traits.sees_change = sees_change;
  return traits;
}

struct MomentResponse {
  double gx, g0, hg1;  // 1/kg

  // By the main mass's exact flow over the step.
  constexpr MomentResponse(const ContactTerms& terms, const LinearFlow& flow)
      : gx(2 * flow.constant_start() / (terms.step * terms.step)),
        g0((4 * flow.c1 - 2 * flow.c0) / (terms.step * terms.step)),
        hg1(6 * (flow.c0 - flow.c1) / (terms.step * terms.step)) {}

  template <class Format>
  constexpr Response<typename Format::Gain, unit::Force> gains(const ContactTerms& terms, const LinearFlow& flow,
                                                               const UnitExponents& unit) const {
    const Scaled<Format> gain{unit};
    const double scale = terms.force_unit * terms.step * terms.step, ball = scale / terms.ball_mass;
    return {{gain(scale * gx), gain(scale * flow.e12 * g0), gain(scale * (flow.e12 * hg1 + flow.e11 * gx)), gain(ball),
             gain(ball)},
            gain(ball + scale * gx),
            gain(ball + scale * g0),
            gain(scale * hg1)};
  }
  // The change of the penetration by a moment.
  constexpr double mobility(const ContactTerms& terms) const { return 1 / terms.ball_mass + gx; }
  // For impulses in units of their change of the penetration.
  template <class Format>
  constexpr SharedResponse<typename Format::Weight> shared(const ContactTerms& terms, const LinearFlow& flow,
                                                           const UnitExponents& unit) const {
    const Scaled<Format> gain{unit};
    const double scale = 1 / mobility(terms), ball = scale / terms.ball_mass;
    return {gain(ball),
            gain(-constant::smaller(scale * flow.e12 * g0, largest_share)),
            gain(-scale * (flow.e12 * hg1 + flow.e11 * gx)),
            gain(1),
            gain(ball + scale * g0),
            gain(scale * hg1)};
  }
};

}  // namespace impact
