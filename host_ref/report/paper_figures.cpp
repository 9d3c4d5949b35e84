// paper_figures OUTPUT.csv TRACES.csv RESTITUTIONS.csv RUNS.csv: the quantities of the paper's figures, from the runs
// of target/paper_runs.cpp and from the reference. It also writes TRACES.csv and RESTITUTIONS.csv, for the pictures.
//
// attenuation: 1 - peak with the absorber / peak without it, both since the start.

#include <cmath>
#include <host_ref/extremes.hpp>
#include <host_ref/reference.hpp>
#include <host_ref/report/paper_scenes.hpp>
#include <host_ref/report/report_program.hpp>
#include <host_ref/report/table.hpp>
#include <host_ref/text.hpp>

namespace impact::report {
namespace {

using host::append_number;
using host::Output;

struct Instant {
  double t, x1, peak, dissipated;  // s, m, m, J
};
using Curve = std::vector<Instant>;

std::vector<Curve> kernel_curves(const std::string& path) {
  std::vector<Curve> curves(paper_runs);
  for (const Row& row : read_table(path)) {
    curves.at(static_cast<size_t>(number(row, "run")))
        .push_back({number(row, "step") * paper_step, 1e-9 * number(row, "x1_nm"), 1e-9 * number(row, "peak_nm"),
                    1e-9 * number(row, "dissipated_nJ")});
  }
  return curves;
}

// The reference at the instants of `kernel`. As there, the peak is that of samples every 0.5 ms.
Curve reference_curve(const PaperRun& run, const Curve& kernel) {
  host::Case scene;
  scene.law = run.law;
  scene.scene = run.scene;
  host::Reference reference(scene);
  Curve curve;
  double peak = 0;
  for (int n = 0; curve.size() < kernel.size(); ++n) {
    const double t = 5 * paper_step * n;
    reference.advance(t);
    const host::Sample now = reference.sample();
    peak = host::larger(peak, std::abs(now.x1));
    if (t > kernel[curve.size()].t - paper_step) curve.push_back({t, now.x1, peak, now.energy_dissipated});
  }
  return curve;
}

struct Curves {
  Curve kernel, reference;
};

double attenuation(const Instant& with, const Instant& without) {
  return without.peak > 0 ? 1 - with.peak / without.peak : 0;
}

void write_traces(const std::string& path, const std::vector<Curves>& curves) {
  Output output(path);
  std::string row = "t";
  for (int run = 0; run < traced_runs; ++run)
    for (const char* what : {" x1", " x1 reference", " attenuation", " dissipated", " dissipated reference"})
      row += std::string(",") + paper_run(run).name + what;
  output.write(row + "\n");
  for (size_t i = 0; i < curves[0].kernel.size(); ++i) {
    row.clear();
    append_number(row, curves[0].kernel[i].t, 6);
    for (int run = 0; run < traced_runs; ++run) {
      const auto& [kernel, reference] = curves[static_cast<size_t>(run)];
      for (const double value :
           {1e3 * kernel[i].x1, 1e3 * reference[i].x1, 100 * attenuation(kernel[i], curves[0].kernel[i]),
            kernel[i].dissipated, reference[i].dissipated})
        append_number(row += ',', value, 5);
    }
    output.write(row + "\n");
  }
  output.commit();
}

void write_restitutions(const std::string& path, const std::vector<Curves>& curves) {
  Output output(path);
  output.write(
      "restitution,hooke-newton,hooke-newton reference,hunt-crossley,hunt-crossley reference,hertz,hertz reference\n");
  for (size_t i = traced_runs; i < paper_runs; i += 2) {
    std::string row;
    append_number(row, paper_run(static_cast<int>(i)).restitution, 3);
    for (const Curves* curve : {&curves[i], &curves[i + 1], &curves[2]})
      for (const double peak : {curve->kernel.back().peak, curve->reference.back().peak})
        append_number(row += ',', 1e3 * peak, 5);
    output.write(row + "\n");
  }
  output.commit();
}

// The largest difference of x1 over the first second, in which trajectories are comparable.
double early_difference(const Curves& curves) {
  double largest = 0;
  for (size_t i = 0; i < curves.kernel.size() && curves.kernel[i].t <= 1; ++i)
    largest = host::larger(largest, std::abs(curves.kernel[i].x1 - curves.reference[i].x1));
  return largest;
}

void write_figures(Output& figures, const std::vector<Curves>& curves) {
  const auto write = [&](int figure, const std::string& law, const std::string& quantity, double value) {
    figures.write(host::csv_line(6, figure, law, quantity, value));
  };
  const auto& without = curves[0];
  const int displacement_figure[] = {0, 2, 4, 6};
  for (int run = 1; run < traced_runs; ++run) {
    const auto& with = curves[static_cast<size_t>(run)];
    const std::string law = paper_run(run).name;
    const int figure = displacement_figure[run];
    write(figure, law, "peak_m", with.kernel.back().peak);
    write(figure, law, "peak_reference_m", with.reference.back().peak);
    write(figure, law, "peak_without_absorber_m", without.kernel.back().peak);
    write(figure, law, "difference_from_reference_in_1_s_m", early_difference(with));
    write(7, law, "peak_m", with.kernel.back().peak);
    write(9, law, "attenuation", attenuation(with.kernel.back(), without.kernel.back()));
    write(9, law, "attenuation_reference", attenuation(with.reference.back(), without.reference.back()));
    write(10, law, "dissipated_J", with.kernel.back().dissipated);
    write(10, law, "dissipated_reference_J", with.reference.back().dissipated);
  }
  for (size_t i = traced_runs; i < paper_runs; ++i) {
    const PaperRun run = paper_run(static_cast<int>(i));
    const std::string e = host::rounded_text(run.restitution, 3);
    write(8, run.name, "peak_at_restitution_" + e + "_m", curves[i].kernel.back().peak);
    write(8, run.name, "peak_reference_at_restitution_" + e + "_m", curves[i].reference.back().peak);
  }
}

}  // namespace

void write_table(Output& output, const std::vector<std::string>& paths) {
  output.write("figure,law,quantity,value\n");
  const std::vector<Curve> kernel = kernel_curves(paths.at(2));
  std::vector<Curves> curves;
  host::Progress progress("runs of the reference", paper_runs);
  for (int run = 0; run < paper_runs; ++run) {
    progress.at(run);
    const Curve& curve = kernel[static_cast<size_t>(run)];
    curves.push_back({curve, reference_curve(paper_run(run), curve)});
  }
  write_traces(paths.at(0), curves);
  write_restitutions(paths.at(1), curves);
  write_figures(output, curves);
}

}  // namespace impact::report
