// SPDX-License-Identifier: MIT
#pragma once
// Whether this compiler, its flags and this processor compute what was proved: 400 steps of the paper's scene at 1 ms,
// with its first impacts, against the bits that every target has. What no header can see fails here, such as
// -ffp-contract=fast where there is a fused multiply-add, a root that rounds otherwise, or memory that does not hold.
//
//     int main() {
//       if (!impact::self_test<Absorber::Format>()) stop();    // before the first step
//
// ROM and stack only. It is an absorber of its own, so that it costs about what one costs, once: see the manual.

#include <stdint.h>

#include <impact/absorber.hpp>

namespace impact {

namespace detail {

struct SelfTestRig {
  static constexpr Scene scene{};
  static constexpr Bounds bounds{};
  static constexpr double step = 1e-3;
};

// FNV-1a over x1, dx1, x2 and dx2 after each step.
template <class Format>
[[gnu::noinline]] uint32_t self_test_bits() {
  Absorber<SelfTestRig, HuntCrossley, Moment, Sine, Format> absorber;
  Fingerprint bits{};
  for (int n = 0; n < 400; ++n) {
    absorber.step();
    const auto& state = absorber.state();
    uint32_t words[sizeof(state.x1)];
    static_assert(sizeof words == 4 * sizeof state.x1);
    __builtin_memcpy(words, &state.x1, sizeof words);
    for (const uint32_t word : words) bits.add(word);
  }
  return bits.value;
}

template <class Format>
inline constexpr uint32_t proved_bits = 0;
template <>
inline constexpr uint32_t proved_bits<Fixed32> = 0x591a72b5;
template <>
inline constexpr uint32_t proved_bits<Float32> = 0xba96a9a6;
template <>
inline constexpr uint32_t proved_bits<Float32Plain> = 0xef84eed3;

}  // namespace detail

template <class Format>
bool self_test() {
  static_assert(detail::proved_bits<Format> != 0, "there are no proved bits of this format");
  return detail::self_test_bits<Format>() == detail::proved_bits<Format>;
}

}  // namespace impact
