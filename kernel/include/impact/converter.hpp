// SPDX-License-Identifier: MIT
#pragma once
// Converts between the native numbers of an absorber and the counts of an ADC or a DAC. Each conversion is one
// multiplication by a constant that the compiler computes:
//
//     constexpr impact::Converter dac{2048, 2047 / 0.05, 0, 4095};     // the middle is 0 m, full scale 0.05 m
//     constexpr impact::ToCounts<Absorber, impact::Quantity::displacement> to_dac(dac);
//     DAC = to_dac(absorber);
//
//     constexpr impact::Converter adc{2048, 2048 / 10.0, 0, 4095};     // the middle is 0 N, full scale 10 N
//     constexpr impact::FromCounts<Absorber> from_adc(adc);            // the sample of a Sampled drive
//     absorber.step(from_adc(ADC));
//
// A ToCounts reads its own quantity from the absorber or from its snapshot(). step() accepts from a FromCounts only the
// quantity that it expects. With a plan AtRunTime, pass the plan, which has the units: to_dac(dac, plan). Read the
// absorber only in the context that steps it. A snapshot may be read in any context.
//
// ToCounts returns the nearest count, clamped to the ends of the converter. The error of a FromCounts is at most 2^-29
// of the unit in Fixed32, and 2^-22 of the value in floating point. In Fixed32 it clamps counts at 1 - 2^-28 of the
// unit. step() raises Fault::sample for a sample of counts that are more than one count beyond that. Ends and counts
// must be less than 2^31 counts from zero. A `constexpr` FromCounts with an end beyond the bound of its quantity does
// not compile.

#include <stdint.h>

#include <impact/numeric/constant_math.hpp>
#include <impact/quantity.hpp>
#include <impact/snapshot.hpp>
#include <impact/status.hpp>
#include <impact/types.hpp>

namespace impact {

// How the counts of a circuit depend on the quantity.
struct Converter {
  int32_t zero;               // counts at 0 of the quantity
  double counts_per_si_unit;  // not 0; negative if it counts backwards
  int32_t least, most;        // smallest and largest count; least <= most
};

namespace detail {
// These functions are not constexpr, so that the compiler's error for a constexpr converter contains their names.
inline void a_converters_least_count_is_above_its_most() {}
inline void a_converter_has_no_counts_per_si_unit() {}
inline void a_converters_end_is_more_than_the_bound_of_its_quantity() {}

constexpr void check_converter(const Converter& converter) {
  if (converter.least > converter.most) a_converters_least_count_is_above_its_most();
  if (!(constant::magnitude(converter.counts_per_si_unit) > 0)) a_converter_has_no_counts_per_si_unit();
}
constexpr int32_t clamped_to_32_bits(double x) {
  return static_cast<int32_t>(constant::larger(-2147483647.0, constant::smaller(x, 2147483647.0)));
}

template <class Format> class CountsOut {
 public:
  using Value = typename Format::Value;

  constexpr CountsOut(const Converter& converter, double unit)
      : gain_(Format::count_gain(converter.counts_per_si_unit * unit)),
        zero_(converter.zero),
        least_(detail::clamped_to_32_bits(static_cast<double>(converter.least) - converter.zero)),
        most_(detail::clamped_to_32_bits(static_cast<double>(converter.most) - converter.zero)) {
    detail::check_converter(converter);
  }

  // The counts of a native value of the same quantity.
  constexpr int32_t of(Value x) const { return zero_ + Format::counts(gain_, x, least_, most_); }

 private:
  typename Format::ClampedGain gain_;
  int32_t zero_, least_, most_;  // the ends count from zero
};

template <class Format> class CountsIn {
 public:
  using Value = typename Format::Value;

  constexpr CountsIn(const Converter& converter, double unit)
      : gain_(Format::gain(per_count(converter, unit), Format::count_exponent, 0)),
        zero_(converter.zero),
        least_(detail::clamped_to_32_bits(static_cast<double>(zero_) - most(converter, unit))),
        most_(detail::clamped_to_32_bits(static_cast<double>(zero_) + most(converter, unit))) {
    detail::check_converter(converter);
  }

  constexpr Value of(int32_t counts) const {
    return gain_ * Format::counted((counts < least_ ? least_ : counts > most_ ? most_ : counts) - zero_);
  }
  // True if of() clamps these counts by more than one count.
  constexpr bool is_beyond(int32_t counts) const {
    return counts < least_ ? counts + 1 < least_ : counts > most_ && counts - 1 > most_;
  }

 private:
  // Units per count. A rejected plan has the unit 0, and then this is 0 too.
  static constexpr double per_count(const Converter& converter, double unit) {
    const double counts = converter.counts_per_si_unit * unit;
    return constant::magnitude(counts) > 0 ? 1 / counts : 0;
  }
  // The largest whole number of counts that fits in a Value.
  static constexpr int32_t most(const Converter& converter, double unit) {
    return detail::clamped_to_32_bits(Format::most_counts(converter.counts_per_si_unit * unit));
  }

  typename Format::Gain gain_;
  int32_t zero_, least_, most_;
};

// The SI value of a native 1.0.
template <Quantity quantity, class Plan> constexpr double unit_of(const Plan& plan) {
  if constexpr (quantity == Quantity::displacement || quantity == Quantity::ball_displacement)
    return plan.displacement_unit();
  else if constexpr (quantity == Quantity::velocity || quantity == Quantity::ball_velocity)
    return plan.velocity_unit();
  else if constexpr (quantity == Quantity::contact_force)
    return plan.force_unit();
  else if constexpr (quantity == Quantity::force)
    return plan.sample_unit();
  else
    return plan.base_sample_unit();
}
// The largest value that may come in, SI.
template <Quantity quantity, class Plan> constexpr double largest_of(const Plan& plan) {
  using Units = typename Plan::FormatType::Units;
  if constexpr (quantity == Quantity::force)
    return Units::fraction(plan.drive.largest) * plan.sample_unit();
  else if constexpr (quantity == Quantity::base_acceleration)
    return Units::fraction(plan.field.largest_base) * plan.base_sample_unit();
  else
    return Plan::FormatType::is_real ? 0x1p20 : unit_of<quantity>(plan);
}
// The quantity, from a getter of the absorber or a member of its snapshot.
template <Quantity quantity, class Absorber> constexpr auto read(const Absorber& absorber) {
  if constexpr (quantity == Quantity::displacement)
    return absorber.displacement();
  else if constexpr (quantity == Quantity::velocity)
    return absorber.velocity();
  else if constexpr (quantity == Quantity::ball_displacement)
    return absorber.ball_displacement();
  else if constexpr (quantity == Quantity::ball_velocity)
    return absorber.ball_velocity();
  else
    return absorber.contact_force();
}
template <Quantity quantity, class Value> constexpr Value read(const Snapshot<Value>& snapshot) {
  if constexpr (quantity == Quantity::displacement)
    return snapshot.displacement;
  else if constexpr (quantity == Quantity::velocity)
    return snapshot.velocity;
  else if constexpr (quantity == Quantity::ball_displacement)
    return snapshot.ball_displacement;
  else if constexpr (quantity == Quantity::ball_velocity)
    return snapshot.ball_velocity;
  else
    return snapshot.contact_force;
}
}  // namespace detail

// Counts that go out, for a displacement, a velocity or the contact force.
template <class Absorber, Quantity quantity> class ToCounts : public detail::CountsOut<typename Absorber::Format> {
  static_assert(quantity != Quantity::force && quantity != Quantity::base_acceleration,
                "ToCounts cannot convert a sample, because samples go in: use FromCounts. The contact force is "
                "Quantity::contact_force");
  using Base = detail::CountsOut<typename Absorber::Format>;

 public:
  using typename Base::Value;

  template <class Owner = Absorber>
  explicit constexpr ToCounts(const Converter& converter) : ToCounts(converter, Owner::plan) {}
  constexpr ToCounts(const Converter& converter, const typename Absorber::PlanType& plan)
      : Base(converter, detail::unit_of<quantity>(plan)) {}

  template <class Source> constexpr int32_t operator()(const Source& source) const {
    constexpr bool is_source = detail::is_one_of<Source, Absorber, Snapshot<Value>>;
    static_assert(is_source,
                  "ToCounts reads its quantity itself: pass the absorber or its snapshot(), as in to_dac(absorber). "
                  "For a native value of your own, call to_dac.of(value)");
    static_assert(quantity != Quantity::contact_force || Absorber::has_contact_force,
                  "the contact force requires the feature ContactForce: append it to the absorber's type");
    if constexpr (is_source)
      return this->of(detail::read<quantity>(source));
    else
      return 0;
  }
};

// Counts that come in, for step() as a sample of the drive or of the base's acceleration, or for correct() as a
// measured value.
template <class Absorber, Quantity quantity = Quantity::force>
class FromCounts : public detail::CountsIn<typename Absorber::Format> {
  static_assert(quantity != Quantity::force || Absorber::Drive::is_sampled,
                "FromCounts converts samples of a drive: name Sampled as the drive");
  using Base = detail::CountsIn<typename Absorber::Format>;

 public:
  using typename Base::Value;

  template <class Owner = Absorber>
  explicit constexpr FromCounts(const Converter& converter) : FromCounts(converter, Owner::plan) {}
  constexpr FromCounts(const Converter& converter, const typename Absorber::PlanType& plan)
      : Base(converter, detail::unit_of<quantity>(plan)) {
    if (plan.status == PlanStatus::ok) check_ends(converter, detail::largest_of<quantity>(plan));
  }

  constexpr Native<quantity, Value> operator()(int32_t counts) const {
    return {this->of(counts), this->is_beyond(counts)};
  }

 private:
  // One count and the rounding of a float are tolerated.
  static constexpr void check_ends(const Converter& converter, double largest) {
    const auto is_beyond = [&](int32_t end) {
      const double counts = constant::magnitude(static_cast<double>(end) - converter.zero);
      return counts - 1 > 1.000001 * largest * constant::magnitude(converter.counts_per_si_unit);
    };
    if (is_beyond(converter.least) || is_beyond(converter.most))
      detail::a_converters_end_is_more_than_the_bound_of_its_quantity();
  }
};

}  // namespace impact
