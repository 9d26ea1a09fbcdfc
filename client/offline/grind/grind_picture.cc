#include "client/offline/grind/grind_picture.h"

#include <cmath>
#include <ranges>
#include <stdexcept>

#include "jobs/grinding/grinding_samples.h"
#include "recording/plot/gnuplot.h"

namespace stanok::client {
namespace {

namespace fs = std::filesystem;
using process::Boundary;
using recording::gnuplot_text;
using recording::number;

constexpr std::size_t points_max = 700;  // of a curve
constexpr const char* size = "1100,1000";
constexpr double shown_beyond_mm = 1e-4;  // of a law, behind the end of its cycle

// The law as removal: Q of the steady state that belongs to a feed, down to an X.
std::string law_block(const std::string& name, const process::GrindingProcess& process,
                      const process::InfeedLaw& law, double end_mm) {
  const double Q_per_feed = process::removal_radius_mm(process) * process::revolution_s(process);
  std::string text = name + " << END\n";
  for (const process::InfeedRow& row : law) {
    if (row.x_mm < end_mm) break;
    text += number(row.x_mm) + " " + number(Q_per_feed * row.feed_mm_per_s) + "\n";
  }
  return text + "END\n";
}

std::string boundary_block(const process::DesignRequest& request) {
  const Boundary boundary(request.process);
  std::string text = "$boundary << END\n";
  const auto add = [&](double H) { text += number(H) + " " + number(boundary.at(H)) + "\n"; };
  add(request.allowance_mm);
  for (const process::BurnPoint& corner : std::views::reverse(boundary.corners()))
    add(corner.allowance_mm);
  add(-process::overrun_max_mm(request.process));
  return text + "END\n";
}

std::string run_block(const std::string& name, const process::GrindingProcess& process,
                      const process::PlungeRun& run) {
  return recording::data_block(name, jobs::thinned(jobs::grinding_samples(process, run), points_max,
                                                   jobs::grinding_overview()));
}

std::string look() {
  return "set encoding utf8\n"
         "set border 3 lc rgb '#9aa3a9' lw 1\n"
         "set tics nomirror out scale 0.6 textcolor rgb '#4a4f54'\n"
         "set grid lc rgb '#e7eaec' lw 1 lt 1\n"
         "set key at graph 1, graph 1.13 right top horizontal maxrows 1 Left reverse samplen 2 "
         "textcolor rgb '#2b2f33'\n";
}

// At the left, on the line of the legend.
std::string title(const char* words) {
  return "set label 1 " + gnuplot_text(words) +
         " at graph 0, graph 1.08 left font ',15' textcolor rgb '#2b2f33'\n";
}

std::string removal_panel(const GrindPicture& picture) {
  const double right = -process::overrun_max_mm(picture.request.process);
  std::string text = title("Removal") +
                     "set xlabel 'H or X [mm]'\n"
                     "set ylabel 'Q [mm²/rad]'\n";
  text += "set xrange [" + number(picture.request.allowance_mm) + ":" + number(right) + "]\n";
  text += "set yrange [0:*]\n";
  text += "plot $boundary with lines lw 2 lc rgb '#c8553d' title 'boundary D(H)', \\\n";
  if (picture.optimum != nullptr) {
    text +=
        "  $continuous with lines lw 1 lc rgb '#b4bec6' title 'optimum V · R_{eq}τ', "
        "\\\n";
  }
  return text +
         "  $law with lines lw 1.5 lc rgb '#3a7d44' title 'infeed V(X) · R_{eq}τ', \\\n"
         "  $run using 3:5 with lines lw 1.5 lc rgb '#1f4e79' title 'removal Q(H)'\n";
}

std::string time_panel(const process::PlungeRun& run) {
  std::string text = title("Infeed in time") +
                     "set xlabel 'time [s]'\nset ylabel 'X, H [mm]'\n"
                     "set y2label 'infeed [mm/s]' offset -1,0 textcolor rgb '#3a7d44'\nset "
                     "y2tics\nset y2range [0:*]\n"
                     "set border 11\n";
  text += "set xrange [0:" + number(run.time_s) + "]\nset yrange [*:*]\n";
  return text +
         "plot $run using 1:2 with lines lw 1.5 lc rgb '#1f4e79' title 'X of the wheel head', \\\n"
         "  $run using 1:3 with lines lw 1.5 lc rgb '#b8860b' title 'allowance left H', \\\n"
         "  $run using 1:4 axes x1y2 with steps lw 1.5 lc rgb '#3a7d44' title 'infeed'\n";
}

std::string ratio_panel(const process::PlungeRun& run) {
  return "unset y2tics\nunset y2label\nset border 3\n" + title("Use of the boundary") +
         "set ylabel 'Q/D'\nset yrange [0:1.1<*]\n"
         "set xrange [0:" +
         number(run.time_s) +
         "]\n"
         "plot 1 with lines lw 1.5 lc rgb '#c8553d' title 'boundary', \\\n"
         "  $run using 1:6 with lines lw 1.5 lc rgb '#1f4e79' title 'Q/D'\n";
}

}  // namespace

std::string picture_script(const GrindPicture& picture, const fs::path& file) {
  const process::GrindingProcess& process = picture.request.process;
  const std::string terminal = file.extension() == ".png"
                                   ? "pngcairo enhanced background rgb 'white' font 'Sans,12'"
                                   : "svg enhanced background rgb 'white' font 'Sans,14'";
  const auto law = [&](const char* name, const process::InfeedLaw& rows,
                       const process::PlungeRun& run) {
    return law_block(name, process, rows, run.samples.back().x_mm - shown_beyond_mm);
  };
  std::string text = boundary_block(picture.request) + law("$law", picture.law, picture.run) +
                     run_block("run", process, picture.run);
  if (picture.optimum != nullptr) {
    text += law("$continuous", picture.optimum->law, picture.optimum->run);
  }
  text += look() + "set terminal " + terminal + " size " + size + "\nset output " +
          gnuplot_text(fs::absolute(file).string()) + "\n";
  text += "set multiplot layout 3,1 margins 0.08,0.90,0.06,0.95 spacing 0,0.12\n";
  return text + removal_panel(picture) + time_panel(picture.run) + ratio_panel(picture.run) +
         "unset multiplot\nunset output\n";
}

void draw_picture(const GrindPicture& picture, const fs::path& file) {
  if (const auto error = recording::draw(picture_script(picture, file))) {
    throw std::runtime_error("cannot draw " + file.string() + ": " + error->text);
  }
}

}  // namespace stanok::client
