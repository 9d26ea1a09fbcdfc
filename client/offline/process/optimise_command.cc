#include "client/offline/process/optimise_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "client/offline/process/forecast_job.h"
#include "client/offline/process/milling_report.h"
#include "client/terminal/output.h"
#include "client/terminal/result_files.h"
#include "config/files/chatter_file.h"
#include "jobs/cutting/cut_columns.h"
#include "recording/plot/gnuplot.h"

namespace stanok::client {
namespace {

using jobs::ForceForecast;
using jobs::ForcePlace;
using jobs::ForecastRequest;
using jobs::MillingForecast;
using jobs::MillingPlace;
using jobs::MillingRequest;
using jobs::with_feeds;

struct OptimiseOptions {
  std::string program;
  JobOptions job;
  double force_n = 0.0;
  double feed_min = 0.0;
  double feed_max = 0.0;
  std::string cut;  // file; empty: a turning program
  int tool = 0;
  double step_mm = 0.0;
  double stiffness_n_per_um = 0.0;  // turning
  std::string out;
  std::string csv;
  std::string picture;
};

// Path, depth, power, forces and feeds before and after.
std::string forces_script(const ForceForecast& forecast, double stiffness_n_per_um,
                          const std::filesystem::path& file) {
  constexpr std::size_t shown_max = 4000;
  const auto columns = jobs::columns_named(
      jobs::turning_columns(), {"path_mm", "force_programmed_n", "force_n", "feed_programmed_mm",
                                "feed_mm", "depth_mm", "power_w"});
  std::string text =
      recording::data_block("places", jobs::thinned(forecast.places, shown_max, columns));
  const bool is_png = file.extension() == ".png";
  text += std::string("set terminal ") +
          (is_png ? "pngcairo enhanced background rgb 'white' font 'Sans,12'"
                  : "svg enhanced background rgb 'white' font 'Sans,14'") +
          " size 1100,1000\nset output " +
          recording::gnuplot_text(std::filesystem::absolute(file).string()) +
          "\nset encoding utf8\nset border 3 lc rgb '#9aa3a9' lw 1\n"
          "set tics nomirror out scale 0.6 textcolor rgb '#4a4f54'\n"
          "set grid lc rgb '#e7eaec' lw 1 lt 1\nset yrange [0:*]\n"
          "set key at graph 1, graph 1.13 right top horizontal maxrows 1 Left reverse samplen 2 "
          "textcolor rgb '#2b2f33'\n"
          "set multiplot layout 4,1 margins 0.08,0.90,0.07,0.96 spacing 0,0.08\n"
          "set ylabel 'P_z [N]'\n";
  if (stiffness_n_per_um > 0.0) {
    const std::string k = recording::number(stiffness_n_per_um);
    text += "set border 11\nset link y2 via y/" + k + " inverse y*" + k +
            "\nset format y2 '%.1f'\nset y2tics out scale 0.6\nset y2label 'deflection [{/Symbol "
            "m}m]'\n";
  }
  text +=
      "plot $places using 1:2 with lines lw 1 lc rgb '#9aa3a9' title 'as programmed', \\\n"
      "  $places using 1:3 with lines lw 1.5 lc rgb '#1f4e79' title 'planned'\n"
      "unset link y2\nunset y2tics\nunset y2label\nset border 3\n"
      "set ylabel 'feed [mm/rev]'\n"
      "plot $places using 1:4 with steps lw 1 lc rgb '#9aa3a9' title 'as programmed', \\\n"
      "  $places using 1:5 with steps lw 1.5 lc rgb '#3a7d44' title 'planned'\n"
      "set ylabel 'power [W]'\n"
      "plot $places using 1:7 with lines lw 1.5 lc rgb '#c8553d' title 'planned'\n"
      "set ylabel 'depth [mm]'\nset xlabel 'path at feed [mm]'\n"
      "plot $places using 1:6 with steps lw 1.5 lc rgb '#b8860b' title 'depth of cut'\n"
      "unset multiplot\nunset output\n";
  return text;
}

// Where even the least feed takes more than the set force.
void warn_of_force(double most_n, double set_n) {
  constexpr double tolerated = 1.01;
  if (set_n <= 0.0 || most_n <= tolerated * set_n) return;
  write_message(fmt::format(
      "warning: the least feed takes {:.1f} N somewhere, more than the set {:.1f} N; allow a lower "
      "one with --feed-min, or take less at once\n",
      most_n, set_n));
}

int optimise_milling(const OptimiseOptions& options) {
  const MillingRequest request{.job = forecast_job(options.program, options.job),
                               .cut = config::read_chatter_file(options.cut),
                               .tool = options.tool,
                               .step_mm = options.step_mm,
                               .force_n = options.force_n,
                               .feed_min = options.feed_min,
                               .feed_max = options.feed_max};
  if (request.cut.kind != process::CutKind::milling)
    throw std::runtime_error(options.cut + " is not of a milling tool; give kind = \"milling\"");
  const MillingForecast forecast = forecast_milling(request);
  if (!options.out.empty())
    write_text_file(options.out, with_feeds(request.job.text, forecast.lines));
  if (!options.csv.empty())
    write_text_file(options.csv, jobs::csv(forecast.places, jobs::milling_columns()));
  if (!options.picture.empty()) draw_picture(forecast, options.picture);
  if (options.job.json) {
    write_json(to_json(forecast));
  } else {
    write_data(to_text(forecast));
  }
  warn_of_force(jobs::greatest(forecast.places, &MillingPlace::force_planned_n), request.force_n);
  return 0;
}

int run_optimise(const OptimiseOptions& options) {
  if (!options.cut.empty()) return optimise_milling(options);
  const ForecastRequest request{.job = forecast_job(options.program, options.job),
                                .force_n = options.force_n,
                                .feed_min = options.feed_min,
                                .feed_max = options.feed_max,
                                .stiffness_n_per_um = options.stiffness_n_per_um};
  const ForceForecast forecast = forecast_forces(request);
  if (!options.out.empty())
    write_text_file(options.out, with_feeds(request.job.text, forecast.lines));
  if (!options.csv.empty())
    write_text_file(options.csv, jobs::csv(forecast.places, jobs::turning_columns()));
  if (!options.picture.empty()) {
    if (const auto error =
            recording::draw(forces_script(forecast, options.stiffness_n_per_um, options.picture)))
      throw std::runtime_error("cannot draw " + options.picture + ": " + error->text);
  }
  const double before_n = jobs::greatest(forecast.places, &ForcePlace::force_programmed_n);
  const double after_n = jobs::greatest(forecast.places, &ForcePlace::force_n);
  const double power_w = jobs::greatest(forecast.places, &ForcePlace::power_w);
  const double deflection = jobs::greatest(forecast.places, &ForcePlace::deflection_um);
  if (options.job.json) {
    nlohmann::ordered_json json{{"force_programmed_max_n", before_n},
                                {"force_max_n", after_n},
                                {"power_max_w", power_w},
                                {"time_programmed_s", forecast.time_programmed_s},
                                {"time_s", forecast.time_s},
                                {"blocks", forecast.lines.size()}};
    if (deflection > 0.0) json["deflection_max_um"] = deflection;
    write_json(json);
  } else {
    write_data(
        fmt::format("as programmed  {:.1f} N at most, {:.2f} s at feed\n"
                    "planned        {:.1f} N at most, {:.2f} s at feed, {:.0f} W\n",
                    before_n, forecast.time_programmed_s, after_n, forecast.time_s, power_w));
    if (deflection > 0.0)
      write_data(fmt::format("               {:.1f} um of deflection at most\n", deflection));
  }
  warn_of_force(after_n, options.force_n);
  return 0;
}

}  // namespace

void add_optimise_command(CLI::App& noun, int& exit_code) {
  const auto options = std::make_shared<OptimiseOptions>();
  CLI::App* command = noun.add_subcommand(
      "optimise", "forces along a program, and feeds that keep them at a set value");
  command->add_option("PROGRAM", options->program, "part program")->required()->type_name("FILE");
  add_job_options(*command, options->job);
  CLI::Option* const cut =
      command
          ->add_option("--cut", options->cut,
                       "a milling program: tool and material (TOML, as of `process lobes`)")
          ->type_name("FILE");
  command
      ->add_option("--tool", options->tool,
                   "with --cut: number of the tool whose cuts are evaluated; default: all")
      ->check(CLI::PositiveNumber)
      ->needs(cut);
  command
      ->add_option("--step", options->step_mm,
                   "with --cut: distance between two evaluated places, mm; default: twice the "
                   "resolution of the workpiece")
      ->check(CLI::Range(0.001, 100.0))
      ->needs(cut);
  command
      ->add_option("--stiffness", options->stiffness_n_per_um,
                   "turning: stiffness of tool and part across the cut, N/um; if given, the "
                   "deflection is reported")
      ->check(CLI::PositiveNumber)
      ->excludes(cut);
  command
      ->add_option(
          "--force", options->force_n,
          "cutting force to be kept, N; without it, only the forces as programmed are reported")
      ->check(CLI::PositiveNumber);
  command
      ->add_option("--feed-min", options->feed_min,
                   "minimum feed, mm per turn; default: a twentieth of the programmed feed")
      ->check(CLI::PositiveNumber);
  command
      ->add_option("--feed-max", options->feed_max,
                   "maximum feed, mm per turn; default: the programmed feed")
      ->check(CLI::PositiveNumber);
  command->add_option("--out", options->out, "part program to write")->type_name("FILE");
  command->add_option("--csv", options->csv, "write the forces along the path as CSV")
      ->type_name("FILE");
  command->add_option("--picture", options->picture, "draw the forces along the path, .svg or .png")
      ->type_name("FILE")
      ->check(picture_name_fault);
  command->callback([options, &exit_code] { exit_code = run_optimise(*options); });
}

}  // namespace stanok::client
