#include "jobs/logs/situation_fields.h"

#include <algorithm>
#include <array>
#include <span>

#include "base/place.h"
#include "channels/stores/live_tables.h"
#include "recording/format/encode.h"

namespace stanok::jobs {
namespace {

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

Fields by_word(std::span<const double> values, const std::vector<AxisDescription>& axes) {
  Fields fields;
  for (std::size_t k = 0; k < axes.size(); ++k) fields.push_back({axes[k].word, values[k]});
  return fields;
}

FieldList turn_rows(const double (&turn)[3][3]) {
  return field_list(turn, [](const auto& row) { return number_list(row); });
}

FieldList codes_of(const situation_t& situation) {
  FieldList codes;
  const std::string_view text = recording::text_of(situation.codes);
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find(' ', begin), text.size());
    codes.push_back(text_field(text.substr(begin, end - begin)));
    begin = end + 1;
  }
  return codes;
}

Fields terms_of(const situation_t& situation, const std::vector<AxisDescription>& axes) {
  const bool hangs_over =
      situation.overhang_axis >= 0 && checked_size(situation.overhang_axis) < axes.size();
  FieldValue overhang;
  if (hangs_over) overhang = axes[checked_size(situation.overhang_axis)].word;
  return {{"work_offset", by_word(situation.work_offset, axes)},
          {"work_turn", turn_rows(situation.work_turn)},
          {"overhang_axis", std::move(overhang)},
          {"overhang", situation.overhang},
          {"set_up_error_turn", turn_rows(situation.set_up_error_turn)},
          {"set_up_error_shift", number_list(situation.set_up_error_shift)},
          {"local_shift", by_word(situation.local_shift, axes)},
          {"axis_shift", by_word(situation.axis_shift, axes)},
          {"plane_turn", turn_rows(situation.plane_turn)},
          {"plane_origin", number_list(situation.plane_origin)},
          {"plane_shift", number_list(situation.plane_shift)},
          {"rotation_turn", turn_rows(situation.rotation_turn)},
          {"rotation_shift", number_list(situation.rotation_shift)},
          {"gain", by_word(situation.gain, axes)},
          {"shift", by_word(situation.shift, axes)}};
}

double seconds_of(const situation_t& situation, const recording::LogContents& contents) {
  return (static_cast<double>(situation.utime) - static_cast<double>(contents.utime_first)) * 1e-6;
}

}  // namespace

Fields situation_fields(const situation_t& situation, const recording::LogContents& contents) {
  const std::vector<AxisDescription> axes = axes_of(situation, contents);
  FieldList diameter;
  for (std::size_t k = 0; k < axes.size(); ++k) {
    if (situation.diameter[k] != 0) diameter.push_back(axes[k].word);
  }
  return {{"cycle", count_field(situation.cycle)},
          {"time_s", seconds_of(situation, contents)},
          {"channel", count_field(situation.channel)},
          {"situation", count_field(situation.number)},
          {"scheme", count_field(situation.scheme)},
          {"codes", codes_of(situation)},
          {"units", situation.inches != 0 ? "inch" : "mm"},
          {"diameter", std::move(diameter)},
          {"work_offset", channels::work_offset_name(situation.work_offset_number)},
          {"frame", Fields{{"offset", by_word(situation.frame_offset, axes)},
                           {"turn", turn_rows(situation.frame_turn)}}},
          {"terms", terms_of(situation, axes)},
          {"tool", Fields{{"number", situation.tool}, {"edge", situation.edge}}},
          {"length", Fields{{"tool", situation.length_tool},
                            {"edge", situation.length_edge},
                            {"row", word_of(length_rows, situation.length_row)},
                            {"base", number_list(situation.length_base)},
                            {"length", number_list(situation.length)}}},
          {"radius_offset", situation.radius_offset},
          {"transformation", Fields{{"kind", word_of(transformations, situation.transformation)},
                                    {"cylinder_radius", situation.cylinder_radius}}}};
}

}  // namespace stanok::jobs
