#pragma once
// Fixed32 with the same bits, which detects whether any sum, product, shift or conversion leaves its type. The kernel
// states its expectation for each one (IMPACT_EXPECT in numeric/high_product.hpp). Here it is checked in integers that
// are wide enough for all of them. The compiler's -include includes this file before the kernel.

#include <stdint.h>

namespace impact {

__extension__ using Wide = __int128;
constexpr bool is_in_64_bits(Wide x) { return x == static_cast<int64_t>(x); }

namespace host {

// The number of expectations that failed since the last clearing, and the first of them with the functions that led to
// it.
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
