#include "runtime/workpiece/workpiece_stream.h"

#include <filesystem>
#include <stanok_messages/process_status_t.hpp>
#include <stanok_messages/program_read_t.hpp>
#include <stanok_messages/tool_t.hpp>
#include <stanok_messages/workpiece_t.hpp>

#include "lang/run/interpreter.h"
#include "recording/format/channel_names.h"
#include "recording/format/decode.h"
#include "recording/format/encode.h"
#include "recording/format/encode_tool_row.h"

namespace stanok::runtime {
namespace {

using recording::Topic;

// LOG_META belongs to the machine: what stands before it begins all names of the machine.
std::string prefix_of(const std::string& machine) {
  const std::string name = recording::ChannelNames(machine).name(0, Topic::log_meta);
  return name.substr(0, name.size() - recording::name_of(Topic::log_meta).size());
}

}  // namespace

WorkpieceStream::WorkpieceStream(const channels::MachineConfig& machine, std::uint64_t memory_max,
                                 const Complaint& complain, const lang::Files* texts)
    : texts_(texts), prefix_(prefix_of(machine.name)), cycle_s_(machine.cycle_us * 1e-6) {
  for (const channels::ChannelConfig& channel : machine.channels) {
    channels_[channel.id].feed = std::make_unique<ChannelFeed>(
        machine, channel, memory_max,
        [id = channel.id, complain](const std::string& code, const std::string& text) {
          complain(id, code, text);
        });
  }
}

WorkpieceStream::Followed* WorkpieceStream::followed(int channel) {
  const auto found = channels_.find(channel);
  return found == channels_.end() ? nullptr : &found->second;
}

ChannelFeed* WorkpieceStream::feed(int channel) {
  Followed* const found = followed(channel);
  return found == nullptr ? nullptr : found->feed.get();
}

void WorkpieceStream::take(std::string_view channel_name, std::span<const std::uint8_t> bytes) {
  if (!channel_name.starts_with(prefix_)) return;
  const std::string_view topic = recording::topic_of(channel_name);
  const auto on = [&](Topic wanted) { return topic == recording::name_of(wanted); };
  if (on(Topic::setpoint)) {
    if (const auto message = recording::decode<setpoint_t>(bytes)) follow(*message);
  } else if (on(Topic::program_read)) {
    const auto message = recording::decode<program_read_t>(bytes);
    if (message && message->found != 0 && message->from[0] == 0)
      program_ = recording::text_of(message->name);
  } else if (on(Topic::tool)) {
    take_of_channel<tool_t>(bytes, [](Followed& channel, const tool_t& message) {
      channel.tool = {message.number, message.edge};
    });
  } else if (on(Topic::tool_row)) {
    take_of_channel<tool_row_t>(bytes, [](Followed& channel, const tool_row_t& message) {
      if (const auto row = recording::from_tool_row(message)) channel.feed->hear_of_tool(*row);
    });
  } else if (on(Topic::process)) {
    take_of_channel<process_status_t>(bytes,
                                      [](Followed& channel, const process_status_t& message) {
                                        channel.spindle_rev_per_min = message.spindle_speed;
                                      });
  } else if (on(Topic::workpiece)) {
    take_of_channel<workpiece_t>(bytes, [](Followed& channel, const workpiece_t& message) {
      channel.news = news_of(message);
    });
  }
}

// A message that names a channel that is followed.
template <class Message, class Use>
void WorkpieceStream::take_of_channel(std::span<const std::uint8_t> bytes, Use use) {
  const auto message = recording::decode<Message>(bytes);
  Followed* channel = message ? followed(message->channel) : nullptr;
  if (channel != nullptr) use(*channel, *message);
}

void WorkpieceStream::follow(const setpoint_t& setpoint) {
  Followed* channel = followed(setpoint.channel);
  if (channel == nullptr) return;
  time_s_ = static_cast<double>(setpoint.cycle) * cycle_s_;
  count_missing(*channel, setpoint.cycle);
  const simulation::Sample sample =
      sample_of(setpoint, time_s_, channel->tool, channel->spindle_rev_per_min);
  if (!channel->files.contains(sample.origin.run))
    channel->files[sample.origin.run] = files_of_program();
  if (!channel->feed->has_heard(channel->news.announcements))
    channel->feed->hear(channel->news, sample);
  channel->feed->follow(sample);
}

void WorkpieceStream::count_missing(Followed& channel, std::int64_t cycle) {
  const std::int64_t missing = channel.next_cycle > 0 ? cycle - channel.next_cycle : 0;
  channel.next_cycle = cycle + 1;
  if (missing <= 0) return;
  if (missing_.count == 0) missing_.first_s = static_cast<double>(cycle - missing) * cycle_s_;
  missing_.count += missing;
}

// The program itself comes first.
std::vector<std::string> WorkpieceStream::files_of_program() const {
  if (texts_ != nullptr && !program_.empty()) {
    Diagnostics warnings;
    const auto program = lang::compile(program_, *texts_, nullptr, warnings);
    if (program) return lang::file_names(**program);
  }
  return {std::filesystem::path(program_).filename().string()};
}

std::vector<ChannelFeed*> WorkpieceStream::feeds() {
  std::vector<ChannelFeed*> feeds;
  feeds.reserve(channels_.size());
  for (auto& [id, channel] : channels_) feeds.push_back(channel.feed.get());
  return feeds;
}

WorkpieceStream::FilesOfRuns WorkpieceStream::files() const {
  FilesOfRuns files;
  for (const auto& [id, channel] : channels_) {
    for (const auto& [run, names] : channel.files) files[{id, run}] = names;
  }
  return files;
}

}  // namespace stanok::runtime
