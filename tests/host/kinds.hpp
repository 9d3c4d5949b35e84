#pragma once
// All laws and formats with every stepper whose contacts create no energy. Hunt-Crossley also has a damping per impact.

#include <ostream>
#include <vector>

#include "host_ref/simulation.hpp"

namespace impact::host {

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

inline std::vector<Kind> kinds() {
  std::vector<Kind> result;
  for (const Stepper stepper : {Stepper::automatic, Stepper::energy, Stepper::impulsive})
    for (const Numeric numeric : {Numeric::float64, Numeric::float32, Numeric::float32_plain, Numeric::fixed32}) {
      for (const Law law : {Law::hooke_newton, Law::hertz, Law::hunt_crossley})
        result.push_back({law, stepper, numeric});
      result.push_back({Law::hunt_crossley, stepper, numeric, Damping::exact});
    }
  return result;
}

}  // namespace impact::host
