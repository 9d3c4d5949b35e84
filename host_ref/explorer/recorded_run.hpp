#pragma once
// A simulation with the data that the page draws: its motion in rows, its contacts as force over penetration, its
// impacts as restitution over speed. All values are in SI units.

#include <algorithm>
#include <host_ref/energies.hpp>
#include <host_ref/simulation.hpp>
#include <iterator>

namespace impact::host {

// The columns of a row of the motion.
struct Row {
  double t, x1, v1, x2, v2, penetration, contact_force, energy_dissipated;
  double energy_rubbed;    // J: lost to contact and dry friction
  double energy_lost;      // J: the same plus the loss to the main damper, c v1^2 by the trapezoidal rule
  double energy_found;     // J: the same plus kinetic energies and those stored in the main spring and the contact
  double energy_supplied;  // J: at the start, and since then by drive, weight and base; it must equal energy_found
  double side;             // of the present contact: -1 left, 1 right, 0 apart
};
struct ContactPoint {
  double t, penetration, force;
};
// The restitution of an impact from its energy loss in the ledger: e^2 = 1 - loss / (mu V^2/2). This holds for any
// other forces on the main mass. It is above 1 if the contact has created energy.
struct ImpactPoint {
  double t, speed, restitution;
};
struct DisplacementExtremes {
  double largest = 0, least = 0, most = 0;  // |x1|; x1, with 0

  void see(double x1) {
    largest = larger(largest, std::abs(x1));
    least = smaller(least, x1);
    most = larger(most, x1);
  }
};
struct Totals : DisplacementExtremes {
  double energy_dissipated = 0, impacts = 0, peak_force = 0, friction_dissipated = 0;
  double energy_error = 0;  // J, of the ledger's balance
  double most_supplied = 0, most_found = 0, least_dissipated = 0;
};

// The number of steps per row, so that a run has at most 40000 rows.
inline long steps_of_a_row(long steps) { return steps / 40000 + 1; }

class RecordedRun {
 public:
  RecordedRun(const Request& request, std::unique_ptr<Simulation> simulation)
      : request_(request), simulation_(std::move(simulation)) {
    rows_.reserve(static_cast<size_t>(steps_ / every_ + 1));
    before_ = simulation_->sample();
    initial_energy_ = energy_of(before_);
    note(before_);
  }

  // Stops at the end of the request's duration, and at a fault.
  void advance(long steps) {
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
  bool is_done() const { return done_ >= steps_ || simulation_->fault() != nullptr; }

  const char* fault() const { return simulation_->fault(); }
  const Request& request() const { return request_; }
  long every() const { return every_; }
  const std::vector<Row>& rows() const { return rows_; }
  const std::vector<ContactPoint>& contacts() const { return contacts_; }
  const std::vector<ImpactPoint>& impacts() const { return impacts_; }
  const Totals& totals() const { return totals_; }

 private:
  static constexpr long most_contact_steps = 400000;

  static double half_square(double factor, double x) { return factor * x * x / 2; }
  static bool is_in_contact(const Sample& sample) { return sample.contact_force != 0 || sample.penetration > 0; }

  void note(const Sample& now) {
    totals_.see(now.x1);
    totals_.energy_dissipated = now.energy_dissipated;
    totals_.impacts = static_cast<double>(now.impacts);
    totals_.peak_force = now.peak_force;
    totals_.friction_dissipated = now.friction_dissipated;
    const double rubbed = now.energy_dissipated + now.friction_dissipated;
    const double lost = rubbed + damper_loss_, found = lost + energy_of(now);
    const double supplied = initial_energy_ + now.drive_work + field_work_;
    totals_.energy_error = larger(totals_.energy_error, std::abs(found - supplied));
    totals_.most_supplied = larger(totals_.most_supplied, supplied);
    totals_.most_found = larger(totals_.most_found, found);
    totals_.least_dissipated = smaller(totals_.least_dissipated, now.energy_dissipated);
    if (done_ % every_ != 0) return;
    const double side = !is_in_contact(now) ? 0 : now.x2 < now.x1 ? -1 : 1;
    rows_.push_back({now.t, now.x1, now.v1, now.x2, now.v2, now.penetration, now.contact_force, now.energy_dissipated,
                     rubbed, lost, found, supplied, side});
  }

  // Includes the step before a contact and the one after it, so that a loop is drawn closed.
  void note_contact(const Sample& now) {
    if (!is_in_contact(now) && !is_in_contact(before_)) return;
    if (done_ % contact_every_ != 0) return;
    if (!is_in_contact(before_)) contacts_.push_back({before_.t, before_.penetration, before_.contact_force});
    contacts_.push_back({now.t, now.penetration, now.contact_force});
  }

  // An impact ends when the ball is outside and the force is 0, or when another impact follows at once.
  void note_impact(const Sample& now) {
    const bool begins = now.impacts != before_.impacts;
    if (in_impact_ && begins) end_impact(before_);
    if (begins) {
      in_impact_ = true;
      dissipated_at_impact_ = before_.energy_dissipated;
    }
    if (in_impact_ && now.penetration <= 0 && now.contact_force == 0) end_impact(now);
  }
  void end_impact(const Sample& now) {
    in_impact_ = false;
    const double mu = 1 / (1 / request_.scene.main_mass + 1 / request_.scene.ball_mass);
    const double brought = half_square(mu, now.impact_speed), lost = now.energy_dissipated - dissipated_at_impact_;
    if (brought > 0) impacts_.push_back({now.t, now.impact_speed, std::sqrt(larger(1 - lost / brought, 0.0))});
  }

  double energy_of(const Sample& now) const { return mechanical_energy(request_.scene, now) + now.energy_stored; }

  // The work of weight and of the base's acceleration in the step that ended now. The acceleration is linear between
  // samples, and the work is by the trapezoidal rule.
  double field_work(const Sample& now) const {
    const Scene& scene = request_.scene;
    double acceleration = scene.gravity;
    if (!request_.base_samples.empty()) {
      const auto n = static_cast<size_t>(done_);
      acceleration -= ((n > 1 ? request_.base_samples[n - 2] : 0) + request_.base_samples[n - 1]) / 2;
    }
    return acceleration * (scene.main_mass * (now.x1 - before_.x1) + scene.ball_mass * (now.x2 - before_.x2));
  }

  Request request_;
  std::unique_ptr<Simulation> simulation_;
  long steps_ = step_count(request_), every_ = steps_of_a_row(steps_);
  long contact_every_ = steps_ / most_contact_steps + 1, done_ = 0;
  Sample before_{};
  double initial_energy_ = 0, damper_loss_ = 0, field_work_ = 0, dissipated_at_impact_ = 0;
  Totals totals_;
  bool in_impact_ = false;
  std::vector<Row> rows_;
  std::vector<ContactPoint> contacts_;
  std::vector<ImpactPoint> impacts_;
};

struct DisplacementRow {
  double t, x1;
};

// A simulation that records only the main mass's displacement, for the machine without absorber and the points of a
// sweep. It is several times as fast as a recorded run.
class DisplacementRun {
 public:
  DisplacementRun(const Request& request, std::unique_ptr<Simulation> simulation)
      : request_(request), simulation_(std::move(simulation)) {
    rows_.reserve(static_cast<size_t>(steps_ / every_ + 1));
    note(simulation_->sample().x1);
  }

  // Stops at the end of the request's duration, and at a fault.
  void advance(long steps) {
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
  bool is_done() const { return done_ >= steps_ || has_fault_; }

  const std::vector<DisplacementRow>& rows() const { return rows_; }
  const DisplacementExtremes& extremes() const { return extremes_; }

 private:
  void note(double x1) {
    extremes_.see(x1);
    if (done_ % every_ == 0) rows_.push_back({static_cast<double>(done_) * request_.step, x1});
  }

  Request request_;
  std::unique_ptr<Simulation> simulation_;
  long steps_ = step_count(request_), every_ = steps_of_a_row(steps_), done_ = 0;
  bool has_fault_ = false;
  DisplacementExtremes extremes_;
  std::vector<DisplacementRow> rows_;
};

}  // namespace impact::host
