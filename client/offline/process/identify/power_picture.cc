#include "client/offline/process/identify/power_picture.h"

#include <stdexcept>

#include "recording/plot/gnuplot.h"

namespace stanok::client {
namespace {

using recording::gnuplot_text;

constexpr std::size_t shown_points_max = 6000;

std::string panel(const char* title, const char* label, const std::string& plot) {
  return "set label 1 " + gnuplot_text(title) +
         " at graph 0, graph 1.08 left font ',15' textcolor rgb '#2b2f33'\nset ylabel " +
         gnuplot_text(label) + "\nplot " + plot + "\n";
}

}  // namespace

std::string power_picture_script(const std::vector<jobs::PowerPoint>& points,
                                 const std::filesystem::path& file) {
  const bool is_png = file.extension() == ".png";
  std::string text = recording::data_block(
      "power", jobs::thinned(points, shown_points_max, jobs::power_columns()));
  text += std::string("set terminal ") +
          (is_png ? "pngcairo enhanced background rgb 'white' font 'Sans,12'"
                  : "svg enhanced background rgb 'white' font 'Sans,14'") +
          " size 1100,800\nset output " + gnuplot_text(std::filesystem::absolute(file).string()) +
          "\nset encoding utf8\nset border 3 lc rgb '#9aa3a9' lw 1\n"
          "set tics nomirror out scale 0.6 textcolor rgb '#4a4f54'\n"
          "set grid lc rgb '#e7eaec' lw 1 lt 1\n"
          "set key at graph 1, graph 1.13 right top horizontal maxrows 1 Left reverse samplen 2 "
          "textcolor rgb '#2b2f33'\n"
          "set multiplot layout 2,1 margins 0.08,0.96,0.08,0.93 spacing 0,0.13\n";
  text += panel("Power of the spindle", "N_d [W]",
                "$power using 1:2 with points pt 7 ps 0.25 lc rgb '#9aa3a9' title 'recorded', \\\n"
                "  $power using 1:3 with lines lw 1.5 lc rgb '#1f4e79' title 'model'");
  text += "set xlabel 'time [s]'\n";
  text += panel("What the model leaves", "recorded - model [W]",
                "$power using 1:4 with points pt 7 ps 0.25 lc rgb '#c8553d' title 'residual'");
  return text + "unset multiplot\nunset output\n";
}

void draw_power_picture(const std::vector<jobs::PowerPoint>& points,
                        const std::filesystem::path& file) {
  if (const auto error = recording::draw(power_picture_script(points, file)))
    throw std::runtime_error("cannot draw " + file.string() + ": " + error->text);
}

}  // namespace stanok::client
