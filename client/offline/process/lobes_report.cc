#include "client/offline/process/lobes_report.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "client/terminal/text_table.h"
#include "recording/plot/gnuplot.h"

namespace stanok::client {
namespace {

using process::LimitAt;
using process::LobesStudy;
using process::PlannedCut;
using recording::gnuplot_text;
using recording::number;

constexpr double shown_max = 5.0;  // of the depth that is always stable: height of the picture

bool is_grinding(const LobesStudy& study) {
  return study.kind == process::CutKind::grinding;
}

std::string depth_text(double depth_mm) {
  return std::isfinite(depth_mm) ? fmt::format("{:.3f}", depth_mm) : "any";
}

std::string cut_text(const PlannedCut& cut) {
  std::string text =
      fmt::format("{:.0f} rev/min, {:.3f} mm: {}, limit {} mm", cut.speed_rev_per_min, cut.depth_mm,
                  cut.is_stable() ? "stable" : "chatters", depth_text(cut.limit_mm));
  if (cut.better_speed > 0.0) text += fmt::format("; stable at {:.0f} rev/min", cut.better_speed);
  if (!cut.is_stable() && cut.better_speed == 0.0) text += "; at no speed of the range";
  return text + "\n";
}

// Marks of a logarithmic axis: 1, 2, 3 and 5 of each power of ten.
std::string marks(double from, double to) {
  std::string text;
  const int last = static_cast<int>(std::floor(std::log10(to)));
  for (int decade = static_cast<int>(std::floor(std::log10(from))); decade <= last; ++decade) {
    const double power = std::pow(10.0, decade);
    for (const double part : {1.0, 2.0, 3.0, 5.0}) {
      const double mark = part * power;
      if (mark < from || mark > to) continue;
      text += (text.empty() ? "" : ",") + number(mark);
    }
  }
  return "set xtics (" + text + ")\n";
}

// The planned cuts that are stable, or that are not, as a curve of the picture; empty: there is
// none.
struct Curve {
  std::string data;
  std::string plot;
};

template <class Shown>
Curve curve_of(const std::vector<PlannedCut>& cuts, const std::string& name,
               const std::string& style, Shown shown) {
  std::string rows;
  for (const PlannedCut& cut : cuts) {
    if (shown(cut)) rows += number(cut.speed_rev_per_min) + " " + number(cut.depth_mm) + "\n";
  }
  if (rows.empty()) return {};
  return {.data = name + " << END\n" + rows + "END\n",
          .plot = ", \\\n  " + name + " with points " + style};
}

}  // namespace

std::string to_text(const LobesStudy& study) {
  std::string text =
      fmt::format("stable at every speed up to {} mm\n", depth_text(study.always_mm));
  if (!study.best.empty()) {
    TextTable table(
        {"speed, rev/min", is_grinding(study) ? "width, mm" : "depth, mm", "chatter, Hz"});
    for (const LimitAt& limit : study.best) {
      table.add_row({fmt::format("{:.0f}", limit.speed_rev_per_min), depth_text(limit.depth_mm),
                     limit.chatter_hz > 0.0 ? fmt::format("{:.1f}", limit.chatter_hz) : "-"});
    }
    text += "the best speeds\n" + table.text(Terminal(STDOUT_FILENO));
  }
  for (const PlannedCut& cut : study.cuts) text += cut_text(cut);
  return text;
}

std::string to_csv(const LobesStudy& study) {
  std::string text = "speed_rev_per_min,depth_mm,chatter_hz\n";
  for (const LimitAt& limit : study.limits) {
    const bool is_finite = std::isfinite(limit.depth_mm);
    text += number(limit.speed_rev_per_min) + "," + (is_finite ? number(limit.depth_mm) : "") +
            "," + (limit.chatter_hz > 0.0 ? number(limit.chatter_hz) : "") + "\n";
  }
  return text;
}

std::string picture_script(const LobesStudy& study, const std::filesystem::path& file) {
  double top = std::isfinite(study.always_mm) ? shown_max * study.always_mm : 1.0;
  for (const PlannedCut& cut : study.cuts) top = std::max(top, 1.2 * cut.depth_mm);
  std::string text = "$limit << END\n";
  for (const LimitAt& limit : study.limits) {
    text += number(limit.speed_rev_per_min) + " " + number(std::min(limit.depth_mm, top)) + "\n";
  }
  const Curve stable =
      curve_of(study.cuts, "$stable", "pt 7 ps 1.2 lc rgb '#1f4e79' title 'planned, stable'",
               [](const PlannedCut& cut) { return cut.is_stable(); });
  const Curve unstable = curve_of(study.cuts, "$unstable",
                                  "pt 2 ps 1.4 lw 2 lc rgb '#c8553d' title 'planned, chatters'",
                                  [](const PlannedCut& cut) { return !cut.is_stable(); });
  text += "END\n" + stable.data + unstable.data;
  const bool is_png = file.extension() == ".png";
  text += std::string("set terminal ") +
          (is_png ? "pngcairo enhanced background rgb 'white' font 'Sans,12'"
                  : "svg enhanced background rgb 'white' font 'Sans,14'") +
          " size 1100,600\nset output " + gnuplot_text(std::filesystem::absolute(file).string()) +
          "\n";
  text +=
      "set encoding utf8\nset border 3 lc rgb '#9aa3a9' lw 1\n"
      "set tics nomirror out scale 0.6 textcolor rgb '#4a4f54'\n"
      "set grid lc rgb '#e7eaec' lw 1 lt 1\nset logscale x\n"
      "set key outside top right horizontal Left reverse samplen 2 textcolor rgb '#2b2f33'\n";
  text += is_grinding(study) ? "set xlabel 'speed of the part [rev/min]'\n"
                               "set ylabel 'width of grinding [mm]'\n"
                             : "set xlabel 'speed of the spindle [rev/min]'\n"
                               "set ylabel 'depth of cut [mm]'\n";
  const double from = study.limits.front().speed_rev_per_min;
  const double to = study.limits.back().speed_rev_per_min;
  text += marks(from, to) + "set xrange [" + number(from) + ":" + number(to) +
          "]\nset yrange [0:" + number(top) + "]\n";
  text += "plot $limit using 1:2:(" + number(top) + ") with filledcurves y=" + number(top) +
          " fc rgb '#f4dcd6' title 'chatters', \\\n"
          "  $limit with lines lw 1.5 lc rgb '#c8553d' title 'limit'";
  return text + stable.plot + unstable.plot + "\nunset output\n";
}

void draw_picture(const LobesStudy& study, const std::filesystem::path& file) {
  if (const auto error = recording::draw(picture_script(study, file)))
    throw std::runtime_error("cannot draw " + file.string() + ": " + error->text);
}

}  // namespace stanok::client
