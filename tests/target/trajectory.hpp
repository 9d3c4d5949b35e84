#pragma once
// A trajectory's fingerprint: FNV-1a, 64 bits, over x1, dx1, x2, dx2, the contact's phase and the fault after every
// step. Every 16 steps eight of its bits are kept, so that a difference shows where it began. Neither the order of
// bytes in memory nor the rest of the state matters.

#include <stdint.h>

namespace impact::target {

constexpr uint32_t steps_per_block = 16, blocks = 64;

struct Fingerprint {
  uint64_t hash = 0xcbf29ce484222325;
  char digits[2 * blocks + 1] = {};  // two hexadecimal digits per block
};

struct Values {
  uint32_t words[9], count;

  void add(uint32_t word) { words[count++] = word; }
};

// A machine that makes steps, for any type, so that a type adds only its step to an image.
struct Trajectory {
  const char* label;
  void (*restart)();
  void (*advance)(uint32_t index);
  Values (*values)();
};

inline Fingerprint fingerprint(const Trajectory& trajectory) {
  Fingerprint result;
  trajectory.restart();
  for (uint32_t block = 0; block < blocks; ++block) {
    for (uint32_t i = 0; i < steps_per_block; ++i) {
      trajectory.advance(block * steps_per_block + i);
      const Values values = trajectory.values();
      for (uint32_t word = 0; word < values.count; ++word)
        result.hash = (result.hash ^ values.words[word]) * 0x100000001b3;
    }
    result.digits[2 * block] = "0123456789abcdef"[result.hash >> 60];
    result.digits[2 * block + 1] = "0123456789abcdef"[(result.hash >> 56) & 15];
  }
  return result;
}

// The block in which the digits first differ, or the last one if only the hash differs.
inline uint32_t first_difference(const char* digits, const char* golden) {
  uint32_t digit = 0;
  while (digit < 2 * blocks - 1 && digits[digit] == golden[digit]) ++digit;
  return digit / 2;
}

}  // namespace impact::target
