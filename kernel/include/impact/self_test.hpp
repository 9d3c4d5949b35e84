// SPDX-License-Identifier: MIT
#pragma once
// True if compiler, flags and processor give the bits of every target: 400 steps of the paper's scene at 1 ms, with its
// first impacts. It fails where no header can see the fault: -ffp-contract=fast with a fused multiply-add, a square
// root that rounds differently, damaged memory. It compares values, so it also works on a big-endian core.
//
//     int main() {
//       if (!impact::self_test<Absorber::Format>()) stop();    // before the first step
//
// It needs flash and stack, no RAM. It has an absorber of its own, which costs about as much flash as one: the manual
// has figures.

#include <stdint.h>

#include <impact/absorber.hpp>

namespace impact {

namespace detail {

struct SelfTestRig {
  static constexpr Scene scene{};
  static constexpr Bounds bounds{};
  static constexpr double step = 1e-3;
};

// A state's number in words of 32 bits, the low one first: of its value, not of its bytes in memory.
template <class Add> void add_words(Fixed32::Long x, Add add) {
  const auto raw = static_cast<uint64_t>(x.raw);
  add(static_cast<uint32_t>(raw));
  add(static_cast<uint32_t>(raw >> 32));
}
template <class Add> void add_words(CompensatedState<float> x, Add add) {
  add(bits_of(x.sum));
  add(bits_of(x.rest));
}
template <class Add> void add_words(PlainState<float> x, Add add) { add(bits_of(x.sum)); }

// FNV-1a over x1, dx1, x2 and dx2 after each step.
template <class Format> [[gnu::noinline]] uint32_t self_test_bits() {
  Absorber<SelfTestRig, HuntCrossley, Moment, Sine, Format> absorber;
  Fingerprint bits{};
  for (int n = 0; n < 400; ++n) {
    absorber.step();
    const auto& state = absorber.state();
    const typename Format::Long numbers[] = {state.x1, state.dx1, state.x2, state.dx2};
    for (const auto number : numbers) add_words(number, [&bits](uint32_t word) { bits.add(word); });
  }
  return bits.value;
}

template <class Format> inline constexpr uint32_t proved_bits = 0;
template <> inline constexpr uint32_t proved_bits<Fixed32> = 0x6a136fec;
template <> inline constexpr uint32_t proved_bits<Float32> = 0x8e254f2b;
template <> inline constexpr uint32_t proved_bits<Float32Plain> = 0xbd543532;

}  // namespace detail

template <class Format> bool self_test() {
  static_assert(detail::proved_bits<Format> != 0,
                "self_test() has reference bits for Fixed32, Float32 and Float32Plain only");
  return detail::self_test_bits<Format>() == detail::proved_bits<Format>;
}

}  // namespace impact
