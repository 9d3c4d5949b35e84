// The C library casts the kernel's faults to its own, so their numbers must be equal. If C lacks a fault, this file
// does not compile, because no case handles it.

#include <gtest/gtest.h>

#include <impact/fault.hpp>

#include "../../kernel/c/impact_c.h"

namespace impact {
namespace {

constexpr impact_fault in_c(Fault fault) {
  switch (fault) {
    case Fault::none:
      return impact_fault_none;
    case Fault::displacement:
      return impact_fault_displacement;
    case Fault::speed:
      return impact_fault_speed;
    case Fault::penetration:
      return impact_fault_penetration;
    case Fault::sample:
      return impact_fault_sample;
    case Fault::plan:
      return impact_fault_plan;
  }
  return impact_fault_none;
}

TEST(FaultsInC, OfCAreThoseOfTheKernel) {
  for (const Fault fault :
       {Fault::none, Fault::displacement, Fault::speed, Fault::penetration, Fault::sample, Fault::plan})
    EXPECT_EQ(static_cast<int>(fault), static_cast<int>(in_c(fault)));
}

}  // namespace
}  // namespace impact
