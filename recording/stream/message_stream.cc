#include "recording/stream/message_stream.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <stanok_messages/program_chunk_t.hpp>
#include <utility>

#include "base/assert.h"
#include "base/place.h"
#include "recording/format/encode_input_record.h"
#include "recording/format/encode_situation.h"
#include "recording/format/encode_tool_row.h"

namespace stanok::recording {
namespace {

constexpr std::int64_t meta_period_us = 60'000'000;
constexpr std::int64_t state_period_us = 50'000;
// So often that every piece of a log, and what a flight recorder has, tells it soon.
constexpr std::int64_t situation_period_us = 1'000'000;
constexpr std::int64_t path_period_us = 10'000;

std::int64_t cycles_in(std::int64_t period_us, int cycle_us) {
  return std::max<std::int64_t>(1, period_us / cycle_us);
}

program_chunk_t chunk_of(const TextRecord& record, std::size_t offset) {
  program_chunk_t chunk;
  std::memset(&chunk, 0, sizeof chunk);
  const std::size_t length = std::min(sizeof chunk.text, record.text.size() - offset);
  chunk.channel = record.channel;
  chunk.run = static_cast<std::int32_t>(record.run);
  chunk.file = static_cast<std::int16_t>(record.file);
  chunk.kind = static_cast<std::int8_t>(record.kind);
  chunk.size = static_cast<std::int64_t>(record.text.size());
  chunk.offset = static_cast<std::int64_t>(offset);
  chunk.length = static_cast<std::int32_t>(length);
  put_text(record.name, chunk.name);
  std::copy_n(record.text.begin() + static_cast<std::ptrdiff_t>(offset), length, chunk.text);
  return chunk;
}

}  // namespace

MessageStream::MessageStream(LogDescription description, std::vector<MessageSink*> sinks)
    : description_(std::move(description)),
      sender_(description_, std::move(sinks),
              std::max(log_meta_t{}.getEncodedSize(), log_types_t{}.getEncodedSize())),
      periods_{.meta = cycles_in(meta_period_us, description_.cycle_us),
               .state = cycles_in(state_period_us, description_.cycle_us),
               .situation = cycles_in(situation_period_us, description_.cycle_us),
               .path = cycles_in(path_period_us, description_.cycle_us)},
      next_meta_cycle_(std::numeric_limits<std::int64_t>::min()) {}

void MessageStream::cycle(const channels::CycleOutput& output) {
  send_meta_when_due(output.cycle);
  for (const channels::ChannelOutput& channel : output.of_channels()) {
    situation_when_due(output.cycle, channel);  // before the setpoint that it holds for
    if (channel.axis_count > 0) {
      sender_.send(
          to_setpoint(channel, sender_.next_stamp(output.cycle, channel.id, Topic::setpoint)),
          channel.id, Topic::setpoint);
    }
    state_when_due(output.cycle, channel);
    drives_when_due(output.cycle, channel);
    process_when_due(output.cycle, channel);
    force_when_due(output.cycle, channel);
    tool_when_due(output.cycle, channel);
    tool_row_when_due(output.cycle, channel);
    workpiece_when_due(output.cycle, channel);
    path_when_due(output.cycle, channel.id);
  }
}

void MessageStream::event(const channels::Event& event) {
  send_meta_when_due(event.cycle);
  sender_.send(to_event(event, sender_.next_stamp(event.cycle, event.channel, Topic::event)),
               event.channel, Topic::event);
}

void MessageStream::input(const channels::InputRecord& record) {
  send_meta_when_due(record.cycle);
  sender_.send(to_input(record, sender_.next_stamp(record.cycle, record.channel, Topic::input)),
               record.channel, Topic::input);
}

void MessageStream::input(const channels::InputChange& change) {
  send_meta_when_due(change.cycle);
  const auto stamp = [&](Topic topic) {
    return sender_.next_stamp(change.cycle, change.channel, topic);
  };
  if (const auto* seen = std::get_if<channels::Arrivals>(&change.content)) {
    sender_.send(to_arrival(change.channel, *seen, stamp(Topic::arrival)), change.channel,
                 Topic::arrival);
  } else if (const auto* told = std::get_if<channels::FeedbackInput>(&change.content)) {
    sender_.send(to_feedback(change.channel, told->axis, told->value, stamp(Topic::feedback)),
                 change.channel, Topic::feedback);
  } else if (const auto* signal = std::get_if<channels::AnalogInput>(&change.content)) {
    input(channels::InputRecord{
        .cycle = change.cycle, .channel = change.channel, .content = *signal});
  } else if (const auto* sensor = std::get_if<channels::SpindleInput>(&change.content)) {
    input(channels::InputRecord{
        .cycle = change.cycle, .channel = change.channel, .content = *sensor});
  }
}

void MessageStream::text(const TextRecord& record) {
  send_meta_when_due(record.cycle);
  const auto hash = static_cast<std::int64_t>(text_hash(record.text));
  std::size_t offset = 0;
  do {
    program_chunk_t chunk = chunk_of(record, offset);
    const Stamp stamp = sender_.next_stamp(record.cycle, record.channel, Topic::program);
    chunk.utime = stamp.utime;
    chunk.cycle = stamp.cycle;
    chunk.seq = stamp.seq;
    chunk.hash = hash;
    sender_.send(chunk, record.channel, Topic::program);
    offset += checked_size(chunk.length);
  } while (offset < record.text.size());
}

void MessageStream::program_read(const ProgramRead& read, std::int64_t cycle) {
  send_meta_when_due(cycle);
  sender_.send(to_program_read(read, sender_.next_stamp(cycle, 0, Topic::program_read)), 0,
               Topic::program_read);
  if (!read.found || !sent_texts_.insert(text_hash(read.text)).second) return;
  text({.cycle = cycle, .name = read.path, .text = read.text});
}

void MessageStream::send_meta_when_due(std::int64_t cycle) {
  if (cycle < next_meta_cycle_) return;
  next_meta_cycle_ = cycle + periods_.meta;
  sender_.send(to_log_meta(description_, sender_.next_stamp(cycle, 0, Topic::log_meta)), 0,
               Topic::log_meta);
  sender_.send(to_log_types(sender_.next_stamp(cycle, 0, Topic::log_types)), 0, Topic::log_types);
}

void MessageStream::drives_when_due(std::int64_t cycle, const channels::ChannelOutput& output) {
  if (!output.has_feedback || output.axis_count == 0 || cycle % periods_.state != 0) return;
  sender_.send(to_drive_status(output, sender_.next_stamp(cycle, output.id, Topic::drive)),
               output.id, Topic::drive);
}

void MessageStream::process_when_due(std::int64_t cycle, const channels::ChannelOutput& output) {
  if (output.axis_count == 0 || cycle % periods_.state != 0) return;
  sender_.send(to_process_status(output, sender_.next_stamp(cycle, output.id, Topic::process)),
               output.id, Topic::process);
}

void MessageStream::force_when_due(std::int64_t cycle, const channels::ChannelOutput& output) {
  const bool is_on = output.process.force.state != motion::ForceState::off;
  if (!output.process.has_force_control || !is_on || cycle % periods_.state != 0) return;
  sender_.send(to_force_status(output, sender_.next_stamp(cycle, output.id, Topic::force)),
               output.id, Topic::force);
}

void MessageStream::state_when_due(std::int64_t cycle, const channels::ChannelOutput& output) {
  if (cycle % periods_.state != 0) return;
  sender_.send(to_state(output, sender_.next_stamp(cycle, output.id, Topic::state)), output.id,
               Topic::state);
}

void MessageStream::tool_when_due(std::int64_t cycle, const channels::ChannelOutput& output) {
  if (output.axis_count == 0) return;
  ShownTool& shown = tools_[output.id];
  if (output.tool == shown.tool && shown.cycle >= 0 && cycle < shown.cycle + periods_.meta) return;
  shown = {output.tool, cycle};
  sender_.send(to_tool(output, sender_.next_stamp(cycle, output.id, Topic::tool)), output.id,
               Topic::tool);
}

// A tool that goes leaves nothing to be told; when it comes back, its row is new again.
void MessageStream::tool_row_when_due(std::int64_t cycle, const channels::ChannelOutput& output) {
  if (output.axis_count == 0) return;
  ShownToolRow& shown = tool_rows_[output.id];
  if (output.tool_row == shown.row && cycle < shown.cycle + periods_.meta) return;
  shown = {output.tool_row, cycle};
  if (output.tool_row.number == 0) return;
  sender_.send(to_tool_row(output.id, output.tool_row,
                           sender_.next_stamp(cycle, output.id, Topic::tool_row)),
               output.id, Topic::tool_row);
}

void MessageStream::situation_when_due(std::int64_t cycle, const channels::ChannelOutput& output) {
  if (!situations_) return;
  ShownSituation& shown = shown_situations_[output.id];
  const bool is_known = output.tag.situation == shown.number && shown.cycle >= 0;
  if (is_known && cycle < shown.cycle + periods_.situation) return;
  shown = {output.tag.situation, cycle};
  sender_.send(to_situation(output, situations_(output),
                            sender_.next_stamp(cycle, output.id, Topic::situation)),
               output.id, Topic::situation);
}

void MessageStream::path(PathPreview preview) {
  STANOK_ASSERT(preview.channel >= 0 && preview.channel <= channels::channels_max);
  ShownPath& shown = paths_[preview.channel];
  shown = {std::move(preview), shown.number + 1, 0, 0};
}

// In parts, so that a viewer on the bus can follow.
void MessageStream::path_when_due(std::int64_t cycle, int channel) {
  ShownPath& shown = paths_[channel];
  if (shown.preview.points.empty() || cycle < shown.next_cycle) return;
  const path_t message = to_path(shown.preview, shown.number, shown.next,
                                 sender_.next_stamp(cycle, channel, Topic::path));
  sender_.send(message, channel, Topic::path);
  shown.next += checked_size(message.count);
  const bool is_whole = shown.next == shown.preview.points.size();
  if (is_whole) shown.next = 0;
  shown.next_cycle = cycle + (is_whole ? periods_.meta : periods_.path);
}

void MessageStream::allow_workpieces(bool allowed) {
  if (allowed && !workpieces_allowed_) workpieces_ = {};
  workpieces_allowed_ = allowed;
}

void MessageStream::workpiece_when_due(std::int64_t cycle, const channels::ChannelOutput& output) {
  if (!workpieces_allowed_) return;
  ShownWorkpiece& shown = workpieces_[output.id];
  const std::uint32_t announcements = output.workpiece.announcements;
  if (announcements == 0) return;
  if (announcements == shown.announcements && cycle < shown.cycle + periods_.meta) return;
  shown = {announcements, cycle};
  sender_.send(to_workpiece(output, sender_.next_stamp(cycle, output.id, Topic::workpiece)),
               output.id, Topic::workpiece);
}

}  // namespace stanok::recording
