#pragma once
// Methods that one would write today for a microcontroller, from a textbook and with the C library. They are the
// baselines of the report. One source runs on the host and on the emulated targets.
//
//     TextbookNewmark   average acceleration (gamma = 1/2, beta = 1/4) in acceleration form; in contact Newton's method
//                       on both masses, until the correction is below `converged` of the acceleration
//     TextbookRk4       the classical Runge-Kutta method; each stage has the force of its own penetration
//     TunedRk4          the same with a sine that turns by w h/2 twice per step, instead of the library's. With
//                       y sqrt(y) it is the strongest simple baseline
//
// The others evaluate the drive by the library's sine. The power delta^(3/2) is a policy.

#include <stdint.h>

#include <impact/numeric/square_root.hpp>
#include <impact/scene.hpp>

namespace impact {

// y^(3/2) = y sqrt(y) in one function, with the kernel's table of square roots. The relative error is at most 2^-27 +
// 2^-24 + 2^-29 for every float from 2^-84 to 2^(256/3). A larger y never has a smaller result. Above that range, and
// for infinity, the result is FLT_MAX. Below, and for y < 0 and a NaN, it is 0.
inline float power_three_halves(float y) {
  constexpr uint32_t lowest = 0x15800000, highest = 0x6a214517, infinity = 0x7f800000, largest = 0x7f7fffff;
  const uint32_t bits = bits_of(y);
  if (bits - lowest > highest - lowest) return bits >= lowest && bits <= infinity ? float_of(largest) : 0;

  const uint32_t exponent = bits >> 23, u = bits << 8 | 0x80000000u;  // y = u 2^(exponent - 158)
  const uint32_t root = square_root_table.root(u >> (exponent & 1));
  const uint32_t product = high_product(u, root), carry = product >> 31;  // product in [2^30, 2^32)
  const uint32_t power_exponent = exponent + ((exponent + 1) >> 1) + carry - 65;
  return float_of((power_exponent << 23) + (((product >> (6 + carry)) + 1) >> 1));
}

namespace report {

// Functions of the C library, as builtins, because an image has no C headers.
inline float sine(float x) { return __builtin_sinf(x); }
inline double sine(double x) { return __builtin_sin(x); }
inline float power(float x, float exponent) { return __builtin_powf(x, exponent); }
inline double power(double x, double exponent) { return __builtin_pow(x, exponent); }

struct LibraryPower {
  static float three_halves(float y) { return __builtin_powf(y, 1.5f); }
  static double three_halves(double y) { return __builtin_pow(y, 1.5); }
};
struct LibraryRoot {
  static float three_halves(float y) { return y * __builtin_sqrtf(y); }
  static double three_halves(double y) { return y * __builtin_sqrt(y); }
};
struct KernelLookup {
  static float three_halves(float y) { return power_three_halves(y); }
  static double three_halves(double y) { return y * __builtin_sqrt(y); }
};

// A Rig has a scene and a step, like the kernel's. The scene has a constant c1, both stops, and a clamped force.
template <class Real, class Rig, Law law, class Power> class TextbookModel {
 public:
  bool is_touching() const { return touching_; }
  double displacement() const { return static_cast<double>(x1_); }

 protected:
  static constexpr Real real(double x) { return static_cast<Real>(x); }
  static constexpr Scene scene = Rig::scene;
  static constexpr Real h = real(Rig::step), main_mass = real(scene.main_mass), ball_mass = real(scene.ball_mass),
                        k = real(scene.main_stiffness), c = real(scene.main_damping),
                        k1 = real(scene.contact_stiffness), c1 = real(scene.contact_damping),
                        gap = real(scene.clearance / 2);

  struct Force {
    Real force, by_penetration, by_rate;  // Fc and its derivatives
  };
  static Force contact(Real penetration, Real rate) {
    Force f{};
    if (law == Law::hooke_newton) {
      f = {k1 * penetration + c1 * rate, k1, c1};
    } else {
      const Real power = Power::three_halves(penetration);
      const Real factor = law == Law::hertz ? k1 : k1 + c1 * rate;
      f = {power * factor, real(1.5) * power / penetration * factor, law == Law::hertz ? 0 : power * c1};
    }
    return f.force > 0 ? f : Force{};
  }
  static Real drive(Real t) { return real(scene.drive_amplitude) * sine(real(scene.drive_pulsation) * t); }

  Real x1_ = real(scene.x1), v1_ = real(scene.v1), x2_ = real(scene.x2), v2_ = real(scene.v2);
  uint32_t steps_ = 0;
  bool touching_ = false;
};

template <class Real, class Rig, Law law, class Power>
class TextbookNewmark : public TextbookModel<Real, Rig, law, Power> {
  using Model = TextbookModel<Real, Rig, law, Power>;
  using Model::c, Model::gap, Model::h, Model::k, Model::main_mass, Model::ball_mass, Model::real;
  using Model::steps_, Model::touching_, Model::v1_, Model::v2_, Model::x1_, Model::x2_;

 public:
  void step() {
    constexpr Real by_position = h * h / 4, by_velocity = h / 2;
    constexpr Real effective_mass = main_mass + by_velocity * c + by_position * k;
    constexpr Real converged = real(1e-6);
    const Real force = Model::drive(static_cast<Real>(++steps_) * h);
    const Real p1 = x1_ + h * v1_ + by_position * a1_, q1 = v1_ + by_velocity * a1_;
    const Real p2 = x2_ + h * v2_ + by_position * a2_, q2 = v2_ + by_velocity * a2_;
    const Real load = force - c * q1 - k * p1;
    a1_ = load / effective_mass;
    a2_ = 0;

    const Real apart = p2 - p1 - by_position * a1_;
    const Real side = apart < 0 ? Real{-1} : Real{1};
    touching_ = side * apart > gap;
    for (int iteration = 0; touching_ && iteration < 10; ++iteration) {
      const Real penetration = side * (p2 - p1 + by_position * (a2_ - a1_)) - gap;
      const Real rate = side * (q2 - q1 + by_velocity * (a2_ - a1_));
      if (penetration <= 0) break;
      const auto f = Model::contact(penetration, rate);
      const Real residual1 = load + side * f.force - effective_mass * a1_;
      const Real residual2 = -side * f.force - ball_mass * a2_;
      const Real stiffness = by_position * f.by_penetration + by_velocity * f.by_rate;
      const Real determinant = effective_mass * ball_mass + stiffness * (effective_mass + ball_mass);
      const Real change1 = ((ball_mass + stiffness) * residual1 + stiffness * residual2) / determinant;
      const Real change2 = ((effective_mass + stiffness) * residual2 + stiffness * residual1) / determinant;
      a1_ += change1;
      a2_ += change2;
      if (size(change1) + size(change2) <= converged * (size(a1_) + size(a2_))) break;
    }
    x1_ = p1 + by_position * a1_;
    v1_ = q1 + by_velocity * a1_;
    x2_ = p2 + by_position * a2_;
    v2_ = q2 + by_velocity * a2_;
  }

 private:
  static Real size(Real x) { return x < 0 ? -x : x; }

  Real a1_ = -(c * v1_ + k * x1_) / main_mass, a2_ = 0;
};

template <class Real, class Rig, Law law, class Power> class RungeKutta : public TextbookModel<Real, Rig, law, Power> {
  using Model = TextbookModel<Real, Rig, law, Power>;
  using Model::c, Model::gap, Model::k, Model::main_mass, Model::ball_mass;
  using Model::touching_, Model::v1_, Model::v2_, Model::x1_, Model::x2_;

 protected:
  using Model::h, Model::real;

  // The drive's force at the start, the middle and the end of the step.
  void advance(Real force, Real middle, Real last) {
    touching_ = false;
    const State start = {x1_, v1_, x2_, v2_};
    const State s1 = slope(force, start);
    const State s2 = slope(middle, moved(start, h / 2, s1));
    const State s3 = slope(middle, moved(start, h / 2, s2));
    const State s4 = slope(last, moved(start, h, s3));
    constexpr Real sixth = h / 6;
    x1_ += sixth * (s1.x1 + 2 * (s2.x1 + s3.x1) + s4.x1);
    v1_ += sixth * (s1.v1 + 2 * (s2.v1 + s3.v1) + s4.v1);
    x2_ += sixth * (s1.x2 + 2 * (s2.x2 + s3.x2) + s4.x2);
    v2_ += sixth * (s1.v2 + 2 * (s2.v2 + s3.v2) + s4.v2);
  }

 private:
  struct State {
    Real x1, v1, x2, v2;
  };
  static State moved(const State& s, Real by, const State& slope) {
    return {s.x1 + by * slope.x1, s.v1 + by * slope.v1, s.x2 + by * slope.x2, s.v2 + by * slope.v2};
  }
  State slope(Real drive, const State& s) {
    const Real apart = s.x2 - s.x1, side = apart < 0 ? Real{-1} : Real{1}, penetration = side * apart - gap;
    Real force = 0;
    if (penetration > 0) {
      touching_ = true;
      force = side * Model::contact(penetration, side * (s.v2 - s.v1)).force;
    }
    constexpr Real per_main_mass = 1 / main_mass, per_ball_mass = 1 / ball_mass;
    return {s.v1, (drive + force - c * s.v1 - k * s.x1) * per_main_mass, s.v2, -force * per_ball_mass};
  }
};

template <class Real, class Rig, Law law, class Power> class TextbookRk4 : public RungeKutta<Real, Rig, law, Power> {
  using Model = TextbookModel<Real, Rig, law, Power>;
  using Model::h, Model::steps_;

 public:
  void step() {
    const Real t = static_cast<Real>(steps_++) * h;
    this->advance(Model::drive(t), Model::drive(t + h / 2), Model::drive(t + h));
  }
};

template <class Real, class Rig, Law law, class Power> class TunedRk4 : public RungeKutta<Real, Rig, law, Power> {
  using Model = TextbookModel<Real, Rig, law, Power>;

 public:
  void step() {
    const Phasor middle = turned(drive_), last = turned(middle);
    this->advance(drive_.sine, middle.sine, last.sine);
    drive_ = last;
  }

 private:
  struct Phasor {
    Real sine, cosine;
  };
  // Turns by the angle a. It adds an increment with 1 - cos a, so that the rounding is that of a small number.
  Phasor turned(const Phasor& p) const {
    return {p.sine + (p.cosine * sine_ - p.sine * versine_), p.cosine - (p.sine * sine_ + p.cosine * versine_)};
  }

  static constexpr Real angle = Model::real(Model::scene.drive_pulsation * Rig::step / 2);
  const Real sine_ = sine(angle), versine_ = 2 * sine(angle / 2) * sine(angle / 2);
  Phasor drive_ = {0, Model::real(Model::scene.drive_amplitude)};  // N
};

// A baseline for stiff stops, as a user would write it: Runge-Kutta of fourth order that locates every touch and
// release. It is in double on a host and in float for an FPU. Free flight advances by whole steps, or to the root of
// the cubic through a step's penetrations and rates. An elastic impact at the same closing speed would have
// `contact_steps` steps. The scene has Hunt-Crossley, both stops and a sine.
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

  struct Reading {
    double x1;
  };
  Reading reading() const { return {static_cast<double>(now_.x1)}; }

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

}  // namespace report
}  // namespace impact
