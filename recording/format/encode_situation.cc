#include "recording/format/encode_situation.h"

#include <algorithm>
#include <cstring>
#include <string>

namespace stanok::recording {
namespace {

template <std::size_t Count>
void put(const lang::AxisValues& values, double (&places)[Count]) {
  static_assert(Count == motion::axes_max);
  std::ranges::copy(values, places);
}

void put(const std::array<double, 3>& values, double (&places)[3]) {
  std::ranges::copy(values, places);
}

void put(const Rotation& rotation, double (&rows)[3][3]) {
  for (std::size_t k = 0; k < 3; ++k) put(rotation.rows()[k], rows[k]);
}

void put(const lang::SystemWithin& system, double (&rows)[3][3], double (&shift)[3]) {
  put(system.is_on ? system.rotation : Rotation{}, rows);
  put(system.is_on ? system.shift : std::array<double, 3>{}, shift);
}

std::string text_of_codes(const lang::ActiveCodes& codes) {
  std::string text;
  for (const char letter : {'G', 'M'}) {
    for (const std::string& name : lang::names_of(codes, letter))
      text += (text.empty() ? "" : " ") + name;
  }
  return text;
}

void put_frames(const lang::MeaningTerms& terms, situation_t& message) {
  message.work_offset_number = terms.frame.work_offset;
  put(terms.frame.offset, message.frame_offset);
  put(terms.frame.rotation, message.frame_turn);
  put(terms.work_offset_B, message.work_offset);
  put(terms.work_offset_rotation, message.work_turn);
  put(terms.local_shift, message.local_shift);
  put(terms.axis_shift, message.axis_shift);
  message.overhang_axis = terms.overhang_axis;
  message.overhang = terms.overhang_mm;
  put(terms.set_up_error, message.set_up_error_turn, message.set_up_error_shift);
  put(terms.plane, message.plane_turn, message.plane_origin);
  put(terms.plane_shift, message.plane_shift);
  put(terms.rotation, message.rotation_turn, message.rotation_shift);
  put(terms.gain, message.gain);
  put(terms.shift, message.shift);
}

void put_tool(const lang::MeaningTerms& terms, situation_t& message) {
  message.tool = terms.tool.number;
  message.edge = terms.tool.edge;
  message.radius_offset = terms.radius_offset;
  message.length_tool = terms.length.tool;
  message.length_edge = terms.length.edge;
  message.length_row = static_cast<std::int8_t>(terms.length.row);
  put(terms.length.base_mm, message.length_base);
  put(terms.length.offset_mm, message.length);
}

}  // namespace

situation_t to_situation(const channels::ChannelOutput& output,
                         const channels::SituationReport& situation, const Stamp& stamp) {
  const lang::Meaning& meaning = situation.meaning;
  situation_t message;
  std::memset(&message, 0, sizeof message);
  message.utime = stamp.utime;
  message.cycle = stamp.cycle;
  message.seq = stamp.seq;
  message.channel = output.id;
  message.number = situation.number;
  message.scheme = output.scheme;
  message.axis_count = output.axis_count;
  put_text(text_of_codes(meaning.codes), message.codes);
  message.inches = meaning.inches() ? 1 : 0;
  for (std::size_t k = 0; k < std::size(message.diameter); ++k)
    message.diameter[k] = meaning.is_diameter(k) ? 1 : 0;
  put_frames(*meaning.terms, message);
  put_tool(*meaning.terms, message);
  message.transformation = static_cast<std::int8_t>(meaning.terms->transformation.kind);
  message.cylinder_radius = meaning.terms->transformation.radius_mm;
  message.rotary_axis = meaning.terms->transformation.rotary_axis;
  return message;
}

}  // namespace stanok::recording
