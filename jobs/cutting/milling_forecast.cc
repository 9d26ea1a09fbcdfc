#include "jobs/cutting/milling_forecast.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <set>
#include <stdexcept>

#include "base/place.h"
#include "jobs/cutting/load_ahead.h"
#include "jobs/cutting/program_text.h"
#include "runtime/simulation.h"
#include "runtime/workpiece/workpiece_feed.h"

namespace stanok::jobs {
namespace {

using simulation::Vector;

constexpr double seconds_of_minute = 60.0;
constexpr double steps_of_default = 2.0;  // resolutions between two places
constexpr double planned_min_part = 0.05;

// What the force at a place depends on.
struct CutAhead {
  process::MillingLoad load;
  double teeth_per_s = 0.0;
  bool plunges = false;  // its face, which is not looked at, may cut
};

// Follows the channel of the job and looks ahead of its tool.
class CutObserver final : public runtime::CycleObserver {
 public:
  CutObserver(const MillingRequest& request, const config::MachineFile& file)
      : request_(request),
        channel_(place_of_channel(file.machine, request.job.channel)),
        cycle_s_(file.machine.cycle_us * 1e-6),
        feed_(file.machine, file.machine.channels[channel_], request.memory_max,
              [this](const std::string& code, const std::string& text) {
                if (refusal_.empty() && code.front() == 'E') refusal_ = code + ": " + text;
              }) {}

  void observe(const channels::CycleOutput& output) override {
    const channels::ChannelOutput& channel = output.channels[channel_];
    if (channel.axis_count == 0) return;
    const simulation::Sample sample =
        runtime::sample_of(channel, static_cast<double>(output.cycle) * cycle_s_);
    feed_.take(sample, channel.tool_row, channel.workpiece);
    const auto mill = feed_.follower().milling_tool();
    const bool is_cutting = mill && channel.feed_commanded > 0.0 && sample.spindle_turns &&
                            (request_.tool == 0 || sample.tool == request_.tool);
    if (!is_cutting) {
      tip_.reset();
      return;
    }
    const Vector tip = mill->place_K.tip;
    const double distance = tip_ ? (tip - *tip_).norm() : 0.0;
    constexpr double standing_mm = 1e-9;
    if (distance > standing_mm) {
      path_mm_ += distance;
      since_mm_ += distance;
      if (since_mm_ >= step_mm() || sample.origin.line != line_)
        look(channel, sample, *mill, (tip - *tip_) / distance, distance / cycle_s_);
    }
    tip_ = tip;
  }

  [[nodiscard]] bool has_workpiece() { return feed_.follower().at_work() != nullptr; }
  [[nodiscard]] const std::string& refusal() const { return refusal_; }
  std::vector<MillingPlace> places;
  std::vector<CutAhead> cuts;

 private:
  static std::size_t place_of_channel(const channels::MachineConfig& machine, int id) {
    for (std::size_t k = 0; k < machine.channels.size(); ++k)
      if (machine.channels[k].id == id) return k;
    throw std::runtime_error("the machine has no channel " + std::to_string(id));
  }

  [[nodiscard]] double resolution() { return feed_.follower().at_work()->blank().resolution; }
  [[nodiscard]] double step_mm() {
    return request_.step_mm > 0.0 ? request_.step_mm : steps_of_default * resolution();
  }

  void look(const channels::ChannelOutput& channel, const simulation::Sample& sample,
            const simulation::WorkpieceFollower::ToolAtWork& tool, const Vector& direction_K,
            double speed_mm_per_s) {
    since_mm_ = 0.0;
    line_ = sample.origin.line;
    const double rev_per_min = channel.process.spindle_rev_per_min;
    const double turns_per_s = std::abs(rev_per_min) / seconds_of_minute;
    if (turns_per_s <= 0.0) return;
    constexpr double level = 1e-6;
    CutAhead cut{.load = load_ahead(feed_.follower(), tool, direction_K, rev_per_min, request_.cut),
                 .teeth_per_s = turns_per_s * request_.cut.teeth,
                 .plunges = direction_K.dot(tool.place_K.axis) < -level};
    const process::MillingForces forces = cut.load.at(speed_mm_per_s / cut.teeth_per_s);
    constexpr double w_per_n_mm_per_s = 1e-3;
    constexpr double um_per_mm = 1e3;
    const Vector place = tool.place_K.tip - feed_.follower().at_work()->blank().zero;
    places.push_back(
        {.line = sample.origin.line,
         .file = sample.origin.file,
         .path_mm = path_mm_,
         .x_mm = place.x(),
         .y_mm = place.y(),
         .z_mm = place.z(),
         .rev_per_min = std::abs(rev_per_min),
         .feed_programmed = channel.feed_commanded * seconds_of_minute,
         .feed_run = speed_mm_per_s * seconds_of_minute,
         .area_mm2 = cut.load.area_mm2(),
         .force_mean_n = std::hypot(forces.mean_x_n, forces.mean_y_n),
         .force_peak_n = forces.peak_n,
         .power_w = forces.torque_n_mm * 2.0 * std::numbers::pi * turns_per_s * w_per_n_mm_per_s,
         .deflection_um = forces.deflection_mm * um_per_mm});
    cuts.push_back(std::move(cut));
  }

  const MillingRequest& request_;
  std::size_t channel_;
  double cycle_s_;
  std::string refusal_;
  runtime::ChannelFeed feed_;
  std::optional<Vector> tip_;
  double path_mm_ = 0.0;
  double since_mm_ = 0.0;
  std::uint32_t line_ = 0;
};

// The feed of each block of the main program, mm/min.
class FeedPlanning {
 public:
  FeedPlanning(const MillingRequest& request, const CutObserver& observer)
      : request_(request), places_(observer.places), cuts_(observer.cuts) {
    check_program();
    for (std::size_t k = 0; k < places_.size(); ++k) take(places_[k], cuts_[k]);
  }

  void apply(MillingForecast& forecast) const {
    for (std::size_t k = 0; k < forecast.places.size(); ++k) {
      MillingPlace& place = forecast.places[k];
      const auto planned = planned_.find(place.line);
      if (planned == planned_.end()) continue;
      place.feed_planned = planned->second;
      // The axes go slower where they have to.
      const double feed = place.feed_run < place.feed_programmed
                              ? std::min(place.feed_run, place.feed_planned)
                              : place.feed_planned;
      place.force_planned_n =
          cuts_[k].load.at(feed / seconds_of_minute / cuts_[k].teeth_per_s).peak_n;
    }
    for (const auto& [line, feed] : planned_)
      forecast.lines[line] = {{.words = "", .feed = fmt::format("F{:.0f}", feed)}};
  }

 private:
  void check_program() {
    const ProgramText text(request_.job.text);
    for (const auto& [number, line] : text.lines()) {
      for (const char* const word : {"G95", "G20", "G93"}) {
        if (ProgramText::has_word(line, word))
          throw std::runtime_error("line " + std::to_string(number) + " has " + word +
                                   "; feeds are planned for G94 in mm only");
      }
      if (ProgramText::has_feed_expression(line)) kept_.insert(number);
    }
  }

  void take(const MillingPlace& place, const CutAhead& cut) {
    if (place.file != 0)
      throw std::runtime_error(
          "the program calls another file with blocks at feed; their feeds cannot be planned");
    if (kept_.contains(place.line)) return;
    const double per_turn = place.rev_per_min;
    const double least = request_.feed_min > 0.0 ? request_.feed_min * per_turn
                                                 : planned_min_part * place.feed_programmed;
    double most = request_.feed_max > 0.0 ? request_.feed_max * per_turn : place.feed_programmed;
    if (cut.plunges) most = std::min(most, place.feed_programmed);
    const double permitted =
        cut.load.feed_of_peak(request_.force_n) * cut.teeth_per_s * seconds_of_minute;
    const double feed =
        std::max(1.0, std::floor(std::clamp(permitted, std::min(least, most), most)));
    const auto [known, is_new] = planned_.emplace(place.line, feed);
    if (!is_new) known->second = std::min(known->second, feed);
  }

  const MillingRequest& request_;
  const std::vector<MillingPlace>& places_;
  const std::vector<CutAhead>& cuts_;
  std::set<std::uint32_t> kept_;
  std::map<std::uint32_t, double> planned_;
};

void tell(const runtime::SimulationResult& result, const ForecastJob& job) {
  for (const auto& report : result.load_diagnostics) job.tell(report.diagnostic);
  for (const auto& report : result.alarms) job.tell(report.diagnostic);
}

}  // namespace

MillingForecast forecast_milling(const MillingRequest& request) {
  const ForecastJob& job = request.job;
  runtime::SimulationOptions options;
  options.file = job.machine;
  options.schemes = job.schemes;
  options.programs = {{job.channel, job.program}};
  options.program_roots = job.program_roots;
  CutObserver observer(request, options.file);
  const auto result = runtime::simulate(options, {&observer}, [&] {
    return job.gives_up() || observer.places.size() > job.places_max;
  });
  tell(result, job);
  if (observer.places.size() > job.places_max)
    throw std::runtime_error(job.program + " has a longer path than is followed here");
  if (!result.ok) throw std::runtime_error(job.program + " does not run to its end");
  if (!observer.refusal().empty()) throw std::runtime_error(observer.refusal());
  if (!observer.has_workpiece())
    throw std::runtime_error("the program announces no workpiece; give its blank with #workpiece");
  MillingForecast forecast;
  forecast.places = observer.places;
  if (request.force_n > 0.0) FeedPlanning(request, observer).apply(forecast);
  double before_mm = 0.0;
  for (MillingPlace& place : forecast.places) {
    if (place.feed_planned == 0.0) {
      place.feed_planned = place.feed_programmed;
      place.force_planned_n = place.force_peak_n;
    }
    const double distance = place.path_mm - before_mm;
    before_mm = place.path_mm;
    forecast.time_programmed_s += seconds_of_minute * distance / place.feed_programmed;
    forecast.time_s += seconds_of_minute * distance / place.feed_planned;
  }
  return forecast;
}

}  // namespace stanok::jobs
