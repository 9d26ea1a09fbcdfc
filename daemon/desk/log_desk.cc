#include "daemon/desk/log_desk.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "base/place.h"
#include "daemon/desk/log_folder.h"
#include "daemon/report/status_report.h"
#include "jobs/foresight/logged_tip.h"
#include "protocol/contract/geometry_bytes.h"
#include "recording/read/log_contents.h"
#include "recording/read/setpoint_walk.h"
#include "runtime/replay.h"

namespace stanok::daemon {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using protocol::Failure;

constexpr float standing_mm = 0.005F;

// The client has gone, or wants something else.
struct NoLongerWanted {};

double unix_time_of(const fs::directory_entry& entry) {
  std::error_code error;
  const auto time = std::chrono::file_clock::to_sys(entry.last_write_time(error));
  return error ? 0.0 : std::chrono::duration<double>(time.time_since_epoch()).count();
}

json log_list(const fs::path& folder, const fs::path& open) {
  json logs = json::array();
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    if (entry.path().extension() != log_ending || !entry.is_regular_file(error)) continue;
    logs.push_back({{"file", entry.path().filename().string()},
                    {"bytes", entry.file_size(error)},
                    {"changed_s", unix_time_of(entry)},
                    {"is_open", entry.path() == open}});
  }
  std::sort(logs.begin(), logs.end(), [](const json& a, const json& b) {
    return a["changed_s"].get<double>() > b["changed_s"].get<double>();
  });
  return {{"folder", folder.string()}, {"logs", std::move(logs)}};
}

json difference_json(const runtime::ReplayResult& result) {
  if (!result.difference) return nullptr;
  const auto& difference = *result.difference;
  return {{"cycle", difference.cycle},       {"channel", difference.channel},
          {"field", difference.field},       {"recorded", difference.recorded},
          {"repeated", difference.repeated}, {"ulp", difference.units_in_last_place}};
}

CommandResult verified_log(const fs::path& log, const std::stop_token& stop) {
  if (const auto failure = too_large(log)) return Unexpected<Failure>(*failure);
  try {
    const auto result = runtime::replay(log, [&](double) {
      if (stop.stop_requested()) throw NoLongerWanted{};
    });
    const char* verdict = result.difference ? "differs" : result.is_complete() ? "same" : "part";
    return json{{"file", log.filename().string()},
                {"verdict", verdict},
                {"cycles", result.cycles},
                {"setpoints", result.setpoints},
                {"difference", difference_json(result)},
                {"lost_from_cycle", result.lost_cycle ? json(*result.lost_cycle) : json(nullptr)},
                {"remarks", result.remarks}};
  } catch (const NoLongerWanted&) {
    return unreadable_log("the request was cancelled");
  } catch (const std::runtime_error& error) {
    return unreadable_log(error.what());
  }
}

// Points at which the tip has moved or another line runs.
class PathThinner {
 public:
  PathThinner(std::array<int, 3> axes, double cycle_ms, LoggedPath& path)
      : axes_(axes), cycle_ms_(cycle_ms), path_(path) {}

  // In the workpiece system that was active.
  void add(const setpoint_t& setpoint) {
    std::array<float, 3> place_mm{};
    for (std::size_t k = 0; k < axes_.size(); ++k) {
      if (axes_[k] >= 0) place_mm[k] = static_cast<float>(setpoint.tip_position[axes_[k]]);
    }
    add(setpoint, place_mm);
  }
  void add(const setpoint_t& setpoint, const std::array<float, 3>& place_mm) {
    pass(setpoint);
    LoggedPath::Point point{.place_mm = place_mm};
    const auto cycles = static_cast<double>(setpoint.cycle - path_.first_cycle);
    point.time_ms = static_cast<std::uint32_t>(std::lround(cycles * cycle_ms_));
    point.line = static_cast<std::uint32_t>(setpoint.line);
    if (!path_.points.empty() && !is_news(point, path_.points.back())) return;
    if (++seen_ % stride_ != 0) return;
    path_.points.push_back(point);
    if (path_.points.size() >= LogDesk::points_max) halve();
  }

  // One whose place is not known.
  void leave_out(const setpoint_t& setpoint) {
    pass(setpoint);
    ++path_.cycles_left_out;
  }

 private:
  void pass(const setpoint_t& setpoint) {
    if (setpoints_++ == 0) path_.first_cycle = setpoint.cycle;
    path_.last_cycle = setpoint.cycle;
  }
  static bool is_news(const LoggedPath::Point& point, const LoggedPath::Point& last) {
    if (point.line != last.line) return true;
    float way = 0.0F;
    for (std::size_t k = 0; k < 3; ++k)
      way = std::max(way, std::abs(point.place_mm[k] - last.place_mm[k]));
    return way >= standing_mm;
  }
  void halve() {
    std::size_t kept = 0;
    for (std::size_t k = 0; k < path_.points.size(); k += 2) path_.points[kept++] = path_.points[k];
    path_.points.resize(kept);
    stride_ *= 2;
  }

  std::array<int, 3> axes_;
  double cycle_ms_;
  LoggedPath& path_;
  std::size_t stride_ = 1;
  std::size_t seen_ = 0;
  std::size_t setpoints_ = 0;
};

// Where X, Y and Z stand among the words of the channel; -1: it has none.
std::array<int, 3> places_of_xyz(const channels::MachineConfig& machine, int channel) {
  std::array<int, 3> places{-1, -1, -1};
  for (const channels::ChannelConfig& config : machine.channels) {
    if (config.id != channel) continue;
    for (std::size_t k = 0; k < config.words.size(); ++k) {
      const std::size_t at = std::string("XYZ").find(config.words[k]);
      if (config.words[k].size() == 1 && at < 3) places[at] = static_cast<int>(k);
    }
  }
  return places;
}

std::optional<recording::LogError> add_places_in_work(const fs::path& log, int channel,
                                                      PathThinner& thinner,
                                                      const std::stop_token& stop) {
  const auto contents = recording::read_contents(log);
  if (!contents) return contents.error();
  return recording::for_each_setpoint(log, *contents, channel, [&](const setpoint_t& setpoint) {
    if (stop.stop_requested()) throw NoLongerWanted{};
    thinner.add(setpoint);
  });
}

std::optional<recording::LogError> add_places_on_part(const fs::path& log, jobs::LoggedTip tip,
                                                      PathThinner& thinner,
                                                      const std::stop_token& stop) {
  return jobs::for_each_place(
      log, tip, [&](const setpoint_t& setpoint, const std::optional<simulation::Vector>& place) {
        if (stop.stop_requested()) throw NoLongerWanted{};
        if (!place) return thinner.leave_out(setpoint);
        const Eigen::Vector3f place_mm = place->cast<float>();
        thinner.add(setpoint, {place_mm.x(), place_mm.y(), place_mm.z()});
      });
}

// `part`: its system, else points are those of the workpiece system that was active.
Expected<LoggedPath, Failure> logged_path(const fs::path& log,
                                          const channels::ChannelConfig& channel,
                                          const channels::MachineConfig& machine,
                                          const std::optional<jobs::PartSystem>& part,
                                          const std::stop_token& stop) {
  LoggedPath path;
  path.file = log;
  path.channel = channel.id;
  path.is_on_part = part.has_value();
  PathThinner thinner(places_of_xyz(machine, channel.id), machine.cycle_us * 1e-3, path);
  try {
    const auto error =
        part ? add_places_on_part(log, jobs::LoggedTip(machine, channel, *part), thinner, stop)
             : add_places_in_work(log, channel.id, thinner, stop);
    if (error) return unreadable_log(error->text);
  } catch (const NoLongerWanted&) {
    return unreadable_log("the request was cancelled");
  }
  return path;
}

json path_page(const LoggedPath& path, std::size_t page, int cycle_us) {
  const std::size_t from = std::min(page * LogDesk::page_points, path.points.size());
  const std::size_t to = std::min(from + LogDesk::page_points, path.points.size());
  protocol::GeometryBytes bytes;
  bytes.reserve(to - from);
  json lines = json::array();
  for (std::size_t k = from; k < to; ++k) {
    const LoggedPath::Point& point = path.points[k];
    bytes.add(point.place_mm, point.time_ms);
    if (k == from || point.line != path.points[k - 1].line) lines.push_back({k - from, point.line});
  }
  const double cycles = static_cast<double>(path.last_cycle - path.first_cycle);
  return {{"file", path.file.filename().string()},
          {"channel", path.channel},
          {"system", path.is_on_part ? "part" : "work"},
          {"first_cycle", path.first_cycle},
          {"time_s", cycles * cycle_us * 1e-6},
          {"left_out_s", static_cast<double>(path.cycles_left_out) * cycle_us * 1e-6},
          {"points", path.points.size()},
          {"pages", (path.points.size() + LogDesk::page_points - 1) / LogDesk::page_points},
          {"geometry",
           {{"kind", protocol::GeometryKind::logged_path},
            {"id", path.channel},
            {"page", page},
            {"count", to - from},
            {"lines", std::move(lines)},
            {"base64", bytes.base64()}}}};
}

}  // namespace

void LogDesk::list(int session, Answer answer) {
  const RecordingStatus status = machine_.recording_status();
  work_.submit(
      session,
      [status](const std::stop_token&) -> CommandResult {
        return log_list(status.log_directory, status.log_file);
      },
      std::move(answer));
}

void LogDesk::verify(int session, const json& parameters, Answer answer) {
  const auto log = log_named(machine_.recording_status(), parameters["file"].get<std::string>());
  if (!log) return answer(Unexpected<Failure>(log.error()));
  work_.submit(
      session, [log = *log](const std::stop_token& stop) { return verified_log(log, stop); },
      std::move(answer));
}

// That of the newest planned path, or the one that would begin now, as `on_part` of channel.status.
std::optional<jobs::PartSystem> LogDesk::part_system(int channel) {
  if (const auto path = machine_.planned_path(channel)) {
    if (const auto part = path->state().part) return part;
  }
  const channels::MachineConfig& machine = machine_.file().machine;
  const jobs::PartPlace place(machine, config_of(machine, channel));
  return place.system_of(output_of(machine_.newest_output(), channel));
}

void LogDesk::path(int session, const json& parameters, int channel, Answer answer) {
  const auto log = log_named(machine_.recording_status(), parameters["file"].get<std::string>());
  if (!log) return answer(Unexpected<Failure>(log.error()));
  const auto page = parameters.value("page", std::size_t{0});
  const auto part = parameters.value("system", std::string("work")) == "part" ? part_system(channel)
                                                                              : std::nullopt;
  const auto work = [newest = newest_, log = *log, channel, page, part,
                     machine =
                         machine_.file().machine](const std::stop_token& stop) -> CommandResult {
    const LoggedPath& last = newest->path;
    const bool is_last = last.file == log && last.channel == channel;
    if (page == 0 || !is_last || last.is_on_part != part.has_value()) {
      auto path = logged_path(log, config_of(machine, channel), machine, part, stop);
      if (!path) return Unexpected<Failure>(path.error());
      newest->path = std::move(*path);
    }
    return path_page(newest->path, page, static_cast<int>(machine.cycle_us));
  };
  work_.submit(session, work, std::move(answer));
}

}  // namespace stanok::daemon
