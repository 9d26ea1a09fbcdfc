#include "recording/read/log_play.h"

#include <chrono>
#include <string>
#include <thread>

#include "recording/format/channel_names.h"

namespace stanok::recording {

Expected<PlayResult, LogError> play(const std::filesystem::path& file, double speed,
                                    MessageSink& sink, const std::function<bool()>& interrupted) {
  auto reader = LogReader::open(file);
  if (!reader) return Unexpected<LogError>(reader.error());
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  PlayResult result;
  std::int64_t first_utime = 0;
  while (const auto event = reader->next()) {
    const std::string_view topic = topic_of(event->channel);
    if (topic == name_of(Topic::log_check) || topic == name_of(Topic::log_rest))
      continue;  // of the file alone
    if (interrupted()) break;
    if (result.messages == 0) first_utime = event->utime;
    result.recorded_s =
        (static_cast<double>(event->utime) - static_cast<double>(first_utime)) * 1e-6;
    if (speed > 0.0) {
      std::this_thread::sleep_until(start +
                                    std::chrono::duration_cast<Clock::duration>(
                                        std::chrono::duration<double>(result.recorded_s / speed)));
    }
    sink.send(std::string(event->channel), event->utime, event->bytes);
    ++result.messages;
  }
  result.damage = reader->damage();
  return result;
}

}  // namespace stanok::recording
