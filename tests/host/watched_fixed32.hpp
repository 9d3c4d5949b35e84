#pragma once
// Detects sums, products, shifts and conversions of Fixed32 that overflow, without changing a bit. The kernel states a
// condition for each one (IMPACT_EXPECT in numeric/high_product.hpp). Here it is checked in sufficiently wide integers.
// The compiler's -include includes this file before the kernel.

#include <stdint.h>

namespace impact {

__extension__ using Wide = __int128;
constexpr bool is_in_64_bits(Wide x) { return x == static_cast<int64_t>(x); }

namespace host {

// The number of conditions that failed since the last reset, and the first one with its call stack.
struct Broken {
  long count;
  const char* condition;
  void* callers[24];
  int depth;
};
inline Broken broken{};
void note_broken(const char* condition);

}  // namespace host
}  // namespace impact

#define IMPACT_EXPECT(condition) \
  (__builtin_is_constant_evaluated() || (condition) ? void() : ::impact::host::note_broken(#condition))
