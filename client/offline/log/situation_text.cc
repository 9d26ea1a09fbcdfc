#include "client/offline/log/situation_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "base/place.h"
#include "channels/stores/live_tables.h"
#include "recording/format/encode.h"

namespace stanok::client {
namespace {

using nlohmann::ordered_json;
using recording::AxisDescription;

constexpr std::array length_rows{"none", "added", "subtracted"};
constexpr std::array transformations{"none", "face", "cylinder"};

// A damaged log may have any number.
template <std::size_t Count>
const char* word_of(const std::array<const char*, Count>& words, std::int8_t number) {
  return number >= 0 && checked_size(number) < Count ? words.at(checked_size(number)) : "unknown";
}

std::vector<AxisDescription> axes_of(const situation_t& situation,
                                     const recording::LogContents& contents) {
  const int places = static_cast<int>(std::size(situation.gain));
  return recording::axes_of(contents, situation.channel,
                            std::clamp(situation.axis_count, 0, places));
}

ordered_json by_word(std::span<const double> values, const std::vector<AxisDescription>& axes) {
  ordered_json json = ordered_json::object();
  for (std::size_t k = 0; k < axes.size(); ++k) json[axes[k].word] = values[k];
  return json;
}

ordered_json rows_of_turn(const double (&turn)[3][3]) {
  ordered_json rows = ordered_json::array();
  for (const auto& row : turn) rows.push_back({row[0], row[1], row[2]});
  return rows;
}

template <std::size_t Count>
ordered_json list_of(const double (&values)[Count]) {
  return ordered_json(std::vector<double>(std::begin(values), std::end(values)));
}

ordered_json codes_of(const situation_t& situation) {
  ordered_json codes = ordered_json::array();
  const std::string_view text = recording::text_of(situation.codes);
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find(' ', begin), text.size());
    codes.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return codes;
}

ordered_json terms_of(const situation_t& situation, const std::vector<AxisDescription>& axes) {
  const bool hangs_over =
      situation.overhang_axis >= 0 && checked_size(situation.overhang_axis) < axes.size();
  ordered_json overhang = nullptr;
  if (hangs_over) overhang = axes[checked_size(situation.overhang_axis)].word;
  return {{"work_offset", by_word(situation.work_offset, axes)},
          {"work_turn", rows_of_turn(situation.work_turn)},
          {"overhang_axis", std::move(overhang)},
          {"overhang", situation.overhang},
          {"set_up_error_turn", rows_of_turn(situation.set_up_error_turn)},
          {"set_up_error_shift", list_of(situation.set_up_error_shift)},
          {"local_shift", by_word(situation.local_shift, axes)},
          {"axis_shift", by_word(situation.axis_shift, axes)},
          {"plane_turn", rows_of_turn(situation.plane_turn)},
          {"plane_origin", list_of(situation.plane_origin)},
          {"plane_shift", list_of(situation.plane_shift)},
          {"rotation_turn", rows_of_turn(situation.rotation_turn)},
          {"rotation_shift", list_of(situation.rotation_shift)},
          {"gain", by_word(situation.gain, axes)},
          {"shift", by_word(situation.shift, axes)}};
}

double seconds_of(const situation_t& situation, const recording::LogContents& contents) {
  return (static_cast<double>(situation.utime) - static_cast<double>(contents.utime_first)) * 1e-6;
}

std::string length_text(const situation_t& situation) {
  const double length = std::hypot(situation.length[0], situation.length[1], situation.length[2]);
  if (length == 0.0 && situation.length_tool == 0) return "-";
  const auto& along = situation.length;
  const bool is_along_z = along[0] == 0.0 && along[1] == 0.0;
  const std::string value = is_along_z
                                ? fmt::format("{:.3f}", along[2])
                                : fmt::format("{:.3f} {:.3f} {:.3f}", along[0], along[1], along[2]);
  return situation.length_tool == 0 ? value : fmt::format("H{} {}", situation.length_tool, value);
}

}  // namespace

ordered_json situation_json(const situation_t& situation, const recording::LogContents& contents) {
  const std::vector<AxisDescription> axes = axes_of(situation, contents);
  ordered_json diameter = ordered_json::array();
  for (std::size_t k = 0; k < axes.size(); ++k) {
    if (situation.diameter[k] != 0) diameter.push_back(axes[k].word);
  }
  return {{"cycle", situation.cycle},
          {"time_s", seconds_of(situation, contents)},
          {"channel", situation.channel},
          {"situation", situation.number},
          {"scheme", situation.scheme},
          {"codes", codes_of(situation)},
          {"units", situation.inches != 0 ? "inch" : "mm"},
          {"diameter", std::move(diameter)},
          {"work_offset", channels::work_offset_name(situation.work_offset_number)},
          {"frame",
           {{"offset", by_word(situation.frame_offset, axes)},
            {"turn", rows_of_turn(situation.frame_turn)}}},
          {"terms", terms_of(situation, axes)},
          {"tool", {{"number", situation.tool}, {"edge", situation.edge}}},
          {"length",
           {{"tool", situation.length_tool},
            {"edge", situation.length_edge},
            {"row", word_of(length_rows, situation.length_row)},
            {"base", list_of(situation.length_base)},
            {"length", list_of(situation.length)}}},
          {"radius_offset", situation.radius_offset},
          {"transformation",
           {{"kind", word_of(transformations, situation.transformation)},
            {"cylinder_radius", situation.cylinder_radius}}}};
}

std::vector<std::string> situation_row(const situation_t& situation,
                                       const recording::LogContents& contents) {
  return {fmt::format("{:.3f}", seconds_of(situation, contents)),
          std::to_string(situation.channel),
          std::to_string(situation.number),
          channels::work_offset_name(situation.work_offset_number),
          situation.tool == 0 ? "-" : fmt::format("T{}.{}", situation.tool, situation.edge),
          length_text(situation),
          std::string(recording::text_of(situation.codes))};
}

}  // namespace stanok::client
