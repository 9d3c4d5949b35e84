// SPDX-License-Identifier: MIT
#pragma once
// The energy-consistent step of a power law at any stiffness, in closed form. Derivation: kernel/docs/energy.md. The
// symbols are lengths:
//
//     D         the displacement of a step without contact
//     b         how much the force reduces it
//     p         half of the change of the displacement per step by spring, drive and field
//     d0, d1    the penetrations at the step's start and end
//     V         the stored energy as a displacement per step, V^2 = (2/5) G d^(5/2)
//
// Hertz, where w is the displacement per step, the contact moves along a circle of w/2 and V, and t is the tangent of
// half of the angle:
//
//     b = (t^2 D + 2 t V0)/(1 + t^2)        V1^2 = V0^2 + b (D - b)        d1 = K V1^(4/5)
//
// Hunt-Crossley, with the elastic force's part q, u = C q, A = C D and x = u (b - p)/b:
//
//     b = q (1 + A)/(1 + u)        V1^2 = V0^2 + q (D - b - k(x) x/C)        artanh x = x + k(x) x^2
//     q = 2 W/(B + (B^2 + 4 C W cos^2)^(1/2))        W = sin^2 D + sin V0        B = 1 - C sin V0
//
// Leaving, V1 = 0 and b = D/2 + Z1/(2 C g(Z1)). No value of t, q or p creates energy. The error of the restitution is
// at most 6e-4 for e from 0.05 to 1 (energy_test). An elastic contact ends late by less than a step. Up to h omega = 3
// a ball at rest trembles by up to 2e-3 of d, and its average is within 1.5e-4 of d (field_test). In a field the
// position correction changes the ball's energy by -g (d1 - d0 - D + b), with g = G m a. Two steps of Newton's method
// take this gain from b or V1, and the ledger counts it as dissipated, with its sign.

#include <impact/law/impact_damping.hpp>
#include <impact/numeric/constant_math.hpp>
#include <impact/numeric/formula.hpp>

namespace impact {

template <class Format, class ContactLaw> struct StiffContact {
  static constexpr bool is_damped = ContactLaw::is_damped, is_per_impact = ContactLaw::is_damped_per_impact;
  using Damping = typename ImpactDamping<Format, is_per_impact>::Damping;
  using Value = typename Format::Value;
  using Gain = typename Format::Gain;

  struct Plan {
    typename Format::Balance ease;       // (8/5)/G, t^2 being sqrt(d) over it
    typename Format::ClampedGain depth;  // K
    typename Format::ClampedGain rate;   // V over d^(5/4)
    Gain force;                          // over b
    Value most;                          // V at the largest penetration that the bounds allow
    int exponent;                        // C x of an x of the unit is below a quarter of 2^exponent

    // G in the unit of penetrations.
    static constexpr Plan make(double compliance, Gain force, Value most, int damping_exponent) {
      const double share = 0.4 * compliance;
      return {Format::balance(0.64 / share),
              {Format::gain(constant::power(share, -0.4), 0, 0)},
              {Format::gain(constant::square_root(share), 0, 0)},
              force,
              most,
              damping_exponent + 2};
    }
    constexpr Value rate_at(Value d) const {
      return rate * Format::value(d * Format::root(Format::value(Format::root(d))));
    }
    constexpr auto stored(Value v) const { return work(v, force * v); }
  };

  struct End {
    Value recoil;       // b
    Value rate;         // V1
    Value penetration;  // d1
    bool is_inside;
  };

  const Plan& plan;
  Damping damping;      // C
  bool is_inside;       // at the step's start
  Value rate, before;   // V0 and d0
  Value travel, trial;  // D, and the penetration that it leads to
  Value press;          // p
  Value field;          // g

  template <bool is_in_field = false> [[gnu::always_inline]] constexpr End end() const {
    // In a unit of the step's own, of which lengths are less than an eighth: the correction is at most 5.7 times the
    // longest of them.
    const int quarters =
        is_in_field ? Format::spare_bits(travel, rate, press, field) : Format::spare_bits(travel, rate, press);
    const int bits = quarters - 1, least = plan.exponent - bits,
              exponent = is_per_impact ? plan.exponent
                         : least > 2   ? least
                                       : 2;
    const auto unit = Format::own_unit(bits);
    return Scaled{*this,
                  unit,
                  unit.own(travel),
                  unit.own(rate),
                  unit.own(press),
                  factor(exponent - least),
                  bits,
                  exponent,
                  Format::power_of_two(-exponent)}
        .template end<is_in_field>();
  }

 private:
  // Of a length in the step's own unit to a number in 2^exponent.
  [[gnu::always_inline]] constexpr auto factor(int bits) const {
    if constexpr (is_per_impact)
      return damping;
    else
      return Format::fraction(damping, 2 + bits);
  }

  struct Scaled {
    const StiffContact& step;
    typename Format::OwnUnit unit;
    Value d, v, press;  // D, V0, p
    decltype(step.factor(0)) damping;
    int bits, exponent;
    Value one;

    // C x, in 2^exponent. The gain of a damping that is set per impact holds what would not fit as it is.
    [[gnu::always_inline]] constexpr Value number(Value x) const {
      if constexpr (is_per_impact)
        return Format::moved(damping * unit.common_clamped(x), 2);
      else
        return damping * x;
    }
    [[gnu::always_inline]] constexpr Value unscaled(Value x) const { return unit.common(x); }
    template <bool is_precise> [[gnu::always_inline]] constexpr Value depth_of(Value v1) const {
      return step.plan.depth * without_sign(Format::template power_four_fifths<is_precise>(v1));
    }

    template <bool is_in_field> [[gnu::always_inline]] constexpr End end() const {
      const Value damped = is_damped ? number(d) : Value{}, base = one + damped;  // A, 1 + A
      if (is_damped && !is_positive(base)) return left_behind();
      End end{};
      return stays<is_in_field>(end, base) ? end : leave<is_in_field>(damped, base);
    }

    constexpr End left_behind() const {
      if (!is_positive(step.trial)) return {Value{}, Value{}, step.trial, false};
      const Value v1 = step.plan.rate_at(step.trial);
      return {Value{}, is_positive(step.rate - v1) ? v1 : step.rate, step.trial, true};
    }
    template <bool is_in_field> [[gnu::always_inline]] constexpr bool stays(End& end, Value base) const {
      if (step.is_inside && !is_positive(step.trial)) return false;
      const Value most = unscaled(v + Format::value(half(is_positive(d) ? d : Value{})));
      const Value deepest = is_positive(most) ? depth_of<false>(most) : Value{};
      const Value pressed = Format::clamped_difference(step.trial, step.press);
      const Value free = step.is_inside && is_positive(pressed) ? pressed : step.trial;
      const bool is_shallow = !is_positive(free - deepest);
      const auto sine = Format::share(phase_at(is_shallow ? free : deepest), step.plan.ease);
      const auto cosine = Format::constant(1) - sine;  // both squared, of half the angle
      const Value by_stored = Format::value(twice(v * Format::root_of_product(sine * cosine)));
      const Value whole = Format::value(d * sine) + by_stored;
      if (!is_positive(whole)) return is_shallow && is_positive(d) && flies_on<is_in_field>(end);

      Value q = whole, back = whole;
      if constexpr (is_damped) {
        q = elastic_part(whole, by_stored, cosine, base);
        const Value u = number(q);
        back = q + Format::value((d - q) * Format::rough_quotient(without_sign(u), without_sign(one + u)));
        if (is_negative(back)) back = Value{};  // by the quotient's error, where 1 + A is nearly 0
      }
      end.recoil = unscaled(back);
      if (step.is_inside && is_positive(end.recoil - step.trial)) return false;
      const Value work = Format::value(afresh(q) * (d - back));
      Value left = square_of(v) + work;
      if constexpr (is_damped)
        if (is_positive(left)) left = left - Format::value(afresh(q) * correction(slowing_part(q, back)));
      if (!is_positive(left))
        return is_shallow && !is_positive(Format::value(afresh(q) * d)) && is_positive(d - back) &&
               flies_on<is_in_field>(end);
      end.rate = unscaled(Format::value(Format::root_of_product(without_sign(left))));
      end.penetration = depth_of<true>(end.rate);
      if constexpr (is_in_field) {
        const End unpaid = end;
        Value taken{};
        for (int pass = 0; pass < 2; ++pass) pay_for_correction(end, taken);
        // What is not paid for waits: the ball stays where the force leaves it. At rest, where nothing is to be had, it
        // must not sink by what x^(4/5) rounds. A correction that has no room in the step's own unit was not paid for
        // at all.
        const Value unmoved = step.trial - unpaid.recoil;
        const bool has_room = Format::spare_bits(moved_to(end)) >= bits;
        if (is_positive(unmoved - end.penetration - Format::value(end.penetration * Format::short_constant(0x1p-10))) &&
            is_positive(has_room ? gained_by_field(end) - taken : step.field)) {
          end = unpaid;
          end.penetration = unmoved;
        }
      }
      end.is_inside = is_positive(end.rate);
      return true;
    }

    // So shallow that the force is below an LSB: none. In a field the stored energy stays that of the penetration, or
    // the next correction would lift the ball; a force of an LSB does no less work than it gains by that.
    template <bool is_in_field> constexpr bool flies_on(End& end) const {
      end = {Value{}, step.rate, step.trial, true};
      if constexpr (is_in_field) {
        const Value v1 = step.plan.rate_at(step.trial), most = Format::value(d * scaled(Format::lsb()));
        if (!is_positive(square_of(scaled(v1)) - square_of(v) - most)) end.rate = v1;
      }
      return true;
    }

    // What the correction has gained by the field and `taken` has not yet, out of b or V1.
    [[gnu::always_inline]] constexpr void pay_for_correction(End& end, Value& taken) const {
      const Value moved = moved_to(end);
      if (Format::spare_bits(moved) < bits || !is_positive(end.rate)) return;
      const Value own_field = scaled(step.field), v1 = scaled(end.rate), back = scaled(end.recoil),
                  gained = -Format::value(own_field * scaled(moved)) - taken, half_v1 = Format::value(half(v1));
      const Value by_back = Format::value(quarter(d + own_field)) - Format::value(half(back));
      const bool is_by_back = is_positive(mirrored(by_back, is_negative(by_back)) - half_v1);
      const Value slope = is_by_back
                              ? by_back
                              : half_v1 - Format::value(ratio(Format::value(own_field * end.penetration), end.rate) *
                                                        Format::constant(0.2));
      const bool is_falling = is_negative(slope);
      const Value steepness = mirrored(slope, is_falling);
      if (!is_positive(gained) || !is_positive(steepness)) return;
      const Value change = mirrored(Format::value(quarter(ratio(gained, steepness))), is_falling);
      End paid = end;
      Value by_both = taken;
      if (is_by_back) {
        paid.recoil = unscaled(back + change);
        if (is_negative(paid.recoil)) return;
        by_both = by_both + Format::value(change * (d - back - back - change));
      } else {
        paid.rate = unscaled(v1 - change);
        if (!is_positive(paid.rate)) return;
        paid.penetration = depth_of<true>(paid.rate);
        by_both = by_both + Format::value(change * (v1 + v1 - change));
      }
      const Value moved_now = moved_to(paid);
      if (Format::spare_bits(moved_now) < bits) return;
      const Value left = -by_both - Format::value(own_field * scaled(moved_now));
      if (is_positive(mirrored(left, is_negative(left)) - gained)) return;
      end = paid;
      taken = by_both;
    }
    [[gnu::always_inline]] constexpr Value scaled(Value x) const { return unit.own(x); }
    // The correction.
    [[gnu::always_inline]] constexpr Value moved_to(const End& end) const {
      return end.penetration - (step.trial - end.recoil);
    }
    // x / y, y > 0, clamped at 1.
    static constexpr Value ratio(Value x, Value y) {
      const bool is_negative = !is_positive(x);
      return mirrored(Format::value(Format::quotient(without_sign(mirrored(x, is_negative)), without_sign(y))),
                      is_negative);
    }
    // By the correction, as a square of rates.
    [[gnu::always_inline]] constexpr Value gained_by_field(const End& end) const {
      return -Format::value(afresh(scaled(step.field)) * scaled(moved_to(end)));
    }
    static constexpr Value square_of(Value x) { return Format::value(x * x); }

    // t^2 times the ease.
    [[gnu::always_inline]] constexpr Value phase_at(Value depth) const {
      if (step.is_inside)
        return Format::value(Format::root(Format::value(half(step.before)) + Format::value(half(depth))));
      if (!is_positive(depth)) return Value{};  // a stop so stiff that all of its penetrations are below an LSB
      const auto share = Format::rough_quotient(without_sign(depth), without_sign(depth - step.before));
      return Format::value(Format::root(depth) * (square(share) * Format::short_constant(0.64)));
    }

    // q from cos^2 q + sin^2 b = whole, at most twice the whole and what leaves x below 0.999.
    template <class Share>
    [[gnu::always_inline]] constexpr Value elastic_part(Value whole, Value by_stored, Share cosine, Value base) const {
      const Value linear = one - number(by_stored);
      const auto squares = square(linear) + without_sign(one * Format::value(twice(twice(number(whole) * cosine))));
      const Value sum = linear + Format::value(Format::root_of_product(squares));
      const auto part = Format::rough_quotient(without_sign(one), without_sign(is_positive(sum - one) ? sum : one));
      const Value q = Format::value(twice(afresh(whole) * part));
      const Value u = number(q), most = most_slowing();
      if (!is_positive(u - most)) return q;
      // x of a u that is pressed: u (1 - P) - P, with P = C p/(1 + A)
      const Value room = is_positive(press) ? base - number(press) : base;
      if (!is_positive(room)) return q;
      const auto share = Format::rough_quotient(without_sign(room), without_sign(base));
      const Value least = Format::value(u * share), limit = one + most - Format::value(one * share);
      if (!is_positive(least - limit)) return q;
      return Format::value(q * Format::rough_quotient(without_sign(limit), without_sign(least)));
    }
    // k(x) x/C from x/C, less than 1: x is at most 0.999, where k is 2.8, and x/C at most q.
    [[gnu::always_inline]] constexpr Value correction(Value slowed) const {
      const Value x = number(slowed), most = most_slowing();
      return Format::value(twice(
          twice(afresh(slowed) * quarter_correction(Format::moved(is_positive(x - most) ? most : x, -exponent)))));
    }
    // 0.999
    constexpr Value most_slowing() const { return Format::value(twice(one * Format::short_constant(0.4995))); }
    // x/C
    [[gnu::always_inline]] constexpr Value slowing_part(Value q, Value back) const {
      if (!is_positive(press)) return q;
      if (!is_positive(back - press)) return Value{};
      return q - Format::value(afresh(q) * Format::rough_quotient(without_sign(press), without_sign(back)));
    }

    // k(x)/4, from w = x^2/4
    [[gnu::always_inline]] static constexpr Value quarter_correction(Value x) {
      constexpr double n0 = 0.1770975, n1 = 0.7574895, d1 = 1.649636, d2 = 0.659117;
      const auto w = square(half(x));
      const auto upper = Format::constant((1 - n0) / 192) - Format::constant(n1 / 48) * w;
      const auto lower = Format::constant(1.0 / 16) - w * (Format::constant(d1 / 4) - Format::constant(d2) * w);
      return Format::value(x * (Format::rough_quotient(upper, lower) + Format::constant(n0 / 12)));
    }

    template <bool is_in_field> [[gnu::always_inline]] constexpr End leave(Value damped, Value base) const {
      const Value elastic = Format::value(Format::root_of_product(square(half(d)) + square(v)));
      Value half_rate = elastic;  // -w1/2
      if constexpr (is_damped) {
        const Value slowed = slowed_half_rate(damped, base);
        if (is_positive(elastic - slowed)) half_rate = slowed;
      }
      // Outside by no more than it can go in the step.
      Value recoil = unscaled(Format::value(half(d)) + half_rate);
      if constexpr (is_in_field) {
        const Value least = is_positive(step.travel - step.field) ? step.field : step.travel;
        if (is_positive(least - recoil)) recoil = least;
        if (step.is_inside && is_positive(step.field) && is_positive(step.trial - recoil) &&
            Format::spare_bits(step.trial) >= bits) {
          const Value own_field = scaled(step.field), middle = Format::value(half(d)) + Format::value(half(own_field));
          const Value squares =
              square_of(middle) + square_of(v) - Format::value(afresh(own_field) * scaled(step.trial));
          const Value most =
              is_positive(squares) ? middle + Format::value(Format::root_of_product(without_sign(squares))) : middle;
          if (is_positive(recoil - unscaled(most))) recoil = unscaled(most);
        }
      }
      if (is_negative(recoil)) recoil = Value{};  // a ball that leaves faster than the law pushes it is not braked
      const Value free = step.trial - recoil, farthest = unscaled(-half_rate) + unscaled(-half_rate);
      Value end{};
      if (step.is_inside && !is_positive(free)) end = is_positive(free - farthest) ? free : farthest;
      if constexpr (is_in_field)
        if (is_negative(step.field) && is_positive(end - free)) end = free;
      return {recoil, Value{}, end, false};
    }
    [[gnu::always_inline]] constexpr Value slowed_half_rate(Value damped, Value base) const {
      const bool forward = is_positive(damped);
      const auto a = Format::quotient(without_sign(forward ? damped : -damped), without_sign(one + base));
      const Value quarter_k = quarter_correction(Format::value(a));
      const Value half_a = Format::value(half(a)), middle = Format::value(Format::constant(0.5));
      const Value p = forward ? middle - half_a : middle + half_a;
      const Value pk = Format::value(p * quarter_k), eighth = Format::value(Format::constant(0.125));
      const Value zeta = Format::value(p * (forward ? eighth - pk : eighth + pk));  // squared, over 16
      const auto squares = Format::value(twice(twice(square_of(d) * zeta))) + square_of(v);
      const Value z = Format::value(Format::root_of_product(without_sign(squares)));  // Z1/(2 C)

      const Value number_z = number(z), last = Format::value(one * Format::constant(0.9));
      if (is_positive(number_z - last - last))
        return Format::value(z * Format::quotient(without_sign(one), without_sign(number_z + number_z)));
      const Value half_z = Format::moved(Format::value(half(number_z)), -exponent);
      const Value x = Format::value(twice(half_z * Format::constant(1 / 1.8)));  // Z/3.6
      Value rise = Format::value(Format::constant(0.8771277)) - Format::value(x * Format::constant(0.3270418));
      rise = Format::value(Format::constant(0.5837475)) - Format::value(x * rise);
      rise = Format::value(Format::constant(0.0369422)) + Format::value(x * rise);
      rise = Format::value(Format::constant(0.3197118)) + Format::value(x * rise);
      rise = Format::value(Format::constant(0.3325318)) + Format::value(x * rise);
      const Value fourth = Format::value(Format::constant(0.25));
      const Value g = fourth + Format::value(x * rise * Format::constant(0.9));
      return Format::value(z * Format::quotient(without_sign(fourth), without_sign(g)));
    }
  };
};

}  // namespace impact
