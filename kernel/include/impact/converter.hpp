// SPDX-License-Identifier: MIT
#pragma once
// Between the kernel's numbers and a converter's counts, one multiplication each way, with a constant that the compiler
// makes:
//
//     constexpr impact::Converter dac{2048, 2047 / 0.05, 0, 4095};     // the middle is 0 m, full scale 0.05 m
//     constexpr impact::ToCounts<Absorber::Format> to_dac(dac, Absorber::displacement_unit());
//     DAC = to_dac(absorber.displacement());
//
//     constexpr impact::Converter adc{2048, 2048 / 10.0, 0, 4095};     // the middle is 0 N, full scale 10 N
//     constexpr impact::FromCounts<Absorber::Format> from_adc(adc, Absorber::sample_unit());
//     absorber.step(from_adc(ADC));
//
// Out: to the nearest count, held at the converter's ends. In: within 2^-29 of the unit (Fixed32) or 2^-22 of
// itself; in Fixed32 counts are held at the last one below the unit by 2^-28 of it. The ends, and the counts that come,
// lie less than 2^31 counts from zero.

#include <stdint.h>

#include <impact/numeric/constant_math.hpp>

namespace impact {

// As its circuit has it.
struct Converter {
  int32_t zero;               // counts at 0
  double counts_per_si_unit;  // below 0 where it counts backwards
  int32_t least, most;        // counts, the ends out
};

namespace detail {
// Not constexpr: where the compiler makes a converter, it names the mistake.
inline void a_converters_least_count_is_above_its_most() {}
inline void a_converter_has_no_counts_per_si_unit() {}

constexpr void check(const Converter& converter) {
  if (converter.least > converter.most) a_converters_least_count_is_above_its_most();
  if (!(constant::magnitude(converter.counts_per_si_unit) > 0)) a_converter_has_no_counts_per_si_unit();
}
constexpr int32_t held_in_32_bits(double x) {
  return static_cast<int32_t>(constant::larger(-2147483647.0, constant::smaller(x, 2147483647.0)));
}
}  // namespace detail

template <class Format>
class ToCounts {
 public:
  using Value = typename Format::Value;

  constexpr ToCounts(const Converter& converter, double unit)
      : gain_(Format::count_gain(converter.counts_per_si_unit * unit)),
        zero_(converter.zero),
        least_(detail::held_in_32_bits(static_cast<double>(converter.least) - converter.zero)),
        most_(detail::held_in_32_bits(static_cast<double>(converter.most) - converter.zero)) {
    detail::check(converter);
  }

  constexpr int32_t operator()(Value x) const { return zero_ + Format::counts(gain_, x, least_, most_); }

 private:
  typename Format::HeldGain gain_;
  int32_t zero_, least_, most_;  // the ends from zero
};

template <class Format>
class FromCounts {
 public:
  using Value = typename Format::Value;

  constexpr FromCounts(const Converter& converter, double unit)
      : gain_(Format::gain(per_count(converter, unit), Format::count_exponent, 0)),
        zero_(converter.zero),
        least_(detail::held_in_32_bits(static_cast<double>(zero_) - most(converter, unit))),
        most_(detail::held_in_32_bits(static_cast<double>(zero_) + most(converter, unit))) {
    detail::check(converter);
  }

  constexpr Value operator()(int32_t counts) const {
    return gain_ * Format::counted((counts < least_ ? least_ : counts > most_ ? most_ : counts) - zero_);
  }

 private:
  // Units a count. Those of a plan that was refused are 0, and the refusal has said why.
  static constexpr double per_count(const Converter& converter, double unit) {
    const double counts = converter.counts_per_si_unit * unit;
    return constant::magnitude(counts) > 0 ? 1 / counts : 0;
  }
  // Whole counts that a Value holds.
  static constexpr int32_t most(const Converter& converter, double unit) {
    return detail::held_in_32_bits(Format::most_counts(converter.counts_per_si_unit * unit));
  }

  typename Format::Gain gain_;
  int32_t zero_, least_, most_;
};

}  // namespace impact
