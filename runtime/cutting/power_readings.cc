#include "runtime/cutting/power_readings.h"

#include <algorithm>
#include <limits>
#include <string_view>
#include <utility>

#include "base/place.h"
#include "recording/format/channel_names.h"
#include "recording/format/decode.h"
#include "recording/format/encode_input_record.h"

namespace stanok::runtime {
namespace {

// Where the spindle has kept its speed for a while, and turns.
std::vector<bool> steady_rows(const std::vector<double>& rev_per_min, double cycle_s) {
  constexpr double settled_s = 0.5;
  std::vector<bool> steady;
  double speed = 0.0;
  double since_s = 0.0;
  for (const double now : rev_per_min) {
    since_s = now == speed ? since_s + cycle_s : 0.0;
    speed = now;
    steady.push_back(speed > 0.0 && since_s > settled_s);
  }
  return steady;
}

}  // namespace

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

std::vector<double> PowerReadings::by_row(std::int64_t first_cycle,
                                          const std::vector<double>& rev_per_min,
                                          double cycle_s) const {
  const std::vector<bool> is_steady = steady_rows(rev_per_min, cycle_s);
  std::vector<double> power(rev_per_min.size(), std::numeric_limits<double>::quiet_NaN());
  // What a cycle was given is what the cycle before had made.
  for (const PowerReading& reading : held()) {
    const std::int64_t row = reading.cycle - 1 - first_cycle;
    if (row >= 0 && std::cmp_less(row, power.size()) && is_steady[checked_size(row)])
      power[checked_size(row)] = reading.power_w;
  }
  return power;
}

}  // namespace stanok::runtime
