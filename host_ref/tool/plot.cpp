#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <host_ref/text.hpp>
#include <host_ref/tool/output.hpp>
#include <host_ref/tool/plot.hpp>
#include <iostream>

namespace impact::host {
namespace {

std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char letter : text) result += letter == '\'' ? std::string("''") : std::string(1, letter);
  return result + "'";
}

std::string data_block(const char* name, const Curve& curve) {
  std::string text = std::string(name) + " << end\n";
  for (const Curve::Point& point : curve.points()) {
    append_number(text, point.t, 9);
    text += ' ';
    append_number(text, 1e3 * point.x, 6);
    text += '\n';
  }
  return text + "end\n";
}

std::string title(const Request& request) {
  std::string text = std::string(name_of(request.law)) + " contact, ";
  if (request.drive != DriveKind::sine) return text + (request.drive == DriveKind::none ? "no drive" : "sampled drive");
  return text + "driven by " + short_text(request.scene.drive_amplitude) + " N at " +
         short_text(request.scene.drive_pulsation) + " rad/s";
}

// True if the file is complete, since gnuplot does not report a full disk. For a device this cannot be determined.
bool is_whole(const std::string& path) {
  std::error_code none;
  if (!std::filesystem::is_regular_file(path, none)) return true;
  const std::string end = "</svg>";
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  const std::streamoff size = file.tellg(), tail = size < 64 ? size : 64;
  std::string last(tail > 0 ? static_cast<size_t>(tail) : 0, ' ');
  file.seekg(-tail, std::ios::end);
  file.read(last.data(), tail);
  return file && last.find(end) != std::string::npos;
}

}  // namespace

void draw(const std::string& path, const Request& request, const Curve& with_absorber, const Curve& without_absorber) {
  if (std::system("command -v gnuplot >/dev/null") != 0) {
    std::cerr << "impact-sim: --plot " << path << ": gnuplot is not installed, so nothing is drawn\n";
    return;
  }
  Output output(path);
  // Vermilion and blue of Okabe and Ito's palette, which colour-blind readers can distinguish. The widths differ for
  // print.
  const std::string script =
      "set terminal svg size 960,480 font 'sans-serif,15' background rgb 'white' noenhanced\n"
      "set output " +
      quoted(output.written_path()) +
      "\n"
      "set title '" +
      title(request) +
      "'\n"
      "set xlabel 'time, s'\n"
      "set ylabel 'displacement of the main mass, mm'\n"
      "set key below height 1 samplen 3\n"
      "set grid linecolor rgb '#dddddd'\n"
      "set border 3 linecolor rgb '#444444'\n"
      "set tics nomirror\n" +
      data_block("$without", without_absorber) + data_block("$with", with_absorber) +
      "plot $without with lines linewidth 1 linecolor rgb '#D55E00' title 'without absorber', "
      "$with with lines linewidth 2 linecolor rgb '#0072B2' title 'with absorber'\n";
  std::signal(SIGPIPE, SIG_IGN);  // if gnuplot fails, its exit status shows it
  std::FILE* gnuplot = popen("gnuplot", "w");
  if (!gnuplot) throw OutputError(path);
  std::fputs(script.c_str(), gnuplot);
  if (pclose(gnuplot) != 0) throw std::runtime_error("--plot " + path + ": gnuplot failed");
  if (!is_standard_output(path) && !is_whole(output.written_path()))
    throw std::runtime_error("--plot " + path + ": gnuplot could not write the whole file");
  output.commit();
}

}  // namespace impact::host
