#include "client/operator/channel_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "client/operator/result_text.h"
#include "client/terminal/screen_text.h"
#include "client/terminal/text_table.h"

namespace stanok::client {
namespace {

using nlohmann::json;

constexpr double s_per_min = 60.0;

// What the text is made of; all other members are shown by their names.
constexpr auto understood = std::to_array<std::string_view>(
    {"id",          "name",          "words",       "axis_names",   "state",       "program_status",
     "held_by",     "tap_in_hole",   "alarm",       "program",      "run",         "line",
     "block",       "scheme",        "position",    "to_go",        "axes",        "feed_mm_s",
     "speed_mm_s",  "feed_mm_min",   "feed_mm_rev", "speed_mm_min", "override",    "g_codes",
     "m_codes",     "tool",          "spindles",    "begins_at",    "remaining_s", "foreseen",
     "predicted_s", "controlled_by", "file",        "situation",    "units",       "diameter",
     "point_W"});

json member(const json& object, const char* name) {
  return object.is_object() ? object.value(name, json()) : json();
}

double number_of_member(const json& object, const char* name) {
  const json value = member(object, name);
  return value.is_number() ? value.get<double>() : 0.0;
}

std::string text(const json& object, const char* name) {
  return cell_text(member(object, name));
}

bool has(const json& object, const char* name) {
  return !member(object, name).is_null();
}

// Names in the order of the list; without a list as the object has them.
std::vector<std::string> names_in_order(const json& list, const json& object) {
  std::vector<std::string> names;
  for (const json& name : list) {
    if (name.is_string() && object.contains(name.get<std::string>()))
      names.push_back(name.get<std::string>());
  }
  for (const auto& [name, value] : object.items()) {
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  return names;
}

std::string joined(const json& list) {
  std::string words;
  for (const json& word : list) words += (words.empty() ? "" : " ") + cell_text(word);
  return words;
}

// Four decimals; a zero has no sign.
std::string coordinate(const json& value) {
  if (!value.is_number()) return "-";
  const double number = value.get<double>();
  constexpr double half_of_the_last = 0.00005;
  return fmt::format("{:.4f}", std::abs(number) < half_of_the_last ? 0.0 : number);
}

bool has_code(const json& status, const char* code) {
  const json codes = member(status, "g_codes");
  return codes.is_array() && std::find(codes.begin(), codes.end(), json(code)) != codes.end();
}

double per_minute(const json& status, const char* of_minute, const char* of_second) {
  return has(status, of_minute) ? number_of_member(status, of_minute)
                                : number_of_member(status, of_second) * s_per_min;
}

std::string percent(const json& status, const char* override_name) {
  const json all = member(status, "override");
  return has(all, override_name) ? ", override " + text(all, override_name) + " %" : "";
}

std::string feed_text(const json& status) {
  const double programmed = per_minute(status, "feed_mm_min", "feed_mm_s");
  const double now = per_minute(status, "speed_mm_min", "speed_mm_s");
  std::string line = fmt::format("{:.1f} mm/min programmed", programmed);
  if (has_code(status, "G95"))
    line += fmt::format(" ({:.4f} mm/rev)", number_of_member(status, "feed_mm_rev"));
  return line + fmt::format(", {:.1f} mm/min now", now) + percent(status, "feed") +
         (has(member(status, "override"), "rapid")
              ? ", rapid " + text(member(status, "override"), "rapid") + " %"
              : "");
}

std::string spindle_text(const json& status, const json& spindle) {
  const json actual = member(spindle, "actual_rev_min");
  const std::string measured = actual.is_number()
                                   ? fmt::format("{:.0f} measured", std::abs(actual.get<double>()))
                                   : std::string("not measured");
  return fmt::format("S{} {}, {:.0f} rev/min commanded, {}", text(spindle, "id"),
                     text(spindle, "direction"),
                     std::abs(number_of_member(spindle, "commanded_rev_min")), measured) +
         percent(status, "spindle");
}

std::string tool_text(const json& tool) {
  if (number_of_member(tool, "number") == 0.0) return "none";
  return "T" + text(tool, "number") + (has(tool, "name") ? " " + text(tool, "name") : "") +
         ", edge " + text(tool, "edge");
}

// The line may be one of a file that the program calls or includes.
std::string program_text(const json& status) {
  std::string line = text(status, "program");
  const bool is_elsewhere =
      has(status, "file") && member(status, "file") != member(status, "program");
  if (is_elsewhere) line += " in " + text(status, "file");
  if (number_of_member(status, "line") != 0.0) line += ":" + text(status, "line");
  if (number_of_member(status, "block") != 0.0) line += "  block " + text(status, "block");
  if (has(status, "remaining_s"))
    line += "  " + duration_text(status["remaining_s"]) + " left";
  else if (has(status, "predicted_s"))
    line += "  takes " + duration_text(status["predicted_s"]);
  return line;
}

std::string alarm_text(const json& alarm) {
  const std::string place =
      has(alarm, "file")
          ? text(alarm, "file") + (has(alarm, "line") ? ":" + text(alarm, "line") : "") + ": "
          : "";
  return place + text(alarm, "code") + " " + text(alarm, "text");
}

std::string drive_word(const json& axis) {
  std::string word = member(axis, "enabled") == true ? "on" : "off";
  if (member(axis, "takes_part") == false) word = "parked, " + word;
  if (member(axis, "brake") == true) word += ", brake";
  if (member(axis, "verified") == false) word += ", position not verified";
  return word;
}

// "X", or "X Ø" where the word is a diameter.
std::string shown_word(const json& status, const std::string& word) {
  const json diameters = member(status, "diameter");
  const bool is_diameter =
      std::any_of(diameters.begin(), diameters.end(), [&](const json& one) { return one == word; });
  return is_diameter ? word + " Ø" : word;
}

std::string axis_table(const json& status, const Terminal& terminal) {
  const json axes = member(status, "axes");
  const json position = member(status, "position");
  const auto words = names_in_order(member(status, "words"), position);
  const auto names = names_in_order(member(status, "axis_names"), axes);
  if (words.empty()) return "";
  TextTable table({"axis", "position", "to go", "machine", "drive"});
  for (std::size_t k = 0; k < words.size(); ++k) {
    const std::string name = k < names.size() ? names[k] : words[k];
    const json axis = member(axes, name.c_str());
    table.add_row({shown_word(status, words[k]) + (name == words[k] ? "" : " = " + name),
                   coordinate(position[words[k]]),
                   coordinate(member(member(status, "to_go"), words[k].c_str())),
                   coordinate(member(axis, "position")), drive_word(axis)});
  }
  return table.text(terminal);
}

// Lines "name  value" with the names in a column.
class Lines {
 public:
  void add(const std::string& name, const std::string& value) {
    constexpr std::size_t column = 12;
    text_ +=
        name + std::string(column - std::min(column - 1, screen_columns(name)), ' ') + value + "\n";
  }
  void add_if_there(const json& status, const char* member_name, const std::string& name) {
    if (has(status, member_name)) add(name, text(status, member_name));
  }
  [[nodiscard]] const std::string& text_so_far() const { return text_; }

 private:
  std::string text_;
};

void add_reasons(Lines& lines, const json& status, const Terminal& terminal) {
  lines.add_if_there(status, "held_by", "held by");
  lines.add_if_there(status, "controlled_by", "control");
  if (status.value("tap_in_hole", false))
    lines.add("tap", "was left in its hole; `stanok mdi \"G30 P99\"` takes it out");
  lines.add_if_there(status, "begins_at", "starts at");
  if (has(status, "foreseen"))
    lines.add("expected", terminal.coloured(alarm_text(status["foreseen"]), Colour::yellow));
  if (has(status, "alarm"))
    lines.add("alarm", terminal.coloured(alarm_text(status["alarm"]), Colour::red));
}

void add_others(Lines& lines, const json& status) {
  for (const auto& [name, value] : status.items()) {
    if (std::find(understood.begin(), understood.end(), name) == understood.end())
      lines.add(name, cell_text(value));
  }
}

}  // namespace

std::string duration_text(const json& seconds) {
  if (!seconds.is_number()) return "-";
  constexpr long minute = 60;
  const long s = std::lround(seconds.get<double>());
  const long hours = s / (minute * minute);
  if (hours > 0) return fmt::format("{}:{:02}:{:02}", hours, s / minute % minute, s % minute);
  return fmt::format("{}:{:02}", s / minute, s % minute);
}

std::string channel_text(const json& status, const Terminal& terminal) {
  Lines lines;
  const std::string state = text(status, "state");
  lines.add("channel " + text(status, "id"), text(status, "name") + "  " +
                                                 terminal.coloured(state, state_colour(state)) +
                                                 "  " + text(status, "program_status"));
  lines.add("program", program_text(status));
  add_reasons(lines, status, terminal);
  lines.add("codes", joined(member(status, "g_codes")) + " " + joined(member(status, "m_codes")));
  if (!member(status, "position").empty()) lines.add("feed", feed_text(status));
  const json spindles = member(status, "spindles");
  for (const json& spindle : spindles) lines.add("spindle", spindle_text(status, spindle));
  if (has(status, "tool") && !spindles.empty())
    lines.add("tool", tool_text(member(status, "tool")));
  if (number_of_member(status, "scheme") != 0.0)
    lines.add("kinematics", "scheme " + text(status, "scheme"));
  add_others(lines, status);
  const std::string axes = axis_table(status, terminal);
  return lines.text_so_far() + (axes.empty() ? "" : "\n" + axes);
}

std::string position_text(const json& status) {
  const json position = member(status, "position");
  std::string line;
  for (const std::string& word : names_in_order(member(status, "words"), position))
    line += (line.empty() ? "" : "  ") + shown_word(status, word) + " " + cell_text(position[word]);
  return line.empty() ? "-" : line;
}

std::string origin_text(const json& result, const Terminal& terminal) {
  std::string text;
  TextTable words({"word", "shown", "machine"});
  bool has_terms = false;
  for (const json& axis : member(result, "axes")) {
    const std::string word = shown_word(result, cell_text(member(axis, "word")));
    if (!has(axis, "terms")) {
      words.add_row({word, coordinate(axis["shown"]), coordinate(axis["machine"])});
      continue;
    }
    has_terms = true;
    TextTable terms({word, "adds", "result", ""});
    for (const json& term : axis["terms"]) {
      terms.add_row({cell_text(member(term, "name")), coordinate(member(term, "amount")),
                     coordinate(member(term, "value")),
                     member(term, "fixed") == false ? "at the present axis positions" : ""});
    }
    text += (text.empty() ? "" : "\n") + terms.text(terminal);
  }
  return has_terms ? text : words.text(terminal);
}

std::vector<json> channels_in_order(const json& channels) {
  std::vector<json> ordered(channels.begin(), channels.end());
  std::stable_sort(ordered.begin(), ordered.end(), [](const json& a, const json& b) {
    return number_of_member(a, "id") < number_of_member(b, "id");
  });
  return ordered;
}

nlohmann::ordered_json in_machine_order(const json& status) {
  nlohmann::ordered_json ordered(status);
  const auto reorder = [&](const char* what, const char* order) {
    const json values = member(status, what);
    if (!values.is_object()) return;
    auto& target = ordered[what] = nlohmann::ordered_json::object();
    for (const std::string& name : names_in_order(member(status, order), values))
      target[name] = nlohmann::ordered_json(values[name]);
  };
  reorder("position", "words");
  reorder("to_go", "words");
  reorder("axes", "axis_names");
  return ordered;
}

}  // namespace stanok::client
