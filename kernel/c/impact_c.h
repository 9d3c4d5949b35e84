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

   No runtime of C++; of C's library memcpy and memset. Rust's bindgen reads the same header. */
#ifndef IMPACT_C_H
#define IMPACT_C_H

#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Opaque, and at most this large; its content differs from rig to rig. Aligned as uint64_t. A plain number. */
#ifndef IMPACT_C_BYTES
#define IMPACT_C_BYTES 256
#endif
typedef struct {
  uint64_t opaque[IMPACT_C_BYTES / 8];
} impact_absorber;

/* A native number: raw 2^31 is the unit in Fixed32; SI in floating point. */
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

void impact_init(impact_absorber*);  /* before anything else: until then an absorber of zeros has the fault plan */
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
impact_number impact_contact_force(const impact_absorber*); /* on the main mass: absorber.hpp */
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
