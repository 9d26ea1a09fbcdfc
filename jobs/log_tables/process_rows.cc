#include "jobs/log_tables/process_rows.h"

#include <algorithm>
#include <string>
#include <utility>

#include "recording/format/channel_names.h"
#include "recording/format/decode.h"

namespace stanok::jobs {
namespace {

bool is_of_topic(std::string_view channel_name, recording::Topic topic) {
  return recording::topic_of(channel_name) == recording::name_of(topic);
}

}  // namespace

bool has_process_rows(const recording::LogContents& contents, int channel) {
  const std::string place = "_CH" + std::to_string(channel) + "_";
  return std::ranges::any_of(contents.channels, [&](const auto& entry) {
    const auto& [name, told] = entry;
    for (const recording::Topic topic : {recording::Topic::process, recording::Topic::force}) {
      if (name.ends_with(place + std::string(recording::name_of(topic))))
        return told.messages > told.undecodable;
    }
    return false;
  });
}

Expected<ProcessRows, recording::LogError> ProcessRows::open(const std::filesystem::path& file,
                                                             int channel) {
  auto reader = recording::LogReader::open(file);
  if (!reader) return Unexpected<recording::LogError>(reader.error());
  return ProcessRows(std::move(*reader), channel);
}

std::optional<ProcessRow> ProcessRows::next() {
  while (const auto event = reader_.next()) {
    if (!utime_first_) utime_first_ = event->utime;
    std::optional<ProcessRow> ended;
    if (is_of_topic(event->channel, recording::Topic::process)) {
      ended = take(*event, &ProcessRow::process);
    } else if (is_of_topic(event->channel, recording::Topic::force)) {
      ended = take(*event, &ProcessRow::force);
    }
    if (ended) return ended;
  }
  return std::exchange(begun_, std::nullopt);
}

template <class Message>
std::optional<ProcessRow> ProcessRows::take(const recording::LogEvent& event,
                                            std::optional<Message> ProcessRow::* part) {
  auto message = recording::decode<Message>(event.bytes);
  if (!message || message->channel != channel_) return std::nullopt;
  const bool goes_on = begun_ && begun_->cycle == message->cycle && !((*begun_).*part);
  std::optional<ProcessRow> ended;
  if (!goes_on) {
    const double time_s = static_cast<double>(message->utime - *utime_first_) * 1e-6;
    ended = std::exchange(begun_, ProcessRow{.time_s = time_s, .cycle = message->cycle});
  }
  (*begun_).*part = *message;
  return ended;
}

}  // namespace stanok::jobs
