#pragma once
// The absorber of a scene whose plan must be accepted. A rejected plan ends the test, which then fails.

#include <impact/absorber.hpp>
#include <stdexcept>
#include <string>

namespace impact {

template <class Kernel> Kernel accepted(const Scene& scene, const Bounds& bounds, double step) {
  const auto plan = Kernel::PlanType::make(scene, bounds, step);
  if (plan.status != PlanStatus::ok)
    throw std::runtime_error("the plan at a step of " + std::to_string(step) + " s is rejected with PlanStatus " +
                             std::to_string(static_cast<int>(plan.status)));
  return Kernel(plan);
}

}  // namespace impact
