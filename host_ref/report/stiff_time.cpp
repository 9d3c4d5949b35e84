// stiff_time OUTPUT.csv COST.csv...: the error of the runs at a stop like steel (stiff_scene.hpp), measured on this
// host, against the instructions of a simulated second on the targets.

#include <cmath>
#include <host_ref/extremes.hpp>
#include <host_ref/reference.hpp>
#include <host_ref/report/report_program.hpp>
#include <host_ref/report/stiff_scene.hpp>
#include <host_ref/report/table.hpp>
#include <host_ref/text.hpp>

namespace impact::report {

void write_table(host::Output& output, const std::vector<std::string>& inputs) {
  output.write("target,method,numeric,step_s,contact_steps,error_m,instructions_per_simulated_second\n");
  host::Case run;
  run.scene = stiff_scene(steel);
  const auto reference = host::reference_trajectory(run, stiff_interval, stiff_duration).samples;
  std::map<std::string, double> errors;  // by method,numeric,microseconds,contact_steps
  const auto key = [](const std::string& method, const std::string& numeric, const std::string& microseconds,
                      const std::string& contact_steps) {
    return method + "," + numeric + "," + microseconds + "," + contact_steps;
  };
  const auto measure = [&](const char* method, const char* numeric, int microseconds, int contact_steps, auto& model) {
    double error = 0;
    for (size_t row = 1; row <= stiff_rows; ++row) {
      for (int step = 0; step < 4000 / microseconds; ++step) model.step();
      error = host::larger(error, std::abs(model.reading().x1 - reference.at(row).x1));
    }
    errors[key(method, numeric, std::to_string(microseconds), std::to_string(contact_steps))] = error;
  };
  run_at_steel<Float32>("float32", measure);
  run_at_steel<Float32Plain>("float32-plain", measure);
  run_at_steel<Fixed32>("fixed32", measure);
  run_events_at_steel(measure);

  for (size_t i = 0; i < inputs.size(); ++i)
    for (const Row& row : read_table(inputs[i])) {
      const std::string &method = row.at("method"), &numeric = row.at("numeric"), &steps = row.at("contact_steps");
      output.write(host::csv_line(5, row.at("target"), method, numeric, 1e-6 * number(row, "microseconds"), steps,
                                  errors.at(key(method, numeric, row.at("microseconds"), steps)),
                                  number(row, "instructions") / stiff_duration));
    }
}

}  // namespace impact::report
