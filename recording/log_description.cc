#include "recording/log_description.h"

#include <gnu/libc-version.h>

#include <algorithm>
#include <cstring>
#include <stanok_messages/log_check_t.hpp>
#include <stanok_messages/program_chunk_t.hpp>
#include <utility>

#include "base/assert.h"
#include "recording/encode_inputs.h"

namespace stanok::recording {
namespace {

constexpr std::size_t types_in_meta = std::extent_v<decltype(log_meta_t::type_name)>;
constexpr std::size_t channels_in_meta = std::extent_v<decltype(log_meta_t::channel_id)>;
constexpr std::size_t axes_in_meta = std::extent_v<decltype(log_meta_t::axis_name), 1>;

template <class Message>
void add_type(log_meta_t& meta) {
  STANOK_ASSERT(meta.type_count < static_cast<std::int32_t>(types_in_meta));
  const auto index = static_cast<std::size_t>(meta.type_count++);
  put_text(Message::getTypeName(), meta.type_name[index]);
  meta.type_fingerprint[index] = Message::getHash();
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
      const channels::AxisConfig& axis = config.axes[static_cast<std::size_t>(channel.axes[k])];
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
  meta.format = log_format;
  meta.cycle_us = description.cycle_us;
  put_text(description.version, meta.version);
  put_text(description.build, meta.build);
  put_text(description.libm, meta.libm);
  put_text(description.machine, meta.machine);
  meta.config_hash = static_cast<std::int64_t>(description.config_hash);
  add_type<setpoint_t>(meta);
  add_type<channel_state_t>(meta);
  add_type<drive_status_t>(meta);
  add_type<process_status_t>(meta);
  add_type<force_status_t>(meta);
  add_type<event_t>(meta);
  add_type<input_t>(meta);
  add_type<program_chunk_t>(meta);
  add_type<arrival_t>(meta);
  add_type<feedback_t>(meta);
  add_type<program_read_t>(meta);
  add_type<workpiece_t>(meta);
  add_type<tool_t>(meta);
  add_type<path_t>(meta);
  add_type<log_meta_t>(meta);
  add_type<log_check_t>(meta);
  const std::size_t count = std::min(description.channels.size(), channels_in_meta);
  meta.channel_count = static_cast<std::int32_t>(count);
  for (std::size_t i = 0; i < count; ++i) put_axes(description.channels[i], i, meta);
  return meta;
}

LogDescription from_log_meta(const log_meta_t& message) {
  LogDescription description;
  description.machine = text_of(message.machine);
  description.version = text_of(message.version);
  description.build = text_of(message.build);
  description.libm = text_of(message.libm);
  description.config_hash = static_cast<std::uint64_t>(message.config_hash);
  description.cycle_us = message.cycle_us;
  const auto channel_count = static_cast<std::size_t>(
      std::clamp<std::int64_t>(message.channel_count, 0, channels_in_meta));
  for (std::size_t i = 0; i < channel_count; ++i) {
    ChannelDescription& channel = description.channels.emplace_back();
    channel.id = message.channel_id[i];
    const auto axis_count =
        static_cast<std::size_t>(std::clamp<std::int64_t>(message.axis_count[i], 0, axes_in_meta));
    for (std::size_t k = 0; k < axis_count; ++k) {
      channel.axes.push_back({std::string(text_of(message.axis_name[i][k])),
                              std::string(text_of(message.axis_word[i][k])),
                              message.axis_rotary[i][k] != 0});
    }
  }
  return description;
}

}  // namespace stanok::recording
