#include "recording/plot/force_plot.h"

#include <stanok_messages/force_status_t.hpp>

#include "recording/format/channel_names.h"
#include "recording/format/decode.h"
#include "recording/log/log_reader.h"

namespace stanok::recording {

Expected<ForcePlot, LogError> gather_force(const std::filesystem::path& file,
                                           const LogContents& contents, int channel) {
  auto reader = LogReader::open(file);
  if (!reader) return Unexpected<LogError>(reader.error());
  ForcePlot plot;
  while (const auto event = reader->next()) {
    if (topic_of(event->channel) != name_of(Topic::force)) continue;
    const auto message = decode<force_status_t>(event->bytes);
    if (!message || message->channel != channel) continue;
    const double time = static_cast<double>(message->utime - contents.utime_first) * 1e-6;
    plot.force_set.add(time, message->force_set_now);
    plot.force.add(time, message->force);
    plot.power.add(time, message->power);
    plot.power_idle.add(time, message->power_idle);
    plot.feed.add(time, message->feed);
    plot.vibration.add(time, message->vibration);
  }
  return plot;
}

}  // namespace stanok::recording
