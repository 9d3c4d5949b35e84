// SPDX-License-Identifier: MIT
#pragma once
// The energy-consistent step of a power law at any stiffness. With q = G n (n the mean of d^(3/2) over the step, so
// that q is what the elastic force alone takes from the penetration), D the displacement without contact, dt = d0 + D,
// A = C D, u = C q, K = u k and the correction k q of position_correction.hpp, the step's end d1 solves
//
//     d1 + b + k q = dt        b = q (1 + A)/(1 + u), what the force takes        (Hertz: C = 0)
//
// whose left side rises with d1: there is one end. 1 + A <= 0 says that the ball leaves faster than the law can push
// it: no force, and d1 = dt. That may still be inside, where a main mass that turns back is pushed again. Otherwise,
// where the left side at d1 = 0 is below dt the contact stays, else it leaves.
//
// Staying, with s^2 = d1: times 1 + u this reads, convex and increasing in d1 from its root on,
//
//     P = d1 + q (1 + C (d1 - d0) + K + k) - dt = 0
//     q = (2/5) G (s^3 + r^2 s + r^3 w)       w = r/(s + r)         in contact since before, d0 = r^2
//     q = (2/5) G s^3 w                       w = d1/(d1 - d0)      entering, d0 <= 0
//
// so that Newton's method from above comes down on the root. It starts from the least of three bounds: d1 <= dt; b <=
// dt; k q <= dt with K >= u^2/3, and u <= 1.01. One of the equation's three terms is dt/3 at least. The bound that
// belongs to it then is at most a fixed multiple of the root, whatever k1, h and the speeds are, because d1, b and k q
// grow like powers of d1 between 1 and 5, and q, where an earlier penetration outweighs d1, no less than (2/5) G r^3
// itself. From a multiple c a term of power m takes m ln(c) passes to come near the root, and then each doubles the
// digits: `passes` is their number, found over the whole range of C dt, A and d0/D (tests/host/energy_test.cpp
// repeats the search).
//
// Leaving, with t = d0/(d0 - d1), the share of the step in contact, and Q = (2/5) G r^3, q = Q t:
//
//     Q t^2 (1 + K + k) - (D + C Q d0) t = d0
//
// by Newton's method from the root without K + k, which for Hertz is all.
//
// Neither a rounding nor a missing pass can make energy: the caller gives the ball whatever correction the equation
// leaves over for the s and b that it takes, the work done is b's and the energy stored is s's, and s is rounded to the
// side on which the correction is positive.

#include <impact/numeric/root_above.hpp>
#include <impact/stepper/energy/position_correction.hpp>

namespace impact {

template <class Format, bool is_damped>
struct EnergySolver {
  using Real = typename Format::Wide;

  struct End {
    Real root;        // s, 0 when the ball has left
    Real recoil;      // b
    Real correction;  // k q, where it has left
  };

  static constexpr int passes = is_damped ? 14 : 7, leaving_passes = 10;

  Real stiffness, damping;  // G, C
  Real r, d0, travel;       // D; r = 0 and d0 <= 0 before contact

  constexpr End solve() const {
    const Real dt = d0 + travel, damping_factor = number(1) + damping * travel;
    if (is_damped && !is_positive(damping_factor))
      return {is_positive(dt) ? rooted(dt) : number(0), number(0), number(0)};
    const Real least = number(0.4) * stiffness * r * r * r;
    const Real at_rest = recoil_of(least, damping_factor) +
                         (is_damped ? least * CorrectionFunction<Format>::at(damping * least).k : number(0));
    return at_rest < dt ? stay(dt, damping_factor) : leave(least, damping_factor);
  }

 private:
  // So that the position correction is positive.
  static constexpr Real rooted(Real d) { return Format::rounded_down(Format::wide_root(d)); }
  static constexpr Real number(double x) { return Format::wide(x); }
  static constexpr Real smaller(Real x, Real y) { return x < y ? x : y; }
  static constexpr Real larger(Real x, Real y) { return x < y ? y : x; }

  constexpr Real recoil_of(Real q, Real damping_factor) const {
    return is_damped ? q * damping_factor / (number(1) + damping * q) : q;
  }

  // No u has a K above this without being below the result: CorrectionFunction's line.
  static constexpr Real most(Real correction_share) {
    return number(1) + larger(correction_share, number(0)) * number(1 / CorrectionFunction<Format>::steepness);
  }

  struct Mean {
    Real q, slope;  // dq/dd1
  };
  constexpr Mean mean_at(Real d, Real s) const {
    const Real fifth = number(0.2) * stiffness;
    if (is_positive(r)) {
      const Real w = r / (s + r), rw = r * w;
      const Real q = fifth * (s * d + r * r * (s + rw));
      return {q + q, fifth * (number(3) * s + rw + rw * w)};
    }
    const Real w = is_positive(-d0) ? d / (d - d0) : number(1), sw = fifth * s * w;
    const Real q = sw * d;
    return {q + q, sw * (number(5) - w - w)};
  }

  constexpr Real start(Real dt, Real damping_factor) const {
    Real q = dt;
    if constexpr (is_damped) {
      q = (dt + dt) / damping_factor;
      const Real u = smaller(most(damping * dt), Format::wide_root(number(3) * damping * dt));
      if (u < damping * q) q = u / damping;
    }
    const Real n = q / stiffness;
    const Real s = is_positive(r)
                       ? root_above<3>(number(2.5) * n)
                       : larger(root_above<3>(number(5) * n), root_above<5>(number(5) * n * (number(0) - d0)));
    return smaller(dt, s * s);
  }

  constexpr End stay(Real dt, Real damping_factor) const {
    Real d = start(dt, damping_factor);
    for (int pass = 0; pass < passes; ++pass) {
      const Mean mean = mean_at(d, Format::wide_root(d));
      Real missed = d + mean.q - dt, slope = number(1) + mean.slope;
      if constexpr (is_damped) {
        const Real u = damping * mean.q;
        const auto correction = CorrectionFunction<Format>::at(u);
        const Real correction_share = u * correction.k, extra = damping * (d - d0) + correction_share + correction.k;
        missed = missed + mean.q * extra;
        slope = slope + u + mean.slope * (extra + (u + u * u) * correction.slope + correction_share);
      }
      d = larger(d - missed / slope, number(1.0 / 64) * d);
    }
    const Real s = rooted(d);
    return {s, recoil_of(mean_at(s * s, s).q, damping_factor), number(0)};
  }

  constexpr End leave(Real least, Real damping_factor) const {
    const Real m = is_damped ? -(travel + damping * least * d0) : -travel, size = is_positive(m) ? m : -m;
    const Real sum = size + Format::wide_root(size * size + number(4) * least * d0);
    Real t = smaller(is_positive(m) ? (d0 + d0) / sum : sum / (least + least), number(1));
    if constexpr (is_damped) {
      const Real u_of_step = damping * least, largest = most(damping * (travel + u_of_step * d0));
      if (largest < u_of_step * t) t = largest / u_of_step;
      for (int pass = 0; pass < leaving_passes; ++pass) {
        const Real u = damping * least * t, ct = least * t;
        const auto correction = CorrectionFunction<Format>::at(u);
        const Real factor = number(1) + (number(1) + u) * correction.k;
        const Real slope = m + ct * (factor + factor + u * ((number(1) + u) * correction.slope + correction.k));
        t = t - (t * (ct * factor + m) - d0) / slope;
      }
    }
    const Real q = least * t;
    return {number(0), recoil_of(q, damping_factor),
            is_damped ? q * CorrectionFunction<Format>::at(damping * q).k : number(0)};
  }
};

}  // namespace impact
