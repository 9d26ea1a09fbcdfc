#include "recording/plot/channel_plot.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/place.h"
#include "recording/read/setpoint_walk.h"

namespace stanok::recording {
namespace {

// A step of the programmed point that is longer than its speed explains is a change of the
// workpiece system, not motion.
constexpr double step_factor = 4.0;
constexpr double step_slack_mm = 0.1;

class Gathering {
 public:
  Gathering(const LogContents& contents, int channel) : contents_(contents) {
    plot_.channel = channel;
    plot_.runs.reserve(plot_runs_max);  // line_ points into it
    if (contents.description) plot_.machine = contents.description->machine;
  }

  void add(const setpoint_t& setpoint) {
    const double time = static_cast<double>(setpoint.utime - contents_.utime_first) * 1e-6;
    const channels::ChannelOutput output = from_setpoint(setpoint);
    if (plot_.axes.empty()) begin(output, time);
    plot_.time_end = time;
    const std::size_t count = std::min(plot_.axes.size(), checked_size(output.axis_count));
    for (std::size_t k = 0; k < count; ++k) {
      plot_.axes[k].velocity.add(time, output.axes[k].velocity);
      plot_.axes[k].acceleration.add(time, output.axes[k].acceleration);
      plot_.axes[k].jerk.add(time, output.axes[k].jerk);
    }
    plot_.feed.add(time, output.running ? output.feed_commanded : 0.0);
    if (output.running) {
      add_run(output, time);
    } else {
      was_running_ = false;
    }
  }

  [[nodiscard]] ChannelPlot take() { return std::move(plot_); }

 private:
  void begin(const channels::ChannelOutput& output, double time) {
    plot_.time_begin = time;
    for (const AxisDescription& axis : axes_of(contents_, plot_.channel, output.axis_count)) {
      plot_.axes.push_back({axis, {}, {}, {}});
    }
    constexpr std::array words{"X", "Y", "Z"};
    for (std::size_t i = 0; i < words.size(); ++i) {
      for (std::size_t k = 0; k < plot_.axes.size(); ++k) {
        if (plot_.axes[k].axis.word == words[i]) plot_.point_axes[i] = k;
      }
    }
  }

  void add_run(const channels::ChannelOutput& output, double time) {
    PlotPoint point{};
    double speed_squared = 0.0;
    for (std::size_t i = 0; i < point.size(); ++i) {
      if (!plot_.point_axes[i]) continue;
      const kinematics::Jet& jet = output.point_W[*plot_.point_axes[i]];
      point[i] = jet.value;
      speed_squared += jet.first * jet.first;
    }
    const double step_max =
        step_slack_mm + step_factor * std::sqrt(speed_squared) * (time - last_time_);
    const double step =
        std::hypot(point[0] - last_point_[0], point[1] - last_point_[1], point[2] - last_point_[2]);
    const bool is_new = begin_run(output);
    RunPlot& run = plot_.runs.back();
    if (!was_running_ || is_new || step > step_max) line_ = nullptr;
    add_point(point, output.feed_commanded > 0.0 ? run.path : plot_.rapid);
    run.speed.add(time, output.path_speed);
    was_running_ = true;
    last_point_ = point;
    last_time_ = time;
  }

  // Feed and rapid traverse are lines of their own that meet in a point.
  void add_point(const PlotPoint& point, ThinnedPath& line) {
    if (line_ != &line) {
      line.add(line_ == nullptr ? point : last_point_, ThinnedPath::Joint::begins_stretch);
    }
    line.add(point, ThinnedPath::Joint::continues);
    line_ = &line;
  }

  // True when the setpoint is the first one of a run or scheme.
  bool begin_run(const channels::ChannelOutput& output) {
    const int run = static_cast<int>(output.run);
    const bool is_new = run != last_run_ || output.scheme != last_scheme_;
    last_run_ = run;
    last_scheme_ = output.scheme;
    if (plot_.runs.empty() || (is_new && plot_.runs.size() < plot_runs_max)) {
      plot_.runs.push_back({run, output.scheme, {}, {}});
    }
    return is_new;
  }

  const LogContents& contents_;
  ChannelPlot plot_;
  bool was_running_ = false;
  ThinnedPath* line_ = nullptr;  // that the last point was added to; none: the next one begins anew
  int last_run_ = -1;
  int last_scheme_ = -1;
  PlotPoint last_point_{};
  double last_time_ = 0.0;
};

}  // namespace

Expected<ChannelPlot, LogError> gather_plot(const std::filesystem::path& file,
                                            const LogContents& contents, int channel) {
  Gathering gathering(contents, channel);
  const auto error = for_each_setpoint(
      file, contents, channel, [&](const setpoint_t& setpoint) { gathering.add(setpoint); });
  if (error) return Unexpected<LogError>(*error);
  auto force = gather_force(file, contents, channel);
  if (!force) return Unexpected<LogError>(force.error());
  ChannelPlot plot = gathering.take();
  plot.force = std::move(*force);
  return plot;
}

}  // namespace stanok::recording
