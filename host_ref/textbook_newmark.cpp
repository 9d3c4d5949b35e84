#include "host_ref/textbook_newmark.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "host_ref/extremes.hpp"

namespace impact::host {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;

struct ContactForce {
  double force, stiffness, damping;  // f, df/d delta, df/d delta'
};

ContactForce contact_force(Law law, double k1, double c1, double delta, double rate) {
  if (law == Law::hooke_newton) return {k1 * delta + c1 * rate, k1, c1};
  const double root = std::sqrt(std::max(delta, 0.0)), power = root * root * root;
  if (law == Law::hertz) return {k1 * power, 1.5 * k1 * root, 0};
  return {power * (k1 + c1 * rate), 1.5 * root * (k1 + c1 * rate), power * c1};
}

double penetration(const Scene& scene, int side, double x1, double x2) {
  return side * (x2 - x1) - scene.clearance / 2;
}

// The stop that is penetrated deepest, or least missed.
int nearest_stop(const Scene& scene, double x1, double x2) {
  if (scene.stops != Stops::both) return scene.stops == Stops::right ? 1 : -1;
  return x2 >= x1 ? 1 : -1;
}

// Both masses, with the penetration of the nearest stop.
Sample sample_at(const Scene& scene, double t, const Vector2d& x, const Vector2d& v) {
  return {t, x[0], v[0], x[1], v[1], penetration(scene, nearest_stop(scene, x[0], x[1]), x[0], x[1])};
}

Sample initial_sample(const Case& run) {
  const Scene& scene = run.scene;
  Sample sample = sample_at(scene, 0, {scene.x1, scene.x2}, {scene.v1, scene.v2});
  if (sample.penetration > 0) {
    const double rate = nearest_stop(scene, scene.x1, scene.x2) * (scene.v2 - scene.v1);
    sample.contact_force =
        contact_force(run.law, scene.contact_stiffness, scene.contact_damping, sample.penetration, rate).force;
    if (scene.tension == Tension::clamp) sample.contact_force = larger(sample.contact_force, 0.0);
  }
  return sample;
}

}  // namespace

TextbookNewmark::TextbookNewmark(const Case& run, double beta, double step)
    : run_(run), beta_(beta), step_(step), sample_(initial_sample(run)) {
  const Scene& scene = run.scene;
  mass_ = Vector2d(scene.main_mass, scene.ball_mass).asDiagonal();
  damping_ = Vector2d(scene.main_damping, 0).asDiagonal();
  stiffness_ = Vector2d(scene.main_stiffness, 0).asDiagonal();
  motion_.displacement = Vector2d(scene.x1, scene.x2);
  motion_.velocity = Vector2d(scene.v1, scene.v2);
  if (sample_.penetration > 0) side_ = nearest_stop(scene, scene.x1, scene.x2);
  const double force = side_ * sample_.contact_force;
  motion_.acceleration = mass_.inverse() * (Vector2d(drive_force(run, 0) + force, -force) -
                                            damping_ * motion_.velocity - stiffness_ * motion_.displacement);
}

TextbookNewmark::Motion TextbookNewmark::step_end(double drive, int side, double& force) const {
  constexpr double gamma = 0.5;
  const double h = step_;
  const Scene& scene = run_.scene;
  const Vector2d displacement =
      motion_.displacement + h * motion_.velocity + h * h * (0.5 - beta_) * motion_.acceleration;
  const Vector2d velocity = motion_.velocity + h * (1 - gamma) * motion_.acceleration;
  const Vector2d direction(-side, side);
  const Matrix2d coupling = direction * direction.transpose();
  Motion end{displacement, velocity, Vector2d::Zero()};
  const auto contact = [&]() -> ContactForce {
    if (side == 0) return {};
    return contact_force(run_.law, scene.contact_stiffness, scene.contact_damping,
                         penetration(scene, side, end.displacement[0], end.displacement[1]),
                         direction.dot(end.velocity));
  };
  // Convergence is quadratic; the cap ends the last-bit cycles of a root that rounding does not let settle.
  for (int iteration = 0; iteration < 50; ++iteration) {
    const ContactForce inner = contact();
    const Vector2d residual = Vector2d(drive, 0) - mass_ * end.acceleration - damping_ * end.velocity -
                              stiffness_ * end.displacement - inner.force * direction;
    const Matrix2d tangent = mass_ + gamma * h * (damping_ + inner.damping * coupling) +
                             beta_ * h * h * (stiffness_ + inner.stiffness * coupling);
    const Vector2d correction = tangent.partialPivLu().solve(residual);
    end.acceleration += correction;
    end.velocity = velocity + gamma * h * end.acceleration;
    end.displacement = displacement + beta_ * h * h * end.acceleration;
    if (correction.norm() <= 1e-14 * end.acceleration.norm()) break;
  }
  force = contact().force;
  return end;
}

void TextbookNewmark::step() {
  const Scene& scene = run_.scene;
  const double t = static_cast<double>(++steps_) * step_, drive = drive_force(run_, t);

  double force = 0;
  Motion end = step_end(drive, 0, force);
  const int side = nearest_stop(scene, end.displacement[0], end.displacement[1]);
  side_ = penetration(scene, side, end.displacement[0], end.displacement[1]) > 0 ? side : 0;
  if (side_ != 0) {
    const Motion touching = step_end(drive, side_, force);
    if (scene.tension == Tension::clamp && force < 0) {
      force = 0;
    } else {
      end = touching;
    }
  }
  motion_ = end;

  const Sample before = std::exchange(sample_, sample_at(scene, t, end.displacement, end.velocity));
  sample_.contact_force = force;
  sample_.impacts = before.impacts + (sample_.penetration > 0 && before.penetration <= 0 ? 1 : 0);
}

TextbookRungeKutta::TextbookRungeKutta(const Case& run, double step)
    : run_(run), step_(step), sample_(initial_sample(run)) {}

void TextbookRungeKutta::step() {
  const Scene& scene = run_.scene;
  const auto contact = [&](const Eigen::Vector4d& z) {
    const int side = nearest_stop(scene, z[0], z[2]);
    const double delta = penetration(scene, side, z[0], z[2]);
    if (delta <= 0) return 0.0;
    const double force =
        contact_force(run_.law, scene.contact_stiffness, scene.contact_damping, delta, side * (z[3] - z[1])).force;
    return scene.tension == Tension::clamp ? std::max(force, 0.0) : force;
  };
  const auto slope = [&](double t, const Eigen::Vector4d& z) -> Eigen::Vector4d {
    const double force = nearest_stop(scene, z[0], z[2]) * contact(z);
    const double pull = drive_force(run_, t) + force - scene.main_damping * z[1] - scene.main_stiffness * z[0];
    return {z[1], pull / scene.main_mass, z[3], -force / scene.ball_mass};
  };
  const Eigen::Vector4d z(sample_.x1, sample_.v1, sample_.x2, sample_.v2);
  const double t = sample_.t, h = step_;
  const Eigen::Vector4d a = slope(t, z), b = slope(t + h / 2, z + h / 2 * a), c = slope(t + h / 2, z + h / 2 * b),
                        d = slope(t + h, z + h * c);
  const Eigen::Vector4d end = z + h / 6 * (a + 2 * b + 2 * c + d);

  sample_ = sample_at(scene, static_cast<double>(++steps_) * h, {end[0], end[2]}, {end[1], end[3]});
  sample_.contact_force = contact(end);
}

}  // namespace impact::host
