#pragma once
// Every law and format by every stepper that promises passive contact.

#include <ostream>
#include <vector>

#include "host_ref/simulation.hpp"

namespace impact::host {

struct Kind {
  Law law;
  Stepper stepper;
  Numeric numeric;
};
inline void PrintTo(const Kind& kind, std::ostream* out) {
  *out << name_of(kind.law) << " " << name_of(kind.stepper) << " " << name_of(kind.numeric);
}

inline std::vector<Kind> kinds() {
  std::vector<Kind> result;
  for (const Law law : {Law::hooke_newton, Law::hertz, Law::hunt_crossley})
    for (const Stepper stepper : {Stepper::automatic, Stepper::energy, Stepper::impulsive})
      for (const Numeric numeric : {Numeric::float64, Numeric::float32, Numeric::float32_plain, Numeric::fixed32})
        result.push_back({law, stepper, numeric});
  return result;
}

}  // namespace impact::host
