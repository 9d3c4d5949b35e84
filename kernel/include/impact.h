// SPDX-License-Identifier: MIT
#pragma once
// For Arduino, which finds a library by a header at the root of its include folder. Elsewhere include
// <impact/absorber.hpp>.

#include <impact/absorber.hpp>
