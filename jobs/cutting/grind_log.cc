#include "jobs/cutting/grind_log.h"

#include <algorithm>
#include <cmath>
#include <stanok_messages/setpoint_t.hpp>
#include <stdexcept>
#include <utility>

#include "base/place.h"
#include "jobs/cutting/power_readings.h"
#include "recording/format/decode.h"
#include "recording/read/log_contents.h"

namespace stanok::jobs {
namespace {

constexpr double before_touch_s = 2.0;
constexpr double goes_back_mm = 1e-4;

std::size_t infeed_axis_of_log(const recording::LogContents& contents, int channel) {
  const recording::ChannelDescription* const description =
      recording::description_of(contents, channel);
  if (description == nullptr) throw std::runtime_error("the log does not describe its channels");
  const auto axis = std::ranges::find(description->axes, "X", &recording::AxisDescription::word);
  if (axis == description->axes.end()) {
    throw std::runtime_error("channel " + std::to_string(channel) +
                             " has no axis X; choose the channel of the grinder with --channel");
  }
  return checked_size(axis - description->axes.begin());
}

// From the begin in front of the touch to the last cycle before the wheel goes back.
struct Plunge {
  std::size_t begin = 0;
  std::size_t end = 0;
};

Plunge first_plunge(const std::vector<double>& x_mm, double touch_mm, double cycle_s) {
  const auto touch = std::ranges::find_if(x_mm, [&](double x) { return x < touch_mm; });
  if (touch == x_mm.end())
    throw std::runtime_error("the wheel does not come to the part at X " +
                             std::to_string(touch_mm) + "; give its X at the touch with --touch");
  const auto at = checked_size(touch - x_mm.begin());
  const auto before = checked_size(before_touch_s / cycle_s);
  Plunge plunge{.begin = at > before ? at - before : 0, .end = at};
  double least = x_mm[at];
  for (; plunge.end < x_mm.size() && x_mm[plunge.end] < least + goes_back_mm; ++plunge.end)
    least = std::min(least, x_mm[plunge.end]);
  return plunge;
}

}  // namespace

GrindLog read_grind_log(const std::filesystem::path& file, const GrindLogRequest& request) {
  const auto contents = recording::read_contents(file);
  if (!contents) throw std::runtime_error(contents.error().text);
  if (!contents->setpoint_channels.contains(request.channel) || !contents->description) {
    throw std::runtime_error("the log has no setpoints of channel " +
                             std::to_string(request.channel));
  }
  const std::size_t axis = infeed_axis_of_log(*contents, request.channel);
  const std::string setpoints = contents->setpoint_channels.at(request.channel);
  const double cycle_s = contents->description->cycle_us * 1e-6;
  auto reader = recording::LogReader::open(file);
  if (!reader) throw std::runtime_error(reader.error().text);
  PowerReadings readings(request.spindle);
  std::vector<double> x_mm;
  std::int64_t first_cycle = -1;
  while (const auto event = reader->next()) {
    readings.take(*event);
    if (event->channel != setpoints) continue;
    const auto message = recording::decode<setpoint_t>(event->bytes);
    if (!message || !is_number_of_a_cycle(message->cycle)) continue;
    request.bounds.check(x_mm.size());
    if (first_cycle < 0) first_cycle = message->cycle;
    x_mm.push_back(message->tip_position[axis]);
  }
  readings.check_any();
  const double touch_mm = request.touch_mm.value_or(request.allowance_mm);
  const Plunge plunge = first_plunge(x_mm, touch_mm, cycle_s);
  GrindLog log{.record = {.cycle_s = cycle_s,
                          .allowance_mm = request.allowance_mm,
                          .watts_per_newton = request.watts_per_newton,
                          .rows = {}},
               .time_s = {}};
  for (std::size_t k = plunge.begin; k < plunge.end; ++k) {
    log.record.rows.push_back({.x_mm = request.allowance_mm + x_mm[k] - touch_mm});
    log.time_s.push_back(static_cast<double>(k) * cycle_s);
  }
  // What a cycle was given is what the cycle before had made.
  const std::int64_t begin = first_cycle + 1 + static_cast<std::int64_t>(plunge.begin);
  const std::vector<double> power_w = readings.given(begin, log.record.rows.size());
  for (std::size_t k = 0; k < power_w.size(); ++k)
    if (!std::isnan(power_w[k])) log.record.rows[k].power_w = power_w[k];
  return log;
}

}  // namespace stanok::jobs
