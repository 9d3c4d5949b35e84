#include <algorithm>
#include <cmath>
#include <fstream>
#include <host_ref/extremes.hpp>
#include <host_ref/settled.hpp>
#include <host_ref/text.hpp>
#include <host_ref/tool/summary.hpp>

namespace impact::host {
namespace {

// The rows of the budgets: law,newmark,numeric,drive,quantity and a column for each part. The first row has the names.
std::vector<std::vector<std::string>> budgets() {
  std::ifstream file(IMPACT_BUDGETS);
  std::vector<std::vector<std::string>> rows;
  for (std::string row; std::getline(file, row);) rows.push_back(cells_of(row));
  if (rows.empty()) rows.emplace_back();  // without the file no part is known
  return rows;
}
constexpr size_t first_part = 5;

std::string three_digits(double value) { return rounded_text(value, 3); }
std::string percent(double share) {
  return (share > 0.995 ? std::to_string(std::lround(100 * share)) : rounded_text(100 * share, 2)) + " %";
}

}  // namespace

StepCost step_cost(const std::string& part, const Request& made) {
  const char* drive = made.drive == DriveKind::sine ? "sine" : made.drive == DriveKind::none ? "none" : "sampled";
  const std::string_view configuration[] = {name_of(made.law), name_of(made.stepper), name_of(made.numeric), drive};
  StepCost cost;
  const auto rows = budgets();
  const auto column = static_cast<size_t>(std::find(rows[0].begin(), rows[0].end(), part) - rows[0].begin());
  for (const auto& row : rows)
    if (column < row.size() && !row[column].empty() &&
        std::equal(std::begin(configuration), std::end(configuration), row.begin())) {
      if (row[4] == "free") cost.free = std::stol(row[column]);
      if (row[4] == "contact") cost.contact = std::stol(row[column]);
    }
  const Resolution contact = resolution(made);
  const bool is_stiff =
      made.stepper == Stepper::energy && !contact.is_linear && made.step > EnergyConsistent::longest_resolved(contact);
  if (has_parts(made) || made.damping != Damping::constant || is_stiff) return {};
  if (made.stepper == Stepper::moment_n) {
    constexpr int measured = 32;  // sub-steps, of the budgets' rows; more cost at most in proportion
    const int parts = std::max(measured, sub_steps(made));
    cost.free = cost.free * parts / measured;
    cost.contact = cost.contact * parts / measured;
  }
  return cost;
}

std::string known_parts() {
  const auto names = budgets()[0];
  std::string parts;
  for (size_t i = first_part; i < names.size(); ++i) parts += (i > first_part ? ", " : "") + names[i];
  return parts;
}

Summary::Summary(const Settings& settings, const Outcome& outcome) : settings_(settings), outcome_(outcome) {}

void Summary::see(const Sample& sample) {
  largest_x1_ = larger(largest_x1_, std::abs(sample.x1));
  largest_v1_ = larger(largest_v1_, std::abs(sample.v1));
  largest_x2_ = larger(largest_x2_, std::abs(sample.x2));
  largest_v2_ = larger(largest_v2_, std::abs(sample.v2));
  deepest_ = larger(deepest_, sample.penetration);
  if (sample.impacts > 0) fastest_impact_ = larger(fastest_impact_, sample.impact_speed);
  last_ = sample;
}

// The bound of displacements does not limit a ball between two stops.
double Summary::farthest() const {
  return outcome_.made.scene.stops == Stops::both ? largest_x1_ : larger(largest_x1_, largest_x2_);
}

std::vector<std::string> Summary::lines() const {
  const Request& made = outcome_.made;
  const Scene& scene = made.scene;
  std::vector<std::string> lines;
  // Measurable quantities, computed from the stated ones, so that a wrong unit is noticed.
  const double w0 = std::sqrt(scene.main_stiffness / scene.main_mass);
  std::string machine = "the ball weighs " + percent(scene.ball_mass / scene.main_mass) + " of the main mass";
  if (w0 > 0)
    machine += ", which vibrates at " + three_digits(w0 / (2 * std::acos(-1.0))) + " Hz with " +
               percent(scene.main_damping / (2 * scene.main_mass * w0)) + " of critical damping";
  lines.push_back(machine);
  const bool is_still = largest_v1_ == 0 && largest_v2_ == 0;
  const double inside = initial_penetration(scene);
  if (inside > 0)
    lines.push_back("the ball starts " + three_digits(inside) + " m inside a stop, which is in contact but no impact");
  else if (last_.impacts == 0 && scene.stops != Stops::none)
    lines.push_back(is_still ? "NO IMPACT: nothing moves. State a drive or initial values, such as --v1 or --x1"
                             : "NO IMPACT: the ball has not reached a stop");
  if (last_.impacts > 0) {
    const double e = restitution_at(made, fastest_impact_);
    lines.push_back(std::to_string(last_.impacts) + (last_.impacts == 1 ? " impact" : " impacts") +
                    ", the fastest at " + three_digits(fastest_impact_) + " m/s, where the law's restitution is " +
                    three_digits(e));
  }
  std::string peaks = "the main mass reaches " + three_digits(largest_x1_) + " m and " + three_digits(largest_v1_) +
                      " m/s, the ball " + three_digits(largest_x2_) + " m and " + three_digits(largest_v2_) + " m/s";
  const double fastest = larger(largest_v1_, largest_v2_);
  const Bounds stated = settings_.request.bounds.value_or(open_bounds);
  const char* before = ": ";
  for (const auto& [name, value, bound] : {std::tuple("displacement", farthest(), stated.displacement),
                                           {"speed", fastest, stated.speed},
                                           {"penetration", deepest_, stated.penetration}}) {
    if (!(bound > 0)) continue;
    peaks += before + percent(value / bound) + " of --bound-" + name;
    before = ", ";
  }
  lines.push_back(peaks);
  if (settings_.request.bounds && made.bounds->speed >= 64 * fastest && fastest > 0)
    lines.push_back("--bound-speed " + three_digits(made.bounds->speed) + " m/s is " +
                    three_digits(made.bounds->speed / fastest) +
                    " times the largest speed. Steps per contact count at twice the bound, so it costs precision");
  const double reach = std::max({largest_x1_, largest_x2_, scene.clearance / 2});
  const double bits = std::floor(std::log2(stated.displacement / reach));
  if (reach > 0 && bits >= 6)
    lines.push_back("--bound-displacement " + three_digits(stated.displacement) + " m is so wide that fixed32 loses " +
                    three_digits(bits) + " bits of every displacement");
  if (last_.impacts > 0) {
    const double depth =
        std::pow(last_.peak_force / scene.contact_stiffness, made.law == Law::hooke_newton ? 1 : 2.0 / 3);
    std::string contact = "contact force up to " + three_digits(last_.peak_force) +
                          " N, which a press test reaches at a depth of " + three_digits(depth) + " m";
    if (outcome_.description.empty()) {  // a description says this already
      contact += "; " + std::string(name_of(made.stepper)) +
                 " at N = " + three_digits(resolution(made).steps_per_contact(made.step));
      if (const double error = restitution_error(made); error >= 0)
        contact += ", the restitution within " + rounded_text(error, 2) + " of the law's";
    }
    lines.push_back(contact);
  }
  if (!settings_.part.empty()) {
    const StepCost cost = step_cost(settings_.part, made);
    lines.push_back(cost.contact == 0 ? "the cost of this step on " + settings_.part + " was not measured"
                                      : "a step on " + settings_.part + ": up to " + std::to_string(cost.free) +
                                            " instructions in flight, " + std::to_string(cost.contact) +
                                            " in contact (the paper's scene)");
  }
  if (scene.stops != Stops::none) {
    const std::string side = three_digits(scene.clearance / 2) + " m to the ";
    const std::string left = side + "left stop", right = side + "right stop";
    lines.push_back("in the middle of its cavity the ball has a clearance of " +
                    (scene.stops == Stops::left    ? left
                     : scene.stops == Stops::right ? right
                                                   : left + " and " + right) +
                    " (--clearance is the whole free travel)");
  }
  return lines;
}

std::string Summary::json(const char* fault) const {
  const Request& made = outcome_.made;
  const auto number = [](double value) { return std::isfinite(value) ? shortest_text(value) : "null"; };
  const auto word = [](std::string_view value) { return "\"" + std::string(value) + "\""; };
  const double none = std::nan("");
  std::vector<std::pair<const char*, std::string>> members = {
      {"time_s", number(last_.t)},
      {"impacts", std::to_string(last_.impacts)},
      {"fastest_impact_m_per_s", number(last_.impacts > 0 ? fastest_impact_ : none)},
      {"restitution", number(last_.impacts > 0 ? restitution_at(made, fastest_impact_) : none)},
      {"largest_x1_m", number(largest_x1_)},
      {"largest_v1_m_per_s", number(largest_v1_)},
      {"largest_x2_m", number(largest_x2_)},
      {"largest_v2_m_per_s", number(largest_v2_)},
      {"peak_force_N", number(last_.peak_force)},
      {"energy_dissipated_J", number(last_.energy_dissipated)},
      {"stepper", word(name_of(made.stepper))},
      {"numeric", word(name_of(made.numeric))},
      {"step_s", number(made.step)},
      {"steps_per_contact", number(resolution(made).steps_per_contact(made.step))},
      {"restitution_error", number(restitution_error(made))},
      {"expected_error_m", number(expected_error_of(made))},
      {"share_of_displacement_bound", number(farthest() / made.bounds->displacement)},
      {"share_of_speed_bound", number(larger(largest_v1_, largest_v2_) / made.bounds->speed)}};
  if (!settings_.part.empty()) {
    const StepCost cost = step_cost(settings_.part, made);
    members.emplace_back("part", word(settings_.part));
    members.emplace_back("instructions_free", number(cost.contact > 0 ? static_cast<double>(cost.free) : none));
    members.emplace_back("instructions_contact", number(cost.contact > 0 ? static_cast<double>(cost.contact) : none));
  }
  members.emplace_back("fault", fault ? word(fault) : "null");
  std::string text;
  for (const auto& [key, value] : members) text += (text.empty() ? "{" : ",") + word(key) + ":" + value;
  return text + "}\n";
}

}  // namespace impact::host
