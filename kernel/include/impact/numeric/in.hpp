// SPDX-License-Identifier: MIT
#pragma once
// Values whose type has their unit, and gains that convert one unit to another. The types cost no instructions.
//
//     Push + Push, half(Push), Push * number    a Push
//     Push + Penetration, Push + Value          does not compile
//     gain * Push                               in the gain's second unit; its first one must be Push
//     Push * Push, root, quotient               a plain Value, for the inner arithmetic of a formula
//     Push(value)                               the only conversion of a plain Value to a Push

#include <impact/numeric/constant_math.hpp>
#include <impact/numeric/formula.hpp>
#include <impact/numeric/units.hpp>
#include <impact/types.hpp>

namespace impact {

namespace unit {
template <int UnitExponents::*own> struct Of {
  static constexpr int exponent(const UnitExponents& units) { return units.*own; }
};
using Position = Of<&UnitExponents::position>;
using Displacement = Of<&UnitExponents::displacement>;
using Damped = Of<&UnitExponents::damped>;
using Increment = Of<&UnitExponents::increment>;
using Push = Of<&UnitExponents::push>;
using Recoil = Of<&UnitExponents::recoil>;
using Penetration = Of<&UnitExponents::penetration>;
using Field = Of<&UnitExponents::field>;

// Units without an exponent. Their SI values are factors: force_unit (law/terms.hpp) and the unit of a sample.
struct Stated {
  static constexpr int exponent(const UnitExponents&) { return 0; }
};
struct Force : Stated {};
struct Sample : Stated {};
struct Number : Stated {};
}  // namespace unit

namespace detail {
template <class Real> struct RealNumber {
  Real own{};
  RealNumber() = default;
  [[gnu::always_inline]] explicit constexpr RealNumber(Real x) : own(x) {}
  constexpr operator Real() const { return own; }
};
template <class Value> using NumberOf = typename Either<__is_class(Value), Value, RealNumber<Value>>::Type;
}  // namespace detail

template <class Value, class Unit> struct In;
template <class Unit, class Value> [[gnu::always_inline]] constexpr In<Value, Unit> in(Value x) {
  return In<Value, Unit>(x);
}
template <class Value, class Unit> [[gnu::always_inline]] constexpr Value bare(In<Value, Unit> x) {
  return static_cast<Value>(x);
}

// A Value in a unit. It converts to a plain Value.
template <class Value, class Unit> struct In : detail::NumberOf<Value> {
  In() = default;
  [[gnu::always_inline]] explicit constexpr In(Value x) : detail::NumberOf<Value>{x} {}
  template <class Other> In(In<Value, Other>) = delete;

  [[gnu::always_inline]] friend constexpr In operator+(In x, In y) { return In(bare(x) + bare(y)); }
  [[gnu::always_inline]] friend constexpr In operator-(In x, In y) { return In(bare(x) - bare(y)); }
  [[gnu::always_inline]] friend constexpr In operator-(In x) { return In(-bare(x)); }
  template <class Other> friend void operator+(In, Other) = delete;
  template <class Other> friend void operator-(In, Other) = delete;
  template <class Other> friend void operator+(Other, In) = delete;
  template <class Other> friend void operator-(Other, In) = delete;

  [[gnu::always_inline]] friend constexpr auto half(In x) { return in<Unit>(half(bare(x))); }
  [[gnu::always_inline]] friend constexpr auto quarter(In x) { return in<Unit>(quarter(bare(x))); }
  [[gnu::always_inline]] friend constexpr auto twice(In x) { return in<Unit>(twice(bare(x))); }
  [[gnu::always_inline]] friend constexpr In afresh(In x) { return In(afresh(bare(x))); }
  [[gnu::always_inline]] friend constexpr In mirrored(In x, bool left) { return In(mirrored(bare(x), left)); }
  [[gnu::always_inline]] friend constexpr In mirrored_down(In x, bool left) { return In(mirrored_down(bare(x), left)); }
  [[gnu::always_inline]] friend constexpr In minus_mirrored(In x, bool left) {
    return In(minus_mirrored(bare(x), left));
  }
  [[gnu::always_inline]] friend constexpr In no_less(In x, In least) { return In(no_less(bare(x), bare(least))); }
  [[gnu::always_inline]] friend constexpr bool is_positive(In x) { return is_positive(bare(x)); }
  [[gnu::always_inline]] friend constexpr bool is_negative(In x) { return is_negative(bare(x)); }
  [[gnu::always_inline]] friend constexpr auto positive_part(In x) { return positive_part(bare(x)); }
  [[gnu::always_inline]] friend constexpr auto without_sign(In x) { return without_sign(bare(x)); }
  [[gnu::always_inline]] friend constexpr auto square(In x) { return square(bare(x)); }
};
template <class Value> using Position = In<Value, unit::Position>;
template <class Value> using Displacement = In<Value, unit::Displacement>;
template <class Value> using Damped = In<Value, unit::Damped>;
template <class Value> using Increment = In<Value, unit::Increment>;
template <class Value> using Push = In<Value, unit::Push>;
template <class Value> using Recoil = In<Value, unit::Recoil>;
template <class Value> using Penetration = In<Value, unit::Penetration>;
template <class Value> using Force = In<Value, unit::Force>;
template <class Value> using Sample = In<Value, unit::Sample>;

template <class First, class Second, class Unit, class Other>
[[gnu::always_inline]] constexpr auto operator*(In<First, Unit> x, In<Second, Other> y) {
  return bare(x) * bare(y);
}
template <class Value, class Unit, class Number>
[[gnu::always_inline]] constexpr auto operator*(In<Value, Unit> x, Number y) {
  return in<Unit>(bare(x) * y);
}
template <class Value, class Unit, class Number>
[[gnu::always_inline]] constexpr auto operator*(Number x, In<Value, Unit> y) {
  return in<Unit>(x * bare(y));
}
template <class First, class Second, class Unit> constexpr auto work(First x, In<Second, Unit> y) {
  return work(x, bare(y));
}
template <class First, class Second, class Unit, class Other>
constexpr auto work(In<First, Unit> x, In<Second, Other> y) {
  return work(bare(x), bare(y));
}

// A gain that converts one unit to another.
template <class Gain, class From, class To> struct GainOf { Gain own; };
template <class Gain, class From, class To, class Value>
[[gnu::always_inline]] constexpr In<Value, To> operator*(GainOf<Gain, From, To> gain, In<Value, From> x) {
  return In<Value, To>(gain.own * bare(x));
}
template <class Gain, class From, class To, class Value, class Unit>
void operator*(GainOf<Gain, From, To>, In<Value, Unit>) = delete;
// The same by the format's term() and dithered_term().
template <class Format, class Gain, class From, class To, class Value>
[[gnu::always_inline]] constexpr In<Value, To> term(GainOf<Gain, From, To> gain, In<Value, From> x) {
  return In<Value, To>(Format::term(gain.own, bare(x)));
}
template <class Format, class Gain, class From, class To, class Value>
[[gnu::always_inline]] constexpr In<Value, To> dithered_term(GainOf<Gain, From, To> gain, In<Value, From> x,
                                                             const typename Format::Long& chance) {
  return In<Value, To>(Format::dithered_term(gain.own, bare(x), chance));
}

// Converts a number in SI units to the constant of a plan that it initialises: a Value, a gain or a weight.
template <class Format> struct Scaled {
  const UnitExponents& units;

  struct Constant {
    double own;
    const UnitExponents& units;

    template <class Value, class Unit> constexpr operator In<Value, Unit>() const {
      return In<Value, Unit>(Format::sample(own * constant::power_of_two(-Unit::exponent(units))));
    }
    template <class Gain, class From, class To> constexpr operator GainOf<Gain, From, To>() const {
      const int from = From::exponent(units), to = To::exponent(units);
      if constexpr (detail::is_one_of<Gain, typename Format::Weight>)
        return {Format::weight(own, from, to)};
      else
        return {Gain{Format::gain(own, from, to)}};
    }
  };
  constexpr Constant operator()(double x) const { return {x, units}; }
};

}  // namespace impact
