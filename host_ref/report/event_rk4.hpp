#pragma once
// A baseline for stiff stops: Runge-Kutta of fourth order in double that locates every touch and release, what a user
// would write on a host. Free flight in whole steps, or to the root of the cubic through a step's penetrations and
// rates; a contact in `contact_steps` parts of what an elastic impact at its closing speed lasts. Hunt-Crossley, both
// stops, a sine.

#include <algorithm>
#include <cmath>
#include <impact/scene.hpp>

namespace impact::report {

class EventRk4 {
 public:
  EventRk4(const Scene& scene, double step, int contact_steps)
      : scene_(scene),
        by_main_mass_(1 / scene.main_mass),
        by_ball_mass_(1 / scene.ball_mass),
        step_(step),
        contact_steps_(contact_steps) {}

  double displacement() const { return now_.x1; }

  void step() {
    const double end = static_cast<double>(++steps_) * step_;
    while (end - t_ > 1e-12 * step_) {
      const double h = std::min(end - t_, side_ == 0 ? step_ : part_);
      const State next = advanced(h);
      const int stop = side_ != 0 ? side_ : beyond(next, 1) > 0 ? 1 : beyond(next, -1) > 0 ? -1 : 0;
      const bool changes = stop != 0 && (beyond(next, stop) > 0) != (side_ != 0);
      const double until = changes ? root(next, stop, h) : h;
      now_ = changes ? advanced(until) : next;
      t_ += until;
      if (!changes) continue;
      side_ = side_ == 0 ? stop : 0;
      if (side_ == 0) continue;
      const double speed = std::max(1e-9, stop * (now_.v2 - now_.v1)),
                   depth = std::pow(1.25 * speed * speed / ((by_main_mass_ + by_ball_mass_) * scene_.contact_stiffness),
                                    0.4);
      part_ = 2.943 * depth / speed / contact_steps_;
    }
  }

 private:
  struct State {
    double x1, v1, x2, v2;

    State plus(const State& rate, double h) const {
      return {x1 + h * rate.x1, v1 + h * rate.v1, x2 + h * rate.x2, v2 + h * rate.v2};
    }
  };

  double beyond(const State& s, int stop) const { return stop * (s.x2 - s.x1) - scene_.clearance / 2; }
  template <int side>
  State rate(const State& s, double t) const {
    double force = 0;
    if (const double depth = side == 0 ? 0 : beyond(s, side); depth > 0)
      force = side * std::max(0.0, depth * std::sqrt(depth) *
                                       (scene_.contact_stiffness + scene_.contact_damping * side * (s.v2 - s.v1)));
    return {s.v1,
            (scene_.drive_amplitude * std::sin(scene_.drive_pulsation * t) - scene_.main_damping * s.v1 -
             scene_.main_stiffness * s.x1 + force) *
                by_main_mass_,
            s.v2, -force * by_ball_mass_};
  }
  template <int side>
  State advanced(double h) const {
    const State a = rate<side>(now_, t_), b = rate<side>(now_.plus(a, h / 2), t_ + h / 2),
                c = rate<side>(now_.plus(b, h / 2), t_ + h / 2), d = rate<side>(now_.plus(c, h), t_ + h);
    const double sixth = h / 6;
    return {now_.x1 + sixth * (a.x1 + 2 * (b.x1 + c.x1) + d.x1), now_.v1 + sixth * (a.v1 + 2 * (b.v1 + c.v1) + d.v1),
            now_.x2 + sixth * (a.x2 + 2 * (b.x2 + c.x2) + d.x2), now_.v2 + sixth * (a.v2 + 2 * (b.v2 + c.v2) + d.v2)};
  }
  State advanced(double h) const { return side_ == 0 ? advanced<0>(h) : side_ > 0 ? advanced<1>(h) : advanced<-1>(h); }
  // When the stop's surface is passed on the way to `next`: Newton's method on the cubic, begun on the chord.
  double root(const State& next, int stop, double h) const {
    const double from = beyond(now_, stop), to = beyond(next, stop), way = to - from,
                 start = h * stop * (now_.v2 - now_.v1), rise = h * stop * (next.v2 - next.v1) - start,
                 bend = start + (start + rise) - 2 * way, bow = way - start - bend;
    if ((from > 0) == (to > 0)) return 0;
    double s = from / (from - to);
    for (int i = 0; i < 4; ++i)
      s -= (from + s * (start + s * (bow + s * bend))) / (start + s * (2 * bow + 3 * s * bend));
    return h * std::clamp(s, 0.0, 1.0);
  }

  Scene scene_;
  double by_main_mass_, by_ball_mass_, step_;
  int contact_steps_;
  State now_{};
  double t_ = 0, part_ = 0;
  long steps_ = 0;
  int side_ = 0;  // the stop in contact, 0 while apart
};

}  // namespace impact::report
