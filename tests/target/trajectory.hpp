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

// A machine that makes steps, whatever its type: what the type adds to an image is its step alone.
struct Trajectory {
  const char* label;
  void* state;
  const void* start;  // the state before the first step
  uint32_t words;     // of the state
  void (*advance)(void* state, uint32_t index);

  void restart() const { __builtin_memcpy(state, start, 4 * words); }
  uint32_t word(uint32_t index) const {
    uint32_t value;
    __builtin_memcpy(&value, static_cast<const char*>(state) + 4 * index, 4);
    return value;
  }
};

inline Fingerprint fingerprint(const Trajectory& trajectory) {
  Fingerprint result;
  trajectory.restart();
  for (uint32_t block = 0; block < blocks; ++block) {
    for (uint32_t i = 0; i < steps_per_block; ++i) {
      trajectory.advance(trajectory.state, block * steps_per_block + i);
      for (uint32_t word = 0; word < trajectory.words; ++word)
        result.hash = (result.hash ^ trajectory.word(word)) * 0x100000001b3;
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
