// SPDX-License-Identifier: MIT
#pragma once
// The one table of the numbers that a plan is made from. Status, explanation, compile-time messages, identity, and the
// tool's options and rigs follow from it. It consists of macros, because a message must be a literal, and an
// image holds only the entries that it reads.
//
//     VALUE(member, least, most, unit, status of the rejected plan, meaning, the part that it belongs to)

#define IMPACT_MACHINE_VALUES(VALUE)                                                                               \
  VALUE(main_mass, 1e-9, 1e9, "kg", main_mass, "main mass", none)                                                  \
  VALUE(main_stiffness, 0, 1e12, "N/m", main_stiffness, "spring of the main mass", none)                           \
  VALUE(main_damping, 0, 1e9, "N s/m", main_damping, "damper of the main mass", none)                              \
  VALUE(ball_mass, 1e-9, 1e9, "kg", ball_mass, "mass of the ball", none)                                           \
  VALUE(clearance, 0, 1e12, "m", clearance, "the ball's whole free travel, from stop to stop", none)               \
  VALUE(contact_stiffness, 1e-3, 1e18, "N/m (HookeNewton) or N/m^(3/2)", contact_stiffness, "stiffness of a stop", \
        none)                                                                                                      \
  VALUE(contact_damping, 0, 1e18, "N s/m (HookeNewton) or N s/m^(5/2)", contact_damping,                           \
        "damping of a stop; Hertz has none", none)                                                                 \
  VALUE(drive_amplitude, 0, 1e9, "N", drive_amplitude, "amplitude of a sine drive", none)                          \
  VALUE(drive_pulsation, 0, 1e6, "rad/s", drive_pulsation, "angular frequency of a sine drive", none)              \
  VALUE(x1, -1e3, 1e3, "m", initial_displacement, "initial displacement of the main mass", none)                   \
  VALUE(v1, -1e3, 1e3, "m/s", initial_velocity, "initial velocity of the main mass", none)                         \
  VALUE(x2, -1e3, 1e3, "m", initial_displacement, "initial displacement of the ball, in the same frame", none)     \
  VALUE(v2, -1e3, 1e3, "m/s", initial_velocity, "initial velocity of the ball", none)
#define IMPACT_MACHINE_BOUNDS(VALUE)                                                                                   \
  VALUE(displacement, 1e-9, 1e6, "m", displacement_bound,                                                              \
        "largest displacement of the main mass; beyond it the kernel raises a fault", none)                            \
  VALUE(speed, 1e-9, 1e6, "m/s", speed_bound, "largest speed of either mass", none)                                    \
  VALUE(penetration, 0, 1e6, "m", penetration_bound,                                                                   \
        "largest penetration; 0: the deepest that the other bounds allow", none)                                       \
  VALUE(force, 0, 1e9, "N", force_bound, "largest sample of the drive; beyond it the sample is clamped, with a fault", \
        none)

// Required by a law with a damping per impact alone.
#define IMPACT_LAW_VALUES(VALUE)                                                                                      \
  VALUE(restitution, 0.01, 1, "of the impact's speed", restitution, "restitution, for a damping that is set from it", \
        none)

// Values of parts, in Scene or in Bounds: one that is stated needs its part in the absorber's type.
#define IMPACT_PARTS(VALUE, BOUND, DO)                                                                                \
  VALUE(DO, gravity, -1e6, 1e6, "m/s^2", gravity, "weight of both masses, along x", Gravity)                          \
  BOUND(DO, base_acceleration, 0, 1e6, "m/s^2", base_acceleration_bound,                                              \
        "largest sample of the base's acceleration; beyond it the sample is clamped, with a fault", BaseAcceleration) \
  VALUE(DO, ball_friction, 0, 1e9, "N", ball_friction, "dry friction between ball and main mass, sticking included",  \
        DryFriction)
#define IMPACT_KEEP(DO, ...) DO(__VA_ARGS__)
#define IMPACT_DROP(...)
#define IMPACT_OF_SCENE(DO, ...) DO(scene, __VA_ARGS__)
#define IMPACT_OF_BOUNDS(DO, ...) DO(bounds, __VA_ARGS__)
#define IMPACT_PART_VALUES(VALUE) IMPACT_PARTS(IMPACT_KEEP, IMPACT_DROP, VALUE)
#define IMPACT_PART_BOUNDS(BOUND) IMPACT_PARTS(IMPACT_DROP, IMPACT_KEEP, BOUND)
// DO(scene or bounds, member, ...) for each of them.
#define IMPACT_EACH_PART(DO) IMPACT_PARTS(IMPACT_OF_SCENE, IMPACT_OF_BOUNDS, DO)

#define IMPACT_SCENE_VALUES(VALUE) IMPACT_MACHINE_VALUES(VALUE) IMPACT_LAW_VALUES(VALUE) IMPACT_PART_VALUES(VALUE)
#define IMPACT_BOUND_VALUES(VALUE) IMPACT_MACHINE_BOUNDS(VALUE) IMPACT_PART_BOUNDS(VALUE)
