#include "host_ref/reference.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "host_ref/extremes.hpp"

namespace impact::host {
namespace {

using Real = long double;
constexpr Real real(double x) { return static_cast<Real>(x); }

// A function on a window of time that is scaled to [0, 1], as a Taylor series about the start of the window.
constexpr int order = 30;
using Series = Eigen::Matrix<Real, order + 1, 1>;
using SeriesOrColumn = Eigen::Ref<const Series>;

Real value(const SeriesOrColumn& p, Real s) {
  Real sum = 0;
  for (int k = order; k >= 0; --k) sum = sum * s + p[k];
  return sum;
}

Series derivative(const SeriesOrColumn& p) {
  Series result = Series::Zero();
  for (int k = 0; k < order; ++k) result[k] = static_cast<Real>(k + 1) * p[k + 1];
  return result;
}

// Coefficient k of a product, from the coefficients up to k of its factors.
Real product(const SeriesOrColumn& p, const SeriesOrColumn& q, int k) {
  Real sum = 0;
  for (int i = 0; i <= k; ++i) sum += p[i] * q[k - i];
  return sum;
}

// The first s in [0, end] at which p rises through zero. A bound on |p''| gives a parabola above p. The search advances
// to the zero of that parabola. It cannot pass a root, and near one it converges quadratically. A positive p that falls
// is the rounding of an event that has just happened. Most windows have no event, as the sum of the coefficients shows.
std::optional<Real> first_rise(Series p, Real end) {
  if (p[0] >= 0 && p[1] > 0) return Real{0};
  if (end <= 1 && p[0] + p.tail(order).cwiseAbs().sum() < 0) return std::nullopt;
  p[0] = std::min(p[0], Real{0});
  const Series slope = derivative(p);
  const Real curvature = derivative(slope).cwiseAbs().sum();
  constexpr Real least_advance = 0x1p-60L;
  for (Real s = 0; s <= end;) {
    const Real height = value(p, s), rate = value(slope, s);
    if (s > 0 && height >= 0) return s;
    if (curvature <= 0 && rate <= 0) return std::nullopt;
    const Real root = std::sqrt(rate * rate - 2 * curvature * height);
    s += std::max(rate > 0 ? -2 * height / (rate + root) : (root - rate) / curvature, least_advance);
  }
  return std::nullopt;
}

// A window is a fraction of the fastest vibration, so that it contains at most one maximum inside.
Real largest(const SeriesOrColumn& p, Real end) {
  const Real at_ends = std::max(value(p, 0), value(p, end));
  const auto peak = first_rise(-derivative(p), end);
  return peak ? std::max(at_ends, value(p, *peak)) : at_ends;
}

// The state z: x1, v1, y and y' of the ball relative to the main mass, the drive's F and its partner G, the field's
// acceleration and its slope, and the sign of y'. For a sine F' = w G and G' = -w F, for a sampled drive F' = G.
constexpr int size = 9;
using Vector = Eigen::Matrix<Real, size, 1>;
using Generator = Eigen::Matrix<Real, size, size>;

// z' = A z over windows of 0.75 rad of the fastest mode, or 0.94 rad with the coarser tolerance. There 20 terms of the
// series of exp(A t) z are more than rounding requires: 0.94^21/21! is 6e-21. The tolerance determines the window like
// a Taylor step, so that runs with two tolerances differ in their rounding too.
class LinearFlow {
 public:
  static constexpr int terms = 20;

  LinearFlow(const Generator& generator, Real tolerance) {
    const Real radians = 0.75L * std::pow(tolerance / real(reference_tolerance), Real{1} / order);
    const Eigen::Matrix<double, size, size> rounded = generator.cast<double>();
    window_ = radians / real(std::max(1.0, rounded.eigenvalues().cwiseAbs().maxCoeff()));
    scaled_ = (generator * window_).sparseView();
  }

  Real window() const { return window_; }

  // The series of each component of z on the window, one per column.
  using Columns = Eigen::Matrix<Real, order + 1, size>;
  void expand(const Vector& z, Columns& result) const {
    Vector term = z;
    result.row(0) = term;
    for (int k = 1; k <= terms; ++k) {
      const Vector next = scaled_ * term;
      term = next * (1 / static_cast<Real>(k));
      result.row(k) = term;
    }
  }

 private:
  Real window_ = 0;
  Eigen::SparseMatrix<Real> scaled_;  // a fourth of it is not 0
};

// The scene in the arithmetic of the reference.
struct Constants {
  Scene scene;
  Real M = real(scene.main_mass), k = real(scene.main_stiffness), c = real(scene.main_damping),
       m = real(scene.ball_mass), half_clearance = real(scene.clearance) / 2, k1 = real(scene.contact_stiffness),
       F0 = real(scene.drive_amplitude), pulsation = real(scene.drive_pulsation), gravity = real(scene.gravity),
       friction = real(scene.ball_friction);
};

void add_inputs(Generator& a, const Constants& scene, DriveKind drive) {
  a(1, 6) = 1;  // the field, which does not change the relative motion
  a(6, 7) = 1;
  if (drive == DriveKind::sine) {
    a(4, 5) = scene.pulsation;
    a(5, 4) = -scene.pulsation;
  } else if (drive == DriveKind::sampled) {
    a(4, 5) = 1;
  }
}

Generator generator(const Constants& scene, DriveKind drive, Real k1, Real c1) {
  Generator a = Generator::Zero();
  a(0, 1) = 1;
  a.row(1).head(6) << -scene.k / scene.M, -scene.c / scene.M, k1 / scene.M, c1 / scene.M, 1 / scene.M, 0;
  a(1, 8) = scene.friction / scene.M;
  a(2, 3) = 1;
  a.row(3) = -a.row(1);
  a(3, 2) -= k1 / scene.m;
  a(3, 3) -= c1 / scene.m;
  a(3, 8) -= scene.friction / scene.m;
  add_inputs(a, scene, drive);
  return a;
}

// Both masses as one.
Generator sticking_generator(const Constants& scene, DriveKind drive) {
  Generator a = Generator::Zero();
  const Real mass = scene.M + scene.m;
  a(0, 1) = 1;
  a.row(1).head(6) << -scene.k / mass, -scene.c / mass, 0, 0, 1 / mass, 0;
  add_inputs(a, scene, drive);
  return a;
}

// Samples of a drive or of the base: linear between them, and the last one after them. Without samples it is 0.
class LinearSamples {
 public:
  LinearSamples(const std::vector<double>& samples, double step, Real start = 0)
      : samples_(samples),
        step_(real(step)),
        segment_(samples.empty()
                     ? 0
                     : static_cast<size_t>(std::clamp(start / step_, Real{0}, static_cast<Real>(samples.size() - 1)))) {
  }

  // The end of the segment that t is in. It does not go back to an earlier one.
  Real end_of_segment(Real t) {
    while (!is_last() && end() <= t) ++segment_;
    return is_last() ? std::numeric_limits<Real>::infinity() : end();
  }
  // The value at t and the slope there, of the present segment.
  std::pair<Real, Real> at(Real t) const {
    if (samples_.empty()) return {0, 0};
    const Real before = real(samples_[segment_]);
    if (is_last()) return {before, 0};
    const Real slope = (real(samples_[segment_ + 1]) - before) / step_;
    return {before + slope * (t - static_cast<Real>(segment_) * step_), slope};
  }

 private:
  bool is_last() const { return segment_ + 1 >= samples_.size(); }
  Real end() const { return static_cast<Real>(segment_ + 1) * step_; }

  const std::vector<double>& samples_;
  Real step_;
  size_t segment_;
};

}  // namespace

double drive_force(const Case& run, double t) {
  switch (run.drive) {
    case DriveKind::none:
      return 0;
    case DriveKind::sine:
      return run.scene.drive_amplitude * std::sin(run.scene.drive_pulsation * t);
    case DriveKind::sampled:
      return static_cast<double>(LinearSamples(run.samples, run.sample_step, real(t)).at(real(t)).first);
  }
  return 0;
}

double base_acceleration(const Case& run, double t) {
  return static_cast<double>(LinearSamples(run.base_samples, run.base_step, real(t)).at(real(t)).first);
}

Case case_of(const Request& request) {
  Case run{request.law, request.scene, request.drive, request.samples, request.step};
  run.damping_ratio = damping_ratio(request.damping, request.scene.restitution).value();
  run.base_samples = request.base_samples;
  run.base_step = request.step;
  for (auto* samples : {&run.samples, &run.base_samples})
    if (!samples->empty()) samples->insert(samples->begin(), 0);
  return run;
}

class Reference::Motion {
 public:
  Motion(const Case& run, Real tolerance)
      : run_(run),
        scene_{run.scene},
        drive_samples_(run_.samples, run_.sample_step),
        base_samples_(run_.base_samples, run_.base_step),
        tolerance_(tolerance),
        c1_(run.law == Law::hertz ? 0 : real(run.scene.contact_damping)),
        apart_flow_(generator(scene_, run.drive, 0, 0), tolerance) {
    if (scene_.friction > 0) sticking_flow_.emplace(sticking_generator(scene_, run.drive), tolerance);
    if (linear_contact()) contact_flow_.emplace(generator(scene_, run.drive, scene_.k1, c1_), tolerance);
    now_.x1 = real(run.scene.x1);
    now_.v1 = real(run.scene.v1);
    now_.y = real(run.scene.x2) - now_.x1;
    now_.rate = real(run.scene.v2) - now_.v1;
    for (const int side : {-1, 1}) {
      if (!has_stop(side) || penetration(side) <= 0) continue;
      side_ = side;
      phase_ = clamped() && law_force() < 0 ? Phase::released : Phase::touching;
    }
    sliding_ = now_.rate > 0 ? 1 : now_.rate < 0 ? -1 : 0;
    if (sliding_ == 0) stick_or_slide();
    open_window();
  }

  void advance(Real t) {
    while (end_ <= t) {
      now_ = at(event_.at);
      now_.t = end_;
      enter(event_);
      open_window();
    }
    now_ = at(fraction_of_window(t));
    now_.t = t;
  }

  Sample sample() const {
    Real deepest = -std::numeric_limits<Real>::infinity();
    for (const int side : {-1, 1}) {
      if (has_stop(side)) deepest = larger(deepest, penetration(side));
    }
    const auto rounded = [](Real x) { return static_cast<double>(x); };
    Sample result{
        rounded(now_.t), rounded(now_.x1), rounded(now_.v1), rounded(now_.x1 + now_.y), rounded(now_.v1 + now_.rate),
        rounded(deepest)};
    result.contact_force = phase_ == Phase::touching ? rounded(law_force()) : 0;
    result.energy_dissipated = rounded(now_.dissipated);
    result.drive_work = rounded(now_.drive_work);
    result.impacts = impacts_;
    result.peak_force = rounded(now_.peak_force);
    result.friction_dissipated = rounded(now_.rubbed);
    return result;
  }

 private:
  enum class Phase { apart, touching, released };  // released at zero force, and still penetrating

  struct Instant {
    Real t = 0, x1 = 0, v1 = 0, y = 0, rate = 0, dissipated = 0, drive_work = 0, peak_force = 0, rubbed = 0;
  };

  // The event that ends a window, at a fraction of it: a change of phase, the end of sliding or sticking, or the end of
  // the window itself.
  struct Event {
    Real at;
    Phase next;
    int side;
    bool turns = false;
  };

  // Columns of the series of a window. A linear window has only the last three, since its state comes from the flow.
  enum { time, x1, v1, r, u, applied, partner, field, dissipated, drive_work, force, columns };

  bool linear_contact() const { return run_.law == Law::hooke_newton; }
  bool clamped() const { return run_.scene.tension == Tension::clamp; }
  bool has_stop(int side) const {
    return run_.scene.stops == Stops::both || run_.scene.stops == (side > 0 ? Stops::right : Stops::left);
  }
  Real penetration(int side) const { return static_cast<Real>(side) * now_.y - scene_.half_clearance; }

  Real law_force() const {
    const Real delta = std::max(penetration(side_), Real{0}), speed = static_cast<Real>(side_) * now_.rate;
    if (linear_contact()) return scene_.k1 * delta + c1_ * speed;
    return delta * std::sqrt(delta) * (scene_.k1 + c1_ * speed);
  }

  Real spring_energy() const {
    const Real delta = std::max(penetration(side_), Real{0});
    return scene_.k1 * delta * delta * (linear_contact() ? 0.5L : 0.4L * std::sqrt(delta));
  }

  // The drive and its partner F, G now.
  std::pair<Real, Real> drive() const {
    if (run_.drive == DriveKind::sampled) return drive_samples_.at(now_.t);
    const Real amplitude = run_.drive == DriveKind::sine ? scene_.F0 : 0, phase = scene_.pulsation * now_.t;
    return {amplitude * std::sin(phase), amplitude * std::cos(phase)};
  }
  // The field's acceleration now, and its slope.
  std::pair<Real, Real> field_now() const {
    const auto [base, slope] = base_samples_.at(now_.t);
    return {scene_.gravity - base, -slope};
  }

  bool is_stuck() const { return scene_.friction > 0 && sliding_ == 0; }
  // The friction force on the ball that makes it stick, N.
  Real holding_force() const {
    const Real contact = phase_ == Phase::touching ? static_cast<Real>(side_) * law_force() : 0;
    return scene_.m / (scene_.M + scene_.m) * (drive().first - scene_.k * now_.x1 - scene_.c * now_.v1) + contact;
  }
  // Decides at a sliding rate of 0.
  void stick_or_slide() {
    now_.rate = 0;
    sliding_ = 0;
    if (!(scene_.friction > 0)) return;
    if (phase_ == Phase::released) {
      phase_ = Phase::touching;
      now_.dissipated -= spring_energy();
    }
    const Real holding = holding_force();
    if (std::abs(holding) > scene_.friction) sliding_ = holding > 0 ? -1 : 1;
  }

  static void keep_earlier(Event& first, std::optional<Real> at, Phase next, int side, bool turns = false) {
    if (at && *at < first.at) first = Event{*at, next, side, turns};
  }

  void enter(const Event& event) {
    if (event.turns) {
      if (sliding_ != 0) return stick_or_slide();
      sliding_ = holding_force() > 0 ? -1 : 1;
      return;
    }
    if (event.next == phase_) return;
    const Phase before = phase_;
    phase_ = event.next;
    side_ = event.side;
    if (before == Phase::apart || phase_ == Phase::apart) {
      now_.y = static_cast<Real>(side_) * scene_.half_clearance;
    } else {
      now_.dissipated += phase_ == Phase::released ? spring_energy() : -spring_energy();
    }
    if (before != Phase::apart) return;
    ++impacts_;
    if (run_.law == Law::hunt_crossley && run_.damping_ratio > 0) {
      const Real approach_speed = std::max(static_cast<Real>(side_) * now_.rate, real(least_approach_speed));
      c1_ = real(run_.damping_ratio) * scene_.k1 / approach_speed;
    }
  }

  void open_window() {
    start_ = now_;
    const Real end_of_drive = std::min(drive_samples_.end_of_segment(now_.t), base_samples_.end_of_segment(now_.t));
    if (is_stuck()) {
      open_sticking_window(end_of_drive);
    } else if (phase_ == Phase::touching && !linear_contact()) {
      open_power_law_window(end_of_drive);
    } else {
      open_linear_window(end_of_drive);
    }
  }

  // The instant t as a fraction of the window.
  Real fraction_of_window(Real t) const {
    if (flow_) return (t - start_.t) / flow_->window();
    Series remaining = series_.col(time);
    remaining[0] -= t - start_.t;
    return first_rise(remaining, event_.at).value_or(event_.at);
  }

  Instant at(Real place) const {
    Instant result = start_;
    result.dissipated += value(series_.col(dissipated), place);
    result.drive_work += value(series_.col(drive_work), place);
    if (phase_ == Phase::touching) {
      result.peak_force = larger(result.peak_force, largest(series_.col(force), place));
    }
    if (flow_) {
      result.x1 = value(linear_.col(0), place);
      result.v1 = value(linear_.col(1), place);
      if (is_stuck()) return result;
      result.y = value(linear_.col(2), place) + stop_;
      result.rate = value(linear_.col(3), place);
    } else {
      const Real root = value(series_.col(r), place);
      result.x1 = value(series_.col(x1), place);
      result.v1 = value(series_.col(v1), place);
      result.y = static_cast<Real>(side_) * (scene_.half_clearance + root * root);
      result.rate = static_cast<Real>(side_) * value(series_.col(u), place);
    }
    result.rubbed += scene_.friction * static_cast<Real>(sliding_) * (result.y - start_.y);
    return result;
  }

  // The instant at which the sliding rate is 0. At the beginning of sliding the rate grows, even if its first slope is
  // rounded to another sign.
  std::optional<Real> turn(const Series& rate, Real end) const {
    Series against = -static_cast<Real>(sliding_) * rate;
    if (now_.rate == 0) against[1] = std::min(against[1], Real{0});
    return first_rise(against, end);
  }

  void follow(const LinearFlow& flow, Real y) {
    flow_ = &flow;
    const auto [force_now, partner_now] = drive();
    const auto [field_value, field_slope] = field_now();
    Vector start;
    start << now_.x1, now_.v1, y, now_.rate, force_now, partner_now, field_value, field_slope,
        static_cast<Real>(sliding_);
    flow.expand(start, linear_);

    series_.rightCols(columns - dissipated).setZero();
    for (int k = 0; k < LinearFlow::terms && run_.drive != DriveKind::none; ++k) {
      const Real share = flow.window() / static_cast<Real>(k + 1);
      series_(k + 1, drive_work) = share * product(linear_.col(4), linear_.col(1), k);
    }
  }
  void end_linear_window(Real whole, Real end_of_drive) {
    end_ = event_.at == whole && whole < 1 ? end_of_drive : start_.t + event_.at * flow_->window();
  }

  // The instant at which sticking requires more than the friction force.
  void open_sticking_window(Real end_of_drive) {
    follow(*sticking_flow_, 0);
    const Real share = scene_.m / (scene_.M + scene_.m);
    Series holding = share * (linear_.col(4) - scene_.k * linear_.col(0) - scene_.c * linear_.col(1));
    if (phase_ == Phase::touching) {
      holding[0] += static_cast<Real>(side_) * law_force();
      series_(0, force) = law_force();
    }
    const Real whole = std::min((end_of_drive - start_.t) / flow_->window(), Real{1});
    event_ = {whole, phase_, side_};
    for (const int sign : {-1, 1}) {
      Series beyond = static_cast<Real>(sign) * holding;
      beyond[0] -= scene_.friction;
      keep_earlier(event_, first_rise(beyond, whole), phase_, side_, true);
    }
    end_linear_window(whole, end_of_drive);
  }

  void open_linear_window(Real end_of_drive) {
    const bool touching = phase_ == Phase::touching;
    const Real side = static_cast<Real>(side_);
    stop_ = touching ? side * scene_.half_clearance : 0;
    follow(touching ? *contact_flow_ : apart_flow_, now_.y - stop_);
    const Series rate = linear_.col(3);
    const auto penetration_series = [&](int of) -> Series {
      Series p = static_cast<Real>(of) * linear_.col(2);
      p[0] += static_cast<Real>(of) * stop_ - scene_.half_clearance;
      return p;
    };
    Series sign_of_force = c1_ * side * rate;
    if (linear_contact()) {
      sign_of_force += scene_.k1 * penetration_series(side_);
    } else {
      sign_of_force[0] += scene_.k1;
    }

    for (int k = 0; k < LinearFlow::terms && touching; ++k)
      series_(k + 1, dissipated) = flow_->window() / static_cast<Real>(k + 1) * c1_ * product(rate, rate, k);
    if (touching) series_.col(force) = sign_of_force;

    const Real whole = std::min((end_of_drive - start_.t) / flow_->window(), Real{1});
    event_ = {whole, phase_, side_};
    if (phase_ == Phase::apart) {
      for (const int of : {-1, 1}) {
        if (has_stop(of)) keep_earlier(event_, first_rise(penetration_series(of), whole), Phase::touching, of);
      }
    } else if (touching && clamped()) {
      keep_earlier(event_, first_rise(-sign_of_force, whole), Phase::released, side_);
    } else {
      keep_earlier(event_, first_rise(-penetration_series(side_), whole), Phase::apart, side_);
      if (!touching) keep_earlier(event_, first_rise(sign_of_force, whole), Phase::touching, side_);
    }
    if (scene_.friction > 0) keep_earlier(event_, turn(rate, whole), phase_, side_, true);
    end_linear_window(whole, end_of_drive);
  }

  // With the penetration rate u, the main mass's acceleration a1 (without that of the field) and ' = d/dtheta,
  //
  //     t' = r    r' = u / 2    u' = r delta''    x1' = r v1    v1' = r a1    force = r^3 (k1 + c1 u)
  //
  // Each line of the recursion is one of these.
  void open_power_law_window(Real end_of_drive) {
    flow_ = nullptr;
    const Real side = static_cast<Real>(side_);
    const auto [force_now, partner_now] = drive();
    const auto [field_value, field_slope] = field_now();
    const Real rubbing = scene_.friction * static_cast<Real>(sliding_);
    auto& c = series_;
    c.setZero();
    c.row(0).head(field + 1) << 0, now_.x1, now_.v1, std::sqrt(std::max(penetration(side_), Real{0})), side * now_.rate,
        force_now, partner_now, field_value;
    Series r2 = Series::Zero(), r3 = r2, factor = r2, a1 = r2, a = r2, x1_rate = r2, r_u = r2, r3_u = r2;
    for (int k = 0; k < order; ++k) {
      r2[k] = product(c.col(r), c.col(r), k);
      r3[k] = product(r2, c.col(r), k);
      factor[k] = (k == 0 ? scene_.k1 : 0) + c1_ * c(k, u);
      c(k, force) = product(r3, factor, k);
      const Real rubs = k == 0 ? rubbing : 0;
      const Real relative =
          (c(k, applied) - scene_.c * c(k, v1) - scene_.k * c(k, x1) + side * c(k, force) + rubs) / scene_.M;
      a1[k] = relative + c(k, field);
      a[k] = -c(k, force) / scene_.m - side * (relative + rubs / scene_.m);
      x1_rate[k] = product(c.col(r), c.col(v1), k);
      r_u[k] = product(c.col(r), c.col(u), k);
      r3_u[k] = product(r3, c.col(u), k);
      const Real next = static_cast<Real>(k + 1);
      c(k + 1, time) = c(k, r) / next;
      c(k + 1, x1) = x1_rate[k] / next;
      c(k + 1, v1) = product(c.col(r), a1, k) / next;
      c(k + 1, r) = c(k, u) / (2 * next);
      c(k + 1, u) = product(c.col(r), a, k) / next;
      if (run_.drive == DriveKind::sine) {
        c(k + 1, applied) = scene_.pulsation * product(c.col(r), c.col(partner), k) / next;
        c(k + 1, partner) = -scene_.pulsation * product(c.col(r), c.col(applied), k) / next;
      } else {
        c(k + 1, applied) = partner_now * c(k, r) / next;
      }
      c(k + 1, field) = field_slope * c(k, r) / next;
      c(k + 1, dissipated) = c1_ * product(r3_u, r_u, k) / next;
      if (run_.drive != DriveKind::none) c(k + 1, drive_work) = product(c.col(applied), x1_rate, k) / next;
    }

    // The longest step, at most twice the last one, whose last two terms are within the tolerance of the largest one.
    Series powers = Series::Ones();
    const auto resolved = [&](Real step) {
      for (int k = 1; k <= order; ++k) powers[k] = powers[k - 1] * step;
      for (const int column : {x1, v1, r, u}) {
        const Series terms = c.col(column).cwiseProduct(powers).cwiseAbs();
        if (terms.tail(2).maxCoeff() > tolerance_ * terms.maxCoeff()) return false;
      }
      return true;
    };
    step_ *= 2;
    while (!resolved(step_)) step_ *= 0.8L;
    for (int k = 0; k <= order; ++k) c.row(k) *= powers[k];

    event_ = {1, phase_, side_};
    keep_earlier(event_, first_rise(-c.col(r), 1), Phase::apart, side_);
    if (clamped()) {
      factor = c1_ * c.col(u);
      factor[0] += scene_.k1;
      keep_earlier(event_, first_rise(-factor, 1), Phase::released, side_);
    }
    if (scene_.friction > 0) keep_earlier(event_, turn(side * c.col(u), 1), phase_, side_, true);
    end_ = start_.t + value(c.col(time), event_.at);
    if (end_ > end_of_drive) {
      event_ = {fraction_of_window(end_of_drive), phase_, side_};
      end_ = end_of_drive;
    }
  }

  Case run_;
  Constants scene_;
  LinearSamples drive_samples_, base_samples_;  // of run_
  Real tolerance_;
  Real c1_;
  LinearFlow apart_flow_;
  std::optional<LinearFlow> contact_flow_, sticking_flow_;

  Instant now_;
  Phase phase_ = Phase::apart;
  int side_ = 1;
  long impacts_ = 0;
  int sliding_ = 0;  // the sign of y', or 0 while the ball sticks

  // The present window.
  Instant start_;
  Real end_ = 0;
  Event event_{};
  Eigen::Matrix<Real, order + 1, columns> series_;
  const LinearFlow* flow_ = nullptr;                          // null in power-law contact
  LinearFlow::Columns linear_ = LinearFlow::Columns::Zero();  // of the flow, y measured from stop_
  Real stop_ = 0;
  Real step_ = 1;  // of theta
};

Reference::Reference(const Case& run, double tolerance) : motion_(std::make_unique<Motion>(run, real(tolerance))) {}
Reference::~Reference() = default;
Reference::Reference(Reference&&) noexcept = default;
void Reference::advance(double t) { motion_->advance(real(t)); }
Sample Reference::sample() const { return motion_->sample(); }

Trajectory reference_trajectory(const Case& run, double sample_interval, double duration, double tolerance) {
  Trajectory result;
  Reference fine(run, tolerance), coarse(run, 1000 * tolerance);
  const auto count = static_cast<size_t>(std::floor(duration / sample_interval * (1 + 1e-12)));
  for (size_t i = 0; i <= count; ++i) {
    const double t = static_cast<double>(i) * sample_interval;
    fine.advance(t);
    coarse.advance(t);
    const Sample a = fine.sample(), b = coarse.sample();
    result.samples.push_back(a);
    result.error_estimate = larger(result.error_estimate, larger(std::abs(a.x1 - b.x1), std::abs(a.x2 - b.x2)));
  }
  return result;
}

}  // namespace impact::host
