#include "client/offline/process/cut_log.h"

#include <algorithm>
#include <cmath>
#include <stanok_messages/process_status_t.hpp>
#include <stanok_messages/setpoint_t.hpp>
#include <stdexcept>

#include "base/place.h"
#include "recording/format/channel_names.h"
#include "recording/format/decode.h"
#include "recording/format/encode_input_record.h"
#include "recording/read/log_contents.h"

namespace stanok::client {
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

// Radius of the stock at a z; 0: in front of it.
double stock_radius(const std::vector<StockStep>& stock, double z_mm) {
  double radius = 0.0;
  for (const StockStep& step : stock)
    if (z_mm <= step.z_mm) radius = step.radius_mm;
  return radius;
}

// Stock that the tool has cut is not there a second time.
class CutSurface {
 public:
  explicit CutSurface(std::vector<StockStep> stock) : stock_(std::move(stock)) {}

  // Of a tool that goes on; at a place where it was a cycle ago the depth is what it was.
  [[nodiscard]] double depth_mm(double x_mm, double z_mm) {
    const double from_mm = stock_.front().z_mm;
    if (z_mm > from_mm) {
      place_ = -1.0;
      return 0.0;
    }
    const double place = std::min(std::floor((from_mm - z_mm) / place_mm), places_max);
    if (place == place_) return depth_mm_;
    const double radius = std::abs(x_mm);
    const double depth = left_at(static_cast<std::size_t>(place)) - radius;
    // What lies between two cycles is cut as well.
    const double from = place_ >= 0.0 && place > place_ ? place_ + 1.0 : place;
    for (double between = from; between <= place; between += 1.0) {
      double& left = left_at(static_cast<std::size_t>(between));
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
      const double z = stock_.front().z_mm - place_mm * (static_cast<double>(left_.size()) + 0.5);
      left_.push_back(stock_radius(stock_, z));
    }
    return left_[place];
  }

  std::vector<StockStep> stock_;
  std::vector<double> left_;
  double place_ = -1.0;    // of the cycle before
  double depth_mm_ = 0.0;  // there
};

struct Reading {
  std::int64_t cycle = 0;
  double power_w = 0.0;
};

// Where the spindle has kept its speed for a while, and turns: a ramp takes power of its own.
std::vector<bool> steady_rows(const process::CutRecord& record) {
  constexpr double settled_s = 0.5;
  std::vector<bool> steady;
  double speed = 0.0;
  double since_s = 0.0;
  for (const process::CutRow& row : record.rows) {
    since_s = row.rev_per_min == speed ? since_s + record.cycle_s : 0.0;
    speed = row.rev_per_min;
    steady.push_back(speed > 0.0 && since_s > settled_s);
  }
  return steady;
}

// A log has changes only: between two of them the sensor has shown the first value with each poll.
void hold_readings(std::vector<Reading>& readings) {
  if (readings.size() < 3) return;
  std::vector<std::int64_t> gaps;
  for (std::size_t k = 1; k < readings.size(); ++k)
    gaps.push_back(readings[k].cycle - readings[k - 1].cycle);
  std::ranges::nth_element(gaps, gaps.begin() + std::ssize(gaps) / 2);
  const std::int64_t poll = std::max<std::int64_t>(1, gaps[gaps.size() / 2]);
  std::vector<Reading> all;
  for (std::size_t k = 0; k + 1 < readings.size(); ++k) {
    all.push_back(readings[k]);
    for (std::int64_t cycle = readings[k].cycle + poll; cycle < readings[k + 1].cycle;
         cycle += poll)
      all.push_back({.cycle = cycle, .power_w = readings[k].power_w});
  }
  all.push_back(readings.back());
  readings = std::move(all);
}

}  // namespace

CutLog read_cut_log(const std::filesystem::path& file, int channel, int spindle,
                    const std::vector<StockStep>& stock) {
  const auto contents = recording::read_contents(file);
  if (!contents) throw std::runtime_error(contents.error().text);
  const auto name = contents->setpoint_channels.find(channel);
  if (name == contents->setpoint_channels.end() || !contents->description)
    throw std::runtime_error("the log has no setpoints of channel " + std::to_string(channel));
  const ToolAxes axes = tool_axes(*contents, channel);
  auto reader = LogReader::open(file);
  if (!reader) throw std::runtime_error(reader.error().text);

  CutLog log;
  log.record.cycle_s = contents->description->cycle_us * 1e-6;
  std::vector<Reading> readings;
  std::int64_t first_cycle = -1;
  double rev_per_min = 0.0;
  CutSurface surface(stock);
  while (const auto event = reader->next()) {
    const std::string_view topic = recording::topic_of(event->channel);
    if (topic == recording::name_of(recording::Topic::input)) {
      const auto message = recording::decode<input_t>(event->bytes);
      if (!message) continue;
      const channels::InputRecord record = recording::from_input(*message);
      const auto* const input = std::get_if<channels::SpindleInput>(&record.content);
      if (input == nullptr || input->spindle != spindle ||
          input->quantity != channels::SpindleQuantity::power_w)
        continue;
      readings.push_back({.cycle = record.cycle, .power_w = input->value});
    } else if (topic == recording::name_of(recording::Topic::process)) {
      const auto message = recording::decode<process_status_t>(event->bytes);
      if (message && message->channel == channel) rev_per_min = std::abs(message->spindle_speed);
    } else if (event->channel == name->second) {
      const auto message = recording::decode<setpoint_t>(event->bytes);
      if (!message) continue;
      if (first_cycle < 0) first_cycle = message->cycle;
      const double x = message->tip_position[axes.x];
      const double z = message->tip_position[axes.z];
      const bool feeds = message->feed_commanded > 0.0;
      log.record.rows.push_back(
          {.rev_per_min = rev_per_min,
           .radius_mm = std::abs(x),
           .depth_mm = feeds ? surface.depth_mm(x, z) : 0.0,
           .travel_mm = feeds ? message->path_speed * log.record.cycle_s : 0.0});
      log.time_s.push_back(static_cast<double>(message->cycle - first_cycle) * log.record.cycle_s);
    }
  }
  hold_readings(readings);
  const std::vector<bool> is_steady = steady_rows(log.record);
  // What a cycle was given is what the cycle before had made.
  for (const Reading& reading : readings) {
    const std::int64_t row = reading.cycle - 1 - first_cycle;
    if (row >= 0 && std::cmp_less(row, log.record.rows.size()) && is_steady[checked_size(row)])
      log.record.rows[checked_size(row)].power_w = reading.power_w;
  }
  if (readings.empty()) {
    throw std::runtime_error("the log has no power of spindle " + std::to_string(spindle + 1) +
                             "; its drive has to report it (power_w)");
  }
  return log;
}

}  // namespace stanok::client
