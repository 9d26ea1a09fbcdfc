#include "client/offline/process/optimise_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "client/offline/process/force_forecast.h"
#include "client/terminal/output.h"
#include "client/terminal/result_files.h"
#include "recording/plot/gnuplot.h"

namespace stanok::client {
namespace {

struct OptimiseOptions {
  ForecastRequest request;
  std::string out;
  std::string csv;
  std::string picture;
};

std::string forces_csv(const ForceForecast& forecast) {
  std::string text =
      "line,path_mm,x_mm,z_mm,depth_mm,feed_programmed_mm,force_programmed_n,feed_mm,force_n,"
      "power_w\n";
  for (const ForcePlace& place : forecast.places) {
    text += fmt::format("{},{:.3f},{:.4f},{:.4f},{:.4f},{:.4f},{:.1f},{:.4f},{:.1f},{:.1f}\n",
                        place.line, place.path_mm, place.x_mm, place.z_mm, place.depth_mm,
                        place.feed_programmed, place.force_programmed_n, place.feed, place.force_n,
                        place.power_w);
  }
  return text;
}

// Path, depth, forces and feeds before and after.
std::string forces_script(const ForceForecast& forecast, const std::filesystem::path& file) {
  using recording::number;
  constexpr std::size_t shown_max = 4000;
  const std::size_t stride = 1 + forecast.places.size() / shown_max;
  std::string text = "$places << END\n";
  for (std::size_t k = 0; k < forecast.places.size(); k += stride) {
    const ForcePlace& place = forecast.places[k];
    for (const double value : {place.path_mm, place.force_programmed_n, place.force_n,
                               place.feed_programmed, place.feed, place.depth_mm})
      text += number(value) + " ";
    text += "\n";
  }
  const bool is_png = file.extension() == ".png";
  text += std::string("END\nset terminal ") +
          (is_png ? "pngcairo enhanced background rgb 'white' font 'Sans,12'"
                  : "svg enhanced background rgb 'white' font 'Sans,14'") +
          " size 1100,800\nset output " +
          recording::gnuplot_text(std::filesystem::absolute(file).string()) +
          "\nset encoding utf8\nset border 3 lc rgb '#9aa3a9' lw 1\n"
          "set tics nomirror out scale 0.6 textcolor rgb '#4a4f54'\n"
          "set grid lc rgb '#e7eaec' lw 1 lt 1\nset yrange [0:*]\n"
          "set key at graph 1, graph 1.13 right top horizontal maxrows 1 Left reverse samplen 2 "
          "textcolor rgb '#2b2f33'\n"
          "set multiplot layout 3,1 margins 0.08,0.96,0.08,0.95 spacing 0,0.1\n"
          "set ylabel 'P_z [N]'\n"
          "plot $places using 1:2 with lines lw 1 lc rgb '#9aa3a9' title 'as programmed', \\\n"
          "  $places using 1:3 with lines lw 1.5 lc rgb '#1f4e79' title 'planned'\n"
          "set ylabel 'feed [mm/rev]'\n"
          "plot $places using 1:4 with steps lw 1 lc rgb '#9aa3a9' title 'as programmed', \\\n"
          "  $places using 1:5 with steps lw 1.5 lc rgb '#3a7d44' title 'planned'\n"
          "set ylabel 'depth [mm]'\nset xlabel 'path at feed [mm]'\n"
          "plot $places using 1:6 with steps lw 1.5 lc rgb '#b8860b' title 'depth of cut'\n"
          "unset multiplot\nunset output\n";
  return text;
}

std::string text_of_program(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::runtime_error("cannot read " + path + "; check the path");
  return {std::istreambuf_iterator<char>(file), {}};
}

double greatest(const ForceForecast& forecast, double ForcePlace::* quantity) {
  double most = 0.0;
  for (const ForcePlace& place : forecast.places) most = std::max(most, place.*quantity);
  return most;
}

int run_optimise(const OptimiseOptions& options) {
  const ForceForecast forecast = forecast_forces(options.request);
  if (!options.out.empty()) {
    write_text_file(options.out,
                    with_feeds(text_of_program(options.request.program), forecast.lines));
  }
  if (!options.csv.empty()) write_text_file(options.csv, forces_csv(forecast));
  if (!options.picture.empty()) {
    if (const auto error = recording::draw(forces_script(forecast, options.picture)))
      throw std::runtime_error("cannot draw " + options.picture + ": " + error->text);
  }
  const double before_n = greatest(forecast, &ForcePlace::force_programmed_n);
  const double after_n = greatest(forecast, &ForcePlace::force_n);
  const double power_w = greatest(forecast, &ForcePlace::power_w);
  if (options.request.job.json) {
    write_json(nlohmann::ordered_json{{"force_programmed_max_n", before_n},
                                      {"force_max_n", after_n},
                                      {"power_max_w", power_w},
                                      {"time_programmed_s", forecast.time_programmed_s},
                                      {"time_s", forecast.time_s},
                                      {"blocks", forecast.lines.size()}});
  } else {
    write_data(
        fmt::format("as programmed  {:.1f} N at most, {:.2f} s at feed\n"
                    "planned        {:.1f} N at most, {:.2f} s at feed, {:.0f} W\n",
                    before_n, forecast.time_programmed_s, after_n, forecast.time_s, power_w));
  }
  return 0;
}

}  // namespace

void add_optimise_command(CLI::App& noun, int& exit_code) {
  const auto options = std::make_shared<OptimiseOptions>();
  CLI::App* command = noun.add_subcommand(
      "optimise", "forces along a turning program, and feeds that keep them at a set value");
  ForecastRequest& request = options->request;
  command->add_option("PROGRAM", request.program, "part program")->required()->type_name("FILE");
  add_job_options(*command, request.job);
  command
      ->add_option("--force", request.force_n,
                   "cutting force to be kept, N; without it the forces as programmed are told")
      ->check(CLI::PositiveNumber);
  command
      ->add_option("--feed-min", request.feed_min,
                   "least feed, mm per turn; default: a twentieth of the programmed one")
      ->check(CLI::PositiveNumber);
  command
      ->add_option("--feed-max", request.feed_max,
                   "greatest feed, mm per turn; default: the programmed one")
      ->check(CLI::PositiveNumber);
  command->add_option("--out", options->out, "part program to write")->type_name("FILE");
  command->add_option("--csv", options->csv, "forces along the path as CSV")->type_name("FILE");
  command->add_option("--picture", options->picture, "the same as a picture, .svg or .png")
      ->type_name("FILE")
      ->check(picture_name_fault);
  command->callback([options, &exit_code] { exit_code = run_optimise(*options); });
}

}  // namespace stanok::client
