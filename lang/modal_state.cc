#include "lang/modal_state.h"

#include <cmath>
#include <string>

namespace stanok::lang {
namespace {

// Coordinates closer than this (mm or deg) are the same: far below any axis resolution, far above
// the rounding of sums of offsets.
constexpr double position_noise = 1e-9;

char letter_of(Group group) {
  return group < Group::stop ? 'G' : 'M';
}

}  // namespace

ModalState default_modal_state(ChannelKind kind) {
  const bool lathe = kind == ChannelKind::lathe;
  ModalState state;
  const auto set = [&state](Group group, CodeNumber number) { state.set(group, number, 0); };
  set(Group::motion, 0);
  set(Group::plane, lathe || kind == ChannelKind::grind ? 180 : 170);
  set(Group::distance, 900);
  set(Group::arc_distance, 911);
  set(Group::feed_mode, lathe ? 950 : 940);
  set(Group::units, 210);
  set(Group::radius_compensation, 400);
  set(Group::length, 490);
  set(Group::transformation, 131);
  set(Group::return_level, 980);
  set(Group::scaling, 500);
  set(Group::mirror, 501);
  set(Group::work_offset, 540);
  set(Group::path_mode, 640);
  set(Group::spindle_mode, 970);
  set(Group::diameter, lathe ? 70 : 80);
  set(Group::rotation, 690);
  set(Group::polar, 150);
  set(Group::spindle, 50);
  set(Group::mist, 90);
  set(Group::flood, 90);
  set(Group::override_control, 480);
  return state;
}

Note ModalState::origin_of(Group group) const {
  const std::uint32_t line = lines[static_cast<std::size_t>(group)];
  const std::string code_name = code_text(letter_of(group), code(group));
  if (line == 0) return {code_name + " is active by default", {}};
  return {code_name + " is active since line " + std::to_string(line), {}};
}

Plane ModalState::plane() const {
  switch (code(Group::plane)) {
    case 180:
      return Plane::zx;
    case 190:
      return Plane::yz;
    default:
      return Plane::xy;
  }
}

FeedMode ModalState::feed_mode() const {
  switch (code(Group::feed_mode)) {
    case 930:
      return FeedMode::inverse_time;
    case 950:
      return FeedMode::per_revolution;
    default:
      return FeedMode::per_minute;
  }
}

AxisValues ModalState::offset() const {
  AxisValues sum = work_offset;
  for (std::size_t i = 0; i < sum.size(); ++i) {
    sum[i] += local_shift[i];
    if (axis_shift_active) sum[i] += axis_shift[i];
  }
  return sum;
}

void ModalState::reexpress_position(const AxisValues& offset_before) {
  const AxisValues now = offset();
  for (std::size_t i = 0; i < now.size(); ++i) {
    if (now[i] != offset_before[i]) position_W[i] += offset_before[i] - now[i];
  }
}

void ModalState::adopt_position(const AxisValues& position_B) {
  const AxisValues now = offset();
  for (std::size_t i = 0; i < now.size(); ++i) {
    const double position = position_B[i] - now[i];
    if (std::abs(position - position_W[i]) > position_noise) position_W[i] = position;
  }
}

}  // namespace stanok::lang
