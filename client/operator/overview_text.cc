#include "client/operator/overview_text.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <vector>

#include "client/operator/channel_text.h"
#include "client/operator/result_text.h"
#include "client/terminal/text_table.h"

namespace stanok::client {
namespace {

using nlohmann::json;

json channel_member(const json& object, const char* name) {
  return object.value(name, json());
}

std::string program_place(const json& channel) {
  const json program = channel_member(channel, "program");
  if (program.is_null()) return "-";
  const json line = channel_member(channel, "line");
  return cell_text(program) + (line.is_number() && line != 0 ? ":" + cell_text(line) : "");
}

// Writes mm/s as mm/min, as programs write feeds.
std::string minute_text(const json& speed_mm_s) {
  constexpr double s_per_min = 60.0;
  return speed_mm_s.is_number() ? fmt::format("{:.0f}", speed_mm_s.get<double>() * s_per_min) : "-";
}

std::vector<std::string> row_of_channel(const json& channel) {
  const json override_percent = channel.value("override", json::object());
  return {cell_text(channel_member(channel, "id")),
          cell_text(channel_member(channel, "name")),
          cell_text(channel_member(channel, "state")),
          cell_text(channel_member(channel, "program_status")),
          program_place(channel),
          minute_text(channel_member(channel, "speed_mm_s")),
          cell_text(channel_member(override_percent, "feed")),
          duration_text(channel_member(channel, "remaining_s")),
          position_text(channel)};
}

std::string alarm_line(const json& channel, const Terminal& terminal) {
  const json alarm = channel_member(channel, "alarm");
  if (!alarm.is_object()) return "";
  const json file = channel_member(alarm, "file");
  const std::string place =
      file.is_null() ? "" : cell_text(file) + ":" + cell_text(channel_member(alarm, "line")) + ": ";
  return "channel " + cell_text(channel_member(channel, "id")) + "  " + place +
         terminal.coloured(cell_text(channel_member(alarm, "code")), Colour::red) + " " +
         cell_text(channel_member(alarm, "text")) + "\n";
}

}  // namespace

std::string overview_text(const json& channels, const Terminal& terminal) {
  TextTable table(
      {"channel", "name", "state", "status", "program", "mm/min", "feed %", "left", "position"});
  std::string alarms;
  for (const json& channel : channels_in_order(channels)) {
    table.add_row(row_of_channel(channel));
    alarms += alarm_line(channel, terminal);
  }
  return table.text(terminal) + alarms;
}

}  // namespace stanok::client
