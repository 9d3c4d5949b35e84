// SPDX-License-Identifier: MIT
#pragma once
// Arduino finds a library by a header at the root of its include folder; elsewhere include <impact/absorber.hpp>.

#include <impact/absorber.hpp>
