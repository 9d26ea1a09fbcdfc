#include "recording/log/flight_recorder.h"

#include <algorithm>
#include <utility>

#include "base/place.h"
#include "recording/log/log_reader.h"

namespace stanok::recording {
namespace {

constexpr std::int64_t second_us = 1'000'000;

}  // namespace

void FlightRecorder::send(const std::string& channel, std::int64_t utime,
                          std::span<const std::uint8_t> bytes) {
  prologue_.take(channel, bytes);
  const bool is_new = seconds_.empty() || seconds_.back().is_shared ||
                      utime >= seconds_.back().second->begin_us + second_us;
  if (is_new) begin_second(utime);
  Second& second = *seconds_.back().second;
  second.bytes.insert(second.bytes.end(), bytes.begin(), bytes.end());
  second.entries.push_back({index_of(channel), utime, second.bytes.size()});
}

// A second that is dropped gives its memory to the new one, unless a recording still has it.
void FlightRecorder::begin_second(std::int64_t utime) {
  std::shared_ptr<Second> fresh;
  while (!seconds_.empty() && seconds_.front().second->begin_us + second_us + span_us_ <= utime) {
    if (!seconds_.front().is_shared) fresh = std::move(seconds_.front().second);
    seconds_.pop_front();
  }
  if (!fresh) fresh = std::make_shared<Second>();
  fresh->begin_us = utime;
  fresh->entries.clear();
  fresh->bytes.clear();
  seconds_.push_back({std::move(fresh)});
}

std::size_t FlightRecorder::index_of(const std::string& channel) {
  const auto known = std::find(channels_.begin(), channels_.end(), channel);
  const auto index = checked_size(known - channels_.begin());
  if (known == channels_.end()) channels_.push_back(channel);
  return index;
}

FlightRecording FlightRecorder::recording() {
  FlightRecording recording;
  recording.prologue_ = prologue_;
  recording.channels_ = channels_;
  for (Kept& kept : seconds_) {
    kept.is_shared = true;
    recording.seconds_.push_back(kept.second);
  }
  return recording;
}

std::size_t FlightRecorder::bytes() const {
  std::size_t sum = 0;
  for (const Kept& kept : seconds_) sum += kept.second->bytes.size();
  return sum;
}

std::int64_t FlightRecording::bytes() const {
  constexpr std::size_t name_about = 64;
  std::size_t sum = 0;
  for (const auto& second : seconds_)
    sum += second->bytes.size() + second->entries.size() * (event_header_bytes + name_about);
  return static_cast<std::int64_t>(sum);
}

Expected<std::int64_t, LogError> FlightRecording::write(const std::filesystem::path& file) const {
  auto writer = LogWriter::open(file);
  if (!writer) return Unexpected<LogError>(writer.error());
  if (!seconds_.empty()) prologue_.send_to(**writer, seconds_.front()->begin_us);
  for (const auto& second : seconds_) {
    std::size_t begin = 0;
    for (const Entry& entry : second->entries) {
      const std::span<const std::uint8_t> bytes(second->bytes);
      (*writer)->send(channels_[entry.channel], entry.utime,
                      bytes.subspan(begin, entry.end - begin));
      begin = entry.end;
    }
  }
  static_cast<void>((*writer)->finish());
  const LogStatus& status = (*writer)->status();
  if (status.error) return Unexpected<LogError>(*status.error);
  return status.events;
}

}  // namespace stanok::recording
