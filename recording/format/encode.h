// Records of the runtime to LCM messages and back. Pure functions; nothing is lost on the way back
// that a verification or a picture needs.
#pragma once

#include <cstdint>
#include <span>
#include <stanok_messages/channel_state_t.hpp>
#include <stanok_messages/drive_status_t.hpp>
#include <stanok_messages/event_t.hpp>
#include <stanok_messages/force_status_t.hpp>
#include <stanok_messages/path_t.hpp>
#include <stanok_messages/process_status_t.hpp>
#include <stanok_messages/setpoint_t.hpp>
#include <stanok_messages/tool_t.hpp>
#include <stanok_messages/workpiece_t.hpp>
#include <string_view>

#include "channels/contract/output.h"
#include "channels/machine/machine.h"
#include "recording/format/path_preview.h"

namespace stanok::recording {

// The three fields every message begins with.
struct Stamp {
  std::int64_t utime = 0;  // us
  std::int64_t cycle = 0;
  std::int64_t seq = 0;
};

[[nodiscard]] setpoint_t to_setpoint(const channels::ChannelOutput& output, const Stamp& stamp);
[[nodiscard]] channel_state_t to_state(const channels::ChannelOutput& output, const Stamp& stamp);
[[nodiscard]] force_status_t to_force_status(const channels::ChannelOutput& output,
                                             const Stamp& stamp);
[[nodiscard]] process_status_t to_process_status(const channels::ChannelOutput& output,
                                                 const Stamp& stamp);
[[nodiscard]] drive_status_t to_drive_status(const channels::ChannelOutput& output,
                                             const Stamp& stamp);
[[nodiscard]] tool_t to_tool(const channels::ChannelOutput& output, const Stamp& stamp);
// The points from `first` on, as many as a message holds.
[[nodiscard]] path_t to_path(const PathPreview& preview, int number, std::size_t first,
                             const Stamp& stamp);
[[nodiscard]] workpiece_t to_workpiece(const channels::ChannelOutput& output, const Stamp& stamp);
[[nodiscard]] event_t to_event(const channels::Event& event, const Stamp& stamp);

// Second and third derivatives of the programmed point are not in the message: they come back as 0.
[[nodiscard]] channels::ChannelOutput from_setpoint(const setpoint_t& message);

// Text of a byte array that ends with NUL or fills it, and the reverse; longer text is cut.
[[nodiscard]] std::string_view text_of(std::span<const std::uint8_t> bytes);
void put_text(std::string_view text, std::span<std::uint8_t> bytes);

}  // namespace stanok::recording
