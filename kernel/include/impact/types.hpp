// SPDX-License-Identifier: MIT
#pragma once
// What the headers ask of types: the kernel has no standard library.

namespace impact::detail {

// Of two types the first where the condition holds.
template <bool, class One, class> struct Either { using Type = One; };
template <class One, class Other> struct Either<false, One, Other> { using Type = Other; };

// Whether a type is among others.
template <class One, class... List> inline constexpr bool is_one_of = false;
template <class One, class First, class... Rest>
inline constexpr bool is_one_of<One, First, Rest...> = is_one_of<One, Rest...>;
template <class One, class... Rest> inline constexpr bool is_one_of<One, One, Rest...> = true;

}  // namespace impact::detail
