#include "daemon/report/measurement_notes.h"

#include "recording/log/measurement_files.h"

namespace stanok::daemon {

using nlohmann::json;

void MeasurementNotes::take(const channels::Event& event) {
  const auto measurement = recording::measurement_of(event.text.view());
  if (!measurement) return;
  OfChannel& channel = channels_[event.channel];
  if (channel.newest.size() == kept_of_channel) channel.newest.pop_front();
  channel.newest.push_back({{"channel", event.channel},
                            {"number", ++channel.count},
                            {"cycle", event.cycle},
                            {"feature", measurement->feature},
                            {"values", measurement->values},
                            {"text", event.text.view()}});
}

json MeasurementNotes::history(int channel) const {
  json rows = json::array();
  std::uint64_t forgotten = 0;
  for (const auto& [id, of_channel] : channels_) {
    if (channel != 0 && id != channel) continue;
    forgotten += of_channel.count - of_channel.newest.size();
    for (const json& row : of_channel.newest) rows.push_back(row);
  }
  json answer{{"measurements", std::move(rows)}};
  if (forgotten > 0) answer["forgotten"] = forgotten;
  return answer;
}

}  // namespace stanok::daemon
