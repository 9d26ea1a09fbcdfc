#include "client/offline/process/identify/power_readings.h"

#include <algorithm>
#include <string_view>

#include "base/place.h"
#include "recording/format/channel_names.h"
#include "recording/format/decode.h"
#include "recording/format/encode_input_record.h"

namespace stanok::client {

void PowerReadings::take(const recording::LogEvent& event) {
  if (recording::topic_of(event.channel) != recording::name_of(recording::Topic::input)) return;
  const auto message = recording::decode<input_t>(event.bytes);
  if (!message) return;
  const channels::InputRecord record = recording::from_input(*message);
  const auto* const input = std::get_if<channels::SpindleInput>(&record.content);
  if (input == nullptr || input->spindle != spindle_ ||
      input->quantity != channels::SpindleQuantity::power_w)
    return;
  changes_.push_back({.cycle = record.cycle, .power_w = input->value});
}

std::vector<PowerReading> PowerReadings::held() const {
  if (changes_.size() < 3) return changes_;
  std::vector<std::int64_t> gaps;
  for (std::size_t k = 1; k < changes_.size(); ++k)
    gaps.push_back(changes_[k].cycle - changes_[k - 1].cycle);
  std::ranges::nth_element(gaps, gaps.begin() + std::ssize(gaps) / 2);
  const std::int64_t poll = std::max<std::int64_t>(1, gaps[gaps.size() / 2]);
  std::vector<PowerReading> all;
  for (std::size_t k = 0; k + 1 < changes_.size(); ++k) {
    all.push_back(changes_[k]);
    for (std::int64_t cycle = changes_[k].cycle + poll; cycle < changes_[k + 1].cycle;
         cycle += poll)
      all.push_back({.cycle = cycle, .power_w = changes_[k].power_w});
  }
  all.push_back(changes_.back());
  return all;
}

}  // namespace stanok::client
