#pragma once
// The parameters of suites with random scenes: every law with given steppers and formats. Hunt-Crossley also has a
// damping per impact.

#include "host_ref/simulation.hpp"
#include "kernel_test.hpp"

namespace impact::host {

inline constexpr Law every_law[] = {Law::hooke_newton, Law::hertz, Law::hunt_crossley};
inline constexpr Numeric every_format[] = {Numeric::float64, Numeric::float32, Numeric::float32_plain,
                                           Numeric::fixed32};
// The rule, and the steppers that it chooses from.
inline constexpr Stepper every_stepper[] = {Stepper::automatic, Stepper::moment, Stepper::moment_4, Stepper::moment_8,
                                            Stepper::moment_n,  Stepper::energy, Stepper::impulsive};

struct Kind {
  Law law;
  Stepper stepper;
  Numeric numeric;
  Damping damping = Damping::constant;
};
inline void PrintTo(const Kind& kind, std::ostream* out) {
  *out << name_of(kind.law) << " " << name_of(kind.stepper) << " " << name_of(kind.numeric) << " "
       << name_of(kind.damping);
}

inline void set_kind(Request& request, const Kind& kind) {
  request.law = kind.law;
  request.stepper = kind.stepper;
  request.numeric = kind.numeric;
  request.damping = kind.damping;
}

inline std::vector<Kind> kinds(const std::vector<Stepper>& varied, Damping per_impact,
                               const std::vector<Numeric>& formats = {std::begin(every_format),
                                                                      std::end(every_format)}) {
  std::vector<Kind> result;
  for (const Stepper stepper : varied)
    for (const Numeric numeric : formats) {
      for (const Law law : every_law) result.push_back({law, stepper, numeric});
      result.push_back({Law::hunt_crossley, stepper, numeric, per_impact});
    }
  return result;
}

// All kinds with a stepper whose contacts create no energy.
inline std::vector<Kind> passive_kinds() {
  return kinds({Stepper::automatic, Stepper::energy, Stepper::impulsive}, Damping::exact);
}

}  // namespace impact::host
