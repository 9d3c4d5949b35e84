// SPDX-License-Identifier: MIT
#pragma once
// The one table of the numbers that a plan is made from. Status, explanation, compile-time messages, identity, and the
// tool's options, rigs and explorer follow from it. It consists of macros, because a message must be a literal, and an
// image holds only the entries that it reads.
//
//     VALUE(member, least, most, unit, status of the rejected plan, meaning, belongs to a part)

#define IMPACT_MACHINE_VALUES(VALUE)                                                                               \
  VALUE(main_mass, 1e-9, 1e9, "kg", main_mass, "main mass", false)                                                 \
  VALUE(main_stiffness, 0, 1e12, "N/m", main_stiffness, "spring of the main mass", false)                          \
  VALUE(main_damping, 0, 1e9, "N s/m", main_damping, "damper of the main mass", false)                             \
  VALUE(ball_mass, 1e-9, 1e9, "kg", ball_mass, "mass of the ball", false)                                          \
  VALUE(clearance, 0, 1e12, "m", clearance, "the ball's whole free travel, from stop to stop", false)              \
  VALUE(contact_stiffness, 1e-3, 1e18, "N/m (HookeNewton) or N/m^(3/2)", contact_stiffness, "stiffness of a stop", \
        false)                                                                                                     \
  VALUE(contact_damping, 0, 1e18, "N s/m (HookeNewton) or N s/m^(5/2)", contact_damping,                           \
        "damping of a stop; Hertz has none", false)                                                                \
  VALUE(drive_amplitude, 0, 1e9, "N", drive_amplitude, "amplitude of a sine drive", false)                         \
  VALUE(drive_pulsation, 0, 1e6, "rad/s", drive_pulsation, "angular frequency of a sine drive", false)             \
  VALUE(x1, -1e3, 1e3, "m", initial_displacement, "initial displacement of the main mass", false)                  \
  VALUE(v1, -1e3, 1e3, "m/s", initial_velocity, "initial velocity of the main mass", false)                        \
  VALUE(x2, -1e3, 1e3, "m", initial_displacement, "initial displacement of the ball, in the same frame", false)    \
  VALUE(v2, -1e3, 1e3, "m/s", initial_velocity, "initial velocity of the ball", false)
#define IMPACT_MACHINE_BOUNDS(VALUE)                                                                                   \
  VALUE(displacement, 1e-9, 1e6, "m", displacement_bound,                                                              \
        "largest displacement of the main mass; beyond it the kernel raises a fault", false)                           \
  VALUE(speed, 1e-9, 1e6, "m/s", speed_bound, "largest speed of either mass", false)                                   \
  VALUE(penetration, 0, 1e6, "m", penetration_bound,                                                                   \
        "largest penetration; 0: the deepest that the other bounds allow", false)                                      \
  VALUE(force, 0, 1e9, "N", force_bound, "largest sample of the drive; beyond it the sample is clamped, with a fault", \
        false)

// Values of parts: unless such a value is stated, its part is not required.
#define IMPACT_PART_VALUES(VALUE)                                                                                     \
  VALUE(restitution, 0.01, 1, "of the impact's speed", restitution, "restitution, for a damping that is set from it", \
        true)                                                                                                         \
  VALUE(gravity, -1e6, 1e6, "m/s^2", gravity, "weight of both masses, along x", true)                                 \
  VALUE(ball_friction, 0, 1e9, "N", ball_friction, "dry friction between ball and main mass, sticking included", true)
#define IMPACT_PART_BOUNDS(VALUE)                                    \
  VALUE(base_acceleration, 0, 1e6, "m/s^2", base_acceleration_bound, \
        "largest sample of the base's acceleration; beyond it the sample is clamped, with a fault", true)

#define IMPACT_SCENE_VALUES(VALUE) IMPACT_MACHINE_VALUES(VALUE) IMPACT_PART_VALUES(VALUE)
#define IMPACT_BOUND_VALUES(VALUE) IMPACT_MACHINE_BOUNDS(VALUE) IMPACT_PART_BOUNDS(VALUE)
