// The numeric functions on all or many inputs. The bounds are checked in exact integers if possible, and otherwise in
// double, whose error of 2^-53 is far smaller.

#include <float.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <impact/numeric/fixed32.hpp>
#include <impact/numeric/reciprocal.hpp>
#include <impact/numeric/square_root.hpp>
#include <random>
#include <vector>

#include "host_ref/report/textbook_methods.hpp"

namespace impact {
namespace {

constexpr uint64_t two_32 = UINT64_C(1) << 32, two_63 = UINT64_C(1) << 63;

// Every power of two and its neighbours, and their negatives.
std::vector<uint32_t> edges() {
  std::vector<uint32_t> values{0};
  for (int k = 0; k < 32; ++k)
    for (uint32_t offset : {0xffffffffu, 0u, 1u}) {
      values.push_back((1u << k) + offset);
      values.push_back(0u - values.back());
    }
  return values;
}

int64_t floor_of_ratio_to_two_32(__int128 numerator) {
  const auto unit = static_cast<__int128>(two_32);
  return static_cast<int64_t>((numerator - ((numerator % unit) + unit) % unit) / unit);
}

template <class Number> void expect_high_product(Number a, Number b) {
  const int64_t exact = floor_of_ratio_to_two_32(static_cast<__int128>(a) * b);
  ASSERT_EQ(instruction::high_product(a, b), exact) << a << " " << b;
  ASSERT_EQ(composed::high_product(a, b), exact) << a << " " << b;
  ASSERT_EQ(composed::high_square(a), instruction::high_square(a)) << a;
  const Number half = b >> 16;
  ASSERT_EQ(composed::short_product(a, half), instruction::short_product(a, half)) << a << " " << b;
}
void expect_products_agree(uint32_t a, uint32_t b) {
  const auto c = static_cast<int32_t>(a), d = static_cast<int32_t>(b);
  expect_high_product(a, b);
  expect_high_product(c, d);
  const int64_t rounded = floor_of_ratio_to_two_32(static_cast<__int128>(c) * d + static_cast<__int128>(two_32 / 2));
  ASSERT_EQ(instruction::rounded_high_product(c, d), rounded) << c << " " << d;
  ASSERT_EQ(composed::rounded_high_product(c, d), rounded) << c << " " << d;
}

TEST(Lookup, ProductsAreExactInBothForms) {
  for (uint32_t a : edges())
    for (uint32_t b : edges()) expect_products_agree(a, b);
  std::mt19937 random(1);
  for (int i = 0; i < 3000000 && !HasFatalFailure(); ++i) {
    const auto a = static_cast<uint32_t>(random()), b = static_cast<uint32_t>(random());
    expect_products_agree(a, b);
  }
}

template <int step> void expect_normalised(uint32_t x) {
  uint32_t by_instruction = x, by_composition = x;
  const int steps = instruction::normalise<step>(by_instruction);
  EXPECT_EQ(composed::normalise<step>(by_composition), steps) << x;
  EXPECT_EQ(by_composition, by_instruction) << x;
  EXPECT_EQ(by_instruction >> (step * steps), x);
  EXPECT_GE(by_instruction, UINT32_C(1) << (32 - step)) << x;
}

// term() is gain * x. It rounds down if the gain shifts right. Otherwise it is within 2/3 of an LSB of the product.
TEST(Lookup, TermsRoundAsTheySay) {
  std::mt19937 random(1);
  for (int k = -32; k <= 0; ++k)
    for (int n = 0; n < 2000; ++n) {
      const double factor = std::ldexp(1 + static_cast<double>(random()) * 0x1p-32, k);
      const auto gain = Fixed32::gain(factor, 0, 0), power = Fixed32::gain(std::ldexp(1, k), 0, 0);
      const auto x = static_cast<int32_t>(random()) >> 1;
      const int64_t product = int64_t{x} * gain.mantissa;
      const int32_t found = Fixed32::term(gain, {x}).raw;
      if (gain.shift > 0)
        EXPECT_EQ(found, product >> (32 + gain.shift)) << factor << " " << x;
      else
        EXPECT_NEAR(found, std::ldexp(product, -32 - gain.shift), std::ldexp(2.0 / 3 + 1e-6, -gain.shift))
            << factor << " " << x;
      EXPECT_EQ(Fixed32::term(gain, {0}).raw, 0) << factor;
      EXPECT_EQ(Fixed32::moved_term(power, {x}).raw, int64_t{x} >> -k) << k << " " << x;
    }
}

TEST(Lookup, LeadingZerosAgreeInBothForms) {
  for (uint32_t x : edges()) {
    int zeros = 0;
    while (zeros < 32 && (x >> (31 - zeros)) == 0) ++zeros;
    EXPECT_EQ(instruction::leading_zeros(x), zeros) << x;
    EXPECT_EQ(composed::leading_zeros(x), zeros) << x;
    if (x == 0) continue;
    expect_normalised<1>(x);
    expect_normalised<2>(x);
  }
}

// 1 if |x| > limit, without a branch, for speed.
int beyond(int64_t x, int64_t limit) {
  return static_cast<uint64_t>(x) + static_cast<uint64_t>(limit) > 2 * static_cast<uint64_t>(limit);
}

static_assert(sizeof square_root_table == 768, "the table's size as its header states it");
static_assert(sizeof reciprocal_table == 128, "the table's size as its header states it");

// All numbers in four parts, for several processors. Each part also compares its first number with the one before it.
class LookupOfAQuarter : public testing::TestWithParam<uint32_t> {};
INSTANTIATE_TEST_SUITE_P(Quarters, LookupOfAQuarter, testing::Range(0u, 4u));

// The test compares squares and needs no root. With T = sqrt(y 2^32), |root - T| <= 2^-27 T + 1/2 becomes |root^2 -
// T^2| <= 2^-26 T^2 + root = 64 y + root.
TEST_P(LookupOfAQuarter, OfEveryUint32) {
  int64_t failures = 0;
  const uint64_t first = GetParam() * (two_32 / 4);
  uint64_t previous = first > 0 ? square_root_q32(static_cast<uint32_t>(first - 1)) : 0;
  for (uint64_t y = first == 0 ? 1 : first; y < first + two_32 / 4; ++y) {
    const uint64_t root = square_root_q32(static_cast<uint32_t>(y));
    const auto excess = static_cast<int64_t>(root * root - y * two_32);
    failures += (root < previous) + beyond(excess, static_cast<int64_t>(64 * y + root));
    previous = root;
  }
  EXPECT_EQ(failures, 0);
}

TEST(Lookup, EndsOfUint32) {
  EXPECT_EQ(square_root_q32(0), 0u);
  EXPECT_EQ(square_root_q32(0xffffffffu), 0xfffffffeu);
  for (int k = 0; k < 16; ++k) EXPECT_EQ(square_root_q32(1u << (2 * k)), 1u << (16 + k));
}

constexpr uint32_t infinity_bits = 0x7f800000;

TEST_P(LookupOfAQuarter, OfEveryFloat) {
  int64_t failures = 0;
  const uint32_t first = GetParam() * (infinity_bits / 4);
  for (uint32_t bits = first; bits < first + infinity_bits / 4; ++bits) {
    const float y = float_of(bits), root = std::sqrt(y);
    failures += (square_root(y) == root ? 0 : 1) + (correct_root(y) == root ? 0 : 1);
  }
  EXPECT_EQ(failures, 0);
}

// A function of the report's baselines, on every eleventh float.
TEST(Lookup, PowersAreWithinTheirBound) {
  const double bound = std::ldexp(1.0, -27) + std::ldexp(1.0, -24) + std::ldexp(1.0, -29);
  const double smallest = static_cast<double>(FLT_MIN) * static_cast<double>(FLT_MIN);
  const double largest = static_cast<double>(FLT_MAX) * static_cast<double>(FLT_MAX);
  int64_t failures = 0;
  float previous = 0;
  for (uint32_t bits = 0; bits < infinity_bits; bits += 11) {
    const auto y = static_cast<double>(float_of(bits));
    const float power = power_three_halves(float_of(bits));
    const double cube = y * y * y, p = static_cast<double>(power);
    const bool good = cube < smallest  ? power == 0
                      : cube > largest ? power == FLT_MAX
                                       : std::fabs(p * p - cube) <= 2 * bound * cube;
    failures += (power < previous) + (good ? 0 : 1);
    previous = power;
  }
  EXPECT_EQ(failures, 0);
}

TEST(Lookup, EndsOfFloat) {
  for (const float zero : {0.0f, -0.0f}) {
    EXPECT_EQ(bits_of(square_root(zero)), bits_of(zero));
    EXPECT_EQ(bits_of(correct_root(zero)), bits_of(zero));
  }
  EXPECT_EQ(bits_of(power_three_halves(0.0f)), 0u);
  EXPECT_EQ(square_root(INFINITY), INFINITY);
  EXPECT_EQ(power_three_halves(INFINITY), FLT_MAX);
  EXPECT_EQ(power_three_halves(std::ldexp(1.0f, -84)), FLT_MIN);
}

TEST(Lookup, WhatHasNoRootGivesZero) {
  std::vector<uint32_t> rootless{0x80000001, 0x807fffff, 0x80800000, 0xbf800000, 0xff7fffff, 0xff800000,
                                 0x7f800001, 0x7fc00000, 0x7fffffff, 0xff800001, 0xffc00000, 0xffffffff};
  for (uint32_t bits = 0x80000001; bits >= 0x80000000; bits += 4093) rootless.push_back(bits);
  for (uint32_t bits : rootless) {
    ASSERT_EQ(bits_of(square_root(float_of(bits))), 0u) << bits;
    ASSERT_EQ(bits_of(power_three_halves(float_of(bits))), 0u) << bits;
  }
}

TEST(Lookup, TheLargerAndTheSmallerKeepANaN) {
  const double numbers[] = {-1, 2, std::nan("")};
  for (const double a : numbers)
    for (const double b : numbers) {
      const double sum = a + b, larger = constant::larger(a, b), smaller = constant::smaller(a, b);
      EXPECT_EQ(std::isnan(larger), std::isnan(sum));
      EXPECT_EQ(std::isnan(smaller), std::isnan(sum));
      EXPECT_TRUE(std::isnan(sum) || (larger == std::fmax(a, b) && smaller == std::fmin(a, b)));
    }
}

// Roots computed bit by bit equal the processor's: random doubles, squares and their neighbours, and both ends of each
// power of two.
TEST(Lookup, RootsOfDoublesAreCorrect) {
  std::mt19937_64 random(1);
  const auto check = [](double y) {
    if (!(y >= 0)) return;
    ASSERT_EQ(bits_of(square_root(y)), bits_of(std::sqrt(y))) << y;
    ASSERT_EQ(bits_of(correct_root(y)), bits_of(std::sqrt(y))) << y;
  };
  for (uint64_t i = 0; i < 100000; ++i) {
    check(double_of(random() >> 1));
    check(double_of(random() >> (12 + i % 52)));  // subnormal ones
    const double root = std::ldexp(static_cast<double>(random() >> (11 + i % 27)), static_cast<int>(i % 900) - 450);
    for (const double y : {root * root, std::nextafter(root * root, 0.0), std::nextafter(root * root, 1e300)}) check(y);
  }
  for (uint64_t exponent = 0; exponent < 2048; ++exponent)
    for (const uint64_t digits : {uint64_t{0}, uint64_t{1}, (uint64_t{1} << 52) - 1})
      check(double_of(exponent << 52 | digits));
  check(-0.0);
}

// A root near a known one is compared with the parabola that the header states, and with the true root.
void expect_root_beside(int32_t y, int32_t z) {
  const double unit = 2147483648.0, s = std::sqrt(y / unit) * unit, e = (static_cast<double>(z) - y) / y;
  const double clamped = std::fmin(e, 1), lsbs = 4 + s * 0x1p-27;
  const double found = KnownSquareRoot::of(y).root_beside(z), parabola = s * (1 + clamped / 2 - clamped * clamped / 8);
  ASSERT_NEAR(found, parabola, s * std::fabs(clamped) * 0x1p-12 + lsbs) << y << " " << z;
  ASSERT_GT(found, 0) << y << " " << z;
  const double root = std::sqrt(z / unit) * unit;
  if (e < -0.5) return;
  ASSERT_LE(found, root + (e > 0 ? root * 6e-6 + lsbs : s * 0.012)) << y << " " << z;
  if (e > 1) return;
  ASSERT_GE(found, root - s * 0.04) << y << " " << z;
}

TEST(Lookup, RootsBesideAKnownOne) {
  std::mt19937 random(5);
  for (int i = 0; i < 3000000 && !HasFatalFailure(); ++i) {
    const auto y = static_cast<int32_t>(static_cast<uint32_t>(random()) >> (1 + i % 31) | 1);
    ASSERT_EQ(KnownSquareRoot::of(y).root_beside(y), square_root_q31(static_cast<uint32_t>(y) << 1));
    // Near y, at twice y, and far above and below.
    const double near = y * (1 + std::ldexp(static_cast<double>(random()) / 2147483648.0 - 1, -(i % 13)));
    for (const double z : {near, 2.0 * y, 2.0 * y + 1, 1.0, 2147483647.0, y - 1.0, y + 1.0})
      if (z >= 1 && z <= 2147483647.0) expect_root_beside(y, static_cast<int32_t>(z));
  }
}

TEST(Lookup, ReciprocalOfEveryNormalisedDivisor) {
  int64_t failures = 0;
  for (uint64_t d = two_32 / 2; d < two_32; ++d) {
    const uint64_t r = reciprocal_q31(static_cast<uint32_t>(d));
    failures += (r * d > two_63) + ((r + 2) * d <= two_63);
    failures += reciprocal_q31<true>(static_cast<uint32_t>(d)) != reciprocal_q31(static_cast<uint32_t>(d & ~1u));
  }
  EXPECT_EQ(failures, 0);
  EXPECT_EQ(reciprocal_q31(0x80000000u), 0xffffffffu);
}

// Since r > 2^63/d - 2, the product n r/2^31 is less than 2^-30 of the quotient too small. Rounding down takes less
// than 1 more.
void expect_quotient(uint32_t numerator, uint32_t denominator) {
  const uint64_t n = numerator, d = denominator;
  const uint64_t fine = quotient_q32(numerator, denominator);
  ASSERT_LE(fine * d, n * two_32) << n << " / " << d;
  ASSERT_LT(n * two_32 - fine * d, d + 4 * n) << n << " / " << d;
  // The table has 17 bits, of which two are rounded off. An LSB is added.
  const double rough = rough_quotient_q31(numerator, denominator),
               exact = static_cast<double>(n) / static_cast<double>(d) * 2147483648.0;
  ASSERT_LE(rough, exact * (1 + 1.0 / 65536) + 1) << n << " / " << d;
  ASSERT_GE(rough, exact * (1 - 4.0 / 65536) - 2) << n << " / " << d;
  const uint32_t brief = instruction::quotient_q16(numerator, denominator);
  ASSERT_EQ(composed::quotient_q16(numerator, denominator), brief) << n << " / " << d;
  ASSERT_LT(brief, 65536u) << n << " / " << d;
  ASSERT_LE(brief * d, n * 65536) << n << " / " << d;
  ASSERT_GT(brief + 1, exact / 32768 * (1 - 1.0 / 32768)) << n << " / " << d;
}

TEST(Lookup, Quotients) {
  for (uint32_t d = 1; d < 1024; ++d)
    for (uint32_t n = 0; n <= d; ++n) expect_quotient(n, d);
  for (uint32_t a : edges())
    for (uint32_t b : edges())
      if (a <= b && b != 0) expect_quotient(a, b);
  std::mt19937 random(2);
  for (int i = 0; i < 10000000 && !HasFatalFailure(); ++i) {
    const auto d = static_cast<uint32_t>(random()) >> (i % 32) | 1;
    expect_quotient(static_cast<uint32_t>(static_cast<uint64_t>(random()) * (uint64_t{d} + 1) / two_32), d);
  }
  // Every divisor that the 16-bit quotient distinguishes.
  for (uint64_t d = two_32 / 2; d < two_32 && !HasFatalFailure(); d += 65536)
    for (uint64_t n : {uint64_t{1}, d / 3, d - 65536, d})
      expect_quotient(static_cast<uint32_t>(n), static_cast<uint32_t>(d));
  for (uint32_t d : edges())
    if (d != 0) {
      EXPECT_EQ(quotient_q32(0, d), 0u);
      EXPECT_EQ(rough_quotient_q31(0, d), 0u);
    }
}

// Both forms have the same bits. They fall short by the stated amount and an LSB of the product. The composed form's
// correction is largest where the estimate's three rounding errors add up.
void expect_square_over_five(int32_t z, uint32_t p) {
  const int32_t result = instruction::square_over_five(z, p);
  ASSERT_EQ(composed::square_over_five(z, p), result) << z << " " << p;
  const double size = std::fabs(z), exact = 2.0 * size * size / (5.0 * p);
  ASSERT_LE(result, exact) << z << " " << p;
  ASSERT_GE(result, exact * (1 - 262144.0 / (262144.0 + p)) - 2 * size / 262144 - 1) << z << " " << p;
}

TEST(Lookup, SquareOverFive) {
  for (uint32_t a : edges())
    for (uint32_t p : edges())
      if (a <= p && a <= INT32_MAX && p != 0) {
        expect_square_over_five(static_cast<int32_t>(a), p);
        expect_square_over_five(-static_cast<int32_t>(a), p);
      }
  std::mt19937 random(4);
  for (int i = 0; i < 20000000 && !HasFatalFailure(); ++i) {
    const uint32_t p = static_cast<uint32_t>(random()) >> (i % 32) | 1;
    const auto size = static_cast<int32_t>(
        std::min(static_cast<uint64_t>(random()) * (uint64_t{p} + 1) / two_32, static_cast<uint64_t>(INT32_MAX)));
    expect_square_over_five(i % 2 == 0 ? size : -size, p);
  }
}

// share() has the bits of quotient_q32(). ratio() falls short by less than an LSB of 2^-29 in its product, and less
// than another in the halved reciprocal. It is clamped at 1.
TEST(Lookup, Divisors) {
  std::mt19937 random(3);
  std::vector<uint32_t> numbers = edges();
  for (int i = 0; i < 2000; ++i) numbers.push_back(static_cast<uint32_t>(random()) >> (i % 32));
  for (const uint32_t own : numbers) {
    if (own == 0 || own > INT32_MAX) continue;
    const Fixed32::Divisor divisor = Fixed32::divisor({own});
    for (const uint32_t raw : numbers) {
      if (raw < own) {
        ASSERT_EQ(divisor.share({raw}).raw, quotient_q32(raw, own)) << raw << " / " << own;
      } else if (raw <= INT32_MAX) {
        ASSERT_EQ(divisor.share({raw}).raw, UINT32_MAX);
      }
      const auto x = static_cast<int32_t>(raw);
      const double ratio = std::fmax(-1, std::fmin(1, static_cast<double>(x) / own));
      ASSERT_NEAR(divisor.ratio({x}).raw, ratio * 0x1p29, 2) << x << " / " << own;
    }
  }
}

}  // namespace
}  // namespace impact
