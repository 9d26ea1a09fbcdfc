#include "recording/format/log_description.h"

#include <gnu/libc-version.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <stanok_messages/arrival_t.hpp>
#include <stanok_messages/channel_state_t.hpp>
#include <stanok_messages/drive_status_t.hpp>
#include <stanok_messages/event_t.hpp>
#include <stanok_messages/feedback_t.hpp>
#include <stanok_messages/force_status_t.hpp>
#include <stanok_messages/input_t.hpp>
#include <stanok_messages/log_check_t.hpp>
#include <stanok_messages/log_rest_t.hpp>
#include <stanok_messages/path_t.hpp>
#include <stanok_messages/process_status_t.hpp>
#include <stanok_messages/program_chunk_t.hpp>
#include <stanok_messages/program_read_t.hpp>
#include <stanok_messages/setpoint_t.hpp>
#include <stanok_messages/situation_t.hpp>
#include <stanok_messages/tool_row_t.hpp>
#include <stanok_messages/tool_t.hpp>
#include <stanok_messages/workpiece_t.hpp>
#include <utility>

#include "recording/format/encode_inputs.h"
#include "recording/format/encode_tool_row.h"

namespace stanok::recording {
namespace {

constexpr std::size_t channels_in_meta = std::extent_v<decltype(log_meta_t::channel_id)>;
constexpr std::size_t axes_in_meta = std::extent_v<decltype(log_meta_t::axis_name), 1>;

struct Type {
  const char* name;
  std::int64_t fingerprint;
};

template <class... Messages>
std::array<Type, sizeof...(Messages)> types_of() {
  return {Type{Messages::getTypeName(), Messages::getHash()}...};
}

// The first ones stand in log_meta_t, in this order since it was released; new ones come last.
auto all_types() {
  return types_of<setpoint_t, channel_state_t, drive_status_t, process_status_t, force_status_t,
                  event_t, input_t, program_chunk_t, arrival_t, feedback_t, program_read_t,
                  workpiece_t, tool_t, path_t, log_meta_t, log_check_t, log_types_t, tool_row_t,
                  situation_t, log_rest_t>();
}

// Puts in as many types as `message`, log_meta_t or log_types_t, has places for.
template <class Message>
void put_types(Message& message) {
  const auto types = all_types();
  const std::size_t count = std::min(types.size(), std::size(message.type_name));
  message.type_count = static_cast<std::int32_t>(count);
  for (std::size_t k = 0; k < count; ++k) {
    put_text(types[k].name, message.type_name[k]);
    message.type_fingerprint[k] = types[k].fingerprint;
  }
}

void put_axes(const ChannelDescription& channel, std::size_t index, log_meta_t& meta) {
  const std::size_t count = std::min(channel.axes.size(), axes_in_meta);
  meta.channel_id[index] = channel.id;
  meta.axis_count[index] = static_cast<std::int32_t>(count);
  for (std::size_t k = 0; k < count; ++k) {
    put_text(channel.axes[k].name, meta.axis_name[index][k]);
    put_text(channel.axes[k].word, meta.axis_word[index][k]);
    meta.axis_rotary[index][k] = channel.axes[k].rotary ? 1 : 0;
  }
}

}  // namespace

std::string this_libm() {
  return std::string("glibc ") + gnu_get_libc_version();
}

std::uint64_t text_hash(std::string_view text) {
  std::uint64_t hash = 14695981039346656037ULL;
  for (const char c : text) {
    hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
  }
  return hash;
}

LogDescription describe(const channels::MachineConfig& config, std::string version,
                        std::string build) {
  LogDescription description;
  description.machine = config.name;
  description.version = std::move(version);
  description.build = std::move(build);
  description.libm = this_libm();
  description.cycle_us = config.cycle_us;
  for (const channels::ChannelConfig& channel : config.channels) {
    ChannelDescription& described = description.channels.emplace_back();
    described.id = channel.id;
    for (std::size_t k = 0; k < channel.axes.size(); ++k) {
      const channels::AxisConfig& axis = config.axes[channel.axes[k]];
      const std::string& word = k < channel.words.size() ? channel.words[k] : axis.name;
      described.axes.push_back({axis.name, word, axis.rotary});
    }
  }
  return description;
}

log_meta_t to_log_meta(const LogDescription& description, const Stamp& stamp) {
  log_meta_t meta;
  std::memset(&meta, 0, sizeof meta);
  meta.utime = stamp.utime;
  meta.cycle = stamp.cycle;
  meta.seq = stamp.seq;
  meta.format = description.format;
  meta.cycle_us = description.cycle_us;
  put_text(description.version, meta.version);
  put_text(description.build, meta.build);
  put_text(description.libm, meta.libm);
  put_text(description.machine, meta.machine);
  meta.config_hash = static_cast<std::int64_t>(description.config_hash);
  put_types(meta);
  const std::size_t count = std::min(description.channels.size(), channels_in_meta);
  meta.channel_count = static_cast<std::int32_t>(count);
  for (std::size_t i = 0; i < count; ++i) put_axes(description.channels[i], i, meta);
  return meta;
}

log_types_t to_log_types(const Stamp& stamp) {
  log_types_t message;
  std::memset(&message, 0, sizeof message);
  message.utime = stamp.utime;
  message.cycle = stamp.cycle;
  message.seq = stamp.seq;
  put_types(message);
  static_assert(std::tuple_size_v<decltype(all_types())> <=
                std::extent_v<decltype(log_types_t::type_name)>);
  return message;
}

LogDescription from_log_meta(const log_meta_t& message) {
  LogDescription description;
  description.machine = text_of(message.machine);
  description.version = text_of(message.version);
  description.build = text_of(message.build);
  description.libm = text_of(message.libm);
  description.config_hash = static_cast<std::uint64_t>(message.config_hash);
  description.format = message.format;
  description.cycle_us = message.cycle_us;
  const auto channel_count = std::clamp<std::int64_t>(message.channel_count, 0, channels_in_meta);
  for (std::int64_t i = 0; i < channel_count; ++i) {
    ChannelDescription& channel = description.channels.emplace_back();
    channel.id = message.channel_id[i];
    const auto axis_count = std::clamp<std::int64_t>(message.axis_count[i], 0, axes_in_meta);
    for (std::int64_t k = 0; k < axis_count; ++k) {
      channel.axes.push_back({std::string(text_of(message.axis_name[i][k])),
                              std::string(text_of(message.axis_word[i][k])),
                              message.axis_rotary[i][k] != 0});
    }
  }
  return description;
}

}  // namespace stanok::recording
