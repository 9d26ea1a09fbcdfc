#include "daemon/inventory.h"

#include <algorithm>
#include <system_error>
#include <vector>

namespace stanok::daemon {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr int folder_depth_max = 16;

const char* bus_word(drives::BusKind kind) {
  switch (kind) {
    case drives::BusKind::none:
      return "none";
    case drives::BusKind::modbus_tcp:
      return "modbus-tcp";
    case drives::BusKind::modbus_rtu:
      return "modbus-rtu";
  }
  return "";
}

bool is_hidden(const fs::path& path) {
  return path.filename().string().starts_with('.');
}

}  // namespace

json drive_list(const RunningMachine& machine) {
  const drives::BusConfig& bus = machine.file().bus;
  json drives = json::array();
  for (const auto& drive : bus.axes) {
    drives.push_back({{"axis", drive.axis},
                      {"unit", drive.unit},
                      {"position_scale", drive.map.position.scale},
                      {"velocity_scale", drive.map.velocity.scale}});
  }
  return {{"bus", bus_word(bus.kind)}, {"drives", std::move(drives)}};
}

json drive_status(RunningMachine& machine) {
  const drives::BusStatus bus = machine.drive_status();
  json errors = json::object();
  for (std::size_t k = 0; k < bus.errors.size(); ++k) {
    errors[std::string(drives::name_of(static_cast<drives::ExchangeError>(k)))] = bus.errors[k];
  }
  json axes = json::array();
  for (const auto& axis : bus.axes) {
    axes.push_back({{"axis", axis.axis},
                    {"in_contact", axis.in_contact},
                    {"answers", axis.answers},
                    {"errors", axis.errors}});
  }
  return {{"choice", machine.drive_choice()},
          {"endpoint", bus.endpoint.empty() ? json(nullptr) : json(bus.endpoint)},
          {"connected", bus.connected},
          {"connections", bus.connections},
          {"exchanges", bus.exchanges},
          {"errors", std::move(errors)},
          {"round_trip_us",
           {{"p50", bus.round_trip.p50_us},
            {"p99", bus.round_trip.p99_us},
            {"max", bus.round_trip.max_us}}},
          {"axes", std::move(axes)}};
}

json tool_list(RunningMachine& machine) {
  json tools = json::array();
  for (const channels::ToolEdge& tool : machine.tables().tools) {
    tools.push_back({{"number", tool.number},
                     {"edge", tool.edge},
                     {"name", tool.name},
                     {"kind", tool.kind},
                     {"length", tool.length},
                     {"length_x", tool.length_x},
                     {"length_y", tool.length_y},
                     {"radius", tool.radius},
                     {"corner_radius", tool.corner_radius},
                     {"wear_length", tool.wear_length},
                     {"wear_radius", tool.wear_radius},
                     {"overhang", tool.overhang},
                     {"flute_length", tool.flute_length},
                     {"shank_diameter", tool.shank_diameter},
                     {"holder_diameter", tool.holder_diameter},
                     {"holder_length", tool.holder_length},
                     {"orientation", tool.orientation},
                     {"angle_front", tool.angle_front},
                     {"angle_back", tool.angle_back}});
  }
  return {{"tools", std::move(tools)}};
}

json offset_list(RunningMachine& machine) {
  return {{"offsets", machine.tables().offsets}};
}

json log_status(RunningMachine& machine) {
  const RecordingStatus status = machine.recording_status();
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
            {"error", text(status.log_error)}}},
          {"outputs_lost", machine.outputs_lost()}};
}

json program_list(const fs::path& root, std::size_t files_max) {
  std::vector<std::pair<std::string, std::uintmax_t>> files;
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
    files.emplace_back(fs::relative(entry->path(), root, unreadable).generic_string(),
                       entry->file_size(unreadable));
  }
  std::sort(files.begin(), files.end());
  json programs = json::array();
  for (const auto& [name, bytes] : files) programs.push_back({{"name", name}, {"bytes", bytes}});
  return {{"root", root.string()}, {"programs", std::move(programs)}, {"complete", is_complete}};
}

}  // namespace stanok::daemon
