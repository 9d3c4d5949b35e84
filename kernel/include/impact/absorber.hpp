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
//     void timer_interrupt() { absorber.step(); write_dac(to_dac(absorber)); }  // converter.hpp
//
// The absorber is a type; parts that its template arguments do not name cost nothing. All member functions but fault()
// and snapshot() belong to the one context that steps, an interrupt or a task.
//
//     contact law   HookeNewton, Hertz, HuntCrossley; with a damping set at each impact HuntCrossleyPerImpact,
//                   HerbertMcWhannell, LeeWang, LankaraniNikravesh, Flores, HuGuo, Exact
//     stepper       Moment, SubsteppedMoment<n>, EnergyConsistent, Impulsive, AverageAcceleration, LinearAcceleration,
//                   FoxGoodwin, CentralDifference, or by the rule for scene and step: Chosen<>, see choice.hpp
//     drive         NoDrive, Sine, Sampled
//     format        Fixed32, Float32, Float32Plain, Float64 (host)
//     parts         Gravity, BaseAcceleration (motion/field.hpp), DryFriction (motion/friction.hpp)
//     features      EnergyLedger, ImpactLog, ContactForce, Snapshots
//
// This header is the way in and out; the step itself is step/step.hpp.

#include <stdint.h>

#include <impact/choice.hpp>
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
#include <impact/motion/no_drive.hpp>
#include <impact/motion/sampled.hpp>
#include <impact/motion/sine.hpp>
#include <impact/numeric/fixed32.hpp>
#include <impact/numeric/real.hpp>
#include <impact/plan/plan.hpp>
#include <impact/plan/source.hpp>
#include <impact/quantity.hpp>
#include <impact/scene.hpp>
#include <impact/snapshot.hpp>
#include <impact/step/restart.hpp>
#include <impact/step/step.hpp>
#include <impact/stepper/energy.hpp>
#include <impact/stepper/impulsive.hpp>
#include <impact/stepper/moment.hpp>
#include <impact/stepper/moment/substepped.hpp>
#include <impact/stepper/newmark.hpp>
#include <impact/types.hpp>

namespace impact {

namespace detail {
// The parts of the scene among the features. If two of them are fields, it is the sampled one, which has weight, too.
template <class... Features> struct FieldAmong { using Type = NoField; };
template <class First, class... Others> struct FieldAmong<First, Others...> {
  using Other = typename FieldAmong<Others...>::Type;
  using Type = typename Either<contract::is_field<First> && !Other::is_sampled, First, Other>::Type;
};
template <class... Features> using FieldOf = typename FieldAmong<Features...>::Type;
template <class... Features>
using FrictionOf = typename Either<is_one_of<DryFriction, Features...>, DryFriction, NoFriction>::Type;

// Each argument, or a valid type in its place if it breaks its contract, so that the compiler prints one message.
template <uint32_t identity, class Rig, class ContactLaw, class Stepper, class Drive, class Format, class... Features>
using CheckedSource =
    PlanSource<contract::KeptRig<Rig>,
               Plan<contract::KeptFormat<Format>, contract::KeptLaw<ContactLaw>,
                    contract::KeptStepper<Stepper, contract::KeptFormat<Format>, contract::KeptLaw<ContactLaw>>,
                    contract::KeptDrive<Drive>, FieldOf<Features...>, FrictionOf<Features...>>,
               identity>;

template <class Rig> constexpr uint32_t identity_of() {
  if constexpr (is_one_of<Rig, AtRunTime>)
    return 0;
  else
    return fingerprint_of_rig(Rig::scene, Rig::bounds, Rig::step);
}

// Without any features if two of them are of one kind, so that the compiler prints the message below.
template <class Source, class... Features>
using MachineOf =
    typename Either<contract::kinds_differ<Features...>, Machine<Source, Features...>, Machine<Source>>::Type;

// impact::Absorber, with the rig's identity.
template <uint32_t identity, class Rig, class Law_, class Stepper_, class Drive_, class Format_, class... Features>
class AbsorberOf
    : private MachineOf<CheckedSource<identity, Rig, Law_, Stepper_, Drive_, Format_, Features...>,
                        contract::KeptFeature<Features>...>,
      private SnapshotWindow<typename contract::KeptFormat<Format_>::Value, is_one_of<Snapshots, Features...>> {
  using Source = CheckedSource<identity, Rig, Law_, Stepper_, Drive_, Format_, Features...>;
  using Machine = MachineOf<Source, contract::KeptFeature<Features>...>;

  // impact/contracts.hpp; one message for one mistake.
  static constexpr bool is_at_run_time = detail::is_one_of<Rig, AtRunTime>, has_scene = contract::has_scene<Rig>,
                        has_bounds = contract::has_bounds<Rig>, has_law = contract::is_law<Law_>,
                        has_stepper = contract::is_stepper<Stepper_>;
  static_assert(
      is_at_run_time || has_scene,
      "the rig has no static scene: write static constexpr impact::Scene scene = ...; or name AtRunTime instead");
  static_assert(is_at_run_time || !has_scene || has_bounds,
                "the rig has no static bounds: write static constexpr impact::Bounds bounds = ...;");
  static_assert(is_at_run_time || !has_scene || !has_bounds || contract::has_step<Rig>,
                "the rig has no static step of type double: write static constexpr double step = 1e-4;  // s");
  static_assert(has_law, "the second argument must be a law, such as HuntCrossley: see impact/contracts.hpp");
  static_assert(!has_law || has_stepper,
                "the third argument must be a stepper, such as Moment: see impact/contracts.hpp");
  static_assert(!has_law || !has_stepper ||
                    contract::has_contact<Stepper_, contract::KeptFormat<Format_>, contract::KeptLaw<Law_>>,
                "the stepper's Contact<Format, Law> is not a contact: see impact/contracts.hpp");
  static_assert(!has_stepper || contract::is_drive<Drive_>,
                "the fourth argument must be a drive, such as NoDrive, Sine or Sampled: see impact/contracts.hpp");
  static_assert(!contract::is_drive<Drive_> || contract::is_format<Format_>,
                "the fifth argument must be a format, such as Fixed32 or Float32, not a number type such as float: see "
                "impact/contracts.hpp");
  static_assert((contract::is_feature<Features> && ...),
                "the sixth and further arguments must be features, such as EnergyLedger: see impact/contracts.hpp");
  static_assert(!(contract::is_feature<Features> && ...) || contract::kinds_differ<contract::KeptFeature<Features>...>,
                "two features are of one kind: name each feature once, and give one of your own a kind of its own");
  static_assert(((!__is_base_of(DryFriction, Features) || detail::is_one_of<DryFriction, Features>)&&...),
                "a class of your own cannot replace DryFriction: name DryFriction itself");

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
  using Contact = typename PlanType::ContactType;
  using Source::plan;
  using typename Machine::State;

  // The SI value of a native 1.0, which is raw 2^31 in Fixed32. In floating point it is 1. These values are constants
  // of the type unless the plan is AtRunTime.
  using Source::base_sample_unit;   // m/s^2
  using Source::displacement_unit;  // m
  using Source::force_unit;         // N, of contact_force()
  using Source::sample_unit;        // N, of the samples of a Sampled drive
  using Source::velocity_unit;      // m/s
  // sample_of(newtons) and base_sample_of(acceleration in m/s^2) return a sample for step(). The argument is a double
  // constant, or a float while running. Without an FPU a float costs some hundred instructions. In Fixed32 both clamp
  // to the bound and replace a NaN by 0. The step() that gets such a sample raises Fault::sample.
  using Source::base_sample_of;
  using Source::sample_of;

  // Starts in the scene's initial state. With AtRunTime the plan is an argument. With a rejected plan the absorber
  // stands still at 0 and has Fault::plan.
  constexpr AbsorberOf() {
    Begin::start(machine());
    if constexpr (publishes) see(Window::first());
  }
  explicit constexpr AbsorberOf(const PlanType& next) : Machine(next) {
    Begin::start(machine());
    if constexpr (publishes) see(Window::first());
  }

  // Goes back to the scene's initial state and clears the fault.
  constexpr void reset() {
    Begin::start(machine());
    publish();
  }

  // Advances by one step. It is for the drives NoDrive and Sine, without BaseAcceleration.
  template <class... Nothing> constexpr void step() {
    static_assert(!Drive::is_sampled || sizeof...(Nothing) > 0,
                  "step() without a sample, but the drive is Sampled: pass the force at the step's end, as "
                  "step(absorber.sample_of(newtons)) or through FromCounts");
    static_assert(!Field::is_sampled || sizeof...(Nothing) > 0,
                  "step() without a sample, but BaseAcceleration is named: pass the acceleration at the step's end, as "
                  "step(absorber.base_sample_of(acceleration)), after the force of a Sampled drive");
    Steps::step(machine(), Value{}, Value{});
    publish();
  }
  // Advances by one step with a Sampled drive or with BaseAcceleration. The sample is the value at the step's end. In
  // floating point it is in N or m/s^2. Beyond its bound it is clamped, with Fault::sample. In Fixed32 it is a fraction
  // of Bounds::force or Bounds::base_acceleration in Q1.31. Before the first step the sample is 0.
  template <class Sample = detail::InBraces> constexpr void step(Sample sample) {
    constexpr Quantity quantity = Drive::is_sampled ? Quantity::force : Quantity::base_acceleration;
    constexpr bool takes_one = Drive::is_sampled != Field::is_sampled,
                   is_sample = detail::is_sample<Sample, Value, quantity>;
    static_assert(Drive::is_sampled || Field::is_sampled,
                  "step(sample), but the drive takes none: name Sampled as the drive, or call step()");
    static_assert(!(Drive::is_sampled && Field::is_sampled),
                  "step(sample), but both the drive and the base take one: call step(force, acceleration)");
    check_sample<Sample, quantity, !takes_one>();
    if constexpr (takes_one && is_sample) {
      note_clamped(sample);
      if constexpr (Drive::is_sampled)
        Steps::step(machine(), sample, Value{});
      else
        Steps::step(machine(), Value{}, sample);
      publish();
    }
  }
  // Advances by one step with a Sampled drive and BaseAcceleration. Both samples are the values at the step's end.
  template <class Force = detail::InBraces, class Acceleration = detail::InBraces>
  constexpr void step(Force force, Acceleration acceleration) {
    constexpr bool takes_both = Drive::is_sampled && Field::is_sampled;
    static_assert(takes_both,
                  "step(force, acceleration): it requires a Sampled drive, and BaseAcceleration appended to the type");
    check_sample<Force, Quantity::force, !takes_both>();
    check_sample<Acceleration, Quantity::base_acceleration, !takes_both>();
    if constexpr (takes_both && detail::is_sample<Force, Value, Quantity::force> &&
                  detail::is_sample<Acceleration, Value, Quantity::base_acceleration>) {
      note_clamped(force);
      note_clamped(acceleration);
      Steps::step(machine(), force, acceleration);
      publish();
    }
  }

  // Displacement and velocity of the main mass and of the ball after the last step, in native numbers of
  // displacement_unit() and velocity_unit(). During an impact of Impulsive they contain what its force has done by then
  // (docs/impulsive.md). Only the context that steps may call them. Others call snapshot().
  constexpr Value displacement() const { return plan.units.position(Machine::main_position()); }
  constexpr Value velocity() const {
    auto rate = plan.units.as_displacement(Machine::rate_ahead());
    if constexpr (Contact::traits.keeps_force) rate = rate - carried(plan.contact.dx1_share);
    if constexpr (Contact::traits.is_instantaneous)
      rate = rate + plan.units.as_displacement(plan.contact.main_share * Machine::spread().rate);
    if constexpr (Friction::is_friction)
      rate = rate - plan.units.as_displacement(plan.friction.main_rate_ahead * Machine::state.impulse);
    return plan.units.velocity(plan.units.displacement(Machine::state.dx1) + rate);
  }
  constexpr Value ball_displacement() const { return plan.units.position(Machine::ball_position()); }
  constexpr Value ball_velocity() const {
    auto rate = plan.units.displacement(Machine::state.dx2);
    if constexpr (Contact::traits.keeps_force) rate = rate + carried(plan.contact.dx2_share);
    if constexpr (Contact::traits.is_instantaneous)
      rate = rate - plan.units.as_displacement(plan.contact.ball_share * Machine::spread().rate);
    if constexpr (Field::is_field) rate = rate - plan.units.as_displacement(Field::ball_rate(plan, Machine::state));
    if constexpr (Friction::is_friction)
      rate = rate + plan.units.as_displacement(plan.friction.ball_ahead * Machine::state.impulse);
    return plan.units.velocity(rate);
  }
  // The contact's force on the main mass along x, in native numbers of force_unit(). The force on the ball is the
  // opposite. With a stepper that resolves the contact it is the average over the last step. With Impulsive, whose
  // impacts take no time, it is the law's peak in an impact of the last step, at every rate. For a ball at rest it is
  // the static force. It requires the feature ContactForce.
  constexpr Value contact_force() const {
    static_assert(has_contact_force,
                  "contact_force() requires the feature ContactForce: append it to the absorber's type");
    if constexpr (!has_contact_force)
      return {};
    else if constexpr (Contact::traits.is_instantaneous)
      return impact_force().peak;
    else
      return plan.units.native_force(record_in<ContactForce, PlanType>(Machine::state).force);
  }
  // With Impulsive, the law's force averaged over the contact whose peak force is contact_force().
  constexpr Value mean_impact_force() const {
    static_assert(has_contact_force,
                  "mean_impact_force() requires the feature ContactForce: append it to the absorber's type");
    static_assert(Contact::traits.is_instantaneous,
                  "mean_impact_force() requires Impulsive: with this stepper contact_force() is the average of a step");
    if constexpr (has_contact_force && Contact::traits.is_instantaneous)
      return impact_force().mean;
    else
      return {};
  }
  // True if the type has contact_force().
  static constexpr bool has_contact_force = detail::is_one_of<ContactForce, Features...>;
  // True if the last step ended in contact. It is false if the stop has released the ball, even if the ball is still
  // inside it.
  constexpr bool is_touching() const { return Machine::state.contact.phase == Phase::touching; }
  // All values that a step changes, and the records of the features.
  constexpr const State& state() const { return Machine::state; }

  // The first fault since the start, reset() or clear_fault(). Any context may call it, also in a loop that waits: each
  // call reads one aligned half word.
  Fault fault() const {
    if (Source::is_refused()) return Fault::plan;
    return *static_cast<const volatile Fault*>(&Machine::state.fault);
  }
  // Clears the fault. The state stays as it is.
  constexpr void clear_fault() {
    Machine::state.fault = Fault::none;
    publish();
  }

  // All values of one step, for any context while another one steps (snapshot.hpp). It requires the feature Snapshots.
  Snapshot<Value> snapshot() const {
    static_assert(publishes, "snapshot() requires the feature Snapshots: append it to the absorber's type");
    if constexpr (publishes)
      return Window::read();
    else
      return {};
  }

  // An observer's correction between two steps. It adds to the main mass's displacement and velocity, in the units of
  // displacement() and velocity(). A correction or a corrected state beyond a bound is clamped to the bound, with a
  // fault. A correction that is a NaN is not added and raises a fault. A contact under way continues from the corrected
  // penetration. A damping that was set at its impact is clamped to what a step tolerates there
  // (law/impact_damping.hpp). A ball that a correction puts into a stop that it did not touch is placed at that stop. A
  // ball at rest on an impulsive stop stays on it. Dry friction's last impulse changes sign with the sliding. A ledger
  // counts the change of the stored energy as dissipated, and nothing as the drive's work.
  constexpr void correct(Value dx, Value dv) {
    if (Source::is_refused()) return;
    const auto& units = plan.units;
    Value du = units.per_step(dv);
    if (units.clamp(dx, units.correction_limit())) Machine::raise(Fault::displacement);
    if (units.clamp(du, units.rate_correction_limit())) Machine::raise(Fault::speed);
    const auto friction = FrictionStep::stop(machine());
    const Position<Value> x(dx);
    const Displacement<Value> u(du);
    units.add_position(Machine::state.x1, x);
    units.add_displacement(Machine::state.dx1, u);
    units.add(Machine::state.dx1, -(plan.change.new_lag_by_u1 * u + plan.change.new_lag_by_x1 * x));
    FrictionStep::start(machine(), friction);
    if (!Machine::clamp_to_range()) {
      if (Machine::state.contact.phase != Phase::apart) Begin::resume_contact(machine(), true);
      if (Machine::state.contact.phase == Phase::apart) Begin::push_out(machine());
    }
    Machine::record_correction();
    publish();
  }
  // The same for numbers that carry their quantity, as a FromCounts returns them.
  template <Quantity first, class Rate = Value> constexpr void correct(Native<first, Value> dx, Rate dv) {
    constexpr bool is_rate = !detail::is_native<Rate> || detail::is_sample<Rate, Value, Quantity::velocity>;
    static_assert(first == Quantity::displacement && is_rate, "correct(dx, dv): first a displacement, then a velocity");
    if constexpr (is_rate) {
      const Value rate = dv;
      correct(static_cast<Value>(dx), rate);
    }
  }
  template <Quantity second> constexpr void correct(Value dx, Native<second, Value> dv) {
    correct(Native<Quantity::displacement, Value>{dx}, dv);
  }

  // save() and restore() save and restore the state. The bytes are the same on every little-endian target and on a
  // 64-bit host, so a host that restores them continues bit for bit. restore() returns false and changes nothing if
  //     - the layout's version, the scene, the bounds, the step or a type differs,
  //     - displacements, drive, friction, fault, kind of contact or features' records are out of range,
  //     - a contact under way is inconsistent.
  // It does not authenticate. If forged bytes pass these checks, every step is still defined and ends in range or with
  // a fault. But the motion may be impossible for this absorber, and the features' records may have any value in range.
  static constexpr uint32_t state_version = 7;
  struct Saved {
    uint32_t version, plan_identity;
    State state;
  };
  constexpr Saved save() const { return {state_version, saved_identity(), Machine::state}; }
  constexpr bool restore(const Saved& saved) {
    if (Source::is_refused() || saved.version != state_version || saved.plan_identity != saved_identity()) return false;
    if (!is_sound(saved.state)) return false;
    Machine::state = saved.state;
    publish();
    return true;
  }

  // Changes to another plan between two steps, for an absorber AtRunTime. Displacements, velocities and the drive's
  // phase do not jump (motion/plan_change.hpp). A drive that was off starts at phase 0. Ledger and log start at 0
  // again. If the parameters of a contact under way change, it continues from its penetration. retune() returns false
  // and changes nothing
  // - if the plan is rejected, or bounds, step, clearance or stops differ;
  // - in Fixed32 if displacement_unit() differs: a softer stop or a larger drive may widen it under the same bounds;
  // - with BaseAcceleration if gravity differs;
  // - during a contact with Newmark's classical steppers, a damping set per impact, EnergyLedger, ImpactLog or
  //   ContactForce, whose state depends on the plan's forces.
  constexpr bool retune(const PlanType& next) {
    static_assert(!Source::is_constant,
                  "retune() requires a plan AtRunTime, and this plan is a constant: name AtRunTime instead of the rig");
    constexpr bool is_bound =
        Contact::traits.keeps_force || ContactLaw::is_damped_per_impact || (Features::is_bound || ...);
    if (next.status != PlanStatus::ok || next.change.units != plan.change.units) return false;
    if (is_bound && Machine::state.contact.phase != Phase::apart) return false;
    const auto friction = FrictionStep::stop(machine());
    FrictionStep::undo(machine());
    const bool is_other_contact = next.change.contact != plan.change.contact;
    change_plan<PlanType>(plan, next, Machine::state);
    if constexpr (!Source::is_constant) Source::go_on_under(next);
    (restart<Features>(), ...);
    if constexpr (counts_sliding_distance) Machine::state.slid = {};
    FrictionStep::start(machine(), friction);
    Machine::clamp_to_range();
    if (is_other_contact && Machine::state.contact.phase != Phase::apart) Begin::resume_contact(machine(), false);
    publish();
    return true;
  }

  // The closing speed of the last impact, m/s, and the largest contact_force() since the start, N. They are for a host,
  // in double arithmetic, and require the feature ImpactLog.
  constexpr double impact_speed() const {
    static_assert(has_log, "impact_speed() requires the feature ImpactLog: append it to the absorber's type");
    if constexpr (has_log)
      return plan.units.si_penetration(record_in<ImpactLog, PlanType>(Machine::state).impact_rate) / plan.step;
    else
      return 0;
  }
  constexpr double peak_force() const {
    static_assert(has_log, "peak_force() requires the feature ImpactLog: append it to the absorber's type");
    if constexpr (!has_log) {
      return 0;
    } else {
      const Value peak = record_in<ImpactLog, PlanType>(Machine::state).peak;
      if constexpr (Contact::traits.is_instantaneous)
        return plan.units.fraction(plan.contact.force.at(plan.contact.rebound, peak).peak) * plan.force_unit();
      else
        return plan.units.fraction(peak) * plan.force_scale;
    }
  }

  // For a host, in double arithmetic: the energy that dry friction has dissipated since the start, J. It requires
  // DryFriction and EnergyLedger.
  constexpr double friction_dissipated() const {
    static_assert(counts_sliding_distance,
                  "friction_dissipated() requires DryFriction and EnergyLedger: append them to the absorber's type");
    if constexpr (counts_sliding_distance) {
      if (!FrictionStep::acts(machine())) return 0;
      const double taken = Machine::state.slid.total() - plan.units.fraction(FrictionStep::still_to_work(machine()));
      return plan.friction.force * plan.units.si_penetration_unit() * taken;
    } else {
      return 0;
    }
  }

  // For a host, in double arithmetic: displacements and velocities from the whole state, in m and m/s.
  struct Reading {
    double x1, v1, x2, v2;  // of the main mass and of the ball
  };
  constexpr Reading reading() const {
    if (Source::is_refused()) return {};
    double u1 = plan.units.si(Machine::state.dx1) + plan.units.si_penetration(Machine::rate_ahead()),
           u2 = plan.units.si(Machine::state.dx2);
    if constexpr (Field::is_field) u2 -= plan.units.si_penetration(Field::ball_rate(plan, Machine::state));
    if constexpr (Friction::is_friction) {
      u1 -= plan.units.si_penetration(plan.friction.main_rate_ahead * Machine::state.impulse);
      u2 += plan.units.si_penetration(plan.friction.ball_ahead * Machine::state.impulse);
    }
    if constexpr (Contact::traits.keeps_force) {
      const double side = Machine::state.at_left ? -1 : 1;
      u1 -= side * plan.units.si_penetration(plan.contact.dx1_share * Machine::state.contact.force);
      u2 += side * plan.units.si_penetration(plan.contact.dx2_share * Machine::state.contact.force);
    }
    if constexpr (Contact::traits.is_instantaneous) {
      const auto rate = Machine::spread().rate;
      u1 += plan.units.si_penetration(plan.contact.main_share * rate);
      u2 -= plan.units.si_penetration(plan.contact.ball_share * rate);
    }
    return {plan.units.si_at(Machine::main_position()), u1 / plan.step, plan.units.si_at(Machine::ball_position()),
            u2 / plan.step};
  }

 private:
  static constexpr bool has_log = detail::is_one_of<ImpactLog, Features...>;
  constexpr auto impact_force() const {
    const auto& seen = record_in<ContactForce, PlanType>(Machine::state);
    return plan.contact.force.of(plan.contact.rebound, seen.force, seen.impact_rate);
  }
  using Window = SnapshotWindow<Value, detail::is_one_of<Snapshots, Features...>>;
  static constexpr bool publishes = detail::is_one_of<Snapshots, Features...>;
  using Steps = Step<Machine>;
  using FrictionStep = FrictionImpulse<Machine>;
  using Begin = Restart<Machine>;
  using Machine::counts_sliding_distance;
  using Machine::keeps_sample_before;
  constexpr Machine& machine() { return *this; }
  constexpr const Machine& machine() const { return *this; }

  // Raises the fault of a sample that sample_of() has clamped.
  template <class Sample> constexpr void note_clamped(const Sample& sample) {
    if constexpr (detail::is_native<Sample>)
      if (sample.is_clamped && !Source::is_refused()) Machine::raise(Fault::sample);
  }
  // One message for one mistake.
  template <class Sample, Quantity quantity, bool is_excused> static constexpr void check_sample() {
    constexpr bool is_sample = is_excused || detail::is_sample<Sample, Value, quantity>,
                   is_in_braces = detail::is_one_of<Sample, detail::InBraces>,
                   is_of_another = detail::is_native<Sample>;
    static_assert(is_sample || !is_in_braces,
                  "step({..}): a number in braces, such as a converter's counts, is not a sample. Pass "
                  "FromCounts(counts), sample_of(newtons), or in Fixed32 Value{raw}, a fraction of the bound");
    static_assert(is_sample || !is_of_another,
                  "this sample is another quantity: for a force use FromCounts<Absorber>, for the base's acceleration "
                  "FromCounts<Absorber, Quantity::base_acceleration>");
    static_assert(
        is_sample || is_in_braces || is_of_another,
        "this sample has another type than the format's values. Pass sample_of(newtons), base_sample_of(acceleration), "
        "FromCounts(counts), a float in Float32, or in Fixed32 Value{raw}, a fraction of the bound");
  }

  // Restarts a feature whose records depend on the plan.
  template <class Feature> constexpr void restart() {
    if constexpr (!__is_base_of(ScenePart, Feature) && Feature::is_bound) {
      static_cast<typename Feature::template State<Format>&>(Machine::state) = {};
      Feature::start(plan, Machine::state);
    }
  }
  constexpr void publish() {
    if constexpr (publishes) Window::publish([this](Snapshot<Value>& now) { see(now); });
  }
  constexpr void see(Snapshot<Value>& now) const {
    now.displacement = displacement();
    now.velocity = velocity();
    now.ball_displacement = ball_displacement();
    now.ball_velocity = ball_velocity();
    if constexpr (has_contact_force) now.contact_force = contact_force();
    now.steps = record_in<Snapshots, PlanType>(Machine::state).steps;
    now.fault = Source::is_refused() ? Fault::plan : Machine::state.fault;
    now.is_touching = is_touching();
  }

  // How much a force that the contact keeps adds to the displacement of the coming step, along x.
  template <class Share> constexpr auto carried(Share share) const {
    return plan.units.as_displacement(mirrored(share * Machine::state.contact.force, Machine::contact_is_left()));
  }

  // Identifies scene, bounds, step, types and features.
  constexpr uint32_t saved_identity() const {
    if constexpr (sizeof...(Features) == 0) {
      return plan.identity;
    } else {
      Fingerprint fingerprint{plan.identity};
      (fingerprint.add(Features::kind), ...);
      return fingerprint.value;
    }
  }

  constexpr bool is_sound(const State& state) const {
    const auto& units = plan.units;
    bool is_sound = Machine::is_in_range(state) && units.is_sound(state.x1) && units.is_sound(state.x2) &&
                    units.is_sound(state.dx1) && units.is_sound(state.dx2) && state.contact.phase <= Phase::released &&
                    state.at_left <= 1 && state.fault < Fault::plan;
    if constexpr (Drive::is_sine) is_sound = is_sound && state.drive.oscillator.is_sound(plan.drive.oscillator);
    if constexpr (Drive::is_sampled) is_sound = is_sound && state.drive.accepts(plan.drive, state.drive.sample);
    if constexpr (keeps_sample_before) is_sound = is_sound && state.drive.accepts(plan.drive, state.sample_before);
    if constexpr (counts_sliding_distance) is_sound = is_sound && Format::is_sound(state.slid);
    return is_sound && state.contact.valid(plan.contact, units) && (Features::is_sound(plan, state) && ...);
  }
};
}  // namespace detail

// The absorber of a rig. The type contains the rig's values as well as its name, so two files of one program may each
// have a `Rig` of their own.
template <class Rig, class ContactLaw, class Stepper, class Drive, class Format, class... Features>
using Absorber = detail::AbsorberOf<
    detail::identity_of<contract::KeptRig<Rig>>(), Rig, ContactLaw,
    typename detail::StepperFor<Stepper, contract::KeptRig<Rig>, contract::KeptLaw<ContactLaw>>::Type, Drive, Format,
    Features...>;

}  // namespace impact
