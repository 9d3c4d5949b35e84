#pragma once
// The kernel's template behind the run-time interface.

#include <cmath>
#include <cstdlib>
#include <impact/absorber.hpp>
#include <type_traits>

#include "host_ref/any_drive.hpp"
#include "host_ref/energies.hpp"
#include "host_ref/extremes.hpp"
#include "host_ref/simulation.hpp"

namespace impact::host {

// A simulation, or the reason why there is none.
struct Planned {
  std::unique_ptr<Simulation> simulation;
  PlanStatus status = PlanStatus::ok;
};

// Plans with any stepper, drive and parts (simulation_instance.hpp).
template <class Format, class ContactLaw> Planned plan_with_law(const Request& request, const Bounds& bounds);

// The force of the law in double, from a penetration and its rate. The tool prints it with the state.
template <class ContactLaw> double law_force(const Scene& scene, double damping, double penetration, double rate) {
  const double shape = ContactLaw::is_linear ? 1 : penetration * std::sqrt(penetration);
  const double elastic = scene.contact_stiffness * (ContactLaw::is_linear ? penetration : shape);
  return elastic + damping * shape * rate;
}

// The kernel's ledger, with the work of the drive if it is requested.
struct Ledger : EnergyLedger {
  template <class Format> struct State : EnergyLedger::State<Format> { bool counts_drive_work; };
  template <class Plan, class State> static constexpr void after_step(const Plan& plan, State& state) {
    if (state.counts_drive_work) EnergyLedger::after_step(plan, state);
  }
};

// SubsteppedMoment<n> for any n, so that all n share a kernel. A plan is made by static functions, so what depends on n
// belongs to the thread that makes one.
struct AnySubsteppedMoment : SubsteppedMoment<> {
  static inline thread_local int (*parts_of_named)(const Resolution&, double) = nullptr;
  static inline thread_local Range (*steps_of_named)(const Resolution&) = nullptr;

  static int parts_for(const Resolution& contact, double step) { return parts_of_named(contact, step); }
  static Range steps(const Resolution& contact) { return steps_of_named(contact); }
};
// Likewise a classical scheme for any beta.
struct BetaOfNamed {
  static inline thread_local double of_named = 0;
  static inline thread_local uint32_t kind = 0;
  static inline thread_local double longest_phase = 0;

  static double value() { return of_named; }
};
// The stepper of the kernel that serves a named one.
template <class Stepper> Stepper serving(Stepper stepper) { return stepper; }
template <class Beta> Newmark<BetaOfNamed> serving(Newmark<Beta>) {
  BetaOfNamed::of_named = Beta::value();
  BetaOfNamed::kind = Beta::kind;
  BetaOfNamed::longest_phase = Beta::longest_phase;
  return {};
}
template <int n> AnySubsteppedMoment serving(SubsteppedMoment<n>) {
  AnySubsteppedMoment::parts_of_named = SubsteppedMoment<n>::parts_for;
  AnySubsteppedMoment::steps_of_named = SubsteppedMoment<n>::steps;
  return {};
}

template <class Format, class ContactLaw, class Stepper, class Drive, class... Parts>
class KernelSimulation final : public Simulation {
 public:
  using Kernel = Absorber<AtRunTime, ContactLaw, Stepper, Drive, Format, Ledger, ImpactLog, ContactForce, Parts...>;

  KernelSimulation(const Request& request, const typename Kernel::PlanType& plan)
      : scene_(request.scene),
        step_(request.step),
        position_unit_(constant::power_of_two(position_exponent(plan) - 63)),
        is_sampled_(request.drive == DriveKind::sampled),
        kernel_(plan) {
    auto start = kernel_.save();
    start.state.counts_drive_work = request.counts_drive_work;
    kernel_.restore(start);
  }

  void step(double force, double base) override {
    double x1 = 0;
    run(1, &force, &x1, &base);
  }

  // Not inlined into step(): it is the whole kernel.
  [[gnu::noinline]] long run(long steps, const double* forces, double* x1, const double* base) override {
    for (long n = 0; n < steps; ++n) {
      advance(forces ? forces[n] : 0, base ? base[n] : 0);
      if (kernel_.fault() != Fault::none) return n;
      x1[n] = displacement();
    }
    return steps;
  }

  Reached reached_in(long steps, const double* forces, const double* base, const Bounds& bounds) override {
    Reached reached;
    for (long n = 0;; ++n) {
      const auto now = kernel_.reading();
      reached.see(now.x1, now.v1, now.x2, now.v2, penetration(now.x2 - now.x1), kernel_.impact_speed());
      if (n == steps || !reached.is_within(bounds) || fault()) return reached;
      advance(forces ? forces[n] : 0, base ? base[n] : 0);
    }
  }

  Sample sample() const override { return sample_of(kernel_.reading()); }
  Sample state() const override { return sample_of(motion_of_state(kernel_)); }

  const char* fault() const override {
    switch (kernel_.fault()) {
      case Fault::none:
        return nullptr;
      case Fault::sample:
        return "a sample of the drive or of the base beyond its bound";
      case Fault::displacement:
        return displacement_fault.data();
      case Fault::speed:
        return speed_fault.data();
      case Fault::penetration:
        return penetration_fault.data();
      case Fault::plan:  // impossible, since no simulation is made from a rejected plan
        return "a plan that was refused";
    }
    return nullptr;
  }

 private:
  Sample sample_of(const typename Kernel::Reading& now) const {
    const auto& state = kernel_.state();
    const auto& plan = kernel_.plan;
    const double side = state.at_left ? -1 : 1;
    const double pair_unit = plan.force_scale * plan.units.si_penetration_unit();
    Sample sample{static_cast<double>(steps_) * step_, now.x1, now.v1, now.x2, now.v2, penetration(now.x2 - now.x1)};
    if (has_impulse_) {
      sample.contact_force = std::abs(plan.units.fraction(kernel_.contact_force())) * plan.force_unit();
    } else if (kernel_.is_touching()) {
      // With a classical scheme, a force of Hooke-Newton may act at the end of a step that ends just outside.
      const double depth = ContactLaw::is_linear ? sample.penetration : larger(sample.penetration, 0.0);
      sample.contact_force = law_force<ContactLaw>(scene_, damping(), depth, side * (now.v2 - now.v1));
      if (scene_.tension == Tension::clamp || !ContactLaw::is_linear)
        sample.contact_force = larger(sample.contact_force, 0.0);
    }
    sample.energy_dissipated = state.dissipated.total() * pair_unit;
    if (kernel_.is_touching()) sample.energy_stored = plan.units.fraction(state.stored) * pair_unit;
    sample.drive_work = state.drive_work.total() * plan.drive_scale * plan.units.si_penetration_unit();
    if constexpr (Kernel::Friction::is_friction) sample.friction_dissipated = kernel_.friction_dissipated();
    sample.impacts = static_cast<long>(state.impacts);
    sample.impact_speed = kernel_.impact_speed();
    sample.peak_force = kernel_.peak_force();
    return sample;
  }

  // The penetration from x2 - x1, of the stop that is touched, if any.
  double penetration(double y) const {
    const double gap = scene_.clearance / 2;
    if (!has_impulse_ && kernel_.is_touching()) return (kernel_.state().at_left ? -1 : 1) * y - gap;
    if (scene_.stops == Stops::none) return -gap;
    return scene_.stops == Stops::right ? y - gap : scene_.stops == Stops::left ? -y - gap : std::abs(y) - gap;
  }

  void advance([[maybe_unused]] double force, [[maybe_unused]] double base) {
    if constexpr (Drive::is_sampled && Kernel::Field::is_sampled)
      kernel_.step(kernel_.sample_of(is_sampled_ ? force : 0), kernel_.base_sample_of(base));
    else if constexpr (Drive::is_sampled)
      kernel_.step(kernel_.sample_of(is_sampled_ ? force : 0));
    else if constexpr (Kernel::Field::is_sampled)
      kernel_.step(kernel_.base_sample_of(base));
    else
      kernel_.step();
    ++steps_;
  }

  static int position_exponent(const typename Kernel::PlanType& plan) {
    if constexpr (std::is_same_v<Format, Fixed32>)
      return plan.units.position_exponent;
    else
      return 0;
  }
  // The same as reading().x1, without computing its unit at every step.
  double displacement() const {
    if constexpr (Kernel::Contact::traits.is_instantaneous) return kernel_.reading().x1;
    const auto x1 = Kernel::Field::position(kernel_.plan, kernel_.state(), kernel_.state().x1);
    if constexpr (std::is_same_v<Format, Fixed32>)
      return static_cast<double>(x1.raw - Format::Units::half_lsb) * position_unit_;
    else
      return kernel_.plan.units.si_at(x1);
  }

  double damping() const {
    if constexpr (ContactLaw::is_damped_per_impact) {
      const double v0 = kernel_.impact_speed();
      return v0 > 0 ? damping_ratio_ * scene_.contact_stiffness / v0 : 0;
    }
    return ContactLaw::is_damped ? scene_.contact_damping : 0;
  }

  Scene scene_;
  double step_, position_unit_;
  bool is_sampled_;
  // Only the impulse of a contact is known, not its force.
  bool has_impulse_ = Kernel::Contact::traits.is_instantaneous || scene_.ball_friction > 0;
  double damping_ratio_ = impact::damping_ratio<ContactLaw>(scene_);
  Kernel kernel_;
  long steps_ = 0;
};

template <class Format, class ContactLaw, class Stepper, class Drive, class... Parts>
Planned plan_for(const Request& request, const Bounds& bounds) {
  using Run = KernelSimulation<Format, ContactLaw, Stepper, Drive, Parts...>;
  const auto plan = Run::Kernel::PlanType::make(request.scene, bounds, request.step);
  if (plan.status != PlanStatus::ok) return {nullptr, plan.status};
  return {std::make_unique<Run>(request, plan), PlanStatus::ok};
}

#define IMPACT_CHECK_ORDER(value, name, Type)                                                                      \
  static_assert(is_classical(Stepper::value) == Type::template Contact<Float64, HuntCrossley>::traits.keeps_force, \
                "the classical schemes are the first of IMPACT_STEPPERS");
IMPACT_STEPPERS(IMPACT_CHECK_ORDER)
#undef IMPACT_CHECK_ORDER

// The result of `found` for the kernel's type of the request's law. `Exact` serves all laws that set the damping at
// each impact, because make_simulation first computes the restitution that the law leads to.
template <class Found> auto by_law(const Request& request, const Found& found) {
  if (request.law == Law::hunt_crossley && request.damping != Damping::constant) return found(Exact{});
  switch (request.law) {
#define IMPACT_FOUND(value, name, Type) \
  case Law::value:                      \
    return found(Type{});
    IMPACT_LAWS(IMPACT_FOUND)
#undef IMPACT_FOUND
  }
  std::abort();
}

template <class Format> Planned plan_simulation(const Request& request, const Bounds& bounds) {
  return by_law(request, [&](auto law) { return plan_with_law<Format, decltype(law)>(request, bounds); });
}

}  // namespace impact::host
