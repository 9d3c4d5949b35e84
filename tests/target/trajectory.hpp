#pragma once
// A trajectory's fingerprint: FNV-1a, 64 bits, taken word by word over the bytes of the whole state after every step,
// with eight of its bits kept every 16 steps, so that a difference shows where it began.

#include <stddef.h>
#include <stdint.h>

namespace impact::target {

constexpr uint32_t steps_per_block = 16, blocks = 64;

struct Fingerprint {
  uint64_t hash = 0xcbf29ce484222325;
  char digits[2 * blocks + 1] = {};  // two hexadecimal digits a block
};

template <class State>
void append(uint64_t& hash, const State& state) {
  static_assert(sizeof(State) % 4 == 0);
  uint32_t words[sizeof(State) / 4];
  __builtin_memcpy(words, &state, sizeof state);
  for (uint32_t word : words) hash = (hash ^ word) * 0x100000001b3;
}

// `advance(state, index)` makes step `index`.
template <class State, class Advance>
Fingerprint fingerprint(State& state, Advance advance) {
  Fingerprint result;
  for (uint32_t block = 0; block < blocks; ++block) {
    for (uint32_t i = 0; i < steps_per_block; ++i) {
      advance(state, block * steps_per_block + i);
      append(result.hash, state);
    }
    result.digits[2 * block] = "0123456789abcdef"[result.hash >> 60];
    result.digits[2 * block + 1] = "0123456789abcdef"[(result.hash >> 56) & 15];
  }
  return result;
}

// The block where the digits first differ; the last one when only the hash does.
inline uint32_t first_difference(const char* digits, const char* golden) {
  uint32_t digit = 0;
  while (digit < 2 * blocks - 1 && digits[digit] == golden[digit]) ++digit;
  return digit / 2;
}

}  // namespace impact::target
