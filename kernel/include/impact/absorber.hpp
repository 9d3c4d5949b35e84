// SPDX-License-Identifier: MIT
#pragma once
// The kernel: an impact absorber that is stepped in real time. The one header that most users include.
//
//     struct Rig {
//       static constexpr impact::Scene scene{};    // SI units
//       static constexpr impact::Bounds bounds{};  // the largest values that the scene reaches
//       static constexpr double step = 1e-4;       // s
//     };
//     using Absorber = impact::Absorber<Rig, impact::HuntCrossley, impact::Moment, impact::Sine, impact::Fixed32>;
//     Absorber absorber;
//     void timer_interrupt() { absorber.step(); write_dac(absorber.displacement()); }
//
// A scene is a type. What its template arguments do not name is not compiled: no power table for Hooke-Newton, no
// oscillator for a sampled drive, no ledger and no log unless asked for.
//
//     contact law   HookeNewton, Hertz, HuntCrossley; with a damping set at each impact HuntCrossleyPerImpact,
//                   HerbertMcWhannell, LeeWang, LankaraniNikravesh, Flores, HuGuo, Exact
//     stepper       Moment, SubsteppedMoment<n>, EnergyConsistent, Impulsive, AverageAcceleration, LinearAcceleration,
//                   FoxGoodwin, CentralDifference, or as the scene and the step ask: Chosen, see choice.hpp
//     drive         NoDrive, Sine, Sampled
//     format        Fixed32, Float32, Float32Plain, Float64 (host)
//     parts         Gravity, BaseAcceleration (motion/field.hpp), DryFriction (motion/friction.hpp)
//     features      EnergyLedger, ImpactLog, ContactForce, Snapshots
//
// A step is: both masses fly freely to its end (motion/linear_flow.hpp); where the ball then stands inside a stop, the
// contact finds the force's impulse and moment, and both masses answer to them.

#include <stdint.h>

#include <impact/contracts.hpp>
#include <impact/converter.hpp>
#include <impact/fault.hpp>
#include <impact/features.hpp>
#include <impact/law/hertz.hpp>
#include <impact/law/hooke_newton.hpp>
#include <impact/law/hunt_crossley.hpp>
#include <impact/law/per_impact.hpp>
#include <impact/motion/field.hpp>
#include <impact/motion/friction.hpp>
#include <impact/motion/none.hpp>
#include <impact/motion/sampled.hpp>
#include <impact/motion/sine.hpp>
#include <impact/numeric/fixed32.hpp>
#include <impact/numeric/real.hpp>
#include <impact/plan.hpp>
#include <impact/plan_source.hpp>
#include <impact/scene.hpp>
#include <impact/snapshot.hpp>
#include <impact/stepper/energy.hpp>
#include <impact/stepper/impulsive.hpp>
#include <impact/stepper/moment.hpp>
#include <impact/stepper/moment/substepped.hpp>
#include <impact/stepper/newmark.hpp>

namespace impact {

namespace detail {
// The parts of the scene among the features. Of two fields the sampled one, which has weight too.
template <class... Features>
struct FieldAmong {
  using Type = NoField;
};
template <class First, class... Others>
struct FieldAmong<First, Others...> {
  using Other = typename FieldAmong<Others...>::Type;
  using Type = typename Either<contract::is_field<First> && !Other::is_sampled, First, Other>::Type;
};
template <class... Features>
using FieldOf = typename FieldAmong<Features...>::Type;
template <class... Features>
using FrictionOf = typename Either<is_one_of<DryFriction, Features...>, DryFriction, NoFriction>::Type;

// Each argument as the contracts let it through.
template <class Rig, class ContactLaw, class Stepper, class Drive, class Format, class... Features>
using CheckedSource =
    PlanSource<contract::KeptRig<Rig>,
               Plan<contract::KeptFormat<Format>, contract::KeptLaw<ContactLaw>,
                    contract::KeptStepper<Stepper, contract::KeptFormat<Format>, contract::KeptLaw<ContactLaw>>,
                    contract::KeptDrive<Drive>, FieldOf<Features...>, FrictionOf<Features...>>>;
}  // namespace detail

template <class Rig, class Law_, class Stepper_, class Drive_, class Format_, class... Features>
class Absorber
    : private detail::CheckedSource<Rig, Law_, Stepper_, Drive_, Format_, Features...>,
      private SnapshotWindow<typename contract::KeptFormat<Format_>::Value, detail::is_one_of<Snapshots, Features...>> {
  using Source = detail::CheckedSource<Rig, Law_, Stepper_, Drive_, Format_, Features...>;

  // impact/contracts.hpp; one message for one mistake.
  static constexpr bool is_at_run_time = detail::is_one_of<Rig, AtRunTime>, has_scene = contract::has_scene<Rig>,
                        has_bounds = contract::has_bounds<Rig>, has_law = contract::is_law<Law_>,
                        has_stepper = contract::is_stepper<Stepper_>;
  static_assert(is_at_run_time || has_scene,
                "the rig has no scene: static constexpr impact::Scene scene = ...; or name AtRunTime");
  static_assert(is_at_run_time || !has_scene || has_bounds,
                "the rig has no bounds: static constexpr impact::Bounds bounds = ...;");
  static_assert(is_at_run_time || !has_scene || !has_bounds || contract::has_step<Rig>,
                "the rig has no step: static constexpr double step = 1e-4;  // s");
  static_assert(has_law, "the second argument must be a law, such as HuntCrossley: see impact/contracts.hpp");
  static_assert(!has_law || has_stepper, "the third argument must be a stepper, such as Moment: see contracts.hpp");
  static_assert(!has_law || !has_stepper ||
                    contract::has_treatment<Stepper_, contract::KeptFormat<Format_>, contract::KeptLaw<Law_>>,
                "the stepper's Contact<Format, Law> is no contact treatment: see impact/contracts.hpp");
  static_assert(!has_stepper || contract::is_drive<Drive_>,
                "the fourth argument must be a drive, such as NoDrive, Sine or Sampled: see impact/contracts.hpp");
  static_assert(!contract::is_drive<Drive_> || contract::is_format<Format_>,
                "the fifth argument must be a format, such as Fixed32 or Float32, and not a number's own type: see "
                "impact/contracts.hpp");
  static_assert((contract::is_feature<Features> && ...),
                "from the sixth on the arguments must be features, such as EnergyLedger: see impact/contracts.hpp");

 public:
  using PlanType = typename Source::PlanType;
  using ContactLaw = typename PlanType::LawType;
  using Stepper = typename PlanType::StepperType;
  using Drive = typename PlanType::DriveType;
  using Field = typename PlanType::FieldType;
  using Friction = typename PlanType::FrictionType;
  using Format = typename PlanType::FormatType;
  using Value = typename Format::Value;
  using Long = typename Format::Long;
  using Contact = typename Stepper::template Contact<Format, ContactLaw>;
  using Source::plan;

  // The SI value of a native 1.0, which is a raw 2^31 in Fixed32; 1 in floating point. Of displacements in m, of
  // velocities in m/s, of contact forces and, of a Sampled drive, of samples in N. Constants of the type, but where the
  // plan is AtRunTime.
  using Source::displacement_unit;
  using Source::force_unit;
  using Source::sample_unit;
  using Source::velocity_unit;
  // A force for step(): newtons as a constant in double, or while running as a float, which asks for an FPU or some
  // hundred instructions.
  using Source::sample_of;
  // The same of an acceleration of the base, m/s^2.
  using Source::base_sample_of;
  using Source::base_sample_unit;

  // Beside an EnergyLedger, or a feature derived from it.
  static constexpr bool counts_slid_way = Friction::is_friction && (__is_base_of(EnergyLedger, Features) || ...);

  // All that changes from step to step. Plain: it can be copied, kept and given back.
  struct State : Features::template State<Format>..., SlidWay<Format, counts_slid_way> {
    // Displacement, as place() reads it, and displacement per step, the one that the coming step will make
    // (motion/linear_flow.hpp): main mass, ball.
    Long x1, dx1, x2, dx2;
    typename Drive::template State<Format> drive;
    Contact contact;
    uint16_t at_left;  // the stop of the contact under way or last
    Fault fault;
  };

  constexpr Absorber() {
    start();
    if constexpr (publishes) see(Window::first(), begins_inside());
  }
  explicit constexpr Absorber(const PlanType& next) : Source(next) {
    start();
    if constexpr (publishes) see(Window::first(), begins_inside());
  }

  // Back to the scene's initial state, without fault.
  constexpr void reset() {
    start();
    publish();
  }

  // Advances by one step.
  template <class... Nothing>
  constexpr void step() {
    static_assert(!Drive::is_sampled || sizeof...(Nothing) > 0,
                  "step() without a sample, but the drive is Sampled: pass the force at the step's end, as "
                  "step(absorber.sample_of(newtons)) or from a converter, see converter.hpp");
    static_assert(!Field::is_sampled || sizeof...(Nothing) > 0,
                  "step() without a sample, but the base accelerates: pass its acceleration at the step's end, as "
                  "step(absorber.base_sample_of(acceleration)), behind the force where the drive is Sampled");
    advance(Value{}, Value{});
    publish();
  }
  // Advances a sampled drive, or a base that accelerates, by one step, with the sample at the step's end: newtons or
  // m/s^2 in a floating-point format, a fraction of Bounds::force or Bounds::base_acceleration in Q1.31 in Fixed32; the
  // sample before the first is 0.
  template <class Sample = Value>
  constexpr void step(Sample sample) {
    constexpr bool is_value = detail::is_one_of<Value, Sample>;
    static_assert(Drive::is_sampled || Field::is_sampled,
                  "step(sample), but the drive takes none: name Sampled as the drive, or step()");
    static_assert(!(Drive::is_sampled && Field::is_sampled),
                  "step(sample), but both the drive and the base take one: step(force, acceleration)");
    static_assert(is_value || !(Drive::is_sampled || Field::is_sampled),
                  "a sample of another type than the format's: pass step(absorber.sample_of(newtons)), of a base "
                  "step(absorber.base_sample_of(acceleration)), step({raw}) in Fixed32, a float in Float32 and "
                  "Float32Plain, or a converter's counts, see converter.hpp");
    if constexpr (is_value && Drive::is_sampled) {
      advance(sample, Value{});
      publish();
    } else if constexpr (is_value && Field::is_sampled) {
      advance(Value{}, sample);
      publish();
    }
  }
  // Both.
  constexpr void step(Value force, Value acceleration) {
    static_assert(Drive::is_sampled && Field::is_sampled,
                  "step(force, acceleration): the drive must be Sampled, and BaseAcceleration among the parts");
    advance(force, acceleration);
    publish();
  }

  // Now, in native numbers: valid in the context that steps. For any other, snapshot(). Of the main mass, and the ball.
  constexpr Value displacement() const { return plan.units.position(place(state_.x1)); }
  constexpr Value velocity() const {
    Value rate = plan.units.as_displacement(rate_ahead());
    if constexpr (Contact::keeps_force) rate = rate - carried(plan.contact.dx1_share);
    if constexpr (Friction::is_friction)
      rate = rate - plan.units.as_displacement(plan.friction.main_rate_ahead * state_.impulse);
    return plan.units.velocity(plan.units.displacement(state_.dx1) + rate);
  }
  constexpr Value ball_displacement() const { return plan.units.position(place(state_.x2)); }
  constexpr Value ball_velocity() const {
    Value rate = plan.units.displacement(state_.dx2);
    if constexpr (Contact::keeps_force) rate = rate + carried(plan.contact.dx2_share);
    if constexpr (Field::is_field) rate = rate - plan.units.as_displacement(Field::ball_rate(plan, state_));
    if constexpr (Friction::is_friction)
      rate = rate + plan.units.as_displacement(plan.friction.ball_ahead * state_.impulse);
    return plan.units.velocity(rate);
  }
  // On the main mass, along x, the mean of the last step; the ball feels the opposite.
  constexpr Value contact_force() const {
    constexpr bool is_named = detail::is_one_of<ContactForce, Features...>;
    static_assert(is_named, "contact_force() needs the feature ContactForce: append it to the absorber's type");
    if constexpr (is_named)
      return plan.units.native_force(state_.contact_force);
    else
      return {};
  }
  constexpr bool is_touching() const { return state_.contact.phase == Phase::touching; }
  constexpr const State& state() const { return state_; }

  // Safe to ask and to wait for in any context: one aligned half word, read anew at each call.
  Fault fault() const {
    if (Source::is_refused()) return Fault::plan;
    return *static_cast<const volatile Fault*>(&state_.fault);
  }
  constexpr void clear_fault() {
    state_.fault = Fault::none;
    publish();
  }

  // The last step whole, for a task that an interrupt may step under (snapshot.hpp).
  Snapshot<Value> snapshot() const {
    static_assert(publishes, "snapshot() needs the feature Snapshots: append it to the absorber's type");
    if constexpr (publishes)
      return Window::read();
    else
      return {};
  }

  // An observer's correction between two steps: what to add to the main mass's displacement and velocity, in the units
  // of displacement() and velocity(). At most half a unit of each in Fixed32, and 2^20 m and 2^20 m per step in
  // floating point: more is held there, and a state that leaves its range at its end, with a fault. A contact under way
  // goes on from the corrected penetration; a damping that was set at its impact is held to what a step bears there
  // (law/impact_damping.hpp). A ball that a correction puts into a stop that it did not touch stands at that stop, and
  // one at rest on an impulsive stop stays on it. Dry friction begins anew. A ledger counts what a correction does to
  // the stored energy as dissipated, and nothing as the drive's work.
  constexpr void correct(Value dx, Value dv) {
    if (Source::is_refused()) return;
    const auto& units = plan.units;
    Value du = units.per_step(dv);
    if (units.hold_correction(dx)) raise(Fault::displacement);
    if (units.hold_correction(du)) raise(Fault::speed);
    leave_rubbing();
    units.add_position(state_.x1, dx);
    units.add_displacement(state_.dx1, du);
    units.add(state_.dx1, -(plan.handover.behind_by_u1 * du + plan.handover.behind_by_x1 * dx));
    begin_to_rub();
    if (!hold_in_range()) {
      if (state_.contact.phase != Phase::apart) touch_anew();
      if (state_.contact.phase == Phase::apart) push_out();
    }
    (Features::after_correction(plan, state_), ...);
    publish();
  }

  // A state to keep or to send, and the way back: a host that takes it over goes on bit for bit. The bytes are the same
  // on every little-endian target and on a 64-bit host. Restoring refuses, and changes nothing, when the layout's
  // version, the scene, the bounds, the step or a type differ, or when no step can have left the state: displacements,
  // drive or kind of contact are out of range, or a contact under way does not fit together; one that a motion far
  // beyond the bounds has just left, and that the next step would hold, is refused as well. It is no signature: of
  // bytes that somebody has made up to pass, the next steps are defined and end in range or with a fault, but they are
  // no motion of this absorber.
  static constexpr uint32_t state_version = 3;
  struct Saved {
    uint32_t version, plan_identity;
    State state;
  };
  constexpr Saved save() const { return {state_version, identity(), state_}; }
  constexpr bool restore(const Saved& saved) {
    if (Source::is_refused() || saved.version != state_version || saved.plan_identity != identity()) return false;
    if (!is_sound(saved.state)) return false;
    state_ = saved.state;
    publish();
    return true;
  }

  // Goes on under another plan from here, for an absorber with its plan AtRunTime: displacements, velocities and the
  // drive's phase do not jump (motion/handover.hpp); a drive that was off starts at phase 0, and ledger and log start
  // anew. A contact under way whose own parameters change goes on from its penetration. Refuses, and changes nothing,
  // when bounds, step, clearance or stops differ; in Fixed32 when displacement_unit() does, which a softer stop or a
  // larger drive may widen under the same bounds; with BaseAcceleration when gravity does; or during a contact when its
  // state depends on the plan's forces: pointwise steppers, a damping set per impact, features.
  constexpr bool retune(const PlanType& next) {
    static_assert(!Source::is_constant,
                  "retune() of an absorber whose plan is a constant: name AtRunTime in the place of the rig");
    constexpr bool is_bound = Contact::keeps_force || ContactLaw::is_damped_per_impact || (Features::is_bound || ...);
    if (next.status != PlanStatus::ok || next.handover.units != plan.handover.units) return false;
    if (is_bound && state_.contact.phase != Phase::apart) return false;
    leave_rubbing();
    const bool is_other_contact = next.handover.contact != plan.handover.contact;
    hand_over(plan, next, state_);
    if constexpr (!Source::is_constant) plan = next;
    hold_in_range();
    (restart<Features>(), ...);
    if constexpr (counts_slid_way) state_.slid = {};
    begin_to_rub();
    if (is_other_contact && state_.contact.phase != Phase::apart) {
      touch_anew();
      load_contact();
    }
    publish();
    return true;
  }

  // J by dry friction since the start, for a host: double arithmetic.
  constexpr double friction_dissipated() const {
    if constexpr (counts_slid_way) {
      if (!rubs()) return 0;
      const double taken = state_.slid.total() - plan.units.fraction(still_to_rub());
      return plan.friction.force * plan.units.si_penetration_unit() * taken;
    } else {
      return 0;
    }
  }

  // In SI units, for a host: double arithmetic.
  struct Reading {
    double x1, v1, x2, v2;
  };
  constexpr Reading reading() const {
    if (Source::is_refused()) return {};
    double u1 = plan.units.si(state_.dx1) + plan.units.si_penetration(rate_ahead()), u2 = plan.units.si(state_.dx2);
    if constexpr (Field::is_field) u2 -= plan.units.si_penetration(Field::ball_rate(plan, state_));
    if constexpr (Friction::is_friction) {
      u1 -= plan.units.si_penetration(plan.friction.main_rate_ahead * state_.impulse);
      u2 += plan.units.si_penetration(plan.friction.ball_ahead * state_.impulse);
    }
    if constexpr (Contact::keeps_force) {
      const double side = state_.at_left ? -1 : 1;
      u1 -= side * plan.units.si_penetration(plan.contact.dx1_share * state_.contact.force);
      u2 += side * plan.units.si_penetration(plan.contact.dx2_share * state_.contact.force);
    }
    return {plan.units.si_at(place(state_.x1)), u1 / plan.step, plan.units.si_at(place(state_.x2)), u2 / plan.step};
  }

 private:
  using SeenForce = typename detail::Either<Field::is_field, ApproachInField<Value>, Approach<Value>>::Type;
  using SeenChange =
      typename detail::Either<Contact::sees_change, ApproachUnderChange<SeenForce, Value>, SeenForce>::Type;
  using SeenStep =
      typename detail::Either<Contact::is_instantaneous, ApproachAtInstant<SeenForce, Value>, SeenChange>::Type;
  using Window = SnapshotWindow<Value, detail::is_one_of<Snapshots, Features...>>;
  static constexpr bool publishes = detail::is_one_of<Snapshots, Features...>;
  static constexpr bool has_own_damping = __is_base_of(ImpactDamping<Format, true>, Contact);

  // Whether the range check after flight may wait until after contact: the response cannot wrap a state that was in
  // range before the step. (A shared one changes x1 by at most an eighth of 2^63, x2 and a step's displacement by a
  // quarter.)
  constexpr bool checks_range_once() const {
    if constexpr (decltype(PlanType::contact.response)::is_shared)
      return !Contact::is_sudden(plan.contact);
    else
      return false;
  }

  constexpr void start() {
    state_ = State{};
    if (Source::is_refused()) return;
    state_.x1 = plan.x1;
    state_.dx1 = plan.dx1;
    state_.x2 = plan.x2;
    state_.dx2 = plan.dx2;
    state_.drive = decltype(state_.drive)::start(plan.drive);
    (Features::start(plan, state_), ...);
    const bool left = is_at_left();
    const Value inside = plan.units.penetration(mirrored(state_.x2 - state_.x1, left));
    if (is_positive(inside)) {
      state_.at_left = left;
      state_.contact.start(plan.contact, plan.units, inside, relative_rate(left));
      load_contact();
    }
    begin_to_rub();
  }
  // A plan AtRunTime may have a friction of 0: then nothing is done, and the bits are those without DryFriction.
  constexpr bool rubs() const {
    if constexpr (Friction::is_friction)
      return is_positive(plan.friction.full);
    else
      return false;
  }
  // What records starts anew.
  template <class Feature>
  constexpr void restart() {
    if constexpr (!__is_base_of(ScenePart, Feature)) {
      static_cast<typename Feature::template State<Format>&>(state_) = {};
      Feature::start(plan, state_);
    }
  }
  // Adds the half impulse that acts in the step ahead.
  constexpr void begin_to_rub() {
    if constexpr (Friction::is_friction) {
      if (!rubs()) return;
      Friction::begin(plan, state_, plan.units.relative(way_ahead()));
      if constexpr (counts_slid_way) state_.slid.add(still_to_rub());
    }
  }
  // Takes it out again.
  constexpr void leave_rubbing() {
    if constexpr (Friction::is_friction) {
      if (!rubs()) return;
      if constexpr (counts_slid_way) state_.slid.add(decltype(still_to_rub()){} - still_to_rub());
      Friction::undo(plan, state_);
    }
  }

  // A step: both masses fly, here; touch() sees by is_inside() whether the ball is inside a stop, and makes the
  // approach of it, push() has the treatment resolve it and both masses answer; friction rubs at the step's end, in
  // flight or at the stop.
  constexpr void advance(Value sample, Value base) {
    if (Source::is_refused()) return;
    if constexpr (Drive::is_sampled)
      if (!state_.drive.accepts(plan.drive, sample)) hold_sample(sample);
    if constexpr (Field::is_sampled) {
      if (!Field::accepts(plan, base)) {
        base = Field::held(plan, base);
        raise(Fault::sample);
      }
      base = Field::at_end(plan, base);
    }
    Long main_travel = state_.dx1;
    if constexpr (Drive::is_sampled) plan.units.add(main_travel, state_.drive.at_once(plan.drive, sample));
    if constexpr (Field::is_sampled) plan.units.add(main_travel, Field::at_once(plan, base));
    state_.x1.advance(main_travel);
    if constexpr (!Field::is_field) state_.x2.advance(state_.dx2);
    [[maybe_unused]] const auto drive_before = state_.drive.before();
    Value increment = -Format::term(plan.stiffness, plan.units.position(state_.x1)) -
                      Format::term(plan.damping, plan.units.damped(state_.dx1));
    if constexpr (Drive::is_sine) increment = increment + state_.drive.advance(plan.drive);
    if constexpr (Drive::is_sampled) increment = increment + state_.drive.advance(plan.drive, sample);
    if constexpr (Field::is_field) increment = increment + Field::main_increment(plan, state_, base);
    plan.units.add(state_.dx1, increment);
    if constexpr (Field::is_field) Field::fly(plan, state_, base);
    if (!checks_range_once() && !is_flight_in_range()) {
      hold();
    } else if (state_.contact.phase != Phase::apart || is_beyond_stop()) {
      DriveChange<Value> change{};
      if constexpr (Contact::sees_change) change = state_.drive.change(plan.drive, drive_before);
      meet_stop(increment, main_travel, change);
    } else if (checks_range_once() && !is_flight_in_range()) {
      hold();
    } else if constexpr (Friction::is_friction) {
      rub(main_travel);
    }
    (Features::after_step(plan, state_), ...);
  }
  // Friction need not be looked at: it brings both rates nearer to each other.
  [[gnu::always_inline]] constexpr bool is_flight_in_range() const {
    if constexpr (Field::is_field)
      return plan.units.in_range_in_field(state_.x1, state_.x2, state_.dx1, state_.dx2);
    else
      return plan.units.in_range(state_.x1, state_.x2, state_.dx1);
  }
  constexpr void publish() {
    if constexpr (publishes) Window::publish([this](Snapshot<Value>& now) { see(now, is_touching()); });
  }
  constexpr void see(Snapshot<Value>& now, bool touches) const {
    now.displacement = displacement();
    now.velocity = velocity();
    now.ball_displacement = ball_displacement();
    now.ball_velocity = ball_velocity();
    if constexpr (detail::is_one_of<ContactForce, Features...>) now.contact_force = contact_force();
    now.steps = state_.steps;
    now.fault = Source::is_refused() ? Fault::plan : state_.fault;
    now.is_touching = touches;
  }

  // is_touching() at the start. (GCC 12 cannot read the phase while it evaluates the constructor.)
  constexpr bool begins_inside() const {
    return !Source::is_refused() && is_positive(plan.units.penetration(mirrored(plan.x2 - plan.x1, is_at_left())));
  }

  // Scene, bounds, step, types and features.
  constexpr uint32_t identity() const {
    if constexpr (sizeof...(Features) == 0) {
      return plan.identity;
    } else {
      Fingerprint fingerprint{plan.identity};
      (fingerprint.add(Features::kind), ...);
      return fingerprint.value;
    }
  }

  // What a force that a treatment keeps has not done yet, towards the stop as a displacement per step.
  constexpr Value carried(typename Format::Gain share) const {
    return plan.units.as_displacement(mirrored(share * state_.contact.force, at_left()));
  }
  constexpr bool at_left() const { return plan.left_stop && plan.right_stop ? state_.at_left & 1 : plan.left_stop; }

  // A ball that a correction has put into a stop without touching it stands at it.
  constexpr void push_out() {
    const bool left = is_at_left();
    if (is_positive(plan.units.penetration(mirrored(state_.x2 - state_.x1, left))))
      state_.x2 = plan.units.stop(state_.x1, left);
  }

  // What spring, drive and field give the contact to bear.
  constexpr void load_contact() {
    const Value in_half_a_step = mirrored(rate_ahead() + Field::ball_rate(plan, state_), at_left());
    state_.contact.bear(plan.contact, in_half_a_step + in_half_a_step);
  }

  // The contact under way as if it stood so from its beginning; what it bears stays, and its damping, as far as a step
  // bears that.
  constexpr void touch_anew() {
    Contact& contact = state_.contact;
    if (contact.rests_on(plan.units, state_, at_left())) return;
    const Phase phase = contact.phase;
    const Value found = plan.units.penetration(mirrored(state_.x2 - state_.x1, at_left())),
                inside = contact.no_deeper(found);
    if (is_positive(found - inside)) plan.units.displace(state_.x2, -mirrored(found - inside, at_left()));
    if (Contact::is_instantaneous ? !is_negative(inside) : is_positive(inside)) {
      const Value rate = relative_rate(at_left());
      if constexpr (has_own_damping) contact.hold_damping(plan.contact, inside, rate);
      contact.start(plan.contact, plan.units, inside, rate);
      contact.phase = phase;
      if (!contact.is_sound(plan.contact, plan.units)) hold();
    } else {
      contact.phase = Phase::apart;
      contact.drop_force();
    }
  }

  // A position, of what the state keeps in its stead: in a sampled field less what the last sample gave at once.
  constexpr Long place(Long x) const { return Field::place(plan, state_, x); }

  // h v1 less the displacement that the coming step will make: what spring and drive will have changed by then.
  constexpr Value rate_ahead() const { return rate_ahead_but_field() - Field::main_rate(plan, state_); }
  constexpr Value rate_ahead_but_field() const {
    Value ahead =
        plan.rate_by_dx1 * plan.units.displacement(state_.dx1) + plan.rate_by_x1 * plan.units.position(state_.x1);
    if constexpr (Drive::is_sine || Drive::is_sampled) ahead = ahead - state_.drive.rate(plan.drive);
    return ahead;
  }

  [[gnu::always_inline]] constexpr void meet_stop(Value increment, Long main_travel, DriveChange<Value> change) {
    if constexpr (Format::calls_contact)
      call_meet_stop_and_rub(increment, main_travel, change);
    else
      meet_stop_and_rub(increment, main_travel, change);
  }
  [[gnu::noinline]] constexpr void call_meet_stop_and_rub(Value increment, Long main_travel,
                                                          DriveChange<Value> change) {
    meet_stop_and_rub(increment, main_travel, change);
  }
  [[gnu::always_inline]] constexpr void meet_stop_and_rub(Value increment, Long main_travel,
                                                          DriveChange<Value> change) {
    if constexpr (Friction::is_friction) {
      const Long flight = Field::ball_travel(plan, state_) - main_travel, apart = state_.x2 - state_.x1;
      touch(increment, main_travel, change);
      if (rubs()) rub_at_stop(flight, apart - (state_.x2 - state_.x1));
    } else {
      touch(increment, main_travel, change);
    }
  }
  [[gnu::always_inline]] constexpr void touch(Value increment, Long main_travel, DriveChange<Value> change) {
    if (state_.contact.phase == Phase::apart) state_.at_left = is_at_left();
    const bool left = at_left();
    state_.contact.carry_over(plan.contact, plan.units, state_, left);
    SeenStep step{};
    if (!is_inside(step, left)) return hold_unjudged();
    step.rate = relative_rate(left);
    step.travel = mirrored(flown(main_travel), left);
    step.before = step.penetration - step.travel;
    if constexpr (Contact::sees_change) step.half_change = -mirrored(change.half, left);
    if constexpr (Contact::is_instantaneous) {
      step.damped = mirrored(Format::term(plan.damping, plan.units.damped(main_travel)), left);
      increment = increment + change.to_end;
    }
    if (push(step, increment, left) && plan.crosses && state_.contact.phase == Phase::apart) cross(increment, !left);
  }

  // The penetration; whether there is a contact, under way or begun.
  [[gnu::always_inline]] constexpr bool is_inside(Approach<Value>& step, bool left) {
    const Long relative_displacement = mirrored(state_.x2 - state_.x1, left);
    step.penetration = plan.units.penetration(relative_displacement);
    if (state_.contact.phase == Phase::apart && !is_positive(step.penetration)) return false;
    if (!plan.units.fits(relative_displacement)) raise(Fault::penetration);
    return true;
  }

  // The ball that has left one stop comes to the other in the same step, at the rate that it left with.
  [[gnu::noinline]] constexpr void cross(Value increment, bool left) {
    SeenStep step{};
    if (!is_inside(step, left)) return;
    state_.at_left = left;
    step.travel = step.rate = relative_rate(left);
    step.before = step.penetration - step.rate;
    if (is_positive(step.before) && !put_back(plan.units, state_, step, left)) return;
    push(step, increment, left);
  }

  // What the contact does to both masses. False where the ball was put back to its stop or a state was held.
  [[gnu::always_inline]] constexpr bool push(SeenStep& step, Value increment, bool left) {
    const auto& units = plan.units;
    Contact& contact = state_.contact;
    if (contact.phase == Phase::apart && is_positive(step.before) && !contact.begin_inside(units, state_, step, left)) {
      reload(state_);  // which every contact would keep in registers for this one
      hold_unjudged();
      return false;
    }
    if constexpr (Field::is_field) {
      const Value ball = Field::ball_increment(plan, state_);
      step.ball_increment = left ? -ball : ball;
      step.increment = -mirrored(increment - ball, left);
    } else {
      step.increment = -mirrored(increment, left);
    }
    step.main_rate = mirrored(units.relative(state_.dx1) + rate_ahead(), left);
    // A law at the step's end has its rate with the friction of the whole step, of which half an impulse is to come.
    [[maybe_unused]] const Value rate = step.rate;
    if constexpr (Friction::is_friction && Contact::keeps_force)
      step.rate = rate - mirrored(Format::value(half(state_.impulse)), left);
    const Contact contact_before = contact;
    // Not const: GCC keeps a constant that several branches make in memory.
    auto impulse = contact.resolve(plan.contact, units, step);
    reload(state_);
    plan.contact.response.answer(units, state_, mirrored(impulse, left));
    contact.place_ball(plan.contact, units, state_, left);
    if (hold_in_range()) return false;
    if constexpr (sizeof...(Features) > 0) {
      step.rate = rate;
      const auto seen = contact.record(plan.contact, units, step, contact_before, impulse);
      (Features::after_contact(plan, state_, seen), ...);
    }
    return true;
  }

  // Rate of penetration, for the state as it stands.
  constexpr Value relative_rate(bool left) const {
    return mirrored(
        plan.units.relative(state_.dx2 - state_.dx1) - rate_ahead_but_field() - Field::rate_apart(plan, state_), left);
  }

  // What the coming step adds to x2 - x1, as the last sample says.
  constexpr Long way_ahead() const {
    Long way = state_.dx2 - state_.dx1;
    if constexpr (Drive::is_sampled) plan.units.add(way, -state_.drive.at_once(plan.drive, state_.drive.sample));
    if constexpr (Field::is_sampled) plan.units.add(way, -Field::at_once(plan, state_.by_field));
    return way;
  }
  // What a step's flight has added to x2 - x1.
  constexpr Value flown(Long main_travel) const {
    return plan.units.relative(Field::ball_travel(plan, state_) - main_travel);
  }

  // Dry friction at the end of a step in flight.
  [[gnu::always_inline]] constexpr void rub(Long main_travel) {
    if (!rubs()) return;
    [[maybe_unused]] Value rate{};
    if constexpr (counts_slid_way) rate = rubbing_rate();
    if (!Friction::slides_on(plan, state_, state_.dx2))
      rub_anew(flown(main_travel), way_ahead(), typename Friction::Any{});
    if constexpr (counts_slid_way) count_slid_way(rate);
  }
  template <class Allowed>
  [[gnu::noinline]] constexpr void rub_anew(Value slid, Long ahead, Allowed allowed) {
    Friction::rub(plan, state_, slid, ahead, allowed);
  }
  // And of one in which the ball has met a stop: where it still touches it, contact will take as much of x2 - x1 in the
  // coming step as it did in this one.
  [[gnu::always_inline]] constexpr void rub_at_stop(Long flight, Long taken) {
    const Long slid = flight - taken;
    const bool touches = state_.contact.phase != Phase::apart;
    if (!touches) taken = {};
    [[maybe_unused]] Value rate{};
    if constexpr (counts_slid_way) rate = rubbing_rate();
    if (Contact::is_sudden(plan.contact))
      rub_anew(plan.units.relative(slid), way_ahead() - taken, Friction::passive(plan, rubbing_rate()));
    else if (!Friction::slides_on(plan, state_, state_.dx2 - taken))
      rub_anew(plan.units.relative(slid), way_ahead() - taken, typename Friction::Any{});
    if constexpr (counts_slid_way) count_slid_way(rate);
    if (!touches) return;
    const Value towards_stop = mirrored(-state_.impulse, at_left());
    state_.contact.change_rate(plan.contact, towards_stop);
    if constexpr (counts_slid_way) state_.rate = state_.rate + towards_stop;
  }
  // The work of an impulse is at the mean of the rates before and after it: what both masses lose, exactly.
  constexpr void count_slid_way(Value before) {
    state_.slid.add(Friction::dissipated(plan, state_, before));
    state_.slid.add(Friction::dissipated(plan, state_, rubbing_rate()));
  }
  constexpr Value rubbing_rate() const {
    Value main = plan.units.relative(state_.dx1) + rate_ahead(), sliding = relative_rate(false);
    if constexpr (Contact::keeps_force) {
      const Value main_carried = plan.contact.dx1_share * state_.contact.force,
                  ball_carried = plan.contact.dx2_share * state_.contact.force;
      main = main - mirrored(main_carried, at_left());
      sliding = sliding + mirrored(main_carried + ball_carried, at_left());
    }
    return Friction::rubbing_rate(plan, sliding, main);
  }
  // The half of the last impulse that acts in the step ahead.
  constexpr auto still_to_rub() const {
    const Value main = plan.friction.main_rate_ahead * state_.impulse, ball = plan.friction.ball_ahead * state_.impulse;
    const Value more = Friction::rubbing_rate(plan, main + ball, -main);
    return Friction::dissipated(plan, state_, rubbing_rate() + Format::value(half(more)));
  }

  constexpr bool is_beyond_stop() const {
    if (plan.left_stop && plan.right_stop) return plan.units.beyond_stops(state_.x2, state_.x1);
    return plan.left_stop ? plan.units.beyond_stop(state_.x1, state_.x2) : plan.units.beyond_stop(state_.x2, state_.x1);
  }

  // The stop that the ball would be in: of two the one on its side.
  constexpr bool is_at_left() const {
    return plan.left_stop && (!plan.right_stop || (state_.x2 - state_.x1).is_negative());
  }

  constexpr bool is_sound(const State& state) const {
    const auto& units = plan.units;
    bool is_sound = units.in_range(state.x1, state.x2, state.dx1, state.dx2) && units.is_sound(state.x1) &&
                    units.is_sound(state.x2) && units.is_sound(state.dx1) && units.is_sound(state.dx2) &&
                    state.contact.phase <= Phase::released && state.at_left <= 1 && state.fault <= Fault::sample;
    if constexpr (Drive::is_sine) is_sound = is_sound && state.drive.oscillator.is_sound(plan.drive.oscillator);
    if constexpr (Drive::is_sampled) is_sound = is_sound && state.drive.accepts(plan.drive, state.drive.sample);
    if constexpr (counts_slid_way) is_sound = is_sound && Format::is_sound(state.slid);
    if constexpr (has_own_damping) is_sound = is_sound && Format::is_sound(state.contact.own_damping);
    return is_sound && state.contact.is_sound(plan.contact, units) && state.contact.fits_together(plan.contact) &&
           (Features::is_sound(plan, state) && ...);
  }

  // What contact or a change of plan has left beyond its range.
  constexpr bool hold_in_range() {
    if (plan.units.in_range(state_.x1, state_.x2, state_.dx1, state_.dx2)) return false;
    hold();
    return true;
  }
  // A flight that was left to a contact to judge, where there is none.
  [[gnu::always_inline]] constexpr void hold_unjudged() {
    if (checks_range_once()) hold_in_range();
  }
  __attribute__((noinline)) constexpr void hold() {
    const bool is_far = plan.units.hold_position(state_.x1), is_ball_far = plan.units.hold_position(state_.x2);
    plan.units.hold_displacement(state_.dx1);
    plan.units.hold_displacement(state_.dx2);
    state_.contact.phase = Phase::apart;  // and no more: to clear it all is a call of memset on a Cortex-M0
    state_.contact.drop_force();
    raise(is_far || is_ball_far ? Fault::displacement : Fault::speed);
  }
  __attribute__((noinline)) constexpr void hold_sample(Value& sample) {
    sample = state_.drive.held(plan.drive, sample);
    raise(Fault::sample);
  }

  constexpr void raise(Fault fault) {
    if (state_.fault == Fault::none) state_.fault = fault;
  }

  State state_{};
};

}  // namespace impact
