/* SPDX-License-Identifier: MIT */
/* One absorber's scene for C: a library that impact_c_library() in c/impact_c.cmake makes of a rig header, or any build
   that compiles c/impact_c.cpp with IMPACT_C_RIG naming it. The header is `#include <impact/absorber.hpp>`, a Rig and
   `using Absorber = impact::Absorber<Rig, ...>;`, as impact-sim --rig writes it.

       impact_absorber absorber;
       impact_init(&absorber);
       void timer_interrupt(void) { impact_step(&absorber); write_dac(impact_displacement(&absorber)); }

   Of the rig this header must be told, and impact_c.cpp checks: IMPACT_C_FLOAT for Float32 and Float32Plain,
   IMPACT_C_SAMPLED for a Sampled drive, IMPACT_C_BASE for the part BaseAcceleration, IMPACT_C_CONTACT_FORCE for the
   feature ContactForce.

   No runtime of C++; of C's library memcpy and memset. Rust's bindgen and Python's ctypes read the same names. */
#ifndef IMPACT_C_H
#define IMPACT_C_H

#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Opaque, and at most this large; its content differs from rig to rig. Aligned as uint64_t. */
#ifndef IMPACT_C_BYTES
#define IMPACT_C_BYTES 256
#endif
typedef struct {
  uint64_t opaque[IMPACT_C_BYTES / 8];
} impact_absorber;

/* A native number: raw 2^31 is the unit in Fixed32; SI in floating point. */
#ifdef IMPACT_C_FLOAT
typedef float impact_number;
#else
typedef int32_t impact_number;
#endif

typedef enum {
  impact_fault_none,
  impact_fault_displacement,
  impact_fault_speed,
  impact_fault_penetration,
  impact_fault_sample,
  impact_fault_plan
} impact_fault;

void impact_init(impact_absorber*);  /* before anything else */
void impact_reset(impact_absorber*); /* back to the initial state, without fault */

/* Samples are those at the step's end, in the units below. */
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
double impact_sample_unit(void); /* N of a native 1.0 */
#endif
#ifdef IMPACT_C_BASE
double impact_base_sample_unit(void); /* m/s^2 */
#endif

impact_number impact_displacement(const impact_absorber*); /* of the main mass */
impact_number impact_velocity(const impact_absorber*);
impact_number impact_ball_displacement(const impact_absorber*);
impact_number impact_ball_velocity(const impact_absorber*);
bool impact_is_touching(const impact_absorber*);
double impact_displacement_unit(void); /* m of a native 1.0 */
double impact_velocity_unit(void);     /* m/s */

#ifdef IMPACT_C_CONTACT_FORCE
impact_number impact_contact_force(const impact_absorber*); /* on the main mass, mean of the last step */
double impact_force_unit(void);                             /* N */
#endif

void impact_correct(impact_absorber*, impact_number dx, impact_number dv); /* of the main mass */
impact_fault impact_get_fault(const impact_absorber*);                     /* may be polled from any context */
void impact_clear_fault(impact_absorber*);
bool impact_self_test(void); /* this compiler, its flags and this core compute what was proved */

#ifdef __cplusplus
}
#endif
#endif
