// SPDX-License-Identifier: MIT
// The functions of impact_c.h, for the Absorber that the header IMPACT_C_RIG defines.

#include "impact_c.h"

#include <impact/self_test.hpp>

#ifndef IMPACT_C_RIG
#error "state the header of your rig: -DIMPACT_C_RIG='\"rig.hpp\"'"
#endif
#include IMPACT_C_RIG

namespace {

// An impact_absorber's content.
struct Made {
  uint64_t is_made;  // 0 before impact_init()
  Absorber absorber;
};
static_assert(sizeof(Made) <= sizeof(impact_absorber), "define IMPACT_C_BYTES, a multiple of 8, large enough");
static_assert(alignof(Absorber) <= alignof(impact_absorber));
#ifdef IMPACT_C_FLOAT
static_assert(sizeof(Absorber::Value) == sizeof(float) && !impact::detail::is_one_of<Absorber::Format, impact::Fixed32>,
              "IMPACT_C_FLOAT, but the rig's format is not Float32 or Float32Plain");
constexpr Absorber::Value in(impact_number x) { return x; }
constexpr impact_number out(Absorber::Value x) { return x; }
#else
static_assert(impact::detail::is_one_of<Absorber::Format, impact::Fixed32>,
              "the rig's format is not Fixed32: Float32 and Float32Plain need IMPACT_C_FLOAT, Float64 is for hosts");
constexpr Absorber::Value in(impact_number x) { return {x}; }
constexpr impact_number out(Absorber::Value x) { return x.raw; }
#endif

constexpr Made at_start{1, {}};

Absorber& as_cpp(impact_absorber* absorber) { return reinterpret_cast<Made*>(absorber)->absorber; }
const Made& made(const impact_absorber* absorber) { return *reinterpret_cast<const Made*>(absorber); }
const Absorber& as_cpp(const impact_absorber* absorber) { return made(absorber).absorber; }

}  // namespace

extern "C" {

void impact_init(impact_absorber* absorber) { __builtin_memcpy(absorber, &at_start, sizeof at_start); }
#ifdef IMPACT_C_SNAPSHOTS
void impact_reset(impact_absorber* absorber) { as_cpp(absorber).reset(); }  // published as a step is
#else
void impact_reset(impact_absorber* absorber) { impact_init(absorber); }
#endif

#ifdef IMPACT_C_SAMPLED
static_assert(Absorber::Drive::is_sampled, "IMPACT_C_SAMPLED, but the rig's drive is not Sampled");
double impact_sample_unit() { return Absorber::sample_unit(); }
#else
static_assert(!Absorber::Drive::is_sampled, "the rig's drive is Sampled: it needs IMPACT_C_SAMPLED");
#endif
#ifdef IMPACT_C_BASE
static_assert(Absorber::Field::is_sampled, "IMPACT_C_BASE, but the rig has no BaseAcceleration");
double impact_base_sample_unit() { return Absorber::base_sample_unit(); }
#else
static_assert(!Absorber::Field::is_sampled, "the rig has a BaseAcceleration: it needs IMPACT_C_BASE");
#endif
// Before impact_init() an absorber stands still at 0.
#if defined(IMPACT_C_SAMPLED) && defined(IMPACT_C_BASE)
void impact_step(impact_absorber* absorber, impact_number force, impact_number acceleration) {
  if (made(absorber).is_made) as_cpp(absorber).step(in(force), in(acceleration));
}
#elif defined(IMPACT_C_SAMPLED) || defined(IMPACT_C_BASE)
void impact_step(impact_absorber* absorber, impact_number sample) {
  if (made(absorber).is_made) as_cpp(absorber).step(in(sample));
}
#else
void impact_step(impact_absorber* absorber) {
  if (made(absorber).is_made) as_cpp(absorber).step();
}
#endif

impact_number impact_displacement(const impact_absorber* absorber) { return out(as_cpp(absorber).displacement()); }
impact_number impact_velocity(const impact_absorber* absorber) { return out(as_cpp(absorber).velocity()); }
impact_number impact_ball_displacement(const impact_absorber* absorber) {
  return out(as_cpp(absorber).ball_displacement());
}
impact_number impact_ball_velocity(const impact_absorber* absorber) { return out(as_cpp(absorber).ball_velocity()); }
bool impact_is_touching(const impact_absorber* absorber) { return as_cpp(absorber).is_touching(); }
double impact_displacement_unit() { return Absorber::displacement_unit(); }
double impact_velocity_unit() { return Absorber::velocity_unit(); }

#ifdef IMPACT_C_CONTACT_FORCE
impact_number impact_contact_force(const impact_absorber* absorber) { return out(as_cpp(absorber).contact_force()); }
double impact_force_unit() { return Absorber::force_unit(); }
#endif

#ifdef IMPACT_C_SNAPSHOTS
impact_snapshot impact_get_snapshot(const impact_absorber* absorber) {
  if (!made(absorber).is_made) return {{}, {}, {}, {}, {}, 0, impact_fault_plan, false, true};
  const auto now = as_cpp(absorber).snapshot();
  return {out(now.displacement),
          out(now.velocity),
          out(now.ball_displacement),
          out(now.ball_velocity),
          out(now.contact_force),
          now.steps,
          static_cast<impact_fault>(now.fault),
          now.is_touching,
          now.is_whole};
}
#endif

void impact_correct(impact_absorber* absorber, impact_number dx, impact_number dv) {
  if (made(absorber).is_made) as_cpp(absorber).correct(in(dx), in(dv));
}
impact_fault impact_get_fault(const impact_absorber* absorber) {
  return made(absorber).is_made ? static_cast<impact_fault>(as_cpp(absorber).fault()) : impact_fault_plan;
}
void impact_clear_fault(impact_absorber* absorber) { as_cpp(absorber).clear_fault(); }
bool impact_self_test() { return impact::self_test<Absorber::Format>(); }
}
