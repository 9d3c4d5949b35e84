// stability OUTPUT.csv: one impact of two free masses (k = c = 0, no drive; 1 kg and 0.3 kg at 0.8 m/s) at every step
// length and contact stiffness, over 64 phases of the impact within the step. c1 gives restitution 0.68 exactly.
//
//     restitution       rebound speed over approach speed, smallest and largest over the phases (free_pair.hpp)
//     energy_gain_max   the largest relative growth of the energy of the relative motion
//     accepted          1 if the plan accepts the configuration
//     machine_rule      see machine_rule.hpp
//
// If a plan is rejected because a contact has too few steps, the run is made in double nevertheless, to show the
// result. textbook-rk4 is the classical Runge-Kutta method, which has no plan.

#include <array>
#include <cmath>
#include <host_ref/free_pair.hpp>
#include <host_ref/parallel.hpp>
#include <host_ref/report/machine_rule.hpp>
#include <host_ref/report/report_program.hpp>
#include <host_ref/simulation_of.hpp>
#include <host_ref/text.hpp>
#include <mutex>
#include <vector>

namespace impact::report {
namespace {

using namespace host;

// A stepper without its limit on the number of steps per contact.
template <class Stepper> struct Unranged : Stepper {
  static constexpr Range steps(const Resolution&) { return any_step; }
};
template <class ContactLaw> std::unique_ptr<Simulation> beyond_range(const Request& request) {
  switch (request.stepper) {
    case Stepper::moment:
      return plan_for<Float64, ContactLaw, Unranged<Moment>, NoDrive>(request, *request.bounds).simulation;
    case Stepper::energy:
      return plan_for<Float64, ContactLaw, Unranged<EnergyConsistent>, NoDrive>(request, *request.bounds).simulation;
    default:
      return plan_for<Float64, ContactLaw, Unranged<Impulsive>, NoDrive>(request, *request.bounds).simulation;
  }
}
std::unique_ptr<Simulation> beyond_range_under_law(const Request& request) {
  return by_law(request, [&](auto law) { return beyond_range<decltype(law)>(request); });
}

void append_row(std::string& rows, const FreePair& free, std::string_view method, Numeric numeric,
                const Rebounds& found, bool is_accepted) {
  if (found.has_fault) return;
  rows += csv_line(6, name_of(free.law), method, name_of(numeric), free.step, free.contact_stiffness, found.least,
                   found.largest, restitution(impact_of(free)).value(), found.energy_gain(), is_accepted ? 1 : 0,
                   machine_rule(free.law, free.step, free.contact_stiffness));
}

void append_cell(std::string& rows, const FreePair& free, Stepper stepper, Numeric numeric) {
  if (const auto found = rebounds(free, stepper, numeric, simulation_of))
    return append_row(rows, free, name_of(stepper), numeric, *found, true);
  const bool has_range = stepper == Stepper::moment || stepper == Stepper::energy || stepper == Stepper::impulsive;
  if (!has_range || numeric != Numeric::float64) return;
  if (const auto found = rebounds(free, stepper, numeric, beyond_range_under_law))
    append_row(rows, free, name_of(stepper), numeric, *found, false);
}

constexpr int least_step = -20, step_lengths = 13;          // quarters of a decade, s
constexpr int least_stiffness = 6, largest_stiffness = 24;  // halves of a decade
constexpr Law laws[] = {Law::hooke_newton, Law::hertz, Law::hunt_crossley};
constexpr size_t columns = std::size(laws) * step_lengths;

// Every stiffness at a law and a step length.
std::string column(size_t index) {
  std::string rows;
  FreePair free;
  free.law = laws[index / step_lengths];
  free.step = std::pow(10, (least_step + static_cast<int>(index % step_lengths)) / 4.0);
  for (int stiffness = least_stiffness; stiffness <= largest_stiffness; ++stiffness) {
    free.contact_stiffness = std::pow(10, stiffness / 2.0);
    for (const Stepper stepper :
         {Stepper::automatic, Stepper::moment, Stepper::moment_4, Stepper::energy, Stepper::impulsive, Stepper::average,
          Stepper::linear, Stepper::fox_goodwin, Stepper::central})
      for (const Numeric numeric : {Numeric::float64, Numeric::float32, Numeric::fixed32})
        append_cell(rows, free, stepper, numeric);
    append_row(rows, free, "textbook-rk4", Numeric::float64,
               rebounds(free, Stepper::automatic, Numeric::float64, runge_kutta).value(), true);
  }
  return rows;
}

}  // namespace

void write_table(Output& output, const std::vector<std::string>&) {
  output.write(
      "law,newmark,numeric,step_s,contact_stiffness,restitution_min,restitution_max,restitution_exact,energy_gain_max,"
      "accepted,machine_rule\n");
  Progress progress("step lengths", columns);
  std::array<std::string, columns> rows;
  std::mutex one_at_a_time;
  long done = 0;
  on_all_cores(columns, [&](size_t index) {
    rows[index] = column(index);
    const std::lock_guard<std::mutex> lock(one_at_a_time);
    progress.at(++done);
  });
  for (const std::string& text : rows) output.write(text);
}

}  // namespace impact::report
