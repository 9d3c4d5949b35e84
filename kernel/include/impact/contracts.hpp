// SPDX-License-Identifier: MIT
#pragma once
// The requirements for the template arguments of Absorber, in words and as conditions. Absorber reports each condition
// that fails in one message, and continues with an argument of the kernel's own, so that no second error follows.
//
// Rig       scene, bounds and step as static constexpr members: Scene, Bounds, double (s). Or AtRunTime.
//
// Law       law                        the Law of scene.hpp to which its constants belong
//           is_linear                  the elastic force is k1 delta, not k1 delta^(3/2)
//           is_damped                  c1 is read
//           is_damped_per_impact       c1 is set at each impact, c1 = a k1/v0, from
//           damping_ratio(e)             a, for the restitution that the scene states; only then
//           stored<Format>(units, d)   the energy stored at the penetration d, in the units of law/terms.hpp
//           A law of your own derives from HuntCrossleyPerImpact and has its own damping_ratio (law/per_impact.hpp).
//
// Stepper   kind                       uint32_t, another one for each stepper: a saved state belongs to one kind
//           longest_phase              rad, the largest angle of the main mass's own vibration in a step
//           flow(scene, h)             LinearFlow: how the main mass moves in a step that nothing touches
//           steps(resolution)          Range, s: the steps that it allows for such contacts
//           Contact<Format, Law>       what happens inside a stop: below
//
// Contact   see stepper/contact.hpp, which has all its members
//
// Drive     is_sine, is_sampled        at most one of them
//           Plan<Format>, State<Format>, PlanChange<Format>    constants, what changes from step to step, and the
//                                      constants of a change of plan
//           make_plan, make_plan_change    <Format>(scene, bounds, h, flow, exponents)
//           force_unit<Format>(scene, bounds)    N: the unit of State::force
//           State::start(plan)         before the first step
//           State::force(plan)         the force that a ledger counts, in force_unit
//           State::change_plan(plan, change, next, next_change)    DriveShares, for a change of plan
//           and if sine: State::advance(plan), rate(plan), oscillator; if sampled: accepts, clamped, at_once,
//                                      advance(plan, next), rate, sample, as motion/sampled.hpp has them
//           State::before()            what change() needs of a step's start
//           State::change(plan, before)    the step's DriveChange, for a contact that sees_change
//           largest(scene, bounds)     N: the largest force
//           at_start(scene, flow), largest_at_once(scene, bounds, flow)    m: what it adds to dx1 at the start, and
//                                      what a sample may add to x1 as it comes
//
// Format    Value, Long                a number of a step, of 32 bits for 32-bit cores; a state, of twice the digits
//           Gain, Weight               a constant that multiplies a Value; the same, in fewer instructions
//           ClampedGain                a Gain whose product may be out of range and is clamped
//           Root, Oscillator           a square root; the sine drive's recurrence
//           Energy, Tally              a product of Values with all its bits; a sum of them without an upper limit
//           Units                      the powers of two that are the units of Values
//           kind                       uint32_t, another one for each way to compute the same
//           The functions              are those of numeric/fixed32.hpp's Fixed32, which has them all
//
// Feature   kind                       uint32_t, not 0, another one for each
//           is_bound                   what it records depends on the plan's forces
//           reads_touch                it reads a contact's rate_at_touch, which is else not computed
//           State<Format>              a base of the absorber's state, that record_in<Feature, Plan>(state) is
//           start(plan, state), after_contact(plan, state, step), after_step(plan, state),
//           after_correction(plan, state), is_sound(plan, state)    see features.hpp; SilentFeature, a base, has them
//
// Part      of the scene, named among the features and derived from ScenePart: Gravity, BaseAcceleration, DryFriction.
//           It has a kind and a State<Format> as a feature has. Below, `rate` is a Value that counts as a penetration
//           per step, `increment` one that counts as what a step adds to dx1; `next` is a Value, the sample at the
//           step's end as the field counts it, or nothing; flows are a LinearFlow of the main mass and of the ball.
//
// Field     is_field, is_sampled       a part whose acceleration, m/s^2 along x, acts on both masses
//           FieldPlan<Format>          a base of the plan: its constants are plan.field
//           make_plan<Format>(scene, bounds, main, ball, exponents, units)    the two flows before the exponents
//           largest(scene, bounds)     m/s^2, of either sign
//           at_once<Units>(scene, bounds, main, ball, exponents)    s^2: what a sample adds to what stands for x1
//           position(plan, state, x)   Long: a position, from what the state keeps instead of it
//           main_rate(plan, state)     rate: the field's share in the displacement of the coming step; ball_rate too,
//           rate_apart                 and how much that is more
//           main_increment(plan, state, next)    increment: what the step adds to dx1
//           fly(plan, state, next)     moves x2 and dx2 by the step's flight; then, until the next,
//           ball_travel(plan, state)   Long: by how much x2,
//           ball_increment             increment: by how much dx2
//           old_share, new_share       increments, for a change of plan: motion/plan_change.hpp
//           ball_start                 the same of the ball, if not sampled
//           and if sampled
//           accepts(plan, sample)      bool; clamped(plan, sample) is a sample in place of a bad one
//           at_end(plan, sample)       `next`
//           acts_at_once(plan)         bool: whether it adds at_once(plan, next), an increment, to x1 in the step that
//                                      the sample ends
//           begin(plan, state)         before the first step
//           State::by_field            `next` of the last sample
//
// Friction  DryFriction is the only one: motion/friction.hpp

#include <impact/law/hunt_crossley.hpp>
#include <impact/law/resolution.hpp>
#include <impact/law/terms.hpp>
#include <impact/motion/linear_flow.hpp>
#include <impact/motion/no_drive.hpp>
#include <impact/numeric/fixed32.hpp>
#include <impact/plan/source.hpp>
#include <impact/scene.hpp>
#include <impact/stepper/moment.hpp>
#include <impact/types.hpp>

namespace impact::contract {

template <class...> using Void = void;
template <class One, class Other> inline constexpr bool is_same = detail::is_one_of<One, Other>;
template <class Type> const Type& value_of();

template <class Type, class = void> inline constexpr bool has_scene = false;
template <class Type>
inline constexpr bool has_scene<Type, Void<decltype(&Type::scene)>> = is_same<const Scene*, decltype(&Type::scene)>;
template <class Type, class = void> inline constexpr bool has_bounds = false;
template <class Type>
inline constexpr bool has_bounds<Type, Void<decltype(&Type::bounds)>> = is_same<const Bounds*, decltype(&Type::bounds)>;
template <class Type, class = void> inline constexpr bool has_step = false;
template <class Type>
inline constexpr bool has_step<Type, Void<decltype(&Type::step)>> = is_same<const double*, decltype(&Type::step)>;

struct PaperRig {
  static constexpr Scene scene{};
  static constexpr Bounds bounds{};
  static constexpr double step = 1e-4;
};

template <class Type>
inline constexpr bool is_rig = is_same<Type, AtRunTime> || (has_scene<Type> && has_bounds<Type> && has_step<Type>);
template <class Type> using KeptRig = typename detail::Either<is_rig<Type>, Type, PaperRig>::Type;

template <class Type, class = void> inline constexpr bool is_law = false;
template <class Type>
inline constexpr bool is_law<
    Type, Void<decltype(Type::law), decltype(Type::is_linear), decltype(Type::is_damped),
               decltype(Type::is_damped_per_impact),
               decltype(Type::template stored<Fixed32>(value_of<Fixed32::Units>(), value_of<Fixed32::Value>()))>> =
    is_same<const Law, decltype(Type::law)>;
template <class Type> using KeptLaw = typename detail::Either<is_law<Type>, Type, HuntCrossley>::Type;

template <class Type, class = void> inline constexpr bool is_stepper = false;
template <class Type>
inline constexpr bool is_stepper<
    Type, Void<decltype(Type::kind), decltype(Type::longest_phase), decltype(Type::flow(value_of<Scene>(), 1.0)),
               decltype(Type::steps(value_of<Resolution>())), typename Type::template Contact<Fixed32, HuntCrossley>>> =
    is_same<LinearFlow, decltype(Type::flow(value_of<Scene>(), 1.0))>;

template <class Stepper, class Format, class ContactLaw, class = void> inline constexpr bool has_contact = false;
template <class Stepper, class Format, class ContactLaw>
inline constexpr bool
    has_contact<Stepper, Format, ContactLaw,
                Void<decltype(value_of<typename Stepper::template Contact<Format, ContactLaw>::Plan>().response),
                     decltype(Stepper::template Contact<Format, ContactLaw>::phase),
                     decltype(Stepper::template Contact<Format, ContactLaw>::traits.reads_rate),
                     decltype(Stepper::template Contact<Format, ContactLaw>::make_plan(
                         value_of<ContactTerms>(), value_of<LinearFlow>(), value_of<UnitExponents>()))>> = true;

template <class Type, class = void> inline constexpr bool is_drive = false;
template <class Type>
inline constexpr bool
    is_drive<Type, Void<decltype(Type::is_sine), decltype(Type::is_sampled), typename Type::template Plan<Fixed32>,
                        typename Type::template State<Fixed32>, typename Type::template PlanChange<Fixed32>>> =
        !(Type::is_sine && Type::is_sampled);
template <class Type> using KeptDrive = typename detail::Either<is_drive<Type>, Type, NoDrive>::Type;

template <class Type, class = void> inline constexpr bool is_format = false;
template <class Type>
inline constexpr bool is_format<
    Type,
    Void<typename Type::Value, typename Type::Long, typename Type::Gain, typename Type::ClampedGain,
         typename Type::Weight, typename Type::Root, typename Type::Energy, typename Type::Tally,
         typename Type::Oscillator, typename Type::Units, decltype(Type::kind), decltype(Type::gain(1.0, 0, 0))>> =
    true;
template <class Type> using KeptFormat = typename detail::Either<is_format<Type>, Type, Fixed32>::Type;

template <class Type, class = void> inline constexpr bool is_feature = false;
template <class Type>
inline constexpr bool
    is_feature<Type, Void<decltype(Type::kind), decltype(Type::is_bound), typename Type::template State<Fixed32>>> =
        true;

// Records nothing: one for each type, since two bases must not be the same.
template <class Type> struct InPlaceOf : SilentFeature {
  static constexpr uint32_t kind = 0;
  static constexpr bool is_bound = false;
  template <class Format> struct State {};
};
template <class Type> using KeptFeature = typename detail::Either<is_feature<Type>, Type, InPlaceOf<Type>>::Type;

// True if no two features are of one kind.
template <class... Features> inline constexpr bool kinds_differ = true;
template <class First, class... Others>
inline constexpr bool kinds_differ<First, Others...> =
    ((First::kind != Others::kind) && ...) && kinds_differ<Others...>;

template <class Type, class = void> inline constexpr bool is_field = false;
template <class Type> inline constexpr bool is_field<Type, Void<decltype(Type::is_field)>> = Type::is_field;

template <class Stepper, class Format, class ContactLaw>
inline constexpr bool is_stepper_for = is_stepper<Stepper>&& has_contact<Stepper, Format, ContactLaw>;
template <class Stepper, class Format, class ContactLaw>
using KeptStepper = typename detail::Either<is_stepper_for<Stepper, Format, ContactLaw>, Stepper, Moment>::Type;

}  // namespace impact::contract
