// SPDX-License-Identifier: MIT
#pragma once
// Laws that set the damping at each impact from its own speed v0. All have Hunt-Crossley's force,
//
//     Fc = delta^(3/2) (k1 + c1 delta')        c1 = a k1/v0
//
// and differ only in the damping ratio a, a function of e = Scene::restitution. The restitution of an impact depends on
// a only (free_impact.hpp): it is the same at every speed. With `Exact` it is e.
//
//     stated e                 0.1    0.3    0.5    0.7    0.9    from e on
//     HuntCrossleyPerImpact   0.516  0.581  0.663  0.768  0.909      0.01
//     HerbertMcWhannell       0.491  0.520  0.594  0.723  0.901      0.01
//     LeeWang                 0.687  0.739  0.799  0.869  0.952      0.01
//     LankaraniNikravesh      0.665  0.684  0.725  0.796  0.913      0.01
//     Flores                  0.069  0.256  0.470  0.683  0.894      0.0158
//     HuGuo                   0.074  0.271  0.488  0.697  0.900      0.0148
//     Exact                   0.100  0.300  0.500  0.700  0.900      0.01
//
// A plan with a smaller e is rejected (PlanStatus::restitution), because its a is beyond damping_ratio_range. Machado,
// Moreira, Flores & Lankarani, Mech. Mach. Theory 53 (2012) compare all formulas but Hu & Guo's. Rodrigues da Silva,
// Marques, Tavares da Silva & Flores, Mech. Mach. Theory 167 (2022) compare all.
//
// A law of your own: struct Mine : HuntCrossleyPerImpact { static constexpr double damping_ratio(double e) {..} };

#include <impact/law/free_impact.hpp>
#include <impact/law/hunt_crossley.hpp>

namespace impact {

// Hunt & Crossley, J. Appl. Mech. 42 (1975); the paper's (2.9). It is right for small losses.
struct HuntCrossleyPerImpact : HuntCrossley {
  static constexpr bool is_damped_per_impact = true;
  static constexpr double damping_ratio(double e) { return 1.5 * (1 - e); }
};

// Herbert & McWhannell, J. Eng. Ind. 99 (1977).
struct HerbertMcWhannell : HuntCrossleyPerImpact {
  static constexpr double damping_ratio(double e) { return 6 * (1 - e) / ((2 * e - 1) * (2 * e - 1) + 3); }
};

// Lee & Wang, Mech. Mach. Theory 18 (1983).
struct LeeWang : HuntCrossleyPerImpact {
  static constexpr double damping_ratio(double e) { return 0.75 * (1 - e); }
};

// Lankarani & Nikravesh, J. Mech. Des. 112 (1990).
struct LankaraniNikravesh : HuntCrossleyPerImpact {
  static constexpr double damping_ratio(double e) { return 0.75 * (1 - e * e); }
};

// Flores, Machado, Silva & Martins, Multibody Syst. Dyn. 25 (2011).
struct Flores : HuntCrossleyPerImpact {
  static constexpr double damping_ratio(double e) { return 1.6 * (1 - e) / e; }
};

// Hu & Guo, Multibody Syst. Dyn. 35 (2015): the energy balance with rates that fall as (1 - (delta/peak)^(5/2))^(1/2).
struct HuGuo : HuntCrossleyPerImpact {
  static constexpr double damping_ratio(double e) { return 1.5 * (1 - e) / e; }
};

// The a whose restitution is e: a (1 + e) = ln((1 + a)/(1 - e a)). 1/e is a convex function of a, with the slope 2/3 at
// 0. Newton's method therefore converges from above, starting at the a of Hu & Guo.
struct Exact : HuntCrossleyPerImpact {
  static constexpr double damping_ratio(double e) {
    double a = HuGuo::damping_ratio(e);
    for (int pass = 0; pass < 6 && a > 1e-7; ++pass) {
      const double r = detail::HuntCrossleyRates(a).restitution;
      const double slope = (r * r - (1 - r * a) / (1 + a)) / (a * r * r * r);
      a -= (1 / r - 1 / e) / slope;
    }
    return a;
  }
};

}  // namespace impact
