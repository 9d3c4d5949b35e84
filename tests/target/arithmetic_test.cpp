// The core's own instructions in high_product.hpp agree with the compiler's 64-bit arithmetic. The operands are the
// ends of the range and of each half word, their neighbours, and random numbers. Long sums are tested at each shift.

#include <impact/numeric/high_product.hpp>

#include "check.hpp"

namespace {

constexpr uint32_t edges[] = {0,          1,          2,          0x7fff,     0x8000,     0xffff,
                              0x10000,    0x10001,    0x7ffffffe, 0x7fffffff, 0x80000000, 0x80000001,
                              0xffff0000, 0xffff7fff, 0xffff8000, 0xfffffffe, 0xffffffff};
constexpr uint32_t numbers = sizeof edges / sizeof *edges + 40;

constexpr uint32_t known_number(uint32_t index) {
  constexpr uint32_t golden = 2654435769;  // 2^32 over the golden ratio
  return index < sizeof edges / sizeof *edges ? edges[index] : index * index * golden;
}
// A number that the compiler does not know as a constant.
uint32_t number(uint32_t index) {
  volatile const uint32_t number = known_number(index);
  return number;
}

uint32_t wrong_products() {
  uint32_t wrong = 0;
  for (uint32_t i = 0; i < numbers; ++i)
    for (uint32_t j = 0; j < numbers; ++j) {
      const uint32_t a = number(i), b = number(j);
      const auto x = static_cast<int32_t>(a), y = static_cast<int32_t>(b);
      const uint64_t product = uint64_t{a} * b;
      const int64_t signed_product = int64_t{x} * y;
      wrong += impact::high_product(a, b) != product >> 32;
      wrong += impact::high_product(x, y) != signed_product >> 32;
      wrong += impact::rounded_high_product(x, y) != (signed_product >> 32) + (signed_product >> 31 & 1);
      wrong += impact::full_product(x, y) != signed_product;
      wrong += impact::short_product(a, b & 0xffff) != static_cast<uint32_t>(uint64_t{a} * (b & 0xffff) >> 16);
      const int32_t half_word = y >> 16;
      wrong += impact::short_product(x, half_word) != int64_t{x} * half_word >> 16;
    }
  return wrong;
}

// Products with numbers that the compiler knows.
template <uint32_t index = 0> uint32_t wrong_products_with_constants() {
  constexpr uint32_t b = known_number(index);
  constexpr auto y = static_cast<int32_t>(b), rough = static_cast<int32_t>(b & 0xffff0000);
  uint32_t wrong = 0;
  for (uint32_t i = 0; i < numbers; ++i) {
    const auto x = static_cast<int32_t>(number(i));
    const int64_t product = int64_t{x} * y;
    wrong += impact::high_product(x, y) != product >> 32;
    wrong += impact::high_product(x, rough) != int64_t{x} * rough >> 32;
    wrong += impact::rounded_high_product(x, y) != (product >> 32) + (product >> 31 & 1);
  }
  if constexpr (index + 1 < numbers)
    return wrong + wrong_products_with_constants<index + 1>();
  else
    return wrong;
}

// Only sums and terms that do not overflow.
template <int bits> uint32_t wrong_sums() {
  uint32_t wrong = 0;
  for (uint32_t i = 0; i < numbers; ++i)
    for (uint32_t j = 0; j < numbers; ++j) {
      const auto x = static_cast<int32_t>(number(i)) >> (bits < 31 ? 0 : bits - 31);
      const auto sum = static_cast<int64_t>(uint64_t{number(j)} << 32 | number(i + j)) >> 1;
      int64_t found = sum;
      impact::add_shifted(found, x, bits);
      wrong += found != sum + x * (INT64_C(1) << bits);
    }
  if constexpr (bits < 62)
    return wrong + wrong_sums<bits + 1>();
  else
    return wrong;
}

}  // namespace

int main() {
  impact::target::check_equal("wrong products", wrong_products(), 0);
  impact::target::check_equal("wrong products with constants", wrong_products_with_constants(), 0);
  impact::target::check_equal("wrong sums", wrong_sums<1>(), 0);
  return impact::target::failures();
}
