#pragma once
// One impact of 1 kg and 0.3 kg at k1 = 32600 and 0.8 m/s under each law, computed with 30 digits and given to ten.

#include <ostream>

#include "host_ref/closed_form.hpp"

namespace impact::host {

struct Known {
  const char* name;
  Law law;
  Tension tension;
  double damping, speed;                                                 // c1, m/s
  double restitution, peak_penetration, peak_force, contact_time, lost;  // -, m, N, s, J
};
inline void PrintTo(const Known& known, std::ostream* out) { *out << known.name; }

inline constexpr Known known_impacts[] = {
    {"HookeNewtonAllowed21", Law::hooke_newton, Tension::allow, 21.13670350, 0.8, 0.68, 1.781709339e-3, 59.85204308,
     8.421278563e-3, 0.03969969231},
    {"HookeNewtonClamped21", Law::hooke_newton, Tension::clamp, 21.13670350, 0.8, 0.7007021277, 1.781709339e-3,
     59.85204308, 7.766418997e-3, 0.03758891286},
    {"HookeNewtonAllowed20", Law::hooke_newton, Tension::allow, 20.81, 0.8, 0.6841256470, 1.786276287e-3, 59.94974646,
     8.419332801e-3, 0.03928409347},
    {"HookeNewtonClamped20", Law::hooke_newton, Tension::clamp, 20.81, 0.8, 0.7042988667, 1.786276287e-3, 59.94974646,
     7.774793620e-3, 0.03721573708},
    {"Hertz", Law::hertz, Tension::clamp, 0, 0.8, 1, 7.965629743e-3, 23.17649584, 0.02930630044, 0},
    {"HuntCrossleyTable2", Law::hunt_crossley, Tension::clamp, 19560, 0.8, 0.7561486807, 7.150708743e-3, 21.07151387,
     0.03035344861, 0.03162381583},
    {"HuntCrossleyStated", Law::hunt_crossley, Tension::clamp, 28345.99094, 0.8, 0.68, 6.877261349e-3, 20.93470711,
     0.03087606500, 0.03969969231},
};

// Hunt-Crossley with the paper's constant c1: {m/s, restitution}.
inline constexpr double restitutions_by_speed[][2] = {
    {0.1, 0.9615327714}, {0.4, 0.8618063006}, {1.6, 0.6038307454}, {3.2, 0.4215916966}};

}  // namespace impact::host
