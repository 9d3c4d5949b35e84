/* SPDX-License-Identifier: MIT */
/* The absorber of one scene for C. impact_c_library() in c/impact_c.cmake makes the library of a rig header. So does
   any build that compiles c/impact_c.cpp with the header's name in IMPACT_C_RIG. The header has `#include
   <impact/absorber.hpp>`, a Rig and `using Absorber = impact::Absorber<Rig, ...>;`, as impact-sim --rig writes it.

       impact_absorber absorber;
       impact_init(&absorber);
       void timer_interrupt(void) { impact_step(&absorber); write_dac(impact_displacement(&absorber)); }

   Define what the rig has; impact_c.cpp checks it: IMPACT_C_FLOAT for Float32 and Float32Plain, IMPACT_C_SAMPLED for a
   Sampled drive, IMPACT_C_BASE for the part BaseAcceleration, IMPACT_C_CONTACT_FORCE and IMPACT_C_SNAPSHOTS for the
   features ContactForce and Snapshots.

   One context steps, an interrupt or a task. Only it calls these functions, with two exceptions: any context may call
   impact_get_fault and impact_get_snapshot. The library needs no C++ runtime, and from C's library memcpy and memset.
   Rust's bindgen reads the same header. */
#ifndef IMPACT_C_H
#define IMPACT_C_H

#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The opaque state of an absorber has at most this many bytes, a multiple of 8. The number depends on the rig. */
#ifndef IMPACT_C_BYTES
#define IMPACT_C_BYTES 256
#endif
typedef struct {
  uint64_t opaque[IMPACT_C_BYTES / 8];
} impact_absorber;

/* A native number: SI in floating point; in Fixed32 2^31 means one unit, see impact_displacement_unit and so on. */
#ifdef IMPACT_C_FLOAT
typedef float impact_number;
#define IMPACT_C_NUMBER float
#else
typedef int32_t impact_number;
#define IMPACT_C_NUMBER fixed32
#endif

/* The options are in the functions' names for the linker, such as impact_step_fixed32_sampled_256: a caller that is
   compiled with other options than the library does not link. */
#ifdef IMPACT_C_SAMPLED
#define IMPACT_C_OF_DRIVE _sampled
#else
#define IMPACT_C_OF_DRIVE
#endif
#ifdef IMPACT_C_BASE
#define IMPACT_C_OF_BASE _base
#else
#define IMPACT_C_OF_BASE
#endif
#define IMPACT_C_JOIN(name, number, drive, base, bytes) name##_##number##drive##base##_##bytes
#define IMPACT_C_JOIN_VALUES(name, number, drive, base, bytes) IMPACT_C_JOIN(name, number, drive, base, bytes)
#define IMPACT_C_NAME(name) \
  IMPACT_C_JOIN_VALUES(name, IMPACT_C_NUMBER, IMPACT_C_OF_DRIVE, IMPACT_C_OF_BASE, IMPACT_C_BYTES)
#define impact_init IMPACT_C_NAME(impact_init)
#define impact_reset IMPACT_C_NAME(impact_reset)
#define impact_step IMPACT_C_NAME(impact_step)
#define impact_displacement IMPACT_C_NAME(impact_displacement)
#define impact_velocity IMPACT_C_NAME(impact_velocity)
#define impact_ball_displacement IMPACT_C_NAME(impact_ball_displacement)
#define impact_ball_velocity IMPACT_C_NAME(impact_ball_velocity)
#define impact_contact_force IMPACT_C_NAME(impact_contact_force)
#define impact_get_snapshot IMPACT_C_NAME(impact_get_snapshot)
#define impact_correct IMPACT_C_NAME(impact_correct)
#define impact_is_touching IMPACT_C_NAME(impact_is_touching)
#define impact_get_fault IMPACT_C_NAME(impact_get_fault)
#define impact_clear_fault IMPACT_C_NAME(impact_clear_fault)

typedef enum {
  impact_fault_none,
  impact_fault_displacement,
  impact_fault_speed,
  impact_fault_penetration,
  impact_fault_sample,
  impact_fault_plan
} impact_fault;

void impact_init(impact_absorber*);  /* call it first: before, an absorber of zeros stands still with the fault plan */
void impact_reset(impact_absorber*); /* returns to the initial state and clears the fault */

/* Advances by one step. A sample is the value at the step's end, in the units below. */
#if defined(IMPACT_C_SAMPLED) && defined(IMPACT_C_BASE)
void impact_step(impact_absorber*, impact_number force, impact_number acceleration);
#elif defined(IMPACT_C_SAMPLED)
void impact_step(impact_absorber*, impact_number force);
#elif defined(IMPACT_C_BASE)
void impact_step(impact_absorber*, impact_number acceleration);
#else
void impact_step(impact_absorber*);
#endif
#ifdef IMPACT_C_SAMPLED
double impact_sample_unit(void); /* the unit of a force sample, N */
#endif
#ifdef IMPACT_C_BASE
double impact_base_sample_unit(void); /* the unit of an acceleration sample, m/s^2 */
#endif

/* After the last step, in the units below. */
impact_number impact_displacement(const impact_absorber*); /* of the main mass */
impact_number impact_velocity(const impact_absorber*);
impact_number impact_ball_displacement(const impact_absorber*);
impact_number impact_ball_velocity(const impact_absorber*);
bool impact_is_touching(const impact_absorber*); /* true if the step ended in contact */
double impact_displacement_unit(void);           /* m */
double impact_velocity_unit(void);               /* m/s */

#ifdef IMPACT_C_CONTACT_FORCE
/* On the main mass along x: the average over the step, or with Impulsive the law's peak. */
impact_number impact_contact_force(const impact_absorber*);
double impact_force_unit(void); /* N */
#endif

#ifdef IMPACT_C_SNAPSHOTS
/* The values of one step, from any context while another steps. contact_force is 0 without ContactForce. */
typedef struct {
  impact_number displacement, velocity, ball_displacement, ball_velocity, contact_force;
  uint32_t steps; /* since impact_init or impact_reset, modulo 2^32 */
  impact_fault fault;
  bool is_touching;
  bool is_whole; /* false if two steps began within each of four tries: the values may be of two steps */
} impact_snapshot;
impact_snapshot impact_get_snapshot(const impact_absorber*);
#endif

/* Adds to the main mass's displacement and velocity between two steps. Beyond a bound it is clamped, with a fault. */
void impact_correct(impact_absorber*, impact_number dx, impact_number dv);
impact_fault impact_get_fault(const impact_absorber*); /* the first fault, until it is cleared; from any context */
void impact_clear_fault(impact_absorber*);
bool impact_self_test(void); /* true if compiler, flags and core compute the bits of every target */

#ifdef __cplusplus
}
#endif
#endif
