#pragma once
// A test case on a target prints "name value", and the expected value if it differs. main() returns failures().

#include <stdint.h>

#include <board/console.hpp>

namespace impact::target {

inline int failure_count = 0;
inline int failures() { return failure_count != 0 ? 1 : 0; }

inline void check_equal(const char* name, uint32_t value, uint32_t expected) {
  board::print(name, " ", value);
  if (value != expected) {
    ++failure_count;
    board::print(" expected ", expected);
  }
  board::print("\n");
}

}  // namespace impact::target
