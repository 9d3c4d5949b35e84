// SPDX-License-Identifier: MIT
#pragma once
// The mean n of d^(3/2) between the penetrations at both ends of a step, with the roots r and s of these (power.hpp):
//
//     inside a contact, with p = (s+r)/2, z = (s-r)/2     n = p^3 + 2 p z^2 + z^4/(5p)
//     over a part of the step, from or to the depth d     n = (2/5) d^(3/2) part
//
// Floating point counts n in units of 2/5, and with q = r s, D = r^2 + s^2 the first is (D (D + q) - q^2)/(s + r).

namespace impact {

template <class Format, bool is_real = Format::is_real> struct MeanShape {
  using Value = typename Format::Value;
  using Root = typename Format::Root;
  using Factor = decltype(Format::constant(0));
  static constexpr double unit = 1;

  // z^2/5p uses 14 bits of p. In the first or last step of a contact, with the depth d, n is too small by up to
  // 2^-17/sqrt(d), relative. Such a step does (pi/N)^(5/2) of the impact's work, so the error is 2e-7 of its energy at
  // any speed.
  static constexpr Factor inside(Root r, Root s, Value, Value) {
    const auto p = half(s + r);
    const auto z = half(difference(s, r));
    const auto zz = square(z);
    return p * (square(p) + zz + zz) + zz * Format::square_over_five(z, p);
  }
  static constexpr Factor over_part(Root root, Value depth, Value displacement) {
    const auto d = without_sign(depth);
    return Format::factor(afresh(root * d) * Format::short_quotient(d, without_sign(displacement)) *
                          Format::short_constant(2.0 / 5));
  }
  // n as d^(3/2), and d^(3/2) as n.
  static constexpr Factor shape(Factor n) { return n; }
  template <class Shape> static constexpr Factor of(Shape shape) { return Format::factor(shape); }
};

template <class Format> struct MeanShape<Format, true> {
  using Real = typename Format::Value;
  static constexpr double unit = 0.4;

  static constexpr Real inside(Real r, Real s, Real before, Real after) {
    const Real q = r * s, sum = before + after;
    return (sum * (sum + q) - q * q) / (r + s);
  }
  static constexpr Real over_part(Real root, Real depth, Real displacement) {
    return root * depth * (depth / displacement);
  }
  static constexpr Real shape(Real n) { return n * Format::constant(unit); }
  static constexpr Real of(Real shape) { return shape * Format::constant(1 / unit); }
};

}  // namespace impact
