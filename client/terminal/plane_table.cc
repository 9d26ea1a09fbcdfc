#include "client/terminal/plane_table.h"

#include <fmt/format.h>

#include <cmath>

#include "client/terminal/screen_text.h"
#include "client/terminal/text_table.h"

namespace stanok::client {
namespace {

using nlohmann::ordered_json;

// Without a sign of zero and without noise behind the fourth place.
std::string number_text(double number) {
  return fmt::format("{:.10g}", std::round(number * 1e4) / 1e4 + 0.0);
}

std::string words_of_axes(const ordered_json& axes) {
  std::string text;
  for (const auto& [word, angle] : axes.items())
    text += (text.empty() ? "" : " ") + one_line(word) + number_text(angle.get<double>());
  return text;
}

std::string direction_text(const ordered_json& tool) {
  return fmt::format("X{} Y{} Z{}", number_text(tool.at(0)), number_text(tool.at(1)),
                     number_text(tool.at(2)));
}

std::string other_text(const ordered_json& plane) {
  const auto other = plane.find("other");
  if (other == plane.end()) return "";
  const ordered_json& axes = other->at("axes");
  std::string there =
      fmt::format("{}: {}", one_line(other->at("word").get<std::string>()), words_of_axes(axes));
  const auto limit = other->find("limit");
  if (limit == other->end() || axes.empty()) return there;
  return fmt::format("{}, but {} ends at {}", there, one_line(axes.begin().key()),
                     number_text(limit->get<double>()));
}

}  // namespace

std::string plane_table(const ordered_json& planes, const Terminal& terminal) {
  if (planes.empty()) return "";
  TextTable table({"tilted plane", "tool on the table", "rotary axes", "other position"});
  for (const ordered_json& plane : planes) {
    table.add_row({fmt::format("{}:{}", one_line(plane.at("file").get<std::string>()),
                               plane.at("line").get<int>()),
                   direction_text(plane.at("tool")), words_of_axes(plane.at("axes")),
                   other_text(plane)});
  }
  return table.text(terminal);
}

}  // namespace stanok::client
