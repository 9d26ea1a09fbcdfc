#include "jobs/cutting/cut_log.h"

#include <algorithm>
#include <cmath>
#include <stanok_messages/process_status_t.hpp>
#include <stanok_messages/setpoint_t.hpp>
#include <stdexcept>
#include <utility>

#include "base/place.h"
#include "jobs/cutting/power_readings.h"
#include "recording/format/channel_names.h"
#include "recording/format/decode.h"
#include "recording/read/log_contents.h"

namespace stanok::jobs {
namespace {

using recording::LogReader;

// A tool that is nearer to the stock than this cuts nothing.
constexpr double depth_least_mm = 1e-4;

struct ToolAxes {
  std::size_t x = 0;
  std::size_t z = 0;
};

ToolAxes tool_axes(const recording::LogContents& contents, int channel) {
  const recording::ChannelDescription* const description =
      recording::description_of(contents, channel);
  if (description == nullptr) throw std::runtime_error("the log does not describe its channels");
  const auto place = [&](const char* word) {
    const auto axis = std::ranges::find(description->axes, word, &recording::AxisDescription::word);
    if (axis == description->axes.end()) {
      throw std::runtime_error("channel " + std::to_string(channel) + " has no axis " + word +
                               "; choose the channel of the lathe with --channel");
    }
    return checked_size(axis - description->axes.begin());
  };
  return {.x = place("X"), .z = place("Z")};
}

// Stock that the tool has cut is not there a second time.
class CutSurface {
 public:
  explicit CutSurface(StockTable stock) : stock_(std::move(stock)) {}

  [[nodiscard]] double force_factor(double z_mm) const { return stock_.force_factor(z_mm); }

  // Of a tool that goes on; at a place where it was a cycle ago the depth is what it was.
  [[nodiscard]] double depth_mm(double x_mm, double z_mm) {
    const double from_mm = stock_.steps.front().z_mm;
    if (z_mm > from_mm) {
      place_ = -1;
      return 0.0;
    }
    const auto place = static_cast<std::int64_t>(std::min((from_mm - z_mm) / place_mm, places_max));
    if (place == place_) return depth_mm_;
    const double radius = std::abs(x_mm);
    const double depth = left_at(checked_size(place)) - radius;
    // What lies between two cycles is cut as well.
    const std::int64_t from = place_ >= 0 && place > place_ ? place_ + 1 : place;
    for (std::int64_t between = from; between <= place; ++between) {
      double& left = left_at(checked_size(between));
      left = std::min(left, radius);
    }
    place_ = place;
    depth_mm_ = depth > depth_least_mm ? depth : 0.0;
    return depth_mm_;
  }

 private:
  static constexpr double place_mm = 0.001;
  static constexpr double places_max = 5e6;

  double& left_at(std::size_t place) {
    while (left_.size() <= place) {
      const double z =
          stock_.steps.front().z_mm - place_mm * (static_cast<double>(left_.size()) + 0.5);
      left_.push_back(stock_.radius_mm(z));
    }
    return left_[place];
  }

  StockTable stock_;
  std::vector<double> left_;
  std::int64_t place_ = -1;  // of the cycle before
  double depth_mm_ = 0.0;    // there
};

// Takes the events of a log one after the other.
class CutReading {
 public:
  CutReading(const recording::LogContents& contents, const CutLogRequest& request)
      : axes_(tool_axes(contents, request.channel)),
        setpoints_(contents.setpoint_channels.at(request.channel)),
        channel_(request.channel),
        bounds_(request.bounds),
        readings_(request.spindle),
        surface_(request.stock) {
    log_.record.cycle_s = contents.description->cycle_us * 1e-6;
  }

  void take(const recording::LogEvent& event) {
    const std::string_view topic = recording::topic_of(event.channel);
    readings_.take(event);
    if (topic == recording::name_of(recording::Topic::process)) {
      const auto message = recording::decode<process_status_t>(event.bytes);
      if (message && message->channel == channel_) rev_per_min_ = std::abs(message->spindle_speed);
    } else if (event.channel == setpoints_) {
      if (const auto message = recording::decode<setpoint_t>(event.bytes)) take_setpoint(*message);
    }
  }

  CutLog end() {
    readings_.check_any();
    std::vector<double> speeds;
    speeds.reserve(log_.record.rows.size());
    for (const process::CutRow& row : log_.record.rows) speeds.push_back(row.rev_per_min);
    const std::vector<double> power = readings_.by_row(first_cycle_, speeds, log_.record.cycle_s);
    for (std::size_t k = 0; k < power.size(); ++k) log_.record.rows[k].power_w = power[k];
    return std::move(log_);
  }

 private:
  void take_setpoint(const setpoint_t& message) {
    bounds_.check(log_.time_s.size());
    if (first_cycle_ < 0) first_cycle_ = message.cycle;
    const double x = message.tip_position[axes_.x];
    const double z = message.tip_position[axes_.z];
    const double cycle_s = log_.record.cycle_s;
    const bool feeds = message.feed_commanded > 0.0;
    log_.record.rows.push_back({.rev_per_min = rev_per_min_,
                                .radius_mm = std::abs(x),
                                .depth_mm = feeds ? surface_.depth_mm(x, z) : 0.0,
                                .travel_mm = feeds ? message.path_speed * cycle_s : 0.0,
                                .z_mm = z,
                                .hardness_factor = surface_.force_factor(z)});
    log_.time_s.push_back(static_cast<double>(message.cycle - first_cycle_) * cycle_s);
  }

  ToolAxes axes_;
  std::string setpoints_;
  int channel_;
  const ReadingBounds& bounds_;
  PowerReadings readings_;
  CutSurface surface_;
  CutLog log_;
  std::int64_t first_cycle_ = -1;
  double rev_per_min_ = 0.0;
};

}  // namespace

CutLog read_cut_log(const std::filesystem::path& file, const CutLogRequest& request) {
  const auto contents = recording::read_contents(file);
  if (!contents) throw std::runtime_error(contents.error().text);
  if (!contents->setpoint_channels.contains(request.channel) || !contents->description) {
    throw std::runtime_error("the log has no setpoints of channel " +
                             std::to_string(request.channel));
  }
  auto reader = LogReader::open(file);
  if (!reader) throw std::runtime_error(reader.error().text);
  CutReading reading(*contents, request);
  while (const auto event = reader->next()) reading.take(*event);
  return reading.end();
}

}  // namespace stanok::jobs
