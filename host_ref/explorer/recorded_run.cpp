#include "host_ref/explorer/recorded_run.hpp"

#include <algorithm>
#include <cmath>
#include <host_ref/extremes.hpp>

namespace impact::host {
namespace {

constexpr long most_rows = 40000, most_contact_steps = 400000;

double half_square(double factor, double x) { return factor * x * x / 2; }
double half_sum(double a, double b) { return (a + b) / 2; }

bool is_in_contact(const Sample& sample) { return sample.contact_force != 0 || sample.penetration > 0; }

}  // namespace

long steps_of_a_row(long steps) { return steps / most_rows + 1; }

RecordedRun::RecordedRun(const Request& request, std::unique_ptr<Simulation> simulation)
    : request_(request),
      simulation_(std::move(simulation)),
      steps_(step_count(request)),
      every_(steps_of_a_row(steps_)),
      contact_every_(steps_ / most_contact_steps + 1) {
  rows_.reserve(static_cast<size_t>(steps_ / every_ + 1));
  before_ = simulation_->sample();
  initial_energy_ = motion_energy(before_);
  note(before_);
}

bool RecordedRun::is_done() const { return done_ >= steps_ || simulation_->fault() != nullptr; }

void RecordedRun::advance(long steps) {
  for (; steps > 0 && !is_done(); --steps) {
    simulation_->step(sample_at(done_, request_.samples), sample_at(done_, request_.base_samples));
    if (simulation_->fault()) return;
    ++done_;
    const Sample now = simulation_->sample();
    field_work_ += field_work(now);
    damper_loss_ += request_.step * (half_square(request_.scene.main_damping, before_.v1) +
                                     half_square(request_.scene.main_damping, now.v1));
    note_impact(now);
    note_contact(now);
    note(now);
    before_ = now;
  }
}

void RecordedRun::note(const Sample& now) {
  totals_.largest_x1 = larger(totals_.largest_x1, std::abs(now.x1));
  squares_ += now.x1 * now.x1;
  const double rubbed = now.energy_dissipated + now.friction_dissipated;
  const double lost = rubbed + damper_loss_, found = lost + motion_energy(now);
  const double supplied = initial_energy_ + now.drive_work + field_work_;
  totals_.energy_error = larger(totals_.energy_error, std::abs(found - supplied));
  totals_.least_x1 = smaller(totals_.least_x1, now.x1);
  totals_.most_x1 = larger(totals_.most_x1, now.x1);
  totals_.most_supplied = larger(totals_.most_supplied, supplied);
  totals_.most_found = larger(totals_.most_found, found);
  totals_.least_dissipated = smaller(totals_.least_dissipated, now.energy_dissipated);
  if (done_ % every_ != 0) return;
  const double side = !is_in_contact(now) ? 0 : now.x2 < now.x1 ? -1 : 1;
  rows_.push_back({now.t, now.x1, now.v1, now.x2, now.v2, now.penetration, now.contact_force, now.energy_dissipated,
                   rubbed, lost, found, supplied, side});
}

// Includes the step before a contact and the one after it, so that a loop is drawn closed.
void RecordedRun::note_contact(const Sample& now) {
  if (!is_in_contact(now) && !is_in_contact(before_)) return;
  if (done_ % contact_every_ != 0) return;
  if (!is_in_contact(before_)) contacts_.push_back({before_.t, before_.penetration, before_.contact_force});
  contacts_.push_back({now.t, now.penetration, now.contact_force});
}

// An impact ends when the ball is outside and the force is 0, or when another impact follows at once.
void RecordedRun::note_impact(const Sample& now) {
  const bool begins = now.impacts != before_.impacts;
  if (in_impact_ && begins) end_impact(before_);
  if (begins) {
    in_impact_ = true;
    dissipated_at_impact_ = before_.energy_dissipated;
  }
  if (in_impact_ && now.penetration <= 0 && now.contact_force == 0) end_impact(now);
}

void RecordedRun::end_impact(const Sample& now) {
  in_impact_ = false;
  const double mu = 1 / (1 / request_.scene.main_mass + 1 / request_.scene.ball_mass);
  const double brought = half_square(mu, now.impact_speed), lost = now.energy_dissipated - dissipated_at_impact_;
  if (brought > 0) impacts_.push_back({now.t, now.impact_speed, std::sqrt(larger(1 - lost / brought, 0.0))});
}

double RecordedRun::motion_energy(const Sample& now) const {
  const Scene& scene = request_.scene;
  return half_square(scene.main_mass, now.v1) + half_square(scene.main_stiffness, now.x1) +
         half_square(scene.ball_mass, now.v2) + now.energy_stored;
}

// The work of weight and of the base's acceleration, which is linear between samples, by the trapezoidal rule.
double RecordedRun::field_work(const Sample& now) const {
  const Scene& scene = request_.scene;
  double acceleration = scene.gravity;
  if (!request_.base_samples.empty()) {
    const auto n = static_cast<size_t>(done_);
    acceleration -= half_sum(n > 1 ? request_.base_samples[n - 2] : 0, request_.base_samples[n - 1]);
  }
  return acceleration * (scene.main_mass * (now.x1 - before_.x1) + scene.ball_mass * (now.x2 - before_.x2));
}

Totals RecordedRun::totals() const {
  Totals totals = totals_;
  totals.steps = static_cast<double>(done_);
  totals.rms_x1 = std::sqrt(squares_ / (totals.steps + 1));
  totals.energy_dissipated = before_.energy_dissipated;
  totals.impacts = static_cast<double>(before_.impacts);
  totals.peak_force = before_.peak_force;
  totals.friction_dissipated = before_.friction_dissipated;
  return totals;
}

DisplacementRun::DisplacementRun(const Request& request, std::unique_ptr<Simulation> simulation)
    : request_(request),
      simulation_(std::move(simulation)),
      steps_(step_count(request)),
      every_(steps_of_a_row(steps_)) {
  rows_.reserve(static_cast<size_t>(steps_ / every_ + 1));
  note(simulation_->sample().x1);
}

void DisplacementRun::advance(long steps) {
  double x1[500];
  while (steps > 0 && !is_done()) {
    const long asked = std::min({steps, static_cast<long>(std::size(x1)), steps_ - done_});
    const long made = simulation_->run(asked, samples_after(done_, asked, request_.samples), x1,
                                       samples_after(done_, asked, request_.base_samples));
    for (long i = 0; i < made; ++i) {
      ++done_;
      note(x1[i]);
    }
    has_fault_ = made < asked;
    steps -= asked;
  }
}

void DisplacementRun::note(double x1) {
  extremes_.largest = larger(extremes_.largest, std::abs(x1));
  extremes_.least = smaller(extremes_.least, x1);
  extremes_.most = larger(extremes_.most, x1);
  if (done_ % every_ == 0) rows_.push_back({static_cast<double>(done_) * request_.step, x1});
}

}  // namespace impact::host
