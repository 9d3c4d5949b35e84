// fragments DATA PARTS: the page's tables and sentences from the files in the folder DATA, as PARTS/*.html, and files
// for its pictures. Every verdict is computed: where a baseline wins or a claim of the paper does not show, the text
// says so.

#include <host_ref/report/page/fragments.hpp>
#include <host_ref/report/page/html.hpp>
#include <host_ref/report/report_program.hpp>

namespace impact::report {

namespace {

void write_fragments(const std::vector<std::string>& arguments) {
  const std::string &folder = arguments.at(0), &parts_folder = arguments.at(1);
  const Table budget = read_table(folder + "/step_budget.csv"), stability = read_table(folder + "/stability.csv"),
              points = with_host(read_table(folder + "/error_vs_time.csv"), read_table(folder + "/accuracy.csv"));
  const auto write = [&](const char* name, const std::string& text) {
    write_file(parts_folder + "/" + name + ".html", text);
  };
  write("glance", at_a_glance(points, budget, stability));
  write("choices", choices(budget, stability));
  write("choice", choice_table(budget, stability));
  write("advantage", advantage(points));
  write_frontiers(parts_folder, points);
  write("budget", budget_table(budget, parts_folder + "/worst_steps.csv"));
  write("stability", stability_table(stability));
  write("coupled", coupled_section(folder));
  write("parts_accuracy", parts_table(read_table(folder + "/parts_accuracy.csv")));
  write_paper_sentences(parts_folder, read_table(folder + "/figures.csv"));
}

}  // namespace
}  // namespace impact::report

int main(int count, char** arguments) {
  return impact::report::run_program(count, arguments, impact::report::write_fragments);
}
