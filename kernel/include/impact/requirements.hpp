// SPDX-License-Identifier: MIT
#pragma once
// The kernel's requirements for a compiler, checked first. A missing header ends the compilation, so no other error
// follows.

#if defined(__clang__) ? __clang_major__ < 9 : !defined(__GNUC__) || __GNUC__ < 9
#error "impact needs GCC 9 or Clang 9, or a later one (Arduino's SAMD and Renesas cores bring GCC 7)"
#include <impact/compilation_ends_here>
#elif __cplusplus < 201703L
#error \
    "impact needs C++17: compile with -std=c++17 or -std=gnu++17 (Arduino: compiler.cpp.extra_flags in platform.local.txt)"
#include <impact/compilation_ends_here>
#elif defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#error "impact needs IEEE arithmetic: compile without -ffast-math, -Ofast and -ffinite-math-only"
#include <impact/compilation_ends_here>
#elif defined(__FLT_EVAL_METHOD__) && __FLT_EVAL_METHOD__ != 0 && __FLT_EVAL_METHOD__ != 16
#error "impact needs a float's arithmetic in float, which an x87 has not: compile with -msse2 -mfpmath=sse"
#include <impact/compilation_ends_here>
#elif !defined(__DBL_MANT_DIG__) || __DBL_MANT_DIG__ < 53
#error \
    "impact needs a double of 64 bits to make its constants: AVR has none, and -fshort-double or -mdouble=32 is not for it"
#include <impact/compilation_ends_here>
#endif

static_assert(sizeof(0.1) == sizeof(double),
              "impact needs its constants in double: without -fsingle-precision-constant");
