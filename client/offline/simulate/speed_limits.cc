#include "client/offline/simulate/speed_limits.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/enum_names.h"

namespace stanok::client {
namespace {

constexpr auto cause_names = enum_names<SpeedCause>({
    {SpeedCause::feed, "feed"},
    {SpeedCause::feed_override, "feed override"},
    {SpeedCause::law, "law"},
    {SpeedCause::velocity, "velocity"},
    {SpeedCause::acceleration, "acceleration"},
    {SpeedCause::jerk, "jerk"},
    {SpeedCause::transition, "between limits"},
    {SpeedCause::hold, "hold"},
    {SpeedCause::standing, "standing"},
});

// So much of a limit counts as all of it: plans keep some of it back, and a cycle samples them.
constexpr double at_limit = 0.9;
constexpr double at_feed = 0.999;
constexpr double even_part = 0.1;  // of a limit of acceleration along the path: it keeps its speed
constexpr std::size_t lines_shown = 20;

bool is_of_axis(SpeedCause cause) {
  return cause == SpeedCause::velocity || cause == SpeedCause::acceleration ||
         cause == SpeedCause::jerk;
}

std::string advice(const SpeedLimit& limit) {
  switch (limit.cause) {
    case SpeedCause::feed:
      return "a higher F";
    case SpeedCause::feed_override:
      return "a higher override";
    case SpeedCause::law:
      return "the feed law";
    case SpeedCause::velocity:
      return "less travel of this axis";
    case SpeedCause::acceleration:
    case SpeedCause::jerk:
      return limit.in_curve ? "a larger G64 P or larger radii" : "fewer stops and slow corners";
    case SpeedCause::transition:
      return "longer blocks between corners";
    case SpeedCause::hold:
    case SpeedCause::standing:
      break;
  }
  return "";
}

// The file of a block, or nothing when no run tells it.
std::string file_of(const std::vector<channels::RunReport>& runs, int channel, std::uint32_t run,
                    std::uint16_t file) {
  const auto is_meant = [&](const channels::RunReport& report) {
    return report.channel == channel && report.run == run;
  };
  const auto report = std::ranges::find_if(runs, is_meant);
  return report != runs.end() && file < report->files.size() ? report->files[file] : "";
}

// Whether a file is the one that a person names, by its last part or by more of its path.
bool is_named(std::string_view file, std::string_view name) {
  if (!file.ends_with(name)) return false;
  return file.size() == name.size() || file[file.size() - name.size() - 1] == '/';
}

}  // namespace

void SpeedLimits::add(Line& sum, const Line& line) {
  sum.time_s += line.time_s;
  for (const auto& [limit, time_s] : line.causes) sum.causes[limit] += time_s;
}

void SpeedLimits::observe(const channels::CycleOutput& output) {
  const double cycle_s = machine_.cycle_us * 1e-6;
  for (const channels::ChannelOutput& channel : output.of_channels()) {
    if (channel.running && channel.tag.line > 0) {
      Line& line = places_[{channel.id, channel.tag.run, channel.tag.file, channel.tag.line}];
      line.time_s += cycle_s;
      line.causes[limit_of(channel)] += cycle_s;
    }
    speeds_[channel.id] = channel.path_speed;
  }
}

SpeedLimits::NamedLines SpeedLimits::asked_lines(
    const std::vector<channels::RunReport>& runs) const {
  NamedLines lines;
  for (const auto& [place, line] : places_) {
    const std::string file = file_of(runs, place.channel, place.run, place.file);
    if (is_asked(place, file)) add(lines[{place.channel, file, place.line}], line);
  }
  return lines;
}

bool SpeedLimits::is_asked(const Place& place, const std::string& file) const {
  const auto is_meant = [&](const AskedLine& asked) {
    if (asked.line != place.line) return false;
    return asked.file.empty() ? place.file == 0 : is_named(file, asked.file);
  };
  return asked_.empty() || std::ranges::any_of(asked_, is_meant);
}

SpeedLimit SpeedLimits::limit_of(const channels::ChannelOutput& channel) const {
  if (channel.state == channels::ChannelState::held) return {.cause = SpeedCause::hold};
  if (!channel.moving) return {.cause = SpeedCause::standing};
  const double asked = channel.feed_commanded * channel.feed_override;
  if (channel.feed_commanded > 0.0 && channel.path_speed >= at_feed * asked) {
    if (channel.process.law != motion::LawKind::none) return {.cause = SpeedCause::law};
    return {.cause = channel.feed_override < 1.0 ? SpeedCause::feed_override : SpeedCause::feed};
  }
  return limit_of_axes(channel);
}

SpeedLimit SpeedLimits::limit_of_axes(const channels::ChannelOutput& channel) const {
  const auto config =
      std::ranges::find(machine_.channels, channel.id, &channels::ChannelConfig::id);
  const auto& axes = config->axes;
  SpeedLimit largest;
  double use = 0.0;
  double acceleration_max = motion::unlimited;
  for (std::size_t k = 0; k < axes.size(); ++k) {
    const motion::AxisLimits& limits = machine_.axes[axes[k]].limits;
    const channels::AxisSetpoint& axis = channel.axes[k];
    const bool is_rapid = channel.feed_commanded == 0.0;
    const double speed_max = is_rapid ? limits.rapid_speed_max() : limits.velocity_max;
    const std::array<std::pair<SpeedCause, double>, 3> uses{
        {{SpeedCause::velocity, std::abs(axis.velocity) / speed_max},
         {SpeedCause::acceleration, std::abs(axis.acceleration) / limits.acceleration_max},
         {SpeedCause::jerk, std::abs(axis.jerk) / limits.jerk_max}}};
    for (const auto& [cause, part] : uses) {
      if (part <= use) continue;
      use = part;
      largest = {.cause = cause, .axis = axes[k]};
    }
    acceleration_max = std::min(acceleration_max, limits.acceleration_max);
  }
  if (use < at_limit) return {.cause = SpeedCause::transition};
  const auto before = speeds_.find(channel.id);
  const double change = before == speeds_.end() ? 0.0 : channel.path_speed - before->second;
  const double along = std::abs(change) / (machine_.cycle_us * 1e-6);
  largest.in_curve = largest.cause != SpeedCause::velocity && along < even_part * acceleration_max;
  return largest;
}

SpeedLimits::Causes SpeedLimits::by_time(const Line& line) {
  Causes causes(line.causes.begin(), line.causes.end());
  std::ranges::stable_sort(causes, std::greater{}, [](const auto& cause) { return cause.second; });
  return causes;
}

nlohmann::ordered_json SpeedLimits::json(const std::vector<channels::RunReport>& runs) const {
  auto lines = nlohmann::ordered_json::array();
  for (const auto& [place, line] : asked_lines(runs)) {
    auto causes = nlohmann::ordered_json::array();
    for (const auto& [limit, time_s] : by_time(line)) {
      nlohmann::ordered_json cause{{"cause", cause_names[limit.cause]}, {"time_s", time_s}};
      if (limit.axis >= 0) {
        cause["axis"] = machine_.axes[limit.axis].name;
        cause["in_curve"] = limit.in_curve;
      }
      causes.push_back(std::move(cause));
    }
    lines.push_back({{"channel", place.channel},
                     {"file", place.file},
                     {"line", place.line},
                     {"time_s", line.time_s},
                     {"causes", std::move(causes)}});
  }
  return lines;
}

std::string SpeedLimits::text(const std::vector<channels::RunReport>& runs) const {
  const NamedLines lines = asked_lines(runs);
  std::vector<const NamedLines::value_type*> shown;
  Line together;
  for (const auto& entry : lines) {
    shown.push_back(&entry);
    add(together, entry.second);
  }
  if (asked_.empty() && shown.size() > lines_shown) {
    std::ranges::stable_sort(shown, std::greater{},
                             [](const auto* entry) { return entry->second.time_s; });
    shown.resize(lines_shown);
  }
  if (shown.empty()) return "no line asked for was run\n";
  std::string text;
  if (shown.size() > 1) text += "all together: " + causes_text(together);
  for (const auto* entry : shown) {
    const NamedPlace& place = entry->first;
    text += fmt::format("channel {} {}:{}: {}", place.channel, place.file, place.line,
                        causes_text(entry->second));
  }
  return text;
}

std::string SpeedLimits::causes_text(const Line& line) const {
  std::string text = fmt::format("{:.3f} s\n", line.time_s);
  for (const auto& [limit, time_s] : by_time(line)) {
    const std::string axis = is_of_axis(limit.cause) ? " of " + machine_.axes[limit.axis].name : "";
    const std::string where = limit.in_curve ? " in a curve" : "";
    const std::string help = advice(limit);
    text +=
        fmt::format("  {:3.0f} %  {}{}{}{}\n", 100.0 * time_s / line.time_s,
                    cause_names[limit.cause], axis, where, help.empty() ? "" : "  (" + help + ")");
  }
  return text;
}

}  // namespace stanok::client
