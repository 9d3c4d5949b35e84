#pragma once
// A simulation with the data that the page draws: its motion in rows, its contacts as force over penetration, its
// impacts as restitution over speed. All values are in SI units.

#include <host_ref/simulation.hpp>
#include <vector>

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
struct Totals {
  double steps = 0, largest_x1 = 0, rms_x1 = 0, energy_dissipated = 0, impacts = 0, peak_force = 0;
  double energy_error = 0;  // J, of the ledger's balance
  double friction_dissipated = 0;
  double least_x1 = 0, most_x1 = 0, most_supplied = 0, most_found = 0, least_dissipated = 0;
};

// The number of steps per row, so that a run has at most 40000 rows.
long steps_of_a_row(long steps);

class RecordedRun {
 public:
  RecordedRun(const Request& request, std::unique_ptr<Simulation> simulation);

  void advance(long steps);  // stops at the end of the request's duration, and at a fault
  bool is_done() const;

  const char* fault() const { return simulation_->fault(); }
  const Request& request() const { return request_; }
  long every() const { return every_; }
  const std::vector<Row>& rows() const { return rows_; }
  const std::vector<ContactPoint>& contacts() const { return contacts_; }
  const std::vector<ImpactPoint>& impacts() const { return impacts_; }
  Totals totals() const;

 private:
  void note(const Sample& sample);
  void note_contact(const Sample& sample);
  void note_impact(const Sample& sample);
  void end_impact(const Sample& sample);
  double motion_energy(const Sample& sample) const;
  double field_work(const Sample& sample) const;  // in the step that ended with it

  Request request_;
  std::unique_ptr<Simulation> simulation_;
  long steps_, every_, contact_every_, done_ = 0;
  Sample before_{};
  double initial_energy_ = 0, damper_loss_ = 0, field_work_ = 0, dissipated_at_impact_ = 0, squares_ = 0;
  Totals totals_;
  bool in_impact_ = false;
  std::vector<Row> rows_;
  std::vector<ContactPoint> contacts_;
  std::vector<ImpactPoint> impacts_;
};

struct DisplacementRow {
  double t, x1;
};
struct DisplacementExtremes {
  double largest = 0, least = 0, most = 0;  // |x1|; x1, with 0
};

// A simulation that records only the main mass's displacement, for the machine without absorber and the points of a
// sweep. It is several times as fast as a recorded run.
class DisplacementRun {
 public:
  DisplacementRun(const Request& request, std::unique_ptr<Simulation> simulation);

  void advance(long steps);  // stops at the end of the request's duration, and at a fault
  bool is_done() const { return done_ >= steps_ || has_fault_; }

  const std::vector<DisplacementRow>& rows() const { return rows_; }
  const DisplacementExtremes& extremes() const { return extremes_; }

 private:
  void note(double x1);

  Request request_;
  std::unique_ptr<Simulation> simulation_;
  long steps_, every_, done_ = 0;
  bool has_fault_ = false;
  DisplacementExtremes extremes_;
  std::vector<DisplacementRow> rows_;
};

}  // namespace impact::host
