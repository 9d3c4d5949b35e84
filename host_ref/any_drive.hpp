#pragma once
// The tool's drive: a sine if the scene has a pulsation, and samples if it has none. Each kernel is therefore compiled
// only once. Every bit is that of Sine or of Sampled.

#include <impact/motion/no_drive.hpp>
#include <impact/motion/sampled.hpp>
#include <impact/motion/sine.hpp>

namespace impact::host {

struct AnyDrive : NoDrive {  // has the PlanChange of NoDrive, since the tool changes no plan while it runs
  static constexpr bool is_sine = false, is_sampled = true;  // step() takes a sample; a sine does not look at it

  template <class Format> struct Plan : Sampled::Plan<Format> {
    Sine::Plan<Format> sine;
    bool is_sine;
  };
  static constexpr bool is_sine_in(const Scene& scene) { return scene.drive_pulsation > 0; }

  static constexpr double largest(const Scene& scene, const Bounds& bounds) {
    return is_sine_in(scene) ? Sine::largest(scene, bounds) : Sampled::largest(scene, bounds);
  }
  static constexpr double at_start(const Scene& scene, const LinearFlow& flow) {
    return is_sine_in(scene) ? Sine::at_start(scene, flow) : Sampled::at_start(scene, flow);
  }
  static constexpr double largest_at_once(const Scene& scene, const Bounds& bounds, const LinearFlow& flow) {
    return is_sine_in(scene) ? Sine::largest_at_once(scene, bounds, flow)
                             : Sampled::largest_at_once(scene, bounds, flow);
  }
  template <class Format> static constexpr double force_unit(const Scene& scene, const Bounds& bounds) {
    return is_sine_in(scene) ? Sine::force_unit<Format>(scene, bounds) : Sampled::force_unit<Format>(scene, bounds);
  }
  template <class Format>
  static constexpr Plan<Format> make_plan(const Scene& scene, const Bounds& bounds, double h, const LinearFlow& flow,
                                          const UnitExponents& unit) {
    if (is_sine_in(scene)) return {{}, Sine::make_plan<Format>(scene, bounds, h, flow, unit), true};
    return {Sampled::make_plan<Format>(scene, bounds, h, flow, unit), {}, false};
  }

  template <class Format> struct State : Sampled::State<Format> {
    using Value = typename Format::Value;
    using Samples = Sampled::State<Format>;
    Sine::State<Format> sine;

    static constexpr State start(const Plan<Format>& plan) {
      return {Samples::start(plan), Sine::State<Format>::start(plan.sine)};
    }
    constexpr bool accepts(const Plan<Format>& plan, Value next) const {
      return plan.is_sine || Samples::accepts(plan, next);
    }
    constexpr Increment<Value> at_once(const Plan<Format>& plan, Value next) const {
      return plan.is_sine ? Increment<Value>{} : Samples::at_once(plan, next);
    }
    constexpr Increment<Value> advance(const Plan<Format>& plan, Value next) {
      return plan.is_sine ? sine.advance(plan.sine) : Samples::advance(plan, next);
    }
    constexpr Penetration<Value> rate(const Plan<Format>& plan) const {
      return plan.is_sine ? sine.rate(plan.sine) : Samples::rate(plan);
    }
    constexpr DriveChange<Value> change(const Plan<Format>& plan, impact::Sample<Value> last) const {
      return plan.is_sine ? sine.change(plan.sine, {}) : Samples::change(plan, last);
    }
    constexpr Value force(const Plan<Format>& plan) const {
      return plan.is_sine ? sine.force(plan.sine) : Samples::force(plan);
    }
  };
};

}  // namespace impact::host
