#include "client/offline/process/milling_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "jobs/cutting/cut_columns.h"
#include "recording/plot/gnuplot.h"

namespace stanok::client {
namespace {

using jobs::MillingForecast;
using jobs::MillingPlace;

using recording::gnuplot_text;
using recording::number;

constexpr std::size_t shown_places_max = 6000;

// The place where a quantity is greatest; nullptr: there is none.
const MillingPlace* greatest(const MillingForecast& forecast, double MillingPlace::* quantity) {
  const auto found = std::ranges::max_element(
      forecast.places, {}, [quantity](const MillingPlace& place) { return place.*quantity; });
  return found == forecast.places.end() ? nullptr : &*found;
}

std::string rows_of_picture(const MillingForecast& forecast) {
  const auto columns =
      jobs::columns_named(jobs::milling_columns(),
                          {"path_mm", "x_mm", "y_mm", "force_programmed_n", "force_n",
                           "feed_programmed_mm_min", "feed_mm_min", "power_w", "deflection_um"});
  return recording::data_block("places", jobs::thinned(forecast.places, shown_places_max, columns));
}

}  // namespace

std::string to_text(const MillingForecast& forecast) {
  const MillingPlace* const peak = greatest(forecast, &MillingPlace::force_peak_n);
  if (peak == nullptr) return "nothing is cut at feed\n";
  std::string text = fmt::format(
      "as programmed  {:.1f} N at most, in line {} at X{:.3f} Y{:.3f} Z{:.3f}; {:.2f} s at feed\n",
      peak->force_peak_n, peak->line, peak->x_mm, peak->y_mm, peak->z_mm,
      forecast.time_programmed_s);
  text += fmt::format("               {:.1f} W and {:.1f} um of deflection at most\n",
                      jobs::greatest(forecast.places, &MillingPlace::power_w),
                      jobs::greatest(forecast.places, &MillingPlace::deflection_um));
  if (!forecast.lines.empty()) {
    text += fmt::format("planned        {:.1f} N at most, {:.2f} s at feed\n",
                        jobs::greatest(forecast.places, &MillingPlace::force_planned_n),
                        forecast.time_s);
  }
  return text;
}

nlohmann::ordered_json to_json(const MillingForecast& forecast) {
  const MillingPlace* const peak = greatest(forecast, &MillingPlace::force_peak_n);
  nlohmann::ordered_json json{
      {"force_programmed_max_n", jobs::greatest(forecast.places, &MillingPlace::force_peak_n)},
      {"force_max_n", jobs::greatest(forecast.places, &MillingPlace::force_planned_n)},
      {"power_max_w", jobs::greatest(forecast.places, &MillingPlace::power_w)},
      {"deflection_max_um", jobs::greatest(forecast.places, &MillingPlace::deflection_um)},
      {"time_programmed_s", forecast.time_programmed_s},
      {"time_s", forecast.time_s},
      {"blocks", forecast.lines.size()}};
  if (peak != nullptr) json["force_programmed_max_line"] = peak->line;
  return json;
}

std::string picture_script(const MillingForecast& forecast, const std::filesystem::path& file) {
  const bool is_png = file.extension() == ".png";
  const bool is_planned = !forecast.lines.empty();
  std::string text = rows_of_picture(forecast);
  text += std::string("set terminal ") +
          (is_png ? "pngcairo enhanced background rgb 'white' font 'Sans,12'"
                  : "svg enhanced background rgb 'white' font 'Sans,14'") +
          " size 1400,900\nset output " + gnuplot_text(std::filesystem::absolute(file).string()) +
          "\nset encoding utf8\nset border 3 lc rgb '#9aa3a9' lw 1\n"
          "set tics nomirror out scale 0.6 textcolor rgb '#4a4f54'\n"
          "set grid lc rgb '#e7eaec' lw 1 lt 1\nset yrange [0:*]\n"
          "set key at graph 1, graph 1.14 right top horizontal maxrows 1 Left reverse samplen 2 "
          "textcolor rgb '#2b2f33'\nset multiplot\n";
  // Four pictures along the path, one above the other, on the left.
  const auto panel = [&](int row, const char* label, const std::string& plot) {
    const double top = 0.95 - 0.235 * row;
    text += "set lmargin at screen 0.075\nset rmargin at screen 0.56\nset tmargin at screen " +
            number(top) + "\nset bmargin at screen " + number(top - 0.17) + "\nset ylabel " +
            gnuplot_text(label) + "\nplot " + plot + "\n";
  };
  const std::string grey = "lw 1 lc rgb '#9aa3a9' title 'as programmed'";
  const std::string blue = "lw 1.5 lc rgb '#1f4e79' title ";
  panel(0, "greatest force [N]",
        is_planned ? "$places using 1:4 with lines " + grey +
                         ", \\\n  $places using 1:5 with lines " + blue + "'planned'"
                   : "$places using 1:4 with lines " + blue + "'as programmed'");
  panel(1, "feed [mm/min]",
        is_planned ? "$places using 1:6 with steps " + grey +
                         ", \\\n  $places using 1:7 with steps lw 1.5 lc rgb '#3a7d44' title "
                         "'planned'"
                   : "$places using 1:6 with steps lw 1.5 lc rgb '#3a7d44' title 'as programmed'");
  panel(2, "power of the cut [W]",
        "$places using 1:8 with lines lw 1.5 lc rgb '#b8860b' title 'as programmed'");
  text += "set xlabel 'path at feed [mm]'\n";
  panel(3, "deflection [{/Symbol m}m]",
        "$places using 1:9 with lines lw 1.5 lc rgb '#c8553d' title 'as programmed'");
  text +=
      "set lmargin at screen 0.64\nset rmargin at screen 0.90\nset tmargin at screen 0.95\n"
      "set bmargin at screen 0.075\nset autoscale y\nset size ratio -1\n"
      "set xlabel 'X [mm]'\nset ylabel 'Y [mm]'\nset cblabel 'greatest force [N]'\n"
      "set palette defined (0 '#dfe6ea', 0.5 '#b8860b', 1 '#c8553d')\nset cbrange [0:*]\n"
      "plot $places using 2:3:" +
      std::string(is_planned ? "5" : "4") +
      " with points pt 7 ps 0.4 palette notitle\nunset multiplot\nunset output\n";
  return text;
}

void draw_picture(const MillingForecast& forecast, const std::filesystem::path& file) {
  if (forecast.places.empty()) throw std::runtime_error("nothing is cut at feed: no picture");
  if (const auto error = recording::draw(picture_script(forecast, file)))
    throw std::runtime_error("cannot draw " + file.string() + ": " + error->text);
}

}  // namespace stanok::client
