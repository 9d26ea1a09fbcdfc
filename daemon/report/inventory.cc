#include "daemon/report/inventory.h"

#include <algorithm>
#include <array>
#include <map>
#include <system_error>
#include <vector>

#include "config/files/tables_file.h"

namespace stanok::daemon {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr int folder_depth_max = 16;

bool is_hidden(const fs::path& path) {
  return path.filename().string().starts_with('.');
}

}  // namespace

json tool_json(const channels::ToolEdge& tool) {
  return {{"number", tool.number},
          {"edge", tool.edge},
          {"name", tool.name},
          {"kind", tool.kind},
          {"length", tool.length},
          {"length_x", tool.length_x},
          {"length_y", tool.length_y},
          {"radius", tool.radius},
          {"corner_radius", tool.corner_radius},
          {"wear_length", tool.wear_length},
          {"wear_length_x", tool.wear_length_x},
          {"wear_radius", tool.wear_radius},
          {"overhang", tool.overhang},
          {"flute_length", tool.flute_length},
          {"shank_diameter", tool.shank_diameter},
          {"holder_diameter", tool.holder_diameter},
          {"holder_length", tool.holder_length},
          {"orientation", tool.orientation},
          {"angle_front", tool.angle_front},
          {"angle_back", tool.angle_back},
          {"point_angle", tool.point_angle},
          {"taper_angle", tool.taper_angle}};
}

json tool_list(RunningMachine& machine) {
  json tools = json::array();
  for (const channels::ToolEdge& tool : machine.tables().tools) tools.push_back(tool_json(tool));
  return {{"tools", std::move(tools)}};
}

std::optional<json> tool_edge(RunningMachine& machine, int number, int edge) {
  for (const channels::ToolEdge& tool : machine.tables().tools) {
    if (tool.number == number && tool.edge == edge) return tool_json(tool);
  }
  return std::nullopt;
}

json tables_text(RunningMachine& machine) {
  return {{"tables", config::to_toml(machine.tables())}};
}

json offset_list(RunningMachine& machine) {
  constexpr auto of_every_machine = std::to_array<const char*>(
      {"G54", "G55", "G56", "G57", "G58", "G59", "G59.1", "G59.2", "G59.3"});
  std::map<std::string, channels::AxisRow> offsets = machine.tables().offsets;
  for (const char* name : of_every_machine) offsets.try_emplace(name);
  json axes = json::array();
  for (const channels::AxisConfig& axis : machine.file().machine.axes) {
    axes.push_back(axis.name);
    for (auto& [name, row] : offsets) row.try_emplace(axis.name, 0.0);
  }
  return {{"axes", std::move(axes)}, {"offsets", std::move(offsets)}};
}

json workpiece_status(RunningMachine& machine) {
  const channels::CycleOutput output = machine.newest_output();
  json workpieces = json::array();
  for (const channels::ChannelOutput& channel : output.of_channels()) {
    const channels::Workpiece& workpiece = channel.workpiece;
    if (workpiece.announcements == 0) continue;
    json row{{"channel", channel.id}, {"tool", channel.tool.number}};
    if (workpiece.has_shape) {
      constexpr std::array names{"box", "cylinder", "solid"};
      row["shape"] = names.at(static_cast<std::size_t>(workpiece.shape.type));
      if (!workpiece.file.empty()) row["file"] = workpiece.file.view();
      row["machining"] = workpiece.shape.machining_type == 0 ? "milling" : "turning";
      row["size"] = workpiece.shape.size_mm;
      row["zero"] = workpiece.shape.zero_mm;
      row["resolution"] = workpiece.shape.screen_resolution_mm;
    }
    if (workpiece.has_position) {
      row["position"] = workpiece.position.position_mm;
      row["angles"] = workpiece.position.angles_deg;
    }
    workpieces.push_back(std::move(row));
  }
  return {{"allowed", machine.recording_status().workpieces_allowed},
          {"workpieces", std::move(workpieces)}};
}

namespace {

// A bound that is none is null.
json bound(std::int64_t value) {
  return value == 0 ? json(nullptr) : json(value);
}

json kept_json(const KeptLogsStatus& kept) {
  constexpr std::int64_t s_per_hour = 3600;
  return {{"files", kept.files},
          {"bytes", kept.bytes},
          {"bytes_max", bound(kept.bytes_max)},
          {"hours_max", bound(kept.age_max_s / s_per_hour)},
          {"free_bytes", kept.free_bytes ? json(*kept.free_bytes) : json(nullptr)},
          {"free_bytes_min", bound(kept.free_bytes_min)}};
}

}  // namespace

json log_status(RunningMachine& machine) {
  const RecordingStatus status = machine.recording_status();
  const CycleLosses losses = machine.losses();
  const auto text = [](const std::string& value) {
    return value.empty() ? json(nullptr) : json(value);
  };
  return {{"lcm",
           {{"url", text(status.lcm_url)},
            {"open", status.lcm_open},
            {"sent", status.lcm_sent},
            {"lost", status.lcm_lost}}},
          {"file",
           {{"path", text(status.log_file)},
            {"bytes", status.log_bytes},
            {"events", status.log_events},
            {"error", text(status.log_error)},
            {"rests", status.log_rests}}},
          {"kept", kept_json(status.kept)},
          {"flight", text(status.flight_file)},
          {"outputs_lost", losses.outputs},
          {"inputs_lost", losses.inputs}};
}

json program_list(const fs::path& root, std::size_t files_max) {
  struct File {
    std::string name;
    std::uintmax_t bytes = 0;
    double changed_s = 0.0;
  };
  std::vector<File> files;
  bool is_complete = true;
  std::error_code error;
  auto entry =
      fs::recursive_directory_iterator(root, fs::directory_options::skip_permission_denied, error);
  for (; !error && entry != fs::recursive_directory_iterator(); entry.increment(error)) {
    if (is_hidden(entry->path()) || entry.depth() >= folder_depth_max) {
      entry.disable_recursion_pending();
      continue;
    }
    std::error_code unreadable;
    if (entry->symlink_status(unreadable).type() != fs::file_type::regular) continue;
    if (files.size() == files_max) {
      is_complete = false;
      break;
    }
    const auto changed = std::chrono::file_clock::to_sys(entry->last_write_time(unreadable));
    files.push_back({fs::relative(entry->path(), root, unreadable).generic_string(),
                     entry->file_size(unreadable),
                     std::chrono::duration<double>(changed.time_since_epoch()).count()});
  }
  std::ranges::sort(files, {}, &File::name);
  json programs = json::array();
  for (const File& file : files) {
    programs.push_back({{"name", file.name}, {"bytes", file.bytes}, {"changed_s", file.changed_s}});
  }
  return {{"root", root.string()}, {"programs", std::move(programs)}, {"complete", is_complete}};
}

}  // namespace stanok::daemon
