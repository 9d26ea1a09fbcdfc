#include "recording/format/encode_tool_row.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace stanok::recording {
namespace {

struct Value {
  double channels::ToolRow::* in_row;
  double tool_row_t::* in_message;
  double min;
  double max;
};

constexpr double length_max = 1e5;  // mm, as LiveTables takes it
constexpr double angle_max = 360.0;

using Row = channels::ToolRow;
using Message = tool_row_t;
constexpr auto values = std::to_array<Value>({
    {&Row::length, &Message::length, -length_max, length_max},
    {&Row::length_x, &Message::length_x, -length_max, length_max},
    {&Row::length_y, &Message::length_y, -length_max, length_max},
    {&Row::radius, &Message::radius, 0.0, length_max},
    {&Row::corner_radius, &Message::corner_radius, 0.0, length_max},
    {&Row::wear_length, &Message::wear_length, -length_max, length_max},
    {&Row::wear_length_x, &Message::wear_length_x, -length_max, length_max},
    {&Row::wear_radius, &Message::wear_radius, -length_max, length_max},
    {&Row::overhang, &Message::overhang, -length_max, length_max},
    {&Row::flute_length, &Message::flute_length, 0.0, length_max},
    {&Row::shank_diameter, &Message::shank_diameter, 0.0, length_max},
    {&Row::holder_diameter, &Message::holder_diameter, 0.0, length_max},
    {&Row::holder_length, &Message::holder_length, 0.0, length_max},
    {&Row::angle_front, &Message::angle_front, -angle_max, angle_max},
    {&Row::angle_back, &Message::angle_back, -angle_max, angle_max},
    {&Row::point_angle, &Message::point_angle, 0.0, 180.0},
    {&Row::taper_angle, &Message::taper_angle, 0.0, 90.0},
});

}  // namespace

tool_row_t to_tool_row(int channel, const channels::ToolRow& row, const Stamp& stamp) {
  tool_row_t message;
  std::memset(&message, 0, sizeof message);
  message.utime = stamp.utime;
  message.cycle = stamp.cycle;
  message.seq = stamp.seq;
  message.channel = channel;
  message.number = row.number;
  message.edge = row.edge;
  put_text(row.kind.view(), message.kind);
  message.orientation = row.orientation;
  for (const Value& value : values) message.*value.in_message = row.*value.in_row;
  return message;
}

std::optional<channels::ToolRow> from_tool_row(const tool_row_t& message) {
  const bool is_one = message.number > 0 && message.edge > 0 && message.orientation >= 0 &&
                      message.orientation <= 9;
  const bool is_in_range = std::ranges::all_of(values, [&](const Value& value) {
    const double number = message.*value.in_message;
    return number >= value.min && number <= value.max;
  });
  if (!is_one || !is_in_range) return std::nullopt;
  channels::ToolRow row;
  row.number = message.number;
  row.edge = message.edge;
  row.kind = text_of(message.kind);
  row.orientation = message.orientation;
  for (const Value& value : values) row.*value.in_row = message.*value.in_message;
  return row;
}

}  // namespace stanok::recording
