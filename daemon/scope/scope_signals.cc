#include "daemon/scope/scope_signals.h"

#include <cmath>
#include <limits>

#include "base/units.h"

namespace stanok::daemon {
namespace {

using channels::ChannelOutput;

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
constexpr double us_per_ns = 1e-3;

std::optional<double> limit_of(double value) {
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

// Where a machine axis stands in the outputs.
struct AxisSeat {
  int channel = 0;
  std::size_t place = 0;
};

using AxisValue = double (*)(const ChannelOutput& channel, std::size_t place);

ScopeSignal axis_signal(std::string name, std::string unit, std::optional<double> limit,
                        AxisSeat seat, AxisValue value) {
  const auto read = [seat, value](const ScopeCycle& cycle) {
    const ChannelOutput* channel = cycle.output.of_channel(seat.channel);
    return channel == nullptr ? nothing : value(*channel, seat.place);
  };
  return {std::move(name), std::move(unit), limit, read};
}

void add_axis(const channels::AxisConfig& axis, AxisSeat seat, std::vector<ScopeSignal>& signals) {
  const std::string unit = axis.rotary ? "deg" : "mm";
  const auto add = [&](const char* what, const char* per, std::optional<double> limit,
                       AxisValue value) {
    signals.push_back(axis_signal(axis.name + '.' + what, unit + per, limit, seat, value));
  };
  const motion::AxisLimits& limits = axis.limits;
  add("position", "", {}, [](const ChannelOutput& c, std::size_t k) { return c.axes[k].position; });
  add("velocity", "/s", limit_of(limits.velocity_max),
      [](const ChannelOutput& c, std::size_t k) { return c.axes[k].velocity; });
  add("acceleration", "/s2", limit_of(limits.acceleration_max),
      [](const ChannelOutput& c, std::size_t k) { return c.axes[k].acceleration; });
  add("jerk", "/s3", limit_of(limits.jerk_max),
      [](const ChannelOutput& c, std::size_t k) { return c.axes[k].jerk; });
  add("actual", "", {}, [](const ChannelOutput& c, std::size_t k) {
    return c.has_feedback && c.feedback[k].valid ? c.feedback[k].position : nothing;
  });
  add("error", "", limit_of(axis.following_error_max), [](const ChannelOutput& c, std::size_t k) {
    const channels::AxisFeedback& feedback = c.feedback[k];
    return c.has_feedback && feedback.valid ? feedback.setpoint - feedback.position : nothing;
  });
}

using ChannelValue = double (*)(const ChannelOutput& channel);

void add_channel(int id, std::vector<ScopeSignal>& signals) {
  const std::string prefix = "channel" + std::to_string(id) + '.';
  const auto add = [&](const char* what, const char* unit, ChannelValue value) {
    const auto read = [id, value](const ScopeCycle& cycle) {
      const ChannelOutput* channel = cycle.output.of_channel(id);
      return channel == nullptr ? nothing : value(*channel);
    };
    signals.push_back({prefix + what, unit, {}, read});
  };
  add("speed", "mm/min", [](const ChannelOutput& c) { return c.path_speed * seconds_per_minute; });
  add("feed", "mm/min",
      [](const ChannelOutput& c) { return c.feed_commanded * seconds_per_minute; });
  add("override", "%", [](const ChannelOutput& c) { return c.feed_override * 100.0; });
  add("line", "", [](const ChannelOutput& c) { return static_cast<double>(c.tag.line); });
  add("spindle", "rev/min", [](const ChannelOutput& c) { return c.process.spindle_rev_per_min; });
  add("force", "N", [](const ChannelOutput& c) {
    return c.process.has_force_control ? c.process.force.force_n : nothing;
  });
  add("power", "W", [](const ChannelOutput& c) {
    return c.process.has_force_control ? c.process.force.power_w : nothing;
  });
}

}  // namespace

std::vector<ScopeSignal> scope_signals(const channels::MachineConfig& machine) {
  std::vector<ScopeSignal> signals;
  for (const channels::ChannelConfig& channel : machine.channels) {
    for (std::size_t k = 0; k < channel.axes.size(); ++k)
      add_axis(machine.axes[channel.axes[k]], {channel.id, k}, signals);
  }
  for (const channels::ChannelConfig& channel : machine.channels) {
    if (!channel.axes.empty()) add_channel(channel.id, signals);
  }
  const auto period_us = static_cast<double>(machine.cycle_us);
  signals.push_back({"cycle.time", "us", period_us, [](const ScopeCycle& cycle) {
                       return static_cast<double>(cycle.times.duration_ns) * us_per_ns;
                     }});
  signals.push_back({"cycle.latency", "us", {}, [](const ScopeCycle& cycle) {
                       return static_cast<double>(cycle.times.latency_ns) * us_per_ns;
                     }});
  return signals;
}

}  // namespace stanok::daemon
