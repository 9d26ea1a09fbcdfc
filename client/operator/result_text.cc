#include "client/operator/result_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <vector>

#include "client/operator/channel_text.h"
#include "client/terminal/diagnostic_output.h"
#include "client/terminal/exit_codes.h"
#include "client/terminal/plane_table.h"
#include "client/terminal/screen_text.h"
#include "client/terminal/text_table.h"
#include "protocol/contract/diagnostic_json.h"
#include "protocol/contract/json_text.h"

namespace stanok::client {
namespace {

using nlohmann::json;

// How the list of a method is shown: its member, and the columns by JSON member.
struct ListView {
  std::string_view method;
  std::string_view member;
  std::vector<std::string> columns;
};

const std::vector<ListView>& list_views() {
  static const std::vector<ListView> views = {
      {"machine.status", "channels", {"id", "name", "state", "program_status"}},
      {"machine.journal", "records", {"at", "kind", "by", "method", "parameters", "outcome"}},
      {"channel.list",
       "channels",
       {"id", "name", "kind", "axes", "scheme", "state", "program_status"}},
      {"program.list", "programs", {"name", "bytes"}},
      {"program.history",
       "runs",
       {"channel", "begun_at", "program", "blocks", "time_s", "path_mm", "lost_periods", "end"}},
      {"kinematics.list", "schemes", {"id", "type", "axes", "active", "file"}},
      {"kinematics.status", "axes", {"name", "takes_part", "enabled", "brake"}},
      {"drive.list",
       "drives",
       {"axis", "unit", "kind", "requests", "watchdog_ms", "position_scale", "velocity_scale"}},
      {"drive.status",
       "axes",
       {"axis", "state", "fault_code", "position", "power_w", "temperature_c", "referenced",
        "in_contact", "answers", "errors"}},
      {"alarm.list", "alarms", {"channel", "at", "code", "file", "line", "text"}},
      {"alarm.history",
       "alarms",
       {"channel", "at", "code", "file", "line", "text", "acknowledged"}},
      {"measurement.history", "measurements", {"channel", "number", "cycle", "text"}},
      {"tool.list",
       "tools",
       {"number", "edge", "name", "kind", "length", "radius", "corner_radius", "wear_length",
        "wear_radius"}},
  };
  return views;
}

// Members of single objects that come first, in this order; the others follow by name.
constexpr auto first_members = std::to_array<std::string_view>(
    {"id", "name", "state", "program_status", "held_by", "alarm", "program", "run", "line", "block",
     "scheme", "position", "feed_mm_s", "speed_mm_s", "override", "remaining_s"});

std::string member_number(double value) {
  if (value == std::floor(value) && std::abs(value) < 1e9)
    return std::to_string(static_cast<long>(value));
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.4f", value);
  return text.data() == std::string_view("-0.0000") ? "0" : text.data();
}

std::vector<std::string> members_in_order(const json& object) {
  std::vector<std::string> names;
  for (const std::string_view name : first_members) {
    if (object.contains(std::string(name))) names.emplace_back(name);
  }
  for (const auto& [name, value] : object.items()) {
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  return names;
}

std::string object_text(const json& object, std::string_view left_out, const Terminal& terminal) {
  std::string text;
  std::size_t widest = 0;
  const auto names = members_in_order(object);
  for (const std::string& name : names) widest = std::max(widest, screen_columns(name));
  for (const std::string& name : names) {
    if (name == left_out) continue;
    const std::string cell = cell_text(object[name]);
    const Colour colour = name == "state" ? state_colour(cell) : Colour::plain;
    text += name + std::string(widest - screen_columns(name), ' ') + "  " +
            terminal.coloured(cell, colour) + "\n";
  }
  return text;
}

// By the clock on the wall.
std::string time_text(double unix_s) {
  const auto seconds = static_cast<std::time_t>(std::floor(unix_s));
  std::tm local{};
  localtime_r(&seconds, &local);
  std::array<char, 32> text{};
  std::strftime(text.data(), text.size(), "%Y-%m-%d %H:%M:%S", &local);
  return text.data();
}

bool is_time(const std::string& column) {
  return column == "at" || column == "begun_at" || column == "ended_at";
}

std::string list_text(const ListView& view, const json& list, const Terminal& terminal) {
  TextTable table(view.columns);
  for (const json& entry : list) {
    std::vector<std::string> cells;
    cells.reserve(view.columns.size());
    for (const std::string& column : view.columns) {
      const json cell = entry.value(column, json());
      cells.push_back(is_time(column) && cell.is_number() ? time_text(cell.get<double>())
                                                          : cell_text(cell));
    }
    table.add_row(std::move(cells));
  }
  return table.text(terminal);
}

// A row for each work offset, a column for each axis in the order of the machine file, and R, the
// rotation, where one has it.
std::string offsets_text(const json& result, const Terminal& terminal) {
  std::vector<std::string> axes = result.value("axes", std::vector<std::string>{});
  const json offsets = result.value("offsets", json::object());
  const bool is_turned = std::any_of(offsets.begin(), offsets.end(),
                                     [](const json& row) { return row.contains("R"); });
  if (is_turned) axes.emplace_back("R");
  std::vector<std::string> headings{"offset"};
  headings.insert(headings.end(), axes.begin(), axes.end());
  TextTable table(headings);
  for (const auto& [name, row] : offsets.items()) {
    std::vector<std::string> cells{name};
    for (const std::string& axis : axes) cells.push_back(member_number(row.value(axis, 0.0)));
    table.add_row(std::move(cells));
  }
  return table.text(terminal);
}

// The queue of each channel: whether it runs, or what stopped it, and a row for each program.
std::string queues_text(const json& result, const Terminal& terminal) {
  std::string text;
  for (const json& queue : result.value("queues", json::array())) {
    const bool is_started = queue.value("started", false);
    const json stopped = queue.value("stopped_by", json());
    text += "channel " + std::to_string(queue.value("channel", 0)) + ": " +
            (is_started          ? "started by " + cell_text(queue.value("started_by", json()))
             : stopped.is_null() ? "not started"
                                 : "stopped: " + one_line(cell_text(stopped))) +
            "\n";
    TextTable table({"position", "id", "program", ""});
    int place = 0;
    for (const json& one : queue.value("programs", json::array())) {
      const json id = one.value("id", json());
      table.add_row({std::to_string(++place), cell_text(id), one.value("program", ""),
                     id == queue.value("under_way", json()) ? "in progress" : ""});
    }
    text += place == 0 ? "no program waiting\n" : table.text(terminal);
  }
  return text;
}

// One line of what came over the socket is one line on the screen.
Diagnostic printable(Diagnostic diagnostic) {
  for (std::string* text : {&diagnostic.code, &diagnostic.place.file, &diagnostic.message})
    *text = one_line(*text);
  for (Note& note : diagnostic.notes) note.text = one_line(note.text);
  for (std::string& text : diagnostic.help) text = one_line(text);
  for (std::string& text : diagnostic.stack) text = one_line(text);
  return diagnostic;
}

// As `stanok check` prints them.
std::string check_text(const json& result, const Terminal& terminal) {
  const json diagnostics = result.value("diagnostics", json::array());
  std::string text;
  if (diagnostics.empty()) text = terminal.coloured("no errors", Colour::green) + "\n";
  for (const json& one : diagnostics)
    text += coloured_text(printable(protocol::diagnostic_of(one)), terminal);
  return text + plane_table(result.value("tilted_planes", json::array()), terminal);
}

// What lies before a block, the way there, and the start that means it.
std::string search_text(const json& result, const Terminal& terminal) {
  std::string text = object_text(result, "approach", terminal);
  const auto approach = result.find("approach");
  if (approach == result.end()) return text;
  TextTable moves({"APPROACH", "MM", "MM/MIN", "TO"});
  for (const json& move : (*approach)["moves"])
    moves.add_row({move.value("kind", ""), cell_text(move.value("length_mm", json())),
                   cell_text(move.value("feed_mm_min", json())),
                   cell_text(move.value("to", json()))});
  text += "\n" + moves.text(terminal);
  const json changes = approach->value("changes", json::array());
  if (!changes.empty()) text += "\nchanges above the workpiece: " + cell_text(changes) + "\n";
  return text + "\nstart with: stanok program start --approach " +
         cell_text((*approach)["number"]) + (changes.empty() ? "" : " --restore") + "\n";
}

}  // namespace

std::string cell_text(const json& value) {
  if (value.is_null() || value.empty()) return "-";
  if (value.is_string()) return one_line(value.get<std::string>());
  if (value.is_boolean()) return value.get<bool>() ? "yes" : "no";
  if (value.is_number_integer()) return protocol::json_text(value);
  if (value.is_number()) return member_number(value.get<double>());
  std::string text;
  if (value.is_array()) {
    for (const json& entry : value) text += (text.empty() ? "" : ", ") + cell_text(entry);
    return text;
  }
  for (const auto& [name, member] : value.items()) {
    text += (text.empty() ? "" : "  ") + name + " " + cell_text(member);
  }
  return text;
}

int result_exit_code(const json& result) {
  if (!result.is_object() || result.value("ok", json(true)) != json(false)) return 0;
  const json diagnostics = result.value("diagnostics", json::array());
  for (const json& one : diagnostics) {
    const int code = exit_code_of(protocol::diagnostic_of(one));
    if (code != 0) return code;
  }
  const json alarm = result.value("alarm", json());
  const int code = alarm.is_object() ? exit_code_of(protocol::diagnostic_of(alarm)) : 0;
  return code != 0 ? code : exit_failed;
}

std::string result_text(std::string_view method, const json& result, const Terminal& terminal) {
  if (result == json{{"accepted", true}}) return "";
  if (method == "channel.status") return channel_text(result, terminal);
  if (method == "channel.position") return origin_text(result, terminal);
  if (method.starts_with("queue.")) return queues_text(result, terminal);
  if (method == "offset.list") return offsets_text(result, terminal);
  if (method == "tool.save") return result.value("tables", "");
  if (method == "program.read") return result.value("text", "");
  if (method == "program.check") return check_text(result, terminal);
  if (method == "program.search") return search_text(result, terminal);
  const auto& views = list_views();
  const auto view = std::find_if(views.begin(), views.end(),
                                 [&](const ListView& v) { return v.method == method; });
  if (view == views.end() || !result.contains(std::string(view->member))) {
    return result.is_object() ? object_text(result, "", terminal) : cell_text(result) + "\n";
  }
  const std::string head = object_text(result, view->member, terminal);
  return head + (head.empty() ? "" : "\n") +
         list_text(*view, result[std::string(view->member)], terminal);
}

}  // namespace stanok::client
