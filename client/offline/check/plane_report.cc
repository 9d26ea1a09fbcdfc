#include "client/offline/check/plane_report.h"

#include <fmt/format.h>

#include <cmath>

#include "client/terminal/text_table.h"

namespace stanok::client {
namespace {

using nlohmann::ordered_json;
using runtime::PlanePosition;
using runtime::RotaryAngle;

// Without a sign of zero and without noise behind the fourth place.
double rounded(double number) {
  return std::round(number * 1e4) / 1e4 + 0.0;
}

std::string number_text(double number) {
  return fmt::format("{:.10g}", rounded(number));
}

std::string words_of(const std::vector<RotaryAngle>& axes) {
  std::string text;
  for (const RotaryAngle& axis : axes)
    text += (text.empty() ? "" : " ") + axis.word + number_text(axis.deg);
  return text;
}

std::string direction_text(const lang::Direction& direction) {
  return fmt::format("X{} Y{} Z{}", number_text(direction[0]), number_text(direction[1]),
                     number_text(direction[2]));
}

const char* word_of(lang::FirstRotary first) {
  return first == lang::FirstRotary::positive ? "P1" : "P2";
}

std::string other_text(const PlanePosition& plane) {
  if (!plane.other) return "";
  const PlanePosition::Other& other = *plane.other;
  const std::string there = fmt::format("{}: {}", word_of(other.first), words_of(other.axes));
  if (!other.limit_deg) return there;
  return fmt::format("{}, but {} ends at {}", there, other.axes.front().word,
                     number_text(*other.limit_deg));
}

ordered_json angles_json(const std::vector<RotaryAngle>& axes) {
  ordered_json json = ordered_json::object();
  for (const RotaryAngle& axis : axes) json[axis.word] = axis.deg;
  return json;
}

ordered_json fields(const PlanePosition& plane) {
  ordered_json json = {{"file", plane.place.file},
                       {"line", plane.place.line},
                       {"tool", plane.normal_B},
                       {"axes", angles_json(plane.axes)}};
  if (!plane.other) return json;
  ordered_json other = {{"word", word_of(plane.other->first)},
                        {"axes", angles_json(plane.other->axes)}};
  if (plane.other->limit_deg) other["limit"] = *plane.other->limit_deg;
  json["other"] = std::move(other);
  return json;
}

}  // namespace

std::string plane_table(const std::vector<CheckedProgram>& programs, const Terminal& terminal) {
  TextTable table({"tilted plane", "tool on the table", "rotary axes", "other position"});
  bool any = false;
  for (const CheckedProgram& program : programs) {
    for (const PlanePosition& plane : program.planes) {
      table.add_row({fmt::format("{}:{}", plane.place.file, plane.place.line),
                     direction_text(plane.normal_B), words_of(plane.axes), other_text(plane)});
    }
    any = any || !program.planes.empty();
  }
  return any ? table.text(terminal) : "";
}

ordered_json plane_json(const std::vector<CheckedProgram>& programs) {
  ordered_json json = ordered_json::array();
  for (const CheckedProgram& program : programs) {
    for (const PlanePosition& plane : program.planes) json.push_back(fields(plane));
  }
  return json;
}

}  // namespace stanok::client
