// SPDX-License-Identifier: MIT
#pragma once
// The physical scene, in SI units. A main mass on a spring and a damper is driven by F(t). A ball moves freely in a
// cavity of the main mass and hits its left and right stops.
//
//     M x1'' + c x1' + k x1 = F(t) + Fc        m x2'' = -Fc        y = x2 - x1
//     right stop: penetration =  y - d/2       left stop: penetration = -y - d/2       contact while it is > 0
//
// Fc > 0 pushes the main mass towards the stop that is hit. The clearance d is the ball's whole free travel: the stops
// are at +-d/2 from the middle of the cavity, where the ball starts. The equations are (2.1) to (2.8) of Chehaibi, Mrad
// & Nasri, "Collision modeling of single unit impact absorber for mechanical systems vibration attenuation". The
// defaults below are that paper's Hunt-Crossley scene (Table 2), driven at 40 rad/s.

#include <impact/requirements.hpp>

namespace impact {

// Hooke-Newton: Fc = k1 delta + c1 delta'               (2.1), Kelvin-Voigt
// Hertz:        Fc = k1 delta^(3/2)                     (2.5), c1 is not used
// Hunt-Crossley: Fc = delta^(3/2) (k1 + c1 delta')      (2.7)
enum class Law { hooke_newton, hertz, hunt_crossley };

// Which stops the ball can meet. With `none` the clearance is irrelevant.
enum class Stops { both, left, right, none };

// What happens if HookeNewton's contact force gets negative. `clamp` releases the ball at zero force, since a stop
// cannot pull. `allow` follows the law as the paper writes it, and releases the ball at zero penetration. The other
// laws never pull.
enum class Tension { clamp, allow };

// The default of contact_damping: the paper's c1 plus one bit, which means that c1 is not stated. With HuntCrossley and
// the default contact_stiffness it stands for 19560. With another stiffness or with HookeNewton the plan is rejected.
inline constexpr double unstated_damping = 19560.0 + 0x1p-38;

// The values of a scene, in SI units. values.hpp has the range of each, such as 1e-9 to 1e9 kg for a mass. A value
// outside its range does not compile. At run time the plan's status then names the value.
struct Scene {
  double main_mass = 1.0;                     // M, kg
  double main_stiffness = 1000.0;             // k, N/m; 0 for a free main mass
  double main_damping = 0.01;                 // c, N s/m
  double ball_mass = 0.3;                     // m, kg
  double clearance = 0.02;                    // d, m
  double contact_stiffness = 32600.0;         // k1, N/m (Hooke-Newton) or N/m^(3/2)
  double contact_damping = unstated_damping;  // c1, N s/m (Hooke-Newton) or N s/m^(5/2)
  double drive_amplitude = 10.0;              // F0, N: F(t) = F0 sin(w t) for Sine; state 0 for another drive
  double drive_pulsation = 40.0;              // w, rad/s
  double x1 = 0.0;                            // initial displacement of the main mass, m
  double v1 = 0.0;                            // initial velocity of the main mass, m/s
  double x2 = 0.0;                            // initial displacement of the ball, m, in the same frame as x1
  double v2 = 0.0;                            // initial velocity of the ball, m/s
  Stops stops = Stops::both;
  Tension tension = Tension::clamp;
  double restitution = 1.0;    // e, 0.01 to 1, for Exact and the other laws of law/per_impact.hpp
  double gravity = 0.0;        // g along x, m/s^2, on both masses: with Gravity or BaseAcceleration, motion/field.hpp
  double ball_friction = 0.0;  // R, N, dry friction between ball and main mass: with DryFriction, motion/friction.hpp
};

// The largest values that the scene may reach, in SI units. The plan checks whether its step suits them. A state beyond
// them raises a fault, in every format. Fixed32 derives its units from them: tighter bounds give a finer resolution.
// The defaults suit the paper's scene with every law that loses energy. Hertz loses none: with it the ball passes 2 m/s
// after 5 to 70 s (steps of 0.1 to 1 ms), and reaches 2.9 m/s in three hours. Units and deepest penetration depend on
// Scene::drive_amplitude with every drive.
struct Bounds {
  double displacement = 0.1;     // of the main mass, and of a ball that has one stop, m
  double speed = 2.0;            // of either mass, m/s
  double penetration = 0;        // into a stop, m; 0: the deepest that the other bounds allow, law/depth.hpp
  double force = 10.0;           // of the samples of a Sampled drive, N; the plan reserves room for it with any drive
  double base_acceleration = 0;  // of the samples of BaseAcceleration, which requires it, m/s^2
};

}  // namespace impact
