#include "recording/log/flight_recorder.h"

#include <algorithm>
#include <utility>

#include "base/place.h"
#include "recording/log/log_reader.h"

namespace stanok::recording {
namespace {

constexpr std::int64_t second_us = 1'000'000;
constexpr std::size_t chunk_bytes = 64UL << 10;

template <class Chunks>
std::size_t bytes_in(const Chunks& chunks) {
  std::size_t sum = 0;
  for (const auto& chunk : chunks) sum += chunk.size();
  return sum;
}

}  // namespace

void FlightRecorder::send(const std::string& channel, std::int64_t utime,
                          std::span<const std::uint8_t> bytes) {
  prologue_.take(channel, bytes);
  const bool is_new = seconds_.empty() || seconds_.back().is_shared ||
                      utime >= seconds_.back().second->begin_us + second_us;
  if (is_new) begin_second(utime);
  Chunk& chunk = chunk_for(bytes.size());
  chunk.insert(chunk.end(), bytes.begin(), bytes.end());
  Second& second = *seconds_.back().second;
  second.entries.push_back({index_of(channel), utime, second.chunks.size() - 1, chunk.size()});
}

// Of the newest second, with room for so many more.
FlightRecorder::Chunk& FlightRecorder::chunk_for(std::size_t bytes) {
  std::vector<Chunk>& chunks = seconds_.back().second->chunks;
  const auto has_room = [&](const Chunk& chunk) {
    return chunk.capacity() - chunk.size() >= bytes;
  };
  if (!chunks.empty() && has_room(chunks.back())) return chunks.back();
  if (!spare_.empty() && has_room(spare_.back())) {
    chunks.push_back(std::move(spare_.back()));
    spare_.pop_back();
  } else {
    chunks.emplace_back().reserve(std::max(bytes, chunk_bytes));
  }
  return chunks.back();
}

void FlightRecorder::begin_second(std::int64_t utime) {
  while (!seconds_.empty() && seconds_.front().second->begin_us + second_us + span_us_ <= utime)
    drop_oldest();
  auto fresh = std::make_shared<Second>();
  fresh->begin_us = utime;
  seconds_.push_back({std::move(fresh)});
}

// It gives its memory to those that come, unless a recording still has it.
void FlightRecorder::drop_oldest() {
  if (!seconds_.front().is_shared) {
    for (Chunk& chunk : seconds_.front().second->chunks) {
      chunk.clear();
      spare_.push_back(std::move(chunk));
    }
  }
  seconds_.pop_front();
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
  for (const Kept& kept : seconds_) sum += bytes_in(kept.second->chunks);
  return sum;
}

std::size_t FlightRecorder::bytes_held() const {
  const auto held = [](const std::vector<Chunk>& chunks) {
    std::size_t sum = 0;
    for (const Chunk& chunk : chunks) sum += chunk.capacity();
    return sum;
  };
  std::size_t sum = held(spare_);
  for (const Kept& kept : seconds_) {
    sum += held(kept.second->chunks) +
           kept.second->entries.capacity() * sizeof(kept.second->entries[0]);
  }
  return sum;
}

std::int64_t FlightRecording::bytes() const {
  constexpr std::size_t name_about = 64;
  std::size_t sum = 0;
  for (const auto& second : seconds_)
    sum += bytes_in(second->chunks) + second->entries.size() * (event_header_bytes + name_about);
  return static_cast<std::int64_t>(sum);
}

Expected<std::int64_t, LogError> FlightRecording::write(const std::filesystem::path& file) const {
  auto writer = LogWriter::open(file);
  if (!writer) return Unexpected<LogError>(writer.error());
  if (!seconds_.empty()) prologue_.send_to(**writer, seconds_.front()->begin_us);
  for (const auto& second : seconds_) {
    std::size_t chunk = 0;
    std::size_t begin = 0;
    for (const Entry& entry : second->entries) {
      if (entry.chunk != chunk) begin = 0;
      chunk = entry.chunk;
      const std::span<const std::uint8_t> bytes(second->chunks[chunk]);
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
