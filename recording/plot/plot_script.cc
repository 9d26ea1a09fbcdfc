#include "recording/plot/plot_script.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "recording/plot/gnuplot.h"

namespace stanok::recording {
namespace {

constexpr std::array colours{"#1f4e79", "#c8553d", "#3a7d44", "#b8860b",
                             "#7a5c99", "#2a8c8c", "#a23b72", "#5c6b73"};
constexpr const char* quiet_colour = "#b4bec6";  // what is no result: commanded feed, rapid

// Pixels.
constexpr int width = 1200;
constexpr int time_height = 520;
constexpr int panel_height = 150;
constexpr int panels_top = 64;
constexpr int panels_bottom = 62;
constexpr int panel_gap = 30;
constexpr double path_width = 1060.0;
constexpr double path_height_max = 800.0;
constexpr int path_margin = 130;
constexpr int title_depth = 20;  // of the middle of its text below the edge

constexpr double slimmest = 0.22;  // height of a drawing, of its width
constexpr double padding = 0.08;   // around data, of their range

struct Range {
  double low = 0.0;
  double high = 0.0;

  [[nodiscard]] double span() const { return high - low; }
  [[nodiscard]] std::string text() const { return "[" + number(low) + ":" + number(high) + "]"; }
  void include(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  // The same middle, that span.
  [[nodiscard]] Range widened(double span) const {
    const double middle = 0.5 * (low + high);
    return {middle - 0.5 * span, middle + 0.5 * span};
  }
  [[nodiscard]] Range padded() const {
    return widened(span() > 0.0 ? span() * (1.0 + 2.0 * padding) : 1.0);
  }
};

struct View {
  const char* name;
  const char* title;
  std::size_t horizontal, vertical;  // of X, Y, Z
};
constexpr std::array views{View{"path-top", "Path from the top", 0, 1},
                           View{"path-front", "Path from the front", 0, 2},
                           View{"path-side", "Path from the side", 1, 2}};

struct Quantity {
  const char* name;
  const char* title;
  const char* per;  // after mm or deg
  PeakSeries AxisPlot::* series;
};
constexpr std::array quantities{
    Quantity{"velocity", "Axis velocity", "/s", &AxisPlot::velocity},
    Quantity{"acceleration", "Axis acceleration", "/s²", &AxisPlot::acceleration},
    Quantity{"jerk", "Axis jerk", "/s³", &AxisPlot::jerk}};

std::string run_label(const RunPlot& run) {
  return "run " + std::to_string(run.run) + ", scheme " + std::to_string(run.scheme);
}

// Whole numbers from 100 on, else three digits.
std::string rounded(double value) {
  if (std::abs(value) >= 100.0) return number(std::round(value));
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.3g", value);
  return text.data();
}

// 1, 2 or 5 times a power of ten: two to five steps in the range.
double tic_step(const Range& range) {
  const double at_least = range.span() / 5.0;
  const double power = std::pow(10.0, std::floor(std::log10(at_least)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= at_least) return factor * power;
  }
  return 10.0 * power;
}

std::string line_style(std::size_t index, const char* line_width) {
  return std::string(" with lines lw ") + line_width + " lc rgb '" +
         colours[index % colours.size()] + "'";
}

std::string block_name(const char* name, std::size_t index) {
  return "$" + std::string(name) + std::to_string(index + 1);
}

class ScriptText {
 public:
  explicit ScriptText(const ChannelPlot& plot) : plot_(plot) {}

  [[nodiscard]] PlotScript script() && {
    text_ = "# Pictures of channel " + std::to_string(plot_.channel) +
            ", made by `stanok log plot`; draws them again: gnuplot " + file_stem() + ".gnuplot\n";
    add_data();
    add_look();
    if (!plot_.runs.empty()) {
      for (const View& view : views) add_path(view);
      add_speed();
    }
    for (const Quantity& quantity : quantities) add_axes(quantity);
    add_force();
    return {std::move(text_), std::move(pictures_)};
  }

 private:
  [[nodiscard]] std::string file_stem() const { return "ch" + std::to_string(plot_.channel); }

  void add_data() {
    for (std::size_t i = 0; i < plot_.runs.size(); ++i) {
      add_path_data(block_name("path", i), plot_.runs[i].path);
      add_series(block_name("speed", i), plot_.runs[i].speed);
    }
    add_path_data("$rapid", plot_.rapid);
    add_series("$feed", plot_.feed);
    add_force_data();
    for (const Quantity& quantity : quantities) {
      for (std::size_t k = 0; k < plot_.axes.size(); ++k) {
        add_series(block_name(quantity.name, k), plot_.axes[k].*quantity.series);
      }
    }
  }

  void add_path_data(const std::string& block, const ThinnedPath& path) {
    text_ += block + " << END\n";
    for (const auto& stretch : path.stretches()) {
      for (const PlotPoint& p : stretch) {
        text_ += number(p[0]) + " " + number(p[1]) + " " + number(p[2]) + "\n";
      }
      text_ += "\n";
    }
    text_ += "END\n";
  }

  void add_series(const std::string& block, const PeakSeries& series) {
    text_ += block + " << END\n";
    for (const TimePoint& p : series.points()) {
      text_ += number(p.time) + " " + number(p.value) + "\n";
    }
    text_ += "END\n";
  }

  void add_look() {
    text_ +=
        "set encoding utf8\n"
        "set border 3 lc rgb '#9aa3a9' lw 1\n"
        "set tics nomirror out scale 0.6 textcolor rgb '#4a4f54'\n"
        "set grid lc rgb '#e7eaec' lw 1 lt 1\n"
        "set xlabel textcolor rgb '#2b2f33'\n"
        "set ylabel textcolor rgb '#2b2f33'\n"
        "set key top right outside horizontal Left reverse samplen 2 textcolor rgb '#2b2f33'\n";
  }

  // The body once as PNG, once as SVG.
  void add_picture(const std::string& name, int height, const std::function<void()>& add_body) {
    const std::string size = std::to_string(width) + "," + std::to_string(height);
    for (const auto& [ending, terminal] :
         {std::pair("png", "pngcairo noenhanced background rgb 'white' font 'Sans,12' size "),
          std::pair("svg", "svg noenhanced background rgb 'white' font 'Sans,14' size ")}) {
      const std::string file = file_stem() + "-" + name + "." + ending;
      text_.append("set terminal ").append(terminal).append(size);
      text_.append("\nset output '").append(file).append("'\n");
      add_body();
      text_ += "unset label\nunset output\n";
      pictures_.push_back(file);
    }
  }

  // At the left, on the line of the legend.
  void add_title(const std::string& title, int height) {
    std::string place = "channel " + std::to_string(plot_.channel);
    if (!plot_.machine.empty()) place = plot_.machine + ", " + place;
    text_ += "set label 2 " + gnuplot_text(title + " – " + place) + " at screen 0.012, screen " +
             number(1.0 - static_cast<double>(title_depth) / height) +
             " left font ',15' textcolor rgb '#2b2f33'\n";
  }

  void add_path(const View& view) {
    const auto& across = plot_.point_axes[view.horizontal];
    const auto& up = plot_.point_axes[view.vertical];
    if (!across || !up) return;
    Range horizontal = path_range(view.horizontal).padded();
    Range vertical = path_range(view.vertical).padded();
    vertical = vertical.widened(std::max(vertical.span(), slimmest * horizontal.span()));
    horizontal = horizontal.widened(
        std::max(horizontal.span(), vertical.span() * path_width / path_height_max));
    const int height =
        path_margin + static_cast<int>(path_width * vertical.span() / horizontal.span());
    add_picture(view.name, height, [&] {
      add_title(view.title, height);
      text_ += "set size ratio -1\n";
      text_ += "set xlabel " + gnuplot_text(plot_.axes[*across].axis.word + " [mm]") + "\n";
      text_ += "set ylabel " + gnuplot_text(plot_.axes[*up].axis.word + " [mm]") + "\n";
      text_ += "set xrange " + horizontal.text() + "\nset yrange " + vertical.text() + "\n";
      const std::string columns =
          " using " + std::to_string(view.horizontal + 1) + ":" + std::to_string(view.vertical + 1);
      text_ +=
          "plot $rapid" + columns + " with lines lw 1 lc rgb '" + quiet_colour + "' title 'rapid'";
      for (std::size_t i = 0; i < plot_.runs.size(); ++i) {
        text_ += ", \\\n  " + block_name("path", i) + columns + line_style(i, "1.4") + " title " +
                 gnuplot_text(run_label(plot_.runs[i]));
      }
      text_ += "\nset size noratio\n";
    });
  }

  // The range of what moves at feed; the frame cuts rapid traverse, unless there is nothing else.
  [[nodiscard]] Range path_range(std::size_t coordinate) const {
    std::optional<Range> range;
    const auto include = [&](const ThinnedPath& path) {
      for (const auto& stretch : path.stretches()) {
        for (const PlotPoint& point : stretch) {
          if (!range) range = {point[coordinate], point[coordinate]};
          range->include(point[coordinate]);
        }
      }
    };
    for (const RunPlot& run : plot_.runs) include(run.path);
    if (!range) include(plot_.rapid);
    return range.value_or(Range{});
  }

  void add_speed() {
    Range speeds;
    for (const TimePoint& point : plot_.feed.points()) speeds.include(point.value);
    for (const RunPlot& run : plot_.runs) {
      for (const TimePoint& point : run.speed.points()) speeds.include(point.value);
    }
    if (speeds.span() <= 0.0) speeds = {0.0, 1.0};
    speeds.high += padding * speeds.span();
    add_picture("path-speed", time_height, [&] {
      add_title("Path speed", time_height);
      text_ += "set xlabel 'time [s]'\nset ylabel 'path speed [mm/s]'\n";
      text_ += "set xrange " + time_range().text() + "\nset yrange " + speeds.text() + "\n";
      text_ += std::string("plot $feed with steps lw 1.5 lc rgb '") + quiet_colour +
               "' title 'feed commanded'";
      for (std::size_t i = 0; i < plot_.runs.size(); ++i) {
        text_ += ", \\\n  " + block_name("speed", i) + line_style(i, "1.2") + " title " +
                 gnuplot_text(run_label(plot_.runs[i]));
      }
      text_ += "\n";
    });
  }

  [[nodiscard]] Range time_range() const {
    return {plot_.time_begin, std::max(plot_.time_end, plot_.time_begin + 1e-3)};
  }

  // A line over time, and another one behind it for comparison.
  struct Line {
    std::string block;
    const PeakSeries* series = nullptr;
  };
  struct Panel {
    std::string label;
    std::string unit;
    Line line;
    Line behind{};  // no series: none
    std::size_t colour = 0;
  };

  // One below the other, over the same time.
  void add_panels(const char* name, const char* title, const std::vector<Panel>& panels) {
    if (panels.empty()) return;
    const int count = static_cast<int>(panels.size());
    const int height = panels_top + panels_bottom + panel_height * count;
    const double bottom = static_cast<double>(panels_bottom) / height;
    const double top = 1.0 - static_cast<double>(panels_top) / height;
    add_picture(name, height, [&] {
      add_title(title, height);
      text_ += "set xrange " + time_range().text() + "\nset xlabel\n";
      text_ += "set multiplot layout " + std::to_string(count) + ",1 margins 0.105,0.985," +
               number(bottom) + "," + number(top) + " spacing 0," +
               number(static_cast<double>(panel_gap) / height) + "\n";
      for (const Panel& panel : panels) {
        add_panel(panel, &panel == &panels.back() ? TimeAxis::labelled : TimeAxis::hidden);
        text_ += "unset label\n";
      }
      text_ += "unset multiplot\nset format x\nset ytics autofreq\n";
    });
  }

  // One panel for each axis.
  void add_axes(const Quantity& quantity) {
    std::vector<Panel> panels;
    for (std::size_t k = 0; k < plot_.axes.size(); ++k) {
      const AxisPlot& axis = plot_.axes[k];
      panels.push_back({.label = axis.axis.name,
                        .unit = (axis.axis.rotary ? "deg" : "mm") + std::string(quantity.per),
                        .line = {block_name(quantity.name, k), &(axis.*quantity.series)},
                        .colour = k});
    }
    add_panels(quantity.name, quantity.title, panels);
  }

  void add_force() {
    const ForcePlot& force = plot_.force;
    if (force.is_empty()) return;
    add_panels("force", "Force control",
               {{"P_z", "N", {"$force", &force.force}, {"$force_set", &force.force_set}, 0},
                {"N_d", "W", {"$power", &force.power}, {"$power_idle", &force.power_idle}, 1},
                {"S", "mm/s", {"$force_feed", &force.feed}, {}, 2},
                {"a_0", "um", {"$vibration", &force.vibration}, {}, 3}});
  }

  void add_force_data() {
    const ForcePlot& force = plot_.force;
    if (force.is_empty()) return;
    add_series("$force", force.force);
    add_series("$force_set", force.force_set);
    add_series("$power", force.power);
    add_series("$power_idle", force.power_idle);
    add_series("$force_feed", force.feed);
    add_series("$vibration", force.vibration);
  }

  enum class TimeAxis : std::uint8_t { hidden, labelled };

  void add_panel(const Panel& panel, TimeAxis time_axis) {
    Range values;
    for (const TimePoint& point : panel.line.series->points()) values.include(point.value);
    const std::string peak =
        "peak " + rounded(std::max({0.0, -values.low, values.high})) + " " + panel.unit;
    if (panel.behind.series != nullptr) {
      for (const TimePoint& point : panel.behind.series->points()) values.include(point.value);
    }
    const Range shown = values.padded();
    text_ += time_axis == TimeAxis::labelled
                 ? "set format x\nset xlabel 'time [s]' textcolor rgb '#2b2f33'\n"
                 : "set format x ''\nunset xlabel\n";
    text_ += "set ylabel " + gnuplot_text(panel.label + " [" + panel.unit + "]") + "\n";
    text_ += "set yrange " + shown.text() + "\nset ytics " + number(tic_step(shown)) + "\n";
    text_ += "set label 1 " + gnuplot_text(peak) +
             " at graph 1, graph 1 offset 0,0.6 right font ',10' textcolor rgb '#5f676d'\n";
    text_ += "plot ";
    if (panel.behind.series != nullptr) {
      text_ += panel.behind.block + " with lines lw 2 lc rgb '" + quiet_colour + "' notitle, ";
    }
    text_ += panel.line.block + line_style(panel.colour, "1") + " notitle\n";
  }

  const ChannelPlot& plot_;
  std::string text_;
  std::vector<std::string> pictures_;
};

}  // namespace

PlotScript plot_script(const ChannelPlot& plot) {
  return ScriptText(plot).script();
}

}  // namespace stanok::recording
