#include "recording/format/encode.h"

#include <algorithm>
#include <cstring>
#include <type_traits>

#include "base/utf8.h"

namespace stanok::recording {
namespace {

enum Flag : unsigned { moving = 1, waiting = 2, running = 4 };

template <class Message>
void stamp_message(const Stamp& stamp, Message& message) {
  message.utime = stamp.utime;
  message.cycle = stamp.cycle;
  message.seq = stamp.seq;
}

template <class Message>
void put_tag(const motion::BlockTag& tag, Message& message) {
  message.run = static_cast<std::int32_t>(tag.run);
  message.block = static_cast<std::int64_t>(tag.block);
  message.line = static_cast<std::int32_t>(tag.line);
  message.file = static_cast<std::int16_t>(tag.file);
}

template <class Message>
motion::BlockTag tag_of(const Message& message) {
  return {.run = static_cast<std::uint32_t>(message.run),
          .block = static_cast<std::uint64_t>(message.block),
          .line = static_cast<std::uint32_t>(message.line),
          .file = static_cast<std::uint16_t>(message.file)};
}

// What setpoint and state messages share.
template <class Message>
void put_status(const channels::ChannelOutput& output, Message& message) {
  message.channel = output.id;
  message.axis_count = output.axis_count;
  message.scheme = output.scheme;
  put_tag(output.tag, message);
  message.run = static_cast<std::int32_t>(output.run);
  message.state = static_cast<std::int8_t>(output.state);
  message.flags =
      static_cast<std::int8_t>((output.moving ? moving : 0U) | (output.waiting ? waiting : 0U) |
                               (output.running ? running : 0U));
  message.feed_commanded = output.feed_commanded;
  message.path_speed = output.path_speed;
  message.feed_override = output.feed_override;
}

template <class Predicate>
std::int16_t bits(int count, Predicate is_set) {
  unsigned mask = 0;
  for (int k = 0; k < count; ++k) {
    if (is_set(k)) mask |= 1U << static_cast<unsigned>(k);
  }
  return static_cast<std::int16_t>(mask);
}

bool bit(std::int16_t mask, int k) {
  return (static_cast<unsigned>(mask) >> k & 1U) != 0;
}

// The arrays of generated types are plain; an unused tail stays zero, so equal records give equal
// bytes.
template <class Message>
Message zeroed() {
  static_assert(std::is_trivially_copyable_v<Message>);
  Message message;
  std::memset(&message, 0, sizeof message);
  return message;
}

}  // namespace

std::string_view text_of(std::span<const std::uint8_t> bytes) {
  const auto* const characters = reinterpret_cast<const char*>(bytes.data());
  return {characters, strnlen(characters, bytes.size())};
}

void put_text(std::string_view text, std::span<std::uint8_t> bytes) {
  const std::string repaired = is_utf8(text) ? std::string() : valid_utf8(text);
  const std::string_view kept = cut_to(repaired.empty() ? text : repaired, bytes.size() - 1);
  std::copy(kept.begin(), kept.end(), bytes.begin());
  std::fill(bytes.begin() + static_cast<std::ptrdiff_t>(kept.size()), bytes.end(), std::uint8_t{0});
}

setpoint_t to_setpoint(const channels::ChannelOutput& output, const Stamp& stamp) {
  auto message = zeroed<setpoint_t>();
  stamp_message(stamp, message);
  put_status(output, message);
  for (int k = 0; k < output.axis_count; ++k) {
    const channels::AxisSetpoint& axis = output.axes[k];
    message.tip_position[k] = output.point_W[k].value;
    message.tip_velocity[k] = output.point_W[k].first;
    message.position[k] = axis.position;
    message.velocity[k] = axis.velocity;
    message.acceleration[k] = axis.acceleration;
    message.jerk[k] = axis.jerk;
    message.position_code[k] = axis.position_code;
    message.velocity_code[k] = axis.velocity_code;
  }
  message.drives_enabled = bits(output.axis_count, [&](int k) { return output.drives[k].enabled; });
  message.brakes_closed =
      bits(output.axis_count, [&](int k) { return output.drives[k].brake_closed; });
  return message;
}

channel_state_t to_state(const channels::ChannelOutput& output, const Stamp& stamp) {
  auto message = zeroed<channel_state_t>();
  stamp_message(stamp, message);
  put_status(output, message);
  for (int k = 0; k < output.axis_count; ++k) {
    message.tip_position[k] = output.point_W[k].value;
    message.position[k] = output.axes[k].position;
  }
  put_text(output.program.view(), message.program);
  return message;
}

drive_status_t to_drive_status(const channels::ChannelOutput& output, const Stamp& stamp) {
  const auto& feedback = output.feedback;
  const auto flags = [&](bool channels::AxisFeedback::* flag) {
    return bits(output.axis_count, [&](int k) { return feedback[k].*flag; });
  };
  auto message = zeroed<drive_status_t>();
  stamp_message(stamp, message);
  message.channel = output.id;
  message.axis_count = output.axis_count;
  for (int k = 0; k < output.axis_count; ++k) {
    message.position[k] = feedback[k].position;
    message.velocity[k] = feedback[k].velocity;
    message.following_error[k] = feedback[k].setpoint - feedback[k].position;
  }
  message.valid = flags(&channels::AxisFeedback::valid);
  message.fault = flags(&channels::AxisFeedback::fault);
  message.enabled = flags(&channels::AxisFeedback::enabled);
  message.brake_closed = flags(&channels::AxisFeedback::brake_closed);
  message.referenced = flags(&channels::AxisFeedback::referenced);
  message.follows_velocity =
      bits(output.axis_count, [&](int k) { return output.drives[k].follows_velocity; });
  return message;
}

process_status_t to_process_status(const channels::ChannelOutput& output, const Stamp& stamp) {
  const channels::ProcessOutput& process = output.process;
  auto message = zeroed<process_status_t>();
  stamp_message(stamp, message);
  message.channel = output.id;
  message.law = static_cast<std::int8_t>(process.law);
  message.stands = process.stands ? 1 : 0;
  message.increments = static_cast<std::int64_t>(process.increments);
  message.feed = process.feed_mm_per_min;
  message.feed_per_rev = process.feed_mm_per_rev;
  message.spindle_speed = process.spindle_rev_per_min;
  message.cutting_speed = process.cutting_speed_m_per_min;
  return message;
}

force_status_t to_force_status(const channels::ChannelOutput& output, const Stamp& stamp) {
  const motion::ForceStatus& force = output.process.force;
  auto message = zeroed<force_status_t>();
  stamp_message(stamp, message);
  message.channel = output.id;
  message.control = static_cast<std::int8_t>(force.state);
  message.force_set = force.force_set_n;
  message.force_set_now = force.force_now_n;
  message.force = force.force_n;
  message.power = force.power_w;
  message.power_idle = force.power_idle_w;
  message.radius = force.radius_mm;
  message.feed = force.feed_per_s;
  message.feed_min = force.feed_min_per_s;
  message.feed_max = force.feed_max_per_s;
  message.vibration = force.vibration_um;
  message.vibration_rate = force.vibration_hz;
  message.oscillation = force.oscillation_n;
  message.oscillation_rate = force.oscillation_hz;
  return message;
}

tool_t to_tool(const channels::ChannelOutput& output, const Stamp& stamp) {
  auto message = zeroed<tool_t>();
  stamp_message(stamp, message);
  message.channel = output.id;
  message.number = output.tool.number;
  message.edge = output.tool.edge;
  return message;
}

path_t to_path(const PathPreview& preview, int number, std::size_t first, const Stamp& stamp) {
  auto message = zeroed<path_t>();
  stamp_message(stamp, message);
  message.channel = preview.channel;
  message.preview = number;
  message.total = static_cast<std::int32_t>(preview.points.size());
  message.first = static_cast<std::int32_t>(first);
  const std::size_t count = std::min(std::size(message.joint), preview.points.size() - first);
  message.count = static_cast<std::int32_t>(count);
  put_text(preview.program, message.program);
  for (std::size_t k = 0; k < count; ++k) {
    const PreviewPoint& one = preview.points[first + k];
    std::ranges::copy(one.point, message.point[k]);
    message.joint[k] = static_cast<std::int8_t>((one.begins ? 1U : 0U) | (one.rapid ? 2U : 0U));
  }
  return message;
}

workpiece_t to_workpiece(const channels::ChannelOutput& output, const Stamp& stamp) {
  const channels::Workpiece& workpiece = output.workpiece;
  auto message = zeroed<workpiece_t>();
  stamp_message(stamp, message);
  message.channel = output.id;
  message.known = static_cast<std::int8_t>((workpiece.has_shape ? 1U : 0U) |
                                           (workpiece.has_position ? 2U : 0U));
  message.shape = static_cast<std::int8_t>(workpiece.shape.type);
  message.machining = static_cast<std::int8_t>(workpiece.shape.machining_type);
  message.screen_resolution = workpiece.shape.screen_resolution_mm;
  std::ranges::copy(workpiece.shape.size_mm, message.size);
  std::ranges::copy(workpiece.shape.zero_mm, message.zero);
  std::ranges::copy(workpiece.position.position_mm, message.position);
  std::ranges::copy(workpiece.position.angles_deg, message.angles);
  message.announcements = static_cast<std::int32_t>(workpiece.announcements);
  message.shapes = static_cast<std::int32_t>(workpiece.shapes);
  for (std::size_t k = 0; k < 3; ++k) {
    const int axis = workpiece.frame.geometry[k];
    if (axis >= 0) message.offset[k] = workpiece.frame.offset[axis];
    std::ranges::copy(workpiece.frame.rotation.rows()[k], message.rotation + 3 * k);
  }
  return message;
}

event_t to_event(const channels::Event& event, const Stamp& stamp) {
  auto message = zeroed<event_t>();
  stamp_message(stamp, message);
  put_tag(event.tag, message);
  message.channel = event.channel;
  put_text(event.code.view(), message.code);
  put_text(event.text.view(), message.text);
  return message;
}

channels::ChannelOutput from_setpoint(const setpoint_t& message) {
  channels::ChannelOutput output;
  output.id = message.channel;
  output.axis_count = std::clamp<std::int32_t>(message.axis_count, 0, motion::axes_max);
  output.state = static_cast<channels::ChannelState>(message.state);
  const auto flags = static_cast<std::uint8_t>(message.flags);
  output.moving = (flags & moving) != 0;
  output.waiting = (flags & waiting) != 0;
  output.running = (flags & running) != 0;
  output.run = static_cast<std::uint32_t>(message.run);
  output.scheme = message.scheme;
  output.tag = tag_of(message);
  output.feed_commanded = message.feed_commanded;
  output.path_speed = message.path_speed;
  output.feed_override = message.feed_override;
  for (int k = 0; k < output.axis_count; ++k) {
    output.point_W[k] = {message.tip_position[k], message.tip_velocity[k], 0.0, 0.0};
    output.axes[k] = {.position = message.position[k],
                      .velocity = message.velocity[k],
                      .acceleration = message.acceleration[k],
                      .jerk = message.jerk[k],
                      .position_code = message.position_code[k],
                      .velocity_code = message.velocity_code[k]};
    output.drives[k] = {.enabled = bit(message.drives_enabled, k),
                        .brake_closed = bit(message.brakes_closed, k)};
  }
  return output;
}

}  // namespace stanok::recording
