#pragma once
// A baseline for stiff stops, as a user would write it: Runge-Kutta of fourth order that locates every touch and
// release. It is in double on a host and in float for an FPU. Free flight advances by whole steps, or to the root of
// the cubic through a step's penetrations and rates. An elastic impact at the same closing speed would have
// `contact_steps` steps. The scene has Hunt-Crossley, both stops and a sine.

#include <host_ref/report/textbook_methods.hpp>
#include <impact/scene.hpp>

namespace impact::report {

inline float power(float x, float exponent) { return __builtin_powf(x, exponent); }
inline double power(double x, double exponent) { return __builtin_pow(x, exponent); }

template <class Real> class EventRk4 {
  static constexpr Real real(double x) { return static_cast<Real>(x); }

 public:
  EventRk4(const Scene& scene, double step, int contact_steps)
      : by_main_mass_(real(1 / scene.main_mass)),
        by_ball_mass_(real(1 / scene.ball_mass)),
        damping_(real(scene.main_damping)),
        stiffness_(real(scene.main_stiffness)),
        contact_damping_(real(scene.contact_damping)),
        contact_stiffness_(real(scene.contact_stiffness)),
        gap_(real(scene.clearance / 2)),
        amplitude_(real(scene.drive_amplitude)),
        pulsation_(real(scene.drive_pulsation)),
        step_(real(step)),
        depth_(real(1.25 / ((1 / scene.main_mass + 1 / scene.ball_mass) * scene.contact_stiffness))),
        duration_(real(2.943 / contact_steps)) {}

  double displacement() const { return static_cast<double>(now_.x1); }

  void step() {
    constexpr Real least = sizeof(Real) == sizeof(float) ? real(1e-6) : real(1e-12);
    for (Real left = step_; left > least * step_;) {
      const Real longest = side_ == 0 ? step_ : part_, h = longest < left ? longest : left;
      t_ = static_cast<Real>(steps_) * step_ + (step_ - left);
      const State next = advanced(h);
      const int stop = side_ != 0 ? side_ : beyond(next, 1) > 0 ? 1 : beyond(next, -1) > 0 ? -1 : 0;
      const bool changes = stop != 0 && (beyond(next, stop) > 0) != (side_ != 0);
      const Real until = changes ? root(next, stop, h) : h;
      now_ = changes ? advanced(until) : next;
      left -= until;
      if (!changes) continue;
      side_ = side_ == 0 ? stop : 0;
      if (side_ == 0) continue;
      const Real closing = signed_by(stop, now_.v2 - now_.v1), speed = closing > real(1e-9) ? closing : real(1e-9);
      part_ = duration_ * power(depth_ * speed * speed, real(0.4)) / speed;
    }
    ++steps_;
  }

 private:
  struct State {
    Real x1, v1, x2, v2;

    State plus(const State& rate, Real h) const {
      return {x1 + h * rate.x1, v1 + h * rate.v1, x2 + h * rate.x2, v2 + h * rate.v2};
    }
  };

  static Real signed_by(int stop, Real x) { return stop < 0 ? -x : x; }
  Real beyond(const State& s, int stop) const { return signed_by(stop, s.x2 - s.x1) - gap_; }
  template <int side> State rate(const State& s, Real t) const {
    Real force = 0;
    if (const Real depth = side == 0 ? 0 : beyond(s, side); depth > 0) {
      const Real size =
          LibraryRoot::three_halves(depth) * (contact_stiffness_ + contact_damping_ * signed_by(side, s.v2 - s.v1));
      force = size > 0 ? signed_by(side, size) : 0;
    }
    return {s.v1, (amplitude_ * sine(pulsation_ * t) - damping_ * s.v1 - stiffness_ * s.x1 + force) * by_main_mass_,
            s.v2, -force * by_ball_mass_};
  }
  template <int side> State advanced(Real h) const {
    const State a = rate<side>(now_, t_), b = rate<side>(now_.plus(a, h / 2), t_ + h / 2),
                c = rate<side>(now_.plus(b, h / 2), t_ + h / 2), d = rate<side>(now_.plus(c, h), t_ + h);
    const Real sixth = h / 6;
    return {now_.x1 + sixth * (a.x1 + 2 * (b.x1 + c.x1) + d.x1), now_.v1 + sixth * (a.v1 + 2 * (b.v1 + c.v1) + d.v1),
            now_.x2 + sixth * (a.x2 + 2 * (b.x2 + c.x2) + d.x2), now_.v2 + sixth * (a.v2 + 2 * (b.v2 + c.v2) + d.v2)};
  }
  State advanced(Real h) const { return side_ == 0 ? advanced<0>(h) : side_ > 0 ? advanced<1>(h) : advanced<-1>(h); }
  // The instant at which the ball passes the face of the stop on its way to `next`. Newton's method on the cubic starts
  // from a straight line.
  Real root(const State& next, int stop, Real h) const {
    const Real from = beyond(now_, stop), to = beyond(next, stop), displacement = to - from,
               start = h * signed_by(stop, now_.v2 - now_.v1), rise = h * signed_by(stop, next.v2 - next.v1) - start,
               bend = start + (start + rise) - 2 * displacement, bow = displacement - start - bend;
    if ((from > 0) == (to > 0)) return 0;
    Real s = from / (from - to);
    for (int i = 0; i < 4; ++i)
      s -= (from + s * (start + s * (bow + s * bend))) / (start + s * (2 * bow + 3 * s * bend));
    return h * (s < 0 ? 0 : s > 1 ? 1 : s);
  }

  Real by_main_mass_, by_ball_mass_, damping_, stiffness_, contact_damping_, contact_stiffness_, gap_, amplitude_,
      pulsation_, step_;
  Real depth_, duration_;  // of an elastic impact: depth^(5/2) over its speed^2, and duration times speed over depth
  State now_{};
  Real t_ = 0, part_ = 0;
  int32_t steps_ = 0;
  int side_ = 0;  // the stop in contact, 0 while apart
};

}  // namespace impact::report
